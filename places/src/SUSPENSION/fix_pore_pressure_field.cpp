/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_pore_pressure_field.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "force.h"
#include "pore_spread.h"
#include "suspension_host.h"

#ifdef SUSPENSION_FFTW
#include "pore_solve.h"
#endif

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using Lubcontact_NS::Vec3;
using Pore_NS::Convergence;
using Pore_NS::Field;
using Pore_NS::Lanes;
using Pore_NS::Motion;

static constexpr int MOST_ITERATIONS = 1000;

// Solutions that are iterated before one per step is enough: the first pressure may be that of an
// impact, which P would let act for many steps.
static constexpr int FIRST_SOLUTIONS = 10;

#ifdef SUSPENSION_FFTW
struct LAMMPS_NS::PoreTransforms {
  explicit PoreTransforms(const Pore_NS::Grid &grid) : solver(grid) {}
  Pore_NS::ConstantSolver solver;
};
#else
struct LAMMPS_NS::PoreTransforms {};
#endif

const char *const PoreField::NO_LIBRARY =
    "needs the library FFTW, without which this SUSPENSION was built: install it (Debian: "
    "libfftw3-dev) and build again";

/* ---------------------------------------------------------------------- */

PoreField::PoreField(LAMMPS *lmp) :
    PoreSolver(lmp), age(0), made_for(-1.0), nlocal(-1), yield_of_plate(0.0), fresh(false),
    measured(false)
{
}

PoreField::~PoreField() = default;

bool PoreField::has_library()
{
#ifdef SUSPENSION_FFTW
  return true;
#else
  return false;
#endif
}

/* ---------------------------------------------------------------------- */

void PoreField::set_grid(const Pore_NS::Grid &grid)
{
  const bool same = transforms && grid.nx == lattice.nx && grid.ny == lattice.ny &&
      grid.nz == lattice.nz && grid.lower == lattice.lower && grid.upper == lattice.upper;
  lattice = grid;
  if (same) return;
#ifdef SUSPENSION_FFTW
  transforms = std::make_unique<PoreTransforms>(grid);
#endif
  if (p.size() != grid.nodes()) {
    p.assign(grid.nodes(), 0.0);
    age = 0;
  }
}

/* ---------------------------------------------------------------------- */

void PoreField::deposit(const Pore_NS::Cell &cell, int groupbits, const Fluid &fluid,
                        const Plates &plates, bool anew)
{
  lattice.cell = cell;
  of_deposit = plates;
  measured = false;
  matrix = element_matrix(lattice);
#ifdef SUSPENSION_FFTW
  transforms->solver.set_cell(lattice);
#endif
  // The plate has its mass instead of those of its particles. If that is the same, it yields less
  // than its particles would, one by one: the bound of P holds. Half of it is for the pressure
  // itself.
  const double most = MAX(plates.response.x, plates.response.y);
  const double yield = plates.mass * most * (plates.push_upper ? 2.0 : 1.0);
  fresh = anew || atom->nlocal != nlocal || yield != yield_of_plate;
  if (fresh) {
    yield_of_plate = yield;
    make_stencils(groupbits, fluid, plates);
  }
  mobility = mobilities(elements, fluid.viscosity);
}

/* ----------------------------------------------------------------------
   what the particles fill, and their weights; in lattice coordinates, in which they hardly move
------------------------------------------------------------------------- */

