/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "lubcontact_checks.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "lubcontact_law.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "suspension_host.h"
#include "update.h"

#include <cmath>
#include <limits>

using namespace LAMMPS_NS;
using Lubcontact_NS::Law;
using Lubcontact_NS::Range;
using Lubcontact_NS::Settings;
using Lubcontact_NS::TypeCoeffs;

static constexpr double LARGEST_SKIN = 2.0;    // over the largest radius
static constexpr double GOOD_SKIN = 0.3;

namespace {

// Is there a pair of types with these coefficients? (g = 0: a pair of another style)
template <class Has> bool any_pair(const Law &law, const Has &has)
{
  for (int i = 1; i <= law.types; i++)
    for (int j = i; j <= law.types; j++)
      if (law.of(i, j).g != 0.0 && has(law.of(i, j))) return true;
  return false;
}

bool any_positive(const Law &law, double TypeCoeffs::*value)
{
  return any_pair(law, [value](const TypeCoeffs &c) {
    return c.*value > 0.0;
  });
}

// Is there a pair with friction whose surfaces can touch?
bool any_frictional_contact(const Law &law)
{
  return any_pair(law, [&law](const TypeCoeffs &c) {
    return c.friction > 0.0 && can_touch(law.settings, c);
  });
}

// Types on which both styles act, as two words; empty: none.
std::string shared_types(LAMMPS *lmp, const Pair *one, const Pair *other)
{
  for (int i = 1; i <= lmp->atom->ntypes; i++)
    for (int j = i; j <= lmp->atom->ntypes; j++)
      if (one->setflag && other->setflag && one->setflag[i][j] && other->setflag[i][j])
        return fmt::format("{} {}", i, j);
  return "";
}

// Other sub-style of hybrid that acts on the same types, whose name matches; null: none.
const Pair *companion(LAMMPS *lmp, const Pair *pair, const char *pattern)
{
  const Pair *last = nullptr;
  for (int nsub = 1;; nsub++) {
    const Pair *other = lmp->force->pair_match(pattern, 0, nsub);
    if (!other || other == last) return nullptr;    // a single one is found whatever the number
    if (other != pair && !shared_types(lmp, pair, other).empty()) return other;
    last = other;
  }
}

}    // namespace

/* ---------------------------------------------------------------------- */

std::string lubcontact_checks::idle(const Law &law, unsigned effect)
{
  if (effect == Lubcontact_NS::REPULSION)
    return any_positive(law, &TypeCoeffs::repulsion) ? "" : "force 0";
  if (effect == Lubcontact_NS::FRICTION) {
    if (!any_positive(law, &TypeCoeffs::friction)) return "coefficient 0";
    return any_frictional_contact(law) ? "" : "smooth surfaces do not touch through a film";
  }
  if (!Lubcontact_NS::effect_row(effect).is_film()) return "";
  if (!(law.settings.viscosity > 0.0)) return "viscosity 0";
  if (effect == Lubcontact_NS::ROLL && law.settings.roll_coeff == 0.0) return "coefficient 0";
  return "";
}

/* ----------------------------------------------------------------------
   friction of surfaces that never touch is an error, asperities without height leave what is meant:
   a warning. Fix adapt and a viscosity that is a variable may change either
------------------------------------------------------------------------- */

void lubcontact_checks::check_coefficients(LAMMPS *lmp, const Law &law, bool viscosity_varies)
{
  if (!lmp->modify->get_fix_by_style("^adapt").empty()) return;
  const bool frictional = any_positive(law, &TypeCoeffs::friction);
  if (!viscosity_varies && frictional && !any_frictional_contact(law))
    lmp->error->all(
        FLERR,
        "Pair style lubcontact friction cannot act: surfaces of roughness 0 never touch "
        "through a squeeze film; give pair_coeff a roughness > 0, or no friction");

  const bool given = any_pair(law, [](const TypeCoeffs &c) {
    return c.asperity != c.g;
  });
  if (given && !any_positive(law, &TypeCoeffs::roughness_a) && lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "Pair style lubcontact asperity has no effect because the roughness is 0");
}

/* ---------------------------------------------------------------------- */

void lubcontact_checks::check_repulsion(LAMMPS *lmp, const Law &law, double smallest_radius)
{
  static constexpr double MOST = 1e-3;    // of the force at closed gap
  if (lmp->comm->me) return;
  const double reach = law.settings.reach_a;
  for (int i = 1; i <= law.types; i++)
    for (int j = i; j <= law.types; j++) {
      const TypeCoeffs &c = law.of(i, j);
      if (c.g == 0.0 || c.repulsion == 0.0) continue;
      const double left = exp(-reach * smallest_radius / c.screening);
      if (left > MOST)
        lmp->error->warning(
            FLERR,
            "Repulsion of types {} {} has {:.3g} of its force left at the end of the range {} "
            "of pair style lubcontact, where it drops to zero: extend the range",
            i, j, left, reach);
    }
}

