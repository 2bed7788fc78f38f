/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_hydro_field.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "neigh_list.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <numeric>

using namespace LAMMPS_NS;
using namespace Hydro_NS;

const char *const HydroField::NO_LIBRARY =
    "needs the library FFTW, without which this SUSPENSION was built: install it (Debian: "
    "libfftw3-dev) and build again";

/* ---------------------------------------------------------------------- */

HydroField::HydroField(LAMMPS *lmp, Fix *owner) :
    Pointers(lmp), fix(owner), width(1.0), eta(1.0), waves(lmp, WITH_COMPANION)
{
}

HydroField::~HydroField() = default;

bool HydroField::has_library()
{
#ifdef SUSPENSION_FFTW
  return true;
#else
  return false;
#endif
}

/* ---------------------------------------------------------------------- */

void HydroField::prepare(const Settings &settings, int groupbit, double mean_radius,
                         double viscosity, NeighList *list)
{
  width = settings.width * mean_radius;
  eta = viscosity;
  find_members(groupbit);
  waves.fit(settings.spacing * width, settings.points);
  waves.set_response([this](const WaveVector &wave) {
    return gaussian_factors(wave, eta, width);
  });
  waves.reach_for(members);
  on_grid.clear();
  for (const int i : members)
    on_grid.push_back({i, {bodies[i].c_force, bodies[i].c_dipole}, waves.spline(i)});
  find_pairs(settings.reach * width, groupbit, list);
}

/* ---------------------------------------------------------------------- */

void HydroField::find_members(int groupbit)
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  members.clear();
  bodies.resize(nall);
  of_sphere.assign(nlocal, Self{});
  missing.assign(nlocal, Self{});
  for (int i = 0; i < nall; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    bodies[i] = make_body(atom->radius[i], width);
    if (i >= nlocal) continue;
    members.push_back(i);
    of_sphere[i] = sphere_self(atom->radius[i], eta);
    missing[i] = of_sphere[i] - wide_self(bodies[i], width, eta);
  }
  load.assign(static_cast<std::size_t>(nall) * NUMBERS, 0.0);
  motion.assign(load.size(), 0.0);
  loads.assign(nall, Load{});
}

/* ----------------------------------------------------------------------
   the list has pairs within its skin, too
------------------------------------------------------------------------- */

void HydroField::find_pairs(double cut, int groupbit, NeighList *list)
{
  const double *const *x = atom->x;
  const int *mask = atom->mask;
  pairs.clear();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    if (!(mask[i] & groupbit)) continue;
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      if (!(mask[j] & groupbit)) continue;
      const Vec3 d = Lubcontact_NS::get_vector(x[i]) - Lubcontact_NS::get_vector(x[j]);
      if (dot(d, d) < cut * cut)
        add_to(pairs, i, j, missing_response(d, bodies[i], bodies[j], width));
    }
  }
}

/* ---------------------------------------------------------------------- */

void HydroField::apply(const double *in, double *out)
{
  const std::size_t size = static_cast<std::size_t>(atom->nlocal) * NUMBERS;
  std::copy_n(in, size, load.data());
  comm->forward_comm(fix);
  for (std::size_t i = 0; i < loads.size(); i++) loads[i] = get_load(&load[i * NUMBERS]);
  motions.assign(loads.size(), Motion{});
  add_pairs(pairs, 1.0 / (8.0 * PI * eta), loads.data(), motions.data());
  add_far();
  std::fill(motion.begin(), motion.end(), 0.0);
  for (std::size_t i = 0; i < motions.size(); i++) add_motion(motions[i], &motion[i * NUMBERS]);
  comm->reverse_comm(fix);
  for (const int i : members) add_self(missing[i], &load[i * NUMBERS], &motion[i * NUMBERS]);
  std::copy_n(motion.data(), size, out);
}

/* ----------------------------------------------------------------------
   to the grid and back
------------------------------------------------------------------------- */

void HydroField::add_far()
{
  std::fill(waves.field.begin(), waves.field.end(), 0.0);
  spread_all<WITH_COMPANION>(on_grid, waves.gradients(), waves.brick(), loads.data(),
                             waves.field.data());
  waves.solve();
  interpolate_all<WITH_COMPANION>(on_grid, waves.gradients(), waves.brick(), waves.field.data(),
                                  motions.data());
}

/* ---------------------------------------------------------------------- */

int HydroField::pack_loads(int n, const int *list, double *buf) const
{
  for (int k = 0; k < n; k++) std::copy_n(&load[list[k] * NUMBERS], NUMBERS, buf + k * NUMBERS);
  return n * NUMBERS;
}

void HydroField::unpack_loads(int n, int first, const double *buf)
{
  std::copy_n(buf, n * NUMBERS, load.begin() + first * NUMBERS);
}

int HydroField::pack_motions(int n, int first, double *buf) const
{
  std::copy_n(motion.begin() + first * NUMBERS, n * NUMBERS, buf);
  return n * NUMBERS;
}

void HydroField::unpack_motions(int n, const int *list, const double *buf)
{
  for (int k = 0; k < n; k++)
    for (int m = 0; m < NUMBERS; m++) motion[list[k] * NUMBERS + m] += buf[k * NUMBERS + m];
}

/* ---------------------------------------------------------------------- */

double HydroField::memory_usage() const
{
  return waves.memory_usage() +
      static_cast<double>(pairs.capacity() * sizeof(PairBlock) +
                          on_grid.capacity() * sizeof(OnGrid) + bodies.capacity() * sizeof(Body) +
                          2 * missing.capacity() * sizeof(Self) +
                          (load.capacity() + motion.capacity()) * sizeof(double) +
                          loads.capacity() * (sizeof(Load) + sizeof(Motion)));
}