void PoreField::make_stencils(int groupbits, const Fluid &fluid, const Plates &plates)
{
  using Pore_NS::Moments;
  nlocal = atom->nlocal;
  const Pore_NS::Metric m = metric(lattice);
  const bool flat = domain->dimension == 2;
  auto place = [this, flat](int i) {
    const double *x = atom->x[i];
    return Vec3{x[0], x[1], flat ? 0.0 : x[2]};
  };
  auto part = [this](int i) {    // that is in the fluid
    return Pore_NS::part_inside(lattice, atom->x[i][1], atom->radius[i]);
  };
  auto inside = [this, &part](int i) {    // its volume
    return part(i) * Suspension_NS::particle_volume(domain, atom->radius[i]);
  };

  std::vector<Moments> mine(lattice.elements()), sums(lattice.elements());
  for (int i = 0; i < nlocal; i++)
    if (atom->mask[i] & groupbits) {
      const double r = atom->radius[i];
      add_moments(lattice, m, place(i), inside(i), part(i) * r * r, mine.data());
    }
  MPI_Allreduce(mine.data(), sums.data(), static_cast<int>(sums.size()) * Pore_NS::MOMENTS,
                MPI_DOUBLE, MPI_SUM, world);
  elements = make_elements(lattice, fluid.law, sums);

  particles.clear();
  stencils.clear();
  pushed.assign(nlocal, Vec3());
  std::vector<double> my_bound(lattice.elements());
  bound.resize(lattice.elements());
  for (int i = 0; i < nlocal; i++)
    if (atom->mask[i] & groupbits) {
      double inverse_mass = force->ftm2v / atom->rmass[i];
      if (atom->mask[i] & plates.lower_bit) inverse_mass = 0.0;
      if (atom->mask[i] & plates.upper_bit) inverse_mass = yield_of_plate / atom->rmass[i];
      particles.push_back({i, inverse_mass});
      stencils.push_back(make_stencil(lattice, m, elements, place(i), inside(i)));
      add_bound(stencils.back(), inverse_mass, lattice.element_volume(), my_bound.data());
    }
  of_pores.resize(particles.size());
  MPI_Allreduce(my_bound.data(), bound.data(), static_cast<int>(bound.size()), MPI_DOUBLE, MPI_SUM,
                world);
}

/* ----------------------------------------------------------------------
   of a pressure on the upper plate, if that can move
------------------------------------------------------------------------- */

static bool is_moved(const PoreField::Plates &plates)
{
  return plates.response.x != 0.0 || plates.response.y != 0.0;
}

Vec3 PoreField::force_on_plate(const Field &of_pressure, const std::vector<Lanes> &gradient,
                               const Plates &plates) const
{
  if (!is_moved(plates)) return {};
  Vec3 mine, all;
  for (std::size_t n = 0; n < particles.size(); n++)
    if (atom->mask[particles[n].i] & plates.upper_bit)
      mine = mine + pore_force(stencils[n], lattice.element_volume(), gradient);
  MPI_Allreduce(&mine.x, &all.x, 3, MPI_DOUBLE, MPI_SUM, world);
  if (plates.push_upper) all.y += wall_force(lattice, of_pressure).upper;
  return all;
}

/* ----------------------------------------------------------------------
   velocities of the elements, with the plates at these velocities
------------------------------------------------------------------------- */

template <class Velocity>
void PoreField::sum_motion(const Velocity &of_particle, const Vec3 &upper, const Plates &plates,
                           std::vector<Motion> &sums, Pore_NS::WallVelocity &of_wall) const
{
  std::vector<Motion> mine(lattice.elements());
  sums.resize(lattice.elements());
  of_wall = {0.0, upper.y};
  const int plate_bits = plates.lower_bit | plates.upper_bit;
  std::vector<Lanes> velocities(particles.size());
  for (std::size_t n = 0; n < particles.size(); n++) {
    const int mask = atom->mask[particles[n].i];
    if (!(mask & plate_bits))
      velocities[n] = {of_particle(particles[n], n)};
    else if (mask & plates.upper_bit)
      velocities[n] = {upper};
  }
  Pore_NS::add_motions(stencils, velocities, mine.data());
  MPI_Allreduce(mine.data(), sums.data(), static_cast<int>(sums.size()) * Pore_NS::MOTIONS,
                MPI_DOUBLE, MPI_SUM, world);
}

static bool is_same_outside(const PoreField::Fluid &a, const PoreField::Fluid &b)
{
  const Vec3 d = a.gradient - b.gradient;
  return a.lower == b.lower && a.upper == b.upper && dot(d, d) == 0.0;
}

/* ----------------------------------------------------------------------
   of the particles relative to the deforming cell, after the forces that act and those of the
   pressure before this step have moved them
------------------------------------------------------------------------- */