/* ---------------------------------------------------------------------- */

void lubcontact_checks::check_residual(LAMMPS *lmp, const Settings &settings)
{
  if (settings.range != Range::RESIDUAL) return;
  if (lmp->domain->dimension == 2)
    lmp->error->all(FLERR,
                    "Pair style lubcontact range residual is for spheres in 3d: use range cut");
  if (lmp->modify->get_fix_by_style("^hydro").empty())
    lmp->error->all(FLERR,
                    "Pair style lubcontact range residual is what fix hydro grid leaves to the "
                    "films: add this fix, or use range cut");
}

void lubcontact_checks::check_sizes(LAMMPS *lmp, const Settings &settings, double smallest_radius,
                                    double largest_radius)
{
  static constexpr double MOST = Lubcontact_NS::RESIDUAL_SIZE_RATIO;
  if (settings.range != Range::RESIDUAL || lmp->comm->me ||
      largest_radius <= MOST * smallest_radius * (1.0 + 1e-9))
    return;
  lmp->error->warning(FLERR,
                      "Radii {:.4g} and {:.4g} differ by more than a factor of {}: pair style "
                      "lubcontact range residual takes the films of that ratio",
                      smallest_radius, largest_radius, MOST);
}

/* ---------------------------------------------------------------------- */

void lubcontact_checks::check_factors(LAMMPS *lmp)
{
  if (utils::strmatch(lmp->force->pair_style, "^hybrid/scaled"))
    lmp->error->all(
        FLERR,
        "Pair style lubcontact cannot be scaled: its stress by origin, its power and the "
        "limit of its time step are those of the full force; use: pair_style "
        "hybrid/overlay");
}

/* ----------------------------------------------------------------------
   a second elastic contact or a second film between the same particles is a mistake
------------------------------------------------------------------------- */

void lubcontact_checks::check_hybrid(LAMMPS *lmp, const Pair *pair, const Law &law)
{
  const char *style = lmp->force->pair_style;
  if (!utils::strmatch(style, "^hybrid/overlay")) return;    // else only one of them acts

  const bool films = law.settings.viscosity > 0.0 && law.settings.films;
  auto warn = [lmp, pair](const char *pattern, const char *what) {
    const Pair *other = companion(lmp, pair, pattern);
    if (other && lmp->comm->me == 0)
      lmp->error->warning(FLERR,
                          "Pair styles lubcontact and {} both act on types {}, so {} act twice; "
                          "lubcontact replaces the other style: remove it",
                          lmp->force->pair_match_ptr(const_cast<Pair *>(other)),
                          shared_types(lmp, pair, other), what);
  };
  warn("^gran", "elastic contacts");
  if (films) warn("^lubricate", "films");
  warn("^lubcontact", "contacts and films");
}

/* ----------------------------------------------------------------------
   LAMMPS' default is one length for all particles in these units, and not in restart files
------------------------------------------------------------------------- */

void lubcontact_checks::check_skin(LAMMPS *lmp, double largest_radius)
{
  const double skin = lmp->neighbor->skin;
  if (lmp->comm->me || !(largest_radius > 0.0) || skin <= LARGEST_SKIN * largest_radius) return;
  lmp->error->warning(
      FLERR,
      "The skin {:.4g} of the neighbor lists is {:.3g} times the largest radius: the "
      "lists are long and slow; use: neighbor {:.3g} bin",
      skin, skin / largest_radius, GOOD_SKIN * largest_radius);
}

/* ---------------------------------------------------------------------- */

void lubcontact_checks::check_motion(LAMMPS *lmp, unsigned effects)
{
  using Lubcontact_NS::FRICTION, Lubcontact_NS::ROLL, Lubcontact_NS::SHEAR, Lubcontact_NS::TWIST;
  const Domain *domain = lmp->domain;
  const Atom *atom = lmp->atom;
  const bool root = lmp->comm->me == 0;
  if (root && domain->deform_flag && !domain->deform_vremap && domain->h_rate[5] != 0.0)
    lmp->error->warning(FLERR,
                        "The cell is sheared, but particles that cross its boundary keep their "
                        "velocity: add to fix deform: remap v");
  const bool turns = effects & (SHEAR | ROLL | TWIST | FRICTION);
  for (const auto &fix : lmp->modify->get_fix_by_style("^nve$")) {
    int mine = 0, any;    // under hybrid it may move points
    for (int i = 0; i < atom->nlocal; i++)
      if ((atom->mask[i] & fix->groupbit) && atom->radius[i] > 0.0) mine = 1;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp->world);
    if (root && turns && any)
      lmp->error->warning(FLERR, "Fix {} nve does not rotate particles: use fix nve/sphere",
                          fix->id);
  }
}

