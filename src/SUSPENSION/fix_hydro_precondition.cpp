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

HydroPreconditioner::HydroPreconditioner(LAMMPS *lmp) : Pointers(lmp), waves(lmp), fraction(0.0) {}

/* ---------------------------------------------------------------------- */

void HydroPreconditioner::prepare(const HydroField &field, double mean_radius)
{
  waves.fit(COARSE_SPACING * mean_radius);
  const Hydro_NS::Lattice &lattice = waves.lattice();
  gradients = lattice_gradients(lattice);
  Vec3 low, high;
  const bool any = waves.corners(field.particles(), low, high);
  waves.set_brick(any ? spline_brick(low, high) : Brick{});

  members.clear();
  double mine[2] = {}, all[2];
  for (const int i : field.particles()) {
    members.push_back(
        {i, 1.0, field.self(i), spline_at(lattice, Lubcontact_NS::get_vector(atom->x[i]))});
    mine[0] += Suspension_NS::particle_volume(domain, atom->radius[i]);
    mine[1] += 1.0 / field.self(i).translation;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  fraction = all[0] / Suspension_NS::cell_volume(domain);
  find_weights(mean_radius, all[1]);
}

/* ----------------------------------------------------------------------
   what makes a density of what is spread and interpolated, times the volume of the cell
------------------------------------------------------------------------- */

double HydroPreconditioner::density_factor(const WaveVector &wave) const
{
  const Hydro_NS::Lattice &grid = waves.lattice();
  const double t = spline_wave(wave.number[0], grid.nx) * spline_wave(wave.number[1], grid.ny) *
      spline_wave(wave.number[2], grid.nz);
  return static_cast<double>(grid.points()) / (t * t);
}

/* ----------------------------------------------------------------------
   the density of resistance about a sphere is that of the whole cell if all are alike
------------------------------------------------------------------------- */

void HydroPreconditioner::find_weights(double mean_radius, double resistance)
{
  const Screening screening{fraction};
  const auto on_grid = [&](const WaveVector &wave) {
    return density_factor(wave) / resistance;
  };
  waves.set_response([&](const WaveVector &wave) {
    const double f = on_grid(wave) * screening.smoothing(std::sqrt(wave.square) * mean_radius);
    return WaveFactors{f, f};
  });
  std::fill(waves.field.begin(), waves.field.end(), 0.0);
  for (const Member &m : members)
    spread(m.spline, gradients, waves.brick(), {{1.0 / m.self.translation, 0.0, 0.0}, {}},
           waves.field.data());
  waves.solve();
  for (Member &m : members)
    m.weight = coarse_weight(
        interpolate(m.spline, gradients, waves.brick(), waves.field.data()).velocity.x);

  waves.set_response([&](const WaveVector &wave) {
    const WaveFactors f = screening.factors(std::sqrt(wave.square) * mean_radius);
    return WaveFactors{on_grid(wave) * f.across, on_grid(wave) * f.along};
  });
}

/* ----------------------------------------------------------------------
   size of a sphere: the mean by volume
------------------------------------------------------------------------- */

std::vector<double> HydroPreconditioner::find_neighborhoods()
{
  const Hydro_NS::Lattice &grid = waves.lattice();
  double mine[2] = {}, all[2];
  for (const Member &m : members) {
    const double volume = Suspension_NS::particle_volume(domain, atom->radius[m.atom]);
    mine[0] += volume;
    mine[1] += volume * atom->radius[m.atom];
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  const double size = all[0] > 0.0 ? all[1] / all[0] : 0.0;
  waves.set_response([&](const WaveVector &wave) {
    const double f =
        density_factor(wave) / grid.volume() * neighborhood(std::sqrt(wave.square) * size);
    return WaveFactors{f, f};
  });
  std::fill(waves.field.begin(), waves.field.end(), 0.0);
  for (const Member &m : members)
    spread(m.spline, gradients, waves.brick(),
           {{Suspension_NS::particle_volume(domain, atom->radius[m.atom]), 0.0, 0.0}, {}},
           waves.field.data());
  waves.solve();
  std::vector<double> found;
  for (const Member &m : members)
    found.push_back(interpolate(m.spline, gradients, waves.brick(), waves.field.data()).velocity.x);
  return found;
}

/* ---------------------------------------------------------------------- */

void HydroPreconditioner::apply_alone(const double *motions, double *loads) const
{
  std::fill_n(loads, static_cast<std::size_t>(atom->nlocal) * NUMBERS, 0.0);
  for (const Member &m : members)
    add_resistance(m.self, motions + m.atom * NUMBERS, loads + m.atom * NUMBERS);
}

void HydroPreconditioner::apply(const double *motions, double *loads)
{
  apply_alone(motions, loads);
  std::fill(waves.field.begin(), waves.field.end(), 0.0);
  for (const Member &m : members) {
    double load[NUMBERS];
    std::copy_n(loads + m.atom * NUMBERS, NUMBERS, load);
    weigh_coarse(m.weight, load);
    spread(m.spline, gradients, waves.brick(), get_load(load), waves.field.data());
  }
  waves.solve();
  for (const Member &m : members) {
    double motion[NUMBERS] = {};
    add_motion(interpolate(m.spline, gradients, waves.brick(), waves.field.data()), motion);
    weigh_coarse(m.weight, motion);
    add_resistance(m.self, motion, loads + m.atom * NUMBERS);
  }
}

/* ---------------------------------------------------------------------- */

double HydroPreconditioner::memory_usage() const
{
  return waves.memory_usage() + static_cast<double>(members.capacity() * sizeof(Member));
}