void PoreField::predict_motion(double dt, const Fluid &fluid, const Plates &plates)
{
  Vec3 upper = plates.velocity;
  // weights and pressures of the last step have made the same forces
  const bool known = !fresh && age > 0 && is_same_outside(fluid, seen.outside);
  if (dt > 0.0 && (!known || is_moved(plates))) {
    const std::vector<Lanes> gradient = gradients(lattice, p, fluid.gradient);
    const Vec3 push = force_on_plate(p, gradient, plates);
    upper = upper + dt * Vec3{plates.response.x * push.x, plates.response.y * push.y, 0.0};
    if (!known) Pore_NS::pore_forces(stencils, lattice.element_volume(), gradient, of_pores);
  }
  const Suspension_NS::CellFlow cell(domain);
  auto velocity = [&](const Particle &one, std::size_t n) {
    using Lubcontact_NS::get_vector;
    const Vec3 v = get_vector(atom->v[one.i]) - get_vector(cell.at(atom->x[one.i]).data());
    if (dt == 0.0) return v;
    return Pore_NS::predicted(v, get_vector(atom->f[one.i]), of_pores[n], one.inverse_mass, dt);
  };
  sum_motion(velocity, upper, plates, motion, wall);
}

/* ----------------------------------------------------------------------
   what the forces of a pressure add to all that per time
------------------------------------------------------------------------- */

void PoreField::respond(const Field &of_pressure, const Plates &plates, std::vector<Motion> &sums,
                        Pore_NS::WallVelocity &of_wall) const
{
  const std::vector<Lanes> gradient = gradients(lattice, of_pressure);
  const Vec3 push = force_on_plate(of_pressure, gradient, plates);
  std::vector<Lanes> forces(particles.size());
  Pore_NS::pore_forces(stencils, lattice.element_volume(), gradient, forces);
  auto acceleration = [&](const Particle &one, std::size_t n) {
    return one.inverse_mass * forces[n];
  };
  sum_motion(acceleration, {plates.response.x * push.x, plates.response.y * push.y, 0.0}, plates,
             sums, of_wall);
}

void PoreField::solve_constant([[maybe_unused]] const Field &r, [[maybe_unused]] double c,
                               [[maybe_unused]] double s, [[maybe_unused]] Field &change) const
{
#ifdef SUSPENSION_FFTW
  transforms->solver.solve(r, c, s, change);
#endif
}

/* ----------------------------------------------------------------------
   Does what is given change by more than a hundredth of the pressure? The answer must be whole at
   once, as that to the first velocities. A load that jumps has the inertia of its plate.
------------------------------------------------------------------------- */

bool PoreField::jumps(const Fluid &fluid) const
{
  static constexpr double JUMP = 0.01;
  if (age == 0) return false;
  double change = 0.0, scale = 0.0;
  for (const double value : p) scale = MAX(scale, fabs(value));
  if (lattice.lower == Pore_NS::Wall::DRAINED) change = fabs(fluid.lower - p.front());
  if (lattice.upper == Pore_NS::Wall::DRAINED) change = MAX(change, fabs(fluid.upper - p.back()));
  scale = MAX(scale, MAX(fabs(fluid.lower), fabs(fluid.upper)));
  if (given_gradient) {
    const Pore_NS::Cell &cell = lattice.cell;
    const double edge = MAX(cell.xprd, MAX(cell.yprd, cell.zprd));
    change = MAX(change, edge * norm(fluid.gradient - *given_gradient));
    scale = MAX(scale, edge * norm(fluid.gradient));
  }
  return change > JUMP * scale;
}

/* ---------------------------------------------------------------------- */