/* ----------------------------------------------------------------------
   e is a share of a velocity that particles keep: without inertia they keep none
------------------------------------------------------------------------- */

void lubcontact_checks::check_restitution(LAMMPS *lmp, unsigned effects)
{
  if (!(effects & Lubcontact_NS::RESTITUTION)) return;
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  const Atom *atom = lmp->atom;
  int mine = 0, any;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & massless) && atom->radius[i] > 0.0) mine = 1;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp->world);
  if (any)
    lmp->error->all(FLERR,
                    "Pair style lubcontact restitution needs particles with inertia, but fix "
                    "overdamped/sphere moves some without: leave restitution out of pair_coeff, or "
                    "use fix nve/sphere");
}

/* ----------------------------------------------------------------------
   history is found by atom ID: a pair must not meet through two images
------------------------------------------------------------------------- */

void lubcontact_checks::check_box(LAMMPS *lmp, double longest)
{
  const Domain *domain = lmp->domain;
  const auto height = Suspension_NS::cell_heights(domain);
  for (int d = 0; d < domain->dimension; d++)
    if (domain->periodicity[d] && height[d] < 2.0 * longest)
      lmp->error->all(
          FLERR,
          "Periodic box height {:.6g} along {} is below twice the range {:.6g} of pair style "
          "lubcontact, so that a pair could meet through two images: enlarge the box, "
          "replicate it, or shorten the range",
          height[d], "xyz"[d], longest);
}

/* ----------------------------------------------------------------------
   NaN positions never trigger a rebuild of the neighbor list, the only place where LAMMPS checks
   for them; and they are out of range of everything
------------------------------------------------------------------------- */

void lubcontact_checks::check_positions(LAMMPS *lmp)
{
  constexpr double LARGEST = std::numeric_limits<double>::max();
  const Atom *atom = lmp->atom;
  const double *x = atom->nlocal ? atom->x[0] : nullptr;    // they are contiguous
  const int size = 3 * atom->nlocal;
  double wrong = 0.0;    // of the type of a position, so that the loop vectorizes
  for (int n = 0; n < size; n++) wrong = fabs(x[n]) <= LARGEST ? wrong : 1.0;
  if (wrong == 0.0) return;
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 3; d++)
      if (!(fabs(atom->x[i][d]) <= LARGEST))
        lmp->error->one(FLERR,
                        "Position {} of atom {} along {} at step {} is not a number: reduce the "
                        "time step, or find the command that set its velocity or force",
                        atom->x[i][d], atom->tag[i], "xyz"[d], lmp -> update -> ntimestep);
}

/* ---------------------------------------------------------------------- */

std::vector<double> lubcontact_checks::find_max_radius(LAMMPS *lmp)
{
  const Atom *atom = lmp->atom;
  const int ntypes = atom->ntypes;
  std::vector<double> mine(ntypes + 1, 0.0), all(ntypes + 1);
  for (const auto &ifix : lmp->modify->get_fix_list()) {
    if (!utils::strmatch(ifix->style, "^pour") && !utils::strmatch(ifix->style, "^deposit"))
      continue;
    for (int itype = 1; itype <= ntypes; itype++) {
      int m = itype;
      const auto *radius = (double *) ifix->extract("radius", m);
      if (radius) mine[itype] = MAX(mine[itype], *radius);
    }
  }
  for (int i = 0; i < atom->nlocal; i++)
    mine[atom->type[i]] = MAX(mine[atom->type[i]], atom->radius[i]);
  MPI_Allreduce(mine.data(), all.data(), ntypes + 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  return all;
}

void lubcontact_checks::check_radii(LAMMPS *lmp, const std::vector<double> &max_radius)
{
  const Atom *atom = lmp->atom;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->radius[i] > max_radius[atom->type[i]])
      lmp->error->one(FLERR,
                      "Radius {} of atom {} exceeds the largest radius {} of its type at the start "
                      "of the run, for which the neighbor list was made; start a new run after it "
                      "grows",
                      atom->radius[i], atom->tag[i], max_radius[atom->type[i]]);
}

/* ---------------------------------------------------------------------- */

double lubcontact_checks::step_limit(LAMMPS *lmp, const std::vector<double> &stiffness)
{
  const Atom *atom = lmp->atom;
  double mine = 0.0, all;
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  for (int i = 0; i < atom->nlocal; i++)
    if (!(atom->mask[i] & massless)) mine = MAX(mine, 2.0 * stiffness[i] / atom->rmass[i]);
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  return all > 0.0 ? 2.0 / sqrt(all * lmp->force->ftm2v) : HUGE_VAL;
}
