/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_hydro_precondition.h"

#include "atom.h"
#include "domain.h"
#include "fix_hydro_field.h"
#include "hydro_hold.h"
#include "hydro_precondition.h"
#include "suspension_host.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace Hydro_NS;

/* ---------------------------------------------------------------------- */

HydroPreconditioner::HydroPreconditioner(LAMMPS *lmp) :
    Pointers(lmp), waves(lmp, VECTOR), fraction(0.0)
{
}

/* ---------------------------------------------------------------------- */

void HydroPreconditioner::prepare(const HydroField &field, double mean_radius)
{
  waves.fit(COARSE_SPACING * mean_radius, COARSE_POINTS);
  waves.reach_for(field.particles());
  loads.resize(atom->nlocal);
  members.clear();
  selves.clear();
  double mine[2] = {}, all[2];
  for (const int i : field.particles()) {
    members.push_back({i, {}, waves.spline(i)});
    selves.push_back(field.self(i));
    mine[0] += Suspension_NS::particle_volume(domain, atom->radius[i]);
    mine[1] += 1.0 / field.self(i).translation;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  fraction = all[0] / Suspension_NS::cell_volume(domain);
  find_weights(mean_radius, all[1]);
}

void HydroPreconditioner::through_grid()
{
  motions.assign(loads.size(), Motion{});
  std::fill(waves.field.begin(), waves.field.end(), 0.0);
  spread_all<VECTOR>(members, waves.gradients(), waves.brick(), loads.data(), waves.field.data());
  waves.solve();
  interpolate_all<VECTOR>(members, waves.gradients(), waves.brick(), waves.field.data(),
                          motions.data());
}

/* ----------------------------------------------------------------------
   the density of resistance about a sphere is that of the whole cell if all are alike
------------------------------------------------------------------------- */

void HydroPreconditioner::find_weights(double mean_radius, double resistance)
{
  const Screening screening{fraction};
  const double per_resistance = waves.lattice().volume() / resistance;
  waves.set_response([&](const WaveVector &wave) {
    const double f = per_resistance * screening.smoothing(std::sqrt(wave.square) * mean_radius);
    return WaveFactors{f, f};
  });
  for (std::size_t n = 0; n < members.size(); n++)
    loads[members[n].atom] = {{1.0 / selves[n].translation, 0.0, 0.0}, {}};
  through_grid();
  weights.clear();
  for (const OnGrid &m : members) weights.push_back(coarse_weight(motions[m.atom].velocity.x));

  waves.set_response([&](const WaveVector &wave) {
    const WaveFactors f = screening.factors(std::sqrt(wave.square) * mean_radius);
    return WaveFactors{per_resistance * f.across, per_resistance * f.along};
  });
}

/* ----------------------------------------------------------------------
   size of a sphere: the mean by volume
------------------------------------------------------------------------- */

std::vector<double> HydroPreconditioner::find_neighborhoods()
{
  double mine[2] = {}, all[2];
  for (const OnGrid &m : members) {
    const double volume = Suspension_NS::particle_volume(domain, atom->radius[m.atom]);
    mine[0] += volume;
    mine[1] += volume * atom->radius[m.atom];
    loads[m.atom] = {{volume, 0.0, 0.0}, {}};
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  const double size = all[0] > 0.0 ? all[1] / all[0] : 0.0;
  waves.set_response([&](const WaveVector &wave) {
    const double f = neighborhood(std::sqrt(wave.square) * size);
    return WaveFactors{f, f};
  });
  through_grid();
  std::vector<double> found;
  for (const OnGrid &m : members) found.push_back(motions[m.atom].velocity.x);
  return found;
}

/* ---------------------------------------------------------------------- */

void HydroPreconditioner::apply_alone(const double *velocities, double *found) const
{
  std::fill_n(found, static_cast<std::size_t>(atom->nlocal) * NUMBERS, 0.0);
  for (std::size_t n = 0; n < members.size(); n++) {
    const std::size_t first = static_cast<std::size_t>(members[n].atom) * NUMBERS;
    add_resistance(selves[n], velocities + first, found + first);
  }
}

void HydroPreconditioner::apply(const double *velocities, double *found)
{
  apply_alone(velocities, found);
  for (std::size_t n = 0; n < members.size(); n++) {
    const int i = members[n].atom;
    double load[NUMBERS];
    std::copy_n(found + static_cast<std::size_t>(i) * NUMBERS, NUMBERS, load);
    weigh_coarse(weights[n], load);
    loads[i] = get_load(load);
  }
  through_grid();
  for (std::size_t n = 0; n < members.size(); n++) {
    const int i = members[n].atom;
    double motion[NUMBERS] = {};
    add_motion(motions[i], motion);
    weigh_coarse(weights[n], motion);
    add_resistance(selves[n], motion, found + static_cast<std::size_t>(i) * NUMBERS);
  }
}

/* ---------------------------------------------------------------------- */

double HydroPreconditioner::memory_usage() const
{
  return waves.memory_usage() +
      static_cast<double>(members.capacity() * (sizeof(OnGrid) + sizeof(Self) + sizeof(double)) +
                          loads.capacity() * (sizeof(Load) + sizeof(Motion)));
}
