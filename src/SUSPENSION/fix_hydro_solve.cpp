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
#include "fix_hydro_precondition.h"
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
   M (F, T, S) = (v', w', -E)
------------------------------------------------------------------------- */

void HydroGrid::solve(double tolerance)
{
  const int groupbit = fix->groupbit;
  state.viscosity = fluid->viscosity_now();
  neighbor->build_one(list);
  field->prepare(settings->field, groupbit, state.radius, state.viscosity, list);
  preconditioner->prepare(*field, state.radius);

  const std::size_t size = static_cast<std::size_t>(atom->nlocal) * NUMBERS;
  double e[5];
  find_strain(e);
  // from the last two solutions
  const double again = state.solutions > 0.0 ? 1.0 : 0.0, slope = state.solutions > 1.0 ? 1.0 : 0.0;
  std::vector<double> right(size, 0.0), x(size, 0.0);
  for (const int i : field->particles()) {
    const Fluid_NS::Flow flow = fluid->flow_at(i);
    double *h = held[i], *b = &right[i * NUMBERS];
    Lubcontact_NS::put_vector(get_vector(atom->v[i]) - flow.velocity, h + MOTION);
    Lubcontact_NS::put_vector(get_vector(atom->omega[i]) - flow.spin, h + MOTION + 3);
    for (int n = 0; n < 6; n++) b[n] = h[MOTION + n];
    for (int n = 6; n < NUMBERS; n++) b[n] = -e[n - 6];
    for (int n = 0; n < NUMBERS; n++)
      x[i * NUMBERS + n] = again * h[LOAD + n] + slope * (h[LOAD + n] - h[BEFORE + n]);
  }
  const auto found = find_loads(right, tolerance, x);
  state.iterations = found.iterations;
  state.residual = found.residual;
  if (!(found.residual <= tolerance) && comm->me == 0)
    error->warning(FLERR, "Fix hydro: residual {:.3g} after {} iterations at step {}",
                   found.residual, found.iterations, update->ntimestep);

  for (const int i : field->particles()) {
    std::copy_n(held[i] + LOAD, NUMBERS, held[i] + BEFORE);
    std::copy_n(&x[i * NUMBERS], NUMBERS, held[i] + LOAD);
  }
  state.phi = preconditioner->phi();
  const Hydro_NS::Hold automatic = Hydro_NS::default_hold(state.phi);
  state.translation = settings->hold[0] > 0.0 ? settings->hold[0] : automatic.translation;
  state.rotation = settings->hold[1] > 0.0 ? settings->hold[1] : automatic.rotation;
  hold_each(settings->hold[0] > 0.0);
  state.solutions += 1.0;
  state.step = static_cast<double>(update->ntimestep);
  state.strain = 0.0;
}

/* ----------------------------------------------------------------------
   where spheres gather they resist more than in the mean of the cell
------------------------------------------------------------------------- */

void HydroGrid::hold_each(bool given)
{
  const std::vector<int> &particles = field->particles();
  const std::vector<double> about = given ? std::vector<double>(particles.size(), 0.0)
                                          : preconditioner->find_neighborhoods();
  for (std::size_t n = 0; n < particles.size(); n++)
    held[particles[n]][HOLD] = given ? 0.0 : Hydro_NS::default_hold(about[n]).translation;
}

/* ----------------------------------------------------------------------
   where the preconditioner is not positive, in a very uneven suspension, spheres alone are
------------------------------------------------------------------------- */

Pore_NS::Convergence HydroGrid::find_loads(const std::vector<double> &right, double tolerance,
                                           std::vector<double> &x)
{
  using Numbers = std::vector<double>;
  const auto apply = [this](const Numbers &loads, Numbers &motions) {
    motions.resize(loads.size());
    field->apply(loads.data(), motions.data());
  };
  const auto precondition = [this](const Numbers &motions, Numbers &loads) {
    loads.resize(motions.size());
    preconditioner->apply(motions.data(), loads.data());
  };
  const auto alone = [this](const Numbers &motions, Numbers &loads) {
    loads.resize(motions.size());
    preconditioner->apply_alone(motions.data(), loads.data());
  };
  const auto product = [this](const Numbers &a, const Numbers &b) {
    const double mine = Pore_NS::scalar_product(a, b);
    double all;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
  };
  const auto measure = Pore_NS::Measure::PRECONDITIONED;
  auto found = Pore_NS::solve_by_products(apply, precondition, product, right, tolerance,
                                          MOST_ITERATIONS, x, measure);
  if (found.positive) return found;
  const int before = found.iterations;
  found = Pore_NS::solve_by_products(apply, alone, product, right, tolerance, MOST_ITERATIONS, x,
                                     measure);
  found.iterations += before;
  return found;
}
