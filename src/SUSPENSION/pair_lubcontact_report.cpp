/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What pair style lubcontact checks and reports at the start of a run.

#include "pair_lubcontact.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "lubcontact_pair.h"
#include "lubcontact_stiffness.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair_lubcontact_checks.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   largest radius of each type, those that fix pour and deposit will insert included
------------------------------------------------------------------------- */

void PairLubcontact::find_max_radius()
{
  const int ntypes = atom->ntypes;
  std::vector<double> mine(ntypes + 1, 0.0);
  for (const auto &ifix : modify->get_fix_list()) {
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
  MPI_Allreduce(mine.data(), max_radius, ntypes + 1, MPI_DOUBLE, MPI_MAX, world);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::check_radii() const
{
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->radius[i] > max_radius[atom->type[i]])
      error->one(FLERR,
                 "Radius {} of atom {} exceeds the largest radius {} of its type at the start of "
                 "the run, for which the neighbor list was made; start a new run after it grows",
                 atom->radius[i], atom->tag[i], max_radius[atom->type[i]]);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::overlap_error(int i, int j, double un) const
{
  error->one(FLERR,
             "Atoms {} and {} overlap by {:.4g} effective radii at step {}: reduce the time step, "
             "stiffen the contact, or separate the particles first",
             atom->tag[i], atom->tag[j], -un, update->ntimestep);
}

/* ----------------------------------------------------------------------
   history is found by atom ID: a pair must not meet through two images
------------------------------------------------------------------------- */

void PairLubcontact::check_box() const
{
  const auto height = Suspension_NS::cell_heights(domain);
  for (int d = 0; d < domain->dimension; d++)
    if (domain->periodicity[d] && height[d] < 2.0 * longest)
      error->all(
          FLERR,
          "Periodic box height {:.6g} along {} is below twice the range {:.6g} of pair style "
          "lubcontact, so that a pair could meet through two images: enlarge the box, "
          "replicate it, or shorten the range",
          height[d], "xyz"[d], longest);
}

/* ----------------------------------------------------------------------
   sum over the partners of each owned atom of the stiffest mode of a pair, particles turning as
   easily as spin says, or of each if that is given. Returns the number of pairs in range on this rank
------------------------------------------------------------------------- */

double PairLubcontact::sum_stiffness(double spin, double each)
{
  const int nlocal = atom->nlocal;
  stiffness.assign(nlocal + atom->nghost, 0.0);
  double pairs = 0.0;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const double *xi = atom->x[i];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const int itype = atom->type[i], jtype = atom->type[j];
      const double *xj = atom->x[j];
      const double ri = atom->radius[i], rj = atom->radius[j], a = effective_radius(ri, rj);
      const auto geometry =
          Lubcontact_NS::pair_geometry({xi[0], xi[1], xi[2]}, {xj[0], xj[1], xj[2]}, ri, rj, a);
      if (!acts(i, jj, geometry.un, a)) continue;
      Lubcontact_NS::PairStiffness k{each, each};
      if (each == 0.0)
        k = Lubcontact_NS::pair_stiffness(g[itype][jtype], kt[itype][jtype], spin, geometry, ri, rj,
                                          mode[ROLL], mode[TWIST]);
      stiffness[i] += k.i;
      stiffness[j] += k.j;
      pairs += force->newton_pair || j < nlocal ? 1.0 : 0.5;
    }
  }
  if (force->newton_pair) comm->reverse_comm(this);
  return pairs;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::count_partners(std::vector<double> &sum)
{
  sum_stiffness(0.0, 1.0);
  sum.swap(stiffness);
}

void PairLubcontact::sum_stiffness_overdamped(double spin, std::vector<double> &sum)
{
  sum_stiffness(spin, 0.0);
  sum.swap(stiffness);
}

/* ---------------------------------------------------------------------- */

int PairLubcontact::pack_reverse_comm(int n, int first, double *buf)
{
  for (int m = 0; m < n; m++) buf[m] = stiffness[first + m];
  return n;
}

void PairLubcontact::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int m = 0; m < n; m++) stiffness[list[m]] += buf[m];
}

/* ----------------------------------------------------------------------
   largest stable time step of the springs: omega_max^2 <= 2 max_i sum_j k_ij/m_i (Gershgorin)
------------------------------------------------------------------------- */

double PairLubcontact::time_step_limit() const
{
  double mine = 0.0, all;
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  for (int i = 0; i < atom->nlocal; i++)
    if (!(atom->mask[i] & massless)) mine = MAX(mine, 2.0 * stiffness[i] / atom->rmass[i]);
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all > 0.0 ? 2.0 / sqrt(all * force->ftm2v) : HUGE_VAL;
}