void PoreField::advance(double dt, const Fluid &fluid, const Plates &plates)
{
  const bool moves = fluid.coupling == Coupling::IMPLICIT;
  const double step = moves ? dt : 0.0;
  const double storage = Pore_NS::node_storage(lattice, fluid.storage, dt);
  if (age == 0) p.assign(lattice.nodes(), 0.0);
  if (jumps(fluid)) age = MIN(age, 1);
  given_gradient = fluid.gradient;
  set_fixed(lattice, fluid.lower, fluid.upper, p);

  predict_motion(step, fluid, plates);
  Field r = imbalance(lattice, matrix, mobility, motion, wall, fluid.gradient, p);
  project(lattice, storage > 0.0, r);
  // what the pressure itself does to a plate: of its gradient and, if it leaks nowhere, of its mean
  double of_plate = 0.0, of_mean = 0.0;
  if (plates.push_upper && plates.response.y > 0.0) {
    const double share = plates.push_lower ? 0.25 : 0.5;    // of the mass of the plate
    of_plate = Pore_NS::wall_bound(lattice, share / plates.response.y);
    const double area = lattice.wall_area();
    if (plates.push_lower)
      of_mean = step * area * area * plates.response.y /
          (share * static_cast<double>(lattice.elements()));
  }
  const double c =
      Pore_NS::largest(Pore_NS::implicit_mobilities(mobility, bound, step)) + step * of_plate;
  seen.plate_lag = c / (c - step * of_plate);
  const double s = storage + of_mean;
  Field change;
  seen.convergence = {};
  if (age < FIRST_SOLUTIONS || fluid.iterate || !moves) {
    auto apply = [&](const Field &q, Field &y) {
      auto response = [&](const Field &of, std::vector<Motion> &sums,
                          Pore_NS::WallVelocity &of_wall) {
        respond(of, plates, sums, of_wall);
      };
      apply_implicit(lattice, matrix, mobility, step, storage, response, q, y);
    };
    auto precondition = [&](const Field &residual, Field &z) {
      solve_constant(residual, c, s, z);
    };
    auto agree = [this](double value) {
      MPI_Bcast(&value, 1, MPI_DOUBLE, 0, world);
      return value;
    };
    change.assign(p.size(), 0.0);
    seen.convergence = Pore_NS::conjugate_gradients(apply, precondition, agree, r, fluid.tolerance,
                                                    MOST_ITERATIONS, change);
  } else
    solve_constant(r, c, s, change);
  for (std::size_t n = 0; n < p.size(); n++) p[n] += change[n];
  MPI_Bcast(p.data(), static_cast<int>(p.size()), MPI_DOUBLE, 0, world);    // to the last bit
  age = MIN(age + 1, FIRST_SOLUTIONS);
  seen.explicit_step = Pore_NS::explicit_step(mobility, bound);
}

/* ----------------------------------------------------------------------
   on an impermeable plate the pressure itself acts: spread over its particles
------------------------------------------------------------------------- */

void PoreField::add_forces(const Fluid &fluid, const Plates &plates)
{
  const int lower_bits = plates.push_lower ? plates.lower_bit : 0;
  const int upper_bits = plates.push_upper ? plates.upper_bit : 0;
  const std::vector<Lanes> gradient = gradients(lattice, p, fluid.gradient);
  Pore_NS::pore_forces(stencils, lattice.element_volume(), gradient, of_pores);
  double mine[5] = {}, all[5];    // force, particles of the plates
  for (std::size_t n = 0; n < particles.size(); n++) {
    const Particle &one = particles[n];
    if (domain->dimension == 2) of_pores[n].z = 0.0;    // but for rounding it is
    pushed[one.i] = of_pores[n];
    mine[0] += of_pores[n].x;
    mine[1] += of_pores[n].y;
    mine[2] += of_pores[n].z;
    if (atom->mask[one.i] & lower_bits) mine[3] += 1.0;
    if (atom->mask[one.i] & upper_bits) mine[4] += 1.0;
  }
  MPI_Allreduce(mine, all, 5, MPI_DOUBLE, MPI_SUM, world);
  std::copy_n(all, 3, seen.total);
  const Pore_NS::WallForce on_wall = wall_force(lattice, p);
  for (const Particle &one : particles) {
    if (atom->mask[one.i] & lower_bits) pushed[one.i].y += on_wall.lower / all[3];
    if (atom->mask[one.i] & upper_bits) pushed[one.i].y += on_wall.upper / all[4];
    if (fluid.coupling == Coupling::OFF) continue;
    double *f = atom->f[one.i];
    f[0] += pushed[one.i].x;
    f[1] += pushed[one.i].y;
    f[2] += pushed[one.i].z;
  }
  see(fluid);
}
