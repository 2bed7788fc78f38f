/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "pair_lubcontact_checks.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_lubcontact.h"

#include <algorithm>
#include <functional>

using namespace LAMMPS_NS;

static constexpr double LARGEST_SKIN = 2.0;    // over the largest radius
static constexpr double GOOD_SKIN = 0.3;

namespace {

const double *const *coefficient(PairLubcontact *pair, const char *name)
{
  int dim;
  return static_cast<double **>(pair->extract(name, dim));
}

bool any_pair(LAMMPS *lmp, PairLubcontact *pair, const std::function<bool(int, int)> &has)
{
  const auto *const *g = coefficient(pair, "g");
  const int ntypes = lmp->atom->ntypes;
  for (int i = 1; i <= ntypes; i++)
    for (int j = i; j <= ntypes; j++)
      if (g[i][j] != 0.0 && has(i, j)) return true;    // 0: a pair of another style
  return false;
}

bool has_fluid(const PairLubcontact *pair)
{
  return pair->viscosity() > 0.0;
}

bool any_positive(LAMMPS *lmp, PairLubcontact *pair, const char *name)
{
  const auto *const *value = coefficient(pair, name);
  return any_pair(lmp, pair, [&](int i, int j) {
    return value[i][j] > 0.0;
  });
}

// Is there a pair with friction whose surfaces can touch?
bool any_rubs(LAMMPS *lmp, PairLubcontact *pair)
{
  const auto *const *friction = coefficient(pair, "friction");
  return any_pair(lmp, pair, [&](int i, int j) {
    return friction[i][j] > 0.0 && lubcontact_checks::can_touch(pair, i, j);
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

bool lubcontact_checks::can_touch(PairLubcontact *pair, int i, int j)
{
  return coefficient(pair, "roughness")[i][j] > 0.0 || !pair->uses("squeeze") || !has_fluid(pair);
}

/* ---------------------------------------------------------------------- */

std::string lubcontact_checks::idle(LAMMPS *lmp, PairLubcontact *pair, const std::string &effect)
{
  if (effect == "repulsion") return any_positive(lmp, pair, "repulsion") ? "" : "force 0";
  if (effect == "friction") {
    if (!any_positive(lmp, pair, "friction")) return "coefficient 0";
    return any_rubs(lmp, pair) ? "" : "smooth surfaces do not touch through a film";
  }
  if (!has_fluid(pair)) return "viscosity 0";
  int dim;
  if (effect == "roll" && *static_cast<double *>(pair->extract("rollcoeff", dim)) == 0.0)
    return "coefficient 0";
  return "";
}

/* ----------------------------------------------------------------------
   friction of surfaces that never touch is an error, asperities without height leave what is meant:
   a warning. Fix adapt and a viscosity that is a variable may change either
------------------------------------------------------------------------- */

void lubcontact_checks::check_coefficients(LAMMPS *lmp, PairLubcontact *pair)
{
  if (!lmp->modify->get_fix_by_style("^adapt").empty()) return;
  int dim;
  const bool variable = pair->extract("eta", dim) == nullptr;
  if (!variable && any_positive(lmp, pair, "friction") && !any_rubs(lmp, pair))
    lmp->error->all(
        FLERR,
        "Pair style lubcontact friction cannot act: surfaces of roughness 0 never touch "
        "through a squeeze film; give pair_coeff a roughness > 0, or no friction");

  const auto *const *g = coefficient(pair, "g"), *const *asperity = coefficient(pair, "asperity");
  const bool given = any_pair(lmp, pair, [&](int i, int j) {
    return asperity[i][j] != g[i][j];
  });
  if (given && !any_positive(lmp, pair, "roughness") && lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "Pair style lubcontact asperity does nothing: it is the stiffness of "
                        "asperities, but the roughness is 0");
}

/* ----------------------------------------------------------------------
   a second elastic contact or a second film between the same particles is a mistake
------------------------------------------------------------------------- */

void lubcontact_checks::check_hybrid(LAMMPS *lmp, PairLubcontact *pair)
{
  const char *style = lmp->force->pair_style;
  if (utils::strmatch(style, "^hybrid/scaled"))
    lmp->error->all(
        FLERR,
        "Pair style lubcontact cannot be scaled: its stress by origin, its power and the "
        "limit of its time step are those of the full force; use: pair_style "
        "hybrid/overlay");
  if (!utils::strmatch(style, "^hybrid/overlay")) return;    // else only one of them acts

  const bool films = has_fluid(pair) &&
      (pair->uses("squeeze") || pair->uses("shear") || pair->uses("roll") || pair->uses("twist"));
  auto warn = [lmp, pair](const char *pattern, const char *what) {
    const Pair *other = companion(lmp, pair, pattern);
    if (other && lmp->comm->me == 0)
      lmp->error->warning(FLERR,
                          "Pair styles lubcontact and {} both act on types {}: two {} between the "
                          "same particles; lubcontact replaces the other one, leave that out",
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
