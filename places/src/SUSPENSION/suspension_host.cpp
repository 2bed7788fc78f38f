/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "suspension_host.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "math_const.h"
#include "modify.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using MathConst::MY_PI;

/* ---------------------------------------------------------------------- */

std::vector<Pair *> Suspension_NS::all_lubcontact(LAMMPS *lmp)
{
  Force *force = lmp->force;
  std::vector<Pair *> found;
  if (Pair *only = force->pair_match("^lubcontact", 0)) return {only};
  for (int nsub = 1; Pair *pair = force->pair_match("^lubcontact", 0, nsub); nsub++)
    found.push_back(pair);    // several under hybrid
  return found;
}

/* ---------------------------------------------------------------------- */

const double *Suspension_NS::viscosity_of_pair(LAMMPS *lmp)
{
  const double *found = nullptr;
  int dim;
  for (Pair *pair : all_lubcontact(lmp)) {
    const auto *eta = static_cast<const double *>(pair->extract("eta", dim));
    if (!eta || (found && *found != *eta)) return nullptr;
    found = eta;
  }
  return found;
}

std::string Suspension_NS::why_no_viscosity(LAMMPS *lmp)
{
  const auto pairs = all_lubcontact(lmp);
  if (pairs.empty()) return "there is no pair style lubcontact";
  std::string values;
  int dim;
  for (Pair *pair : pairs) {
    const auto *eta = static_cast<const double *>(pair->extract("eta", dim));
    if (!eta) return "the viscosity of pair style lubcontact is a variable";
    values += fmt::format("{}{}", values.empty() ? "" : " and ", *eta);
  }
  return "the sub-styles lubcontact have different viscosities, " + values;
}

/* ---------------------------------------------------------------------- */

int Suspension_NS::groups_without_inertia(LAMMPS *lmp)
{
  int bits = 0;
  for (const auto &fix : lmp->modify->get_fix_by_style("^overdamped")) bits |= fix->groupbit;
  return bits;
}

/* ---------------------------------------------------------------------- */

double Suspension_NS::cell_volume(const Domain *domain)
{
  const double area = domain->xprd * domain->yprd;
  return domain->dimension == 3 ? area * domain->zprd : area;
}

double Suspension_NS::particle_volume(const Domain *domain, double radius)
{
  return domain->dimension == 3 ? 4.0 / 3.0 * MY_PI * radius * radius * radius
                                : MY_PI * radius * radius;
}

/* ---------------------------------------------------------------------- */

Suspension_NS::Particles Suspension_NS::measure_particles(LAMMPS *lmp)
{
  const Atom *atom = lmp->atom;
  double mine[4] = {}, sum[4];                              // number, mass, radii, volume
  double mine_most[2] = {-HUGE_VAL, -HUGE_VAL}, most[2];    // radius, minus radius
  for (int i = 0; i < atom->nlocal; i++) {
    const double r = atom->radius[i];
    if (r == 0.0) continue;
    const double values[4] = {1.0, atom->rmass[i], r, 4.0 / 3.0 * MY_PI * r * r * r};
    for (int n = 0; n < 4; n++) mine[n] += values[n];
    mine_most[0] = MAX(mine_most[0], r);
    mine_most[1] = MAX(mine_most[1], -r);
  }
  MPI_Allreduce(mine, sum, 4, MPI_DOUBLE, MPI_SUM, lmp->world);
  MPI_Allreduce(mine_most, most, 2, MPI_DOUBLE, MPI_MAX, lmp->world);
  if (sum[0] == 0.0) return {};
  return {sum[0], sum[1], -most[1], most[0], sum[2] / sum[0], sum[1] / sum[3]};
}

/* ---------------------------------------------------------------------- */

std::array<double, 3> Suspension_NS::cell_heights(const Domain *domain)
{
  const double *hi = domain->h_inv;
  return {1.0 / sqrt(hi[0] * hi[0] + hi[5] * hi[5] + hi[4] * hi[4]),
          1.0 / sqrt(hi[1] * hi[1] + hi[3] * hi[3]), 1.0 / hi[2]};
}

/* ----------------------------------------------------------------------
   (rate of h)/h, in the order xx yy zz yz xz xy
------------------------------------------------------------------------- */

Suspension_NS::CellGradient Suspension_NS::cell_gradient(const Domain *domain)
{
  CellGradient l;
  if (!domain->deform_flag) return l;
  const double *rate = domain->h_rate, *inv = domain->h_inv;
  l.xx = rate[0] * inv[0];
  l.yy = rate[1] * inv[1];
  l.zz = rate[2] * inv[2];
  l.xy = rate[0] * inv[5] + rate[5] * inv[1];
  l.yz = rate[1] * inv[3] + rate[3] * inv[2];
  l.xz = rate[0] * inv[4] + rate[5] * inv[3] + rate[4] * inv[2];
  return l;
}

Lubcontact_NS::Strain Suspension_NS::cell_strain(const Domain *domain)
{
  const CellGradient l = cell_gradient(domain);
  return Lubcontact_NS::strain_of_gradient(l.xx, l.yy, l.zz, l.xy, l.xz, l.yz);
}

Suspension_NS::CellFlow::CellFlow(const Domain *domain)
{
  if (!domain->deform_flag) return;
  gradient = cell_gradient(domain);
  std::copy_n(domain->boxlo, 3, origin.begin());
  std::copy_n(domain->h_ratelo, 3, at_origin.begin());
}

/* ---------------------------------------------------------------------- */

void Suspension_NS::require_spheres(LAMMPS *lmp, const std::string &who)
{
  const Atom *atom = lmp->atom;
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    lmp->error->all(FLERR, "{} needs finite-size spheres; use: atom_style sphere", who);
}

void Suspension_NS::require_verlet(LAMMPS *lmp, const std::string &who)
{
  if (utils::strmatch(lmp->update->integrate_style, "^respa"))
    lmp->error->all(FLERR, "{} does not work with run_style respa; use: run_style verlet", who);
}