/* ----------------------------------------------------------------------
   those with a radius; under hybrid others are points
------------------------------------------------------------------------- */

namespace {
struct Particles {
  double number, smallest, largest, mean;    // radii; 0 without particles
  double density;                            // mean
};

Particles find_particles(LAMMPS *lmp)
{
  const Atom *atom = lmp->atom;
  double mine[4] = {}, sum[4];                              // number, mass, radii, volume
  double mine_most[2] = {-HUGE_VAL, -HUGE_VAL}, most[2];    // radius, minus radius
  for (int i = 0; i < atom->nlocal; i++) {
    const double r = atom->radius[i];
    if (r == 0.0) continue;
    const double values[4] = {1.0, atom->rmass[i], r, 4.0 / 3.0 * Lubcontact_NS::PI * r * r * r};
    for (int n = 0; n < 4; n++) mine[n] += values[n];
    mine_most[0] = MAX(mine_most[0], r);
    mine_most[1] = MAX(mine_most[1], -r);
  }
  MPI_Allreduce(mine, sum, 4, MPI_DOUBLE, MPI_SUM, lmp->world);
  MPI_Allreduce(mine_most, most, 2, MPI_DOUBLE, MPI_MAX, lmp->world);
  if (sum[0] == 0.0) return {};
  return {sum[0], -most[1], most[0], sum[2] / sum[0], sum[1] / sum[3]};
}

std::string flow_text(const Particles &p, double rate, double eta, double g, double ftm2v)
{
  std::string text = fmt::format("  shear rate     {:.6g}, Ca = eta rate a/g = {:.3g}", rate,
                                 eta * fabs(rate) * p.mean / g);
  if (eta > 0.0)
    text += fmt::format(", St = rho a^2 rate/eta = {:.3g}",
                        p.density * p.mean * p.mean * fabs(rate) / (eta * ftm2v));
  return text + ", a = mean radius\n";
}
}    // namespace

/* ---------------------------------------------------------------------- */

void PairLubcontact::setup()
{
  check_box();
  update_viscosity();
  tessellate();
  const double mine = sum_stiffness(Lubcontact_NS::SPIN_OF_INERTIA, 0.0);
  double pairs;
  MPI_Allreduce(&mine, &pairs, 1, MPI_DOUBLE, MPI_SUM, world);
  const auto all = PairLubcontact::all(lmp);    // a particle feels the springs of every sub-style
  for (PairLubcontact *other : all) {
    if (other == this) continue;
    other->tessellate();    // its own set-up may come later
    other->sum_stiffness(Lubcontact_NS::SPIN_OF_INERTIA, 0.0);
    for (int i = 0; i < atom->nlocal; i++) stiffness[i] += other->stiffness[i];
  }
  const double limit = dt_limit = time_step_limit();
  double mass = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->radius[i] > 0.0) mass += atom->rmass[i];
  MPI_Allreduce(&mass, &dt_limit_mass, 1, MPI_DOUBLE, MPI_SUM, world);
  warned_dt = this != all.front();    // one speaks for all
  reset_dt();
  lubcontact_checks::check_skin(lmp,
                                *std::max_element(max_radius + 1, max_radius + atom->ntypes + 1));
  if (!reported) {
    lubcontact_checks::check_hybrid(lmp, this);
    lubcontact_checks::check_coefficients(lmp, this);
    check_motion();
    report(pairs, limit);
  }
  reported = dt_limit_mass > 0.0;    // again when there are particles
}

/* ----------------------------------------------------------------------
   also when fix dt/reset has changed the step; not between runs, when the limit may be an old one
------------------------------------------------------------------------- */

void PairLubcontact::reset_dt()
{
  if (warned_dt || update->whichflag == 0 || dt_limit <= 0.0 || update->dt <= dt_limit) return;
  warned_dt = true;
  if (comm->me == 0)
    error->warning(FLERR,
                   "Time step {} exceeds {:.4g}, the stability limit of the contact springs in the "
                   "state at the start of the run: reduce it, or soften the contact",
                   update->dt, dt_limit);
}

/* ----------------------------------------------------------------------
   a repulsion that has not died out where pairs come into range: its force would jump there
------------------------------------------------------------------------- */

void PairLubcontact::check_repulsion(double smallest) const
{
  static constexpr double MOST = 1e-3;    // of the force at closed gap
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (g[i][j] == 0.0 || repulsion[i][j] == 0.0) continue;
      const double left = exp(-hc * smallest / screening[i][j]);
      if (left > MOST)
        error->warning(FLERR,
                       "Repulsion of types {} {} still has {:.3g} of its force at the end of the "
                       "range {} of pair style lubcontact, where it jumps: extend the range",
                       i, j, left, hc);
    }
}

/* ----------------------------------------------------------------------
   what moves the particles in a way that the pair style cannot mean
------------------------------------------------------------------------- */

