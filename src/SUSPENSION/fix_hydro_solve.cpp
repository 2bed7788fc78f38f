/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The loads of fix hydro grid: the solution of a linear system.

#include "fix_hydro_grid.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_hydro_held.h"
#include "fix_hydro_settings.h"
#include "hydro_hold.h"
#include "neighbor.h"
#include "pore_cg.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>
#include <vector>

using namespace LAMMPS_NS;
using namespace Hydro_NS;
using Lubcontact_NS::get_vector;

static constexpr int MOST_ITERATIONS = 500;

/* ----------------------------------------------------------------------
   M (F, T, S) = (v', w', -E). Lengths in widths, so that all numbers have the same unit
------------------------------------------------------------------------- */

void HydroGrid::solve(double tolerance)
{
  const int groupbit = fix->groupbit;
  state.viscosity = fluid->viscosity_now();
  neighbor->build_one(list);
  field->prepare(settings->field, groupbit, state.radius, state.viscosity, list);

  const int nlocal = atom->nlocal;
  const std::size_t size = static_cast<std::size_t>(nlocal) * NUMBERS;
  const double length = field->length();
  double e[5], volume = 0.0;
  find_strain(e);
  std::vector<double> right(size, 0.0), x(size, 0.0), scaled(size);
  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    volume += Suspension_NS::particle_volume(domain, atom->radius[i]);
    const Fluid_NS::Flow flow = fluid->flow_at(i);
    double *h = held[i], *b = &right[i * NUMBERS];
    Lubcontact_NS::put_vector(get_vector(atom->v[i]) - flow.velocity, h + MOTION);
    Lubcontact_NS::put_vector(get_vector(atom->omega[i]) - flow.spin, h + MOTION + 3);
    for (int n = 0; n < 3; n++) b[n] = h[MOTION + n];
    for (int n = 3; n < 6; n++) b[n] = length * h[MOTION + n];
    for (int n = 6; n < NUMBERS; n++) b[n] = -length * e[n - 6];
    // from the last two solutions
    const double again = state.solutions > 0.0 ? 1.0 : 0.0,
                 slope = state.solutions > 1.0 ? 1.0 : 0.0;
    for (int n = 0; n < NUMBERS; n++)
      x[i * NUMBERS + n] =
          (again * h[LOAD + n] + slope * (h[LOAD + n] - h[BEFORE + n])) / (n < 3 ? 1.0 : length);
  }
  const auto scale = [&](const std::vector<double> &from, std::vector<double> &to) {
    to.resize(size);
    for (std::size_t n = 0; n < size; n++) to[n] = from[n] * (n % NUMBERS < 3 ? 1.0 : length);
  };
  const auto apply = [&](const std::vector<double> &loads, std::vector<double> &motions) {
    motions.resize(size);
    scale(loads, scaled);
    field->apply(scaled.data(), motions.data());
    scale(motions, motions);
  };
  const auto precondition = [&](const std::vector<double> &r, std::vector<double> &z) {
    z.assign(size, 0.0);
    for (int i = 0; i < nlocal; i++) {
      if (!(atom->mask[i] & groupbit)) continue;
      const Hydro_NS::Self &self = field->self(i);
      for (int n = 0; n < NUMBERS; n++) {
        const double turn = n < 6 ? self.rotation : self.strain;
        z[i * NUMBERS + n] =
            r[i * NUMBERS + n] / (n < 3 ? self.translation : turn * length * length);
      }
    }
  };
  const auto product = [this](const std::vector<double> &a, const std::vector<double> &b) {
    const double mine = Pore_NS::scalar_product(a, b);
    double all;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
  };
  const auto found = Pore_NS::solve_by_products(apply, precondition, product, right, tolerance,
                                                MOST_ITERATIONS, x);
  state.iterations = found.iterations;
  state.residual = found.residual;
  if (!(found.residual <= tolerance) && comm->me == 0)
    error->warning(FLERR, "Fix hydro: residual {:.3g} after {} iterations at step {}",
                   found.residual, found.iterations, update->ntimestep);

  scale(x, x);
  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    std::copy_n(held[i] + LOAD, NUMBERS, held[i] + BEFORE);
    std::copy_n(&x[i * NUMBERS], NUMBERS, held[i] + LOAD);
  }
  double all;
  MPI_Allreduce(&volume, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  state.phi = all / Suspension_NS::cell_volume(domain);
  const Hydro_NS::Hold automatic = Hydro_NS::default_hold(state.phi);
  state.translation = settings->hold[0] > 0.0 ? settings->hold[0] : automatic.translation;
  state.rotation = settings->hold[1] > 0.0 ? settings->hold[1] : automatic.rotation;
  state.solutions += 1.0;
  state.step = static_cast<double>(update->ntimestep);
  state.strain = 0.0;
}