void PairLubcontact::check_motion() const
{
  const bool root = comm->me == 0;
  if (root && domain->deform_flag && !domain->deform_vremap && domain->h_rate[5] != 0.0)
    error->warning(FLERR,
                   "The cell is sheared, but particles that cross its boundary keep their "
                   "velocity: add to fix deform: remap v");
  const bool turns = mode[SHEAR] || mode[ROLL] || mode[TWIST] || (mask & Lubcontact_NS::FRICTION);
  for (const auto &fix : modify->get_fix_by_style("^nve$")) {
    int mine = 0, any;    // under hybrid it may move points
    for (int i = 0; i < atom->nlocal; i++)
      if ((atom->mask[i] & fix->groupbit) && atom->radius[i] > 0.0) mine = 1;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    if (root && turns && any)
      error->warning(FLERR, "Fix {} nve does not turn particles: use fix nve/sphere", fix->id);
  }
}

/* ----------------------------------------------------------------------
   table: what this run simulates
------------------------------------------------------------------------- */

void PairLubcontact::report(double pairs, double limit)
{
  const Particles p = find_particles(lmp);
  double softest = HUGE_VAL;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      if (g[i][j] != 0.0) softest = MIN(softest, g[i][j]);
  if (comm->me) return;
  if (p.number > 0.0) check_repulsion(p.smallest);

  auto state = [this](const char *effect, bool on, const std::string &more) {
    const std::string idle = on ? lubcontact_checks::idle(lmp, this, effect) : "";
    return !on ? "no" : idle.empty() ? "yes" + more : "not now: " + idle;
  };
  std::string text = "Pair style lubcontact: what this run simulates\n";
  text += fmt::format("  squeeze film   {}\n",
                      state("squeeze", mode[SQUEEZE], euler ? ", gap euler" : ", gap exponential"));
  text += fmt::format("  shear film     {}\n", state("shear", mode[SHEAR], ""));
  text += fmt::format("  rolling film   {}\n",
                      state("roll", mode[ROLL], fmt::format(", coefficient {:.6g}", roll_coeff)));
  text += fmt::format("  twisting film  {}\n", state("twist", mode[TWIST], ""));
  text +=
      fmt::format("  friction       {}\n", state("friction", mask & Lubcontact_NS::FRICTION, ""));
  text += fmt::format("  adhesion       {}\n", mask & Lubcontact_NS::ADHESION ? "yes" : "no");
  text +=
      fmt::format("  repulsion      {}\n", state("repulsion", mask & Lubcontact_NS::REPULSION, ""));
  text += fmt::format("  range          {} {:.6g} effective radii, radius {}\n",
                      Lubcontact_NS::RANGE_NAME[range_rule], hc, radius_rule ? "harmonic" : "mean");
  text += fmt::format("  viscosity      {:.6g}{}\n", eta,
                      eta_name ? fmt::format(" now, variable {}", eta_name)
                               : (eta == 0.0 ? ": dry grains" : ""));
  text += p.number == 0.0
      ? std::string("  particles      none yet")
      : fmt::format("  particles      {}, radius {:.6g} to {:.6g}, mean {:.6g}, {:.6g} pairs in "
                    "range",
                    p.number, p.smallest, p.largest, p.mean, pairs);
  text += fmt::format(", {} doubles of history a pair\n", size_history);
  const int shown = MIN(atom->ntypes, 4);
  for (int i = 1; i <= shown; i++)
    for (int j = i; j <= shown; j++) {
      if (g[i][j] == 0.0) continue;
      const bool rubs = friction[i][j] == 0.0 || lubcontact_checks::can_touch(this, i, j);
      text += fmt::format("  types {} {}      g {:.6g} kt {:.6g} {}{}\n", i, j, g[i][j], kt[i][j],
                          coeff_words(i, j, {}), rubs ? "" : ": smooth, does not rub");
    }
  if (shown < atom->ntypes) text += "  further types: see write_data pair ij\n";
  text += fmt::format("  time step      {:.6g}, ", update->dt);
  text += std::isfinite(limit)
      ? fmt::format("{:.3g} of the stability limit {:.6g}\n", update->dt / limit, limit)
      : "without limit here: no pair in range of particles with inertia\n";

  if (shear_rate() != 0.0 && p.number > 0.0)
    text += flow_text(p, shear_rate(), eta, softest, force->ftm2v);
  utils::logmesg(lmp, text);
}

/* ----------------------------------------------------------------------
   of the cell, if a fix deform shears it
------------------------------------------------------------------------- */

double PairLubcontact::shear_rate() const
{
  return domain->triclinic && domain->deform_flag ? domain->h_rate[5] / domain->yprd : 0.0;
}
