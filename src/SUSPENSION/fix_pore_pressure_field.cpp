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
    PoreSolver(lmp), age(0), made_for(-1.0), nlocal(-1), measured(false)
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
                        const Plates &plates)
{
  using Pore_NS::Moments;
  lattice.cell = cell;
  of_deposit = plates;
  nlocal = atom->nlocal;
  measured = false;
  matrix = element_matrix(lattice);
#ifdef SUSPENSION_FFTW
  transforms->solver.set_cell(lattice);
#endif
  const Pore_NS::Metric m = metric(lattice);
  const bool flat = domain->dimension == 2;
  auto place = [this, flat](int i) {
    const double *x = atom->x[i];
    return Vec3{x[0], x[1], flat ? 0.0 : x[2]};
  };
  auto inside = [this](int i) {    // volume of the part that is in the fluid
    const double r = atom->radius[i];
    return Suspension_NS::particle_volume(domain, r) *
        Pore_NS::part_inside(lattice, atom->x[i][1], r);
  };

  std::vector<Moments> mine(lattice.elements()), sums(lattice.elements());
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbits) {
      const double r = atom->radius[i];
      add_moments(lattice, m, place(i), inside(i), r * r, mine.data());
    }
  MPI_Allreduce(mine.data(), sums.data(), static_cast<int>(sums.size()) * Pore_NS::MOMENTS,
                MPI_DOUBLE, MPI_SUM, world);
  elements = make_elements(lattice, fluid.law, sums);
  mobility = mobilities(elements, fluid.viscosity);

  // The plate has its mass instead of those of its particles. If that is the same, it yields less
  // than its particles would, one by one: the bound of P holds. Half of it is for the pressure
  // itself.
  const double most = MAX(plates.response.x, plates.response.y);
  const double of_plate = plates.mass * most * (plates.push_upper ? 2.0 : 1.0);
  particles.clear();
  pushed.assign(atom->nlocal, Vec3());
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbits) {
      double inverse_mass = force->ftm2v / atom->rmass[i];
      if (atom->mask[i] & plates.lower_bit) inverse_mass = 0.0;
      if (atom->mask[i] & plates.upper_bit) inverse_mass = of_plate / atom->rmass[i];
      particles.push_back(
          {i, inverse_mass, make_stencil(lattice, m, elements, place(i), inside(i))});
    }
}

/* ----------------------------------------------------------------------
   of a pressure on the upper plate, if that can move
------------------------------------------------------------------------- */

Vec3 PoreField::force_on_plate(const Field &of_pressure, const std::vector<Vec3> &gradient,
                               const Plates &plates) const
{
  if (plates.response.x == 0.0 && plates.response.y == 0.0) return {};
  Vec3 mine, all;
  for (const Particle &one : particles)
    if (atom->mask[one.i] & plates.upper_bit)
      mine = mine + pore_force(one.stencil, lattice.element_volume(), gradient);
  MPI_Allreduce(&mine.x, &all.x, 3, MPI_DOUBLE, MPI_SUM, world);
  if (plates.push_upper) all.y += wall_force(lattice, of_pressure).upper;
  return all;
}

/* ----------------------------------------------------------------------
   velocities of the elements: those of the particles, relative to the deforming cell, after the
   forces that act and the given pressure have moved them; or what that pressure alone adds
------------------------------------------------------------------------- */

void PoreField::sum_motion(const Field &of_pressure, double dt, bool whole, const Plates &plates,
                           std::vector<Motion> &sums, Pore_NS::WallVelocity &of_wall) const
{
  std::vector<Motion> mine(lattice.elements());
  sums.resize(lattice.elements());
  const double volume = lattice.element_volume(), span = whole ? dt : 1.0;
  const std::vector<Vec3> gradient = gradients(lattice, of_pressure);
  const Vec3 push = dt > 0.0 ? force_on_plate(of_pressure, gradient, plates) : Vec3();
  Vec3 upper = span * Vec3{plates.response.x * push.x, plates.response.y * push.y, 0.0};
  if (whole) upper = upper + plates.velocity;
  of_wall = {0.0, upper.y};
  for (const Particle &one : particles) {
    Vec3 v;
    if (atom->mask[one.i] & plates.upper_bit)
      v = upper;
    else if (!(atom->mask[one.i] & plates.lower_bit)) {
      if (dt > 0.0) v = (span * one.inverse_mass) * pore_force(one.stencil, volume, gradient);
      if (whole) {
        const auto flow = Suspension_NS::cell_velocity(domain, atom->x[one.i]);
        v = v + Lubcontact_NS::get_vector(atom->v[one.i]) - Vec3{flow[0], flow[1], flow[2]} +
            (dt * one.inverse_mass) * Lubcontact_NS::get_vector(atom->f[one.i]);
      }
    }
    add_motion(one.stencil, v, one.inverse_mass, volume, mine.data());
  }
  MPI_Allreduce(mine.data(), sums.data(), static_cast<int>(sums.size()) * Pore_NS::MOTIONS,
                MPI_DOUBLE, MPI_SUM, world);
}

void PoreField::solve_constant([[maybe_unused]] const Field &r, [[maybe_unused]] double c,
                               [[maybe_unused]] double s, [[maybe_unused]] Field &change) const
{
#ifdef SUSPENSION_FFTW
  transforms->solver.solve(r, c, s, change);
#endif
}

/* ---------------------------------------------------------------------- */

void PoreField::advance(double dt, const Fluid &fluid, const Plates &plates)
{
  const bool moves = fluid.coupling == Coupling::IMPLICIT;
  const double step = moves ? dt : 0.0;
  const double storage = Pore_NS::node_storage(lattice, fluid.storage, dt);
  if (age == 0) p.assign(lattice.nodes(), 0.0);
  set_fixed(lattice, fluid.lower, fluid.upper, p);

  sum_motion(p, step, true, plates, motion, wall);
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
  const double c = Pore_NS::largest(implicit_mobilities(mobility, motion, step)) + step * of_plate;
  const double s = storage + of_mean;
  Field change;
  seen.convergence = {};
  if (age < FIRST_SOLUTIONS || fluid.iterate || !moves) {
    auto apply = [&](const Field &q, Field &y) {
      auto response = [&](const Field &of, std::vector<Motion> &sums,
                          Pore_NS::WallVelocity &of_wall) {
        sum_motion(of, step, false, plates, sums, of_wall);
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
  seen.explicit_step = Pore_NS::explicit_step(mobility, motion);
}

/* ----------------------------------------------------------------------
   on an impermeable plate the pressure itself acts: spread over its particles
------------------------------------------------------------------------- */

void PoreField::add_forces(const Fluid &fluid, const Plates &plates)
{
  const int lower_bits = plates.push_lower ? plates.lower_bit : 0;
  const int upper_bits = plates.push_upper ? plates.upper_bit : 0;
  const std::vector<Vec3> gradient = gradients(lattice, p, fluid.gradient);
  const double volume = lattice.element_volume();
  double mine[5] = {}, all[5];    // force, particles of the plates
  for (const Particle &one : particles) {
    pushed[one.i] = pore_force(one.stencil, volume, gradient);
    if (domain->dimension == 2) pushed[one.i].z = 0.0;    // but for rounding it is
    mine[0] += pushed[one.i].x;
    mine[1] += pushed[one.i].y;
    mine[2] += pushed[one.i].z;
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

/* ---------------------------------------------------------------------- */

void PoreField::see(const Fluid &fluid)
{
  seen.gradient = fluid.gradient;
  seen.given_mean = fluid.mean;
  seen.mean = mean_pressure(lattice, p) + fluid.mean;
  seen.largest = 0.0;
  for (const double value : p) seen.largest = MAX(seen.largest, fabs(value + fluid.mean));
  const bool plates = lattice.has_plates();
  seen.lower = plates ? layer_mean(lattice, p, 0) : seen.mean;
  seen.upper = plates ? layer_mean(lattice, p, lattice.ny) : seen.mean;
  seen.k_min = HUGE_VAL;
  seen.k_max = 0.0;
  for (const Pore_NS::Element &e : elements) {
    seen.k_min = MIN(seen.k_min, e.permeability);
    seen.k_max = MAX(seen.k_max, e.permeability);
  }
}

/* ---------------------------------------------------------------------- */

double PoreField::dissipation() const
{
  return elements.empty() ? 0.0 : Pore_NS::dissipation(lattice, matrix, mobility, seen.gradient, p);
}

/* ---------------------------------------------------------------------- */

std::vector<double> PoreField::pressure_shares() const
{
  std::vector<double> shares(atom->nlocal, 0.0);
  if (atom->nlocal != nlocal) return shares;
  std::vector<double> integrals = element_means(lattice, p);
  for (double &of_element : integrals)
    of_element = lattice.element_volume() * (of_element + seen.given_mean);
  for (const Particle &one : particles) shares[one.i] = share_of(one.stencil, integrals);
  return shares;
}

/* ----------------------------------------------------------------------
   what advance() has used are velocities that it has predicted from the pressure before
------------------------------------------------------------------------- */

void PoreField::measure_flow(const Vec3 &upper_plate)
{
  if (measured || atom->nlocal != nlocal) return;
  measured = true;
  of_deposit.velocity = upper_plate;
  sum_motion(p, 0.0, true, of_deposit, motion, wall);
  const Pore_NS::WallFlux flux =
      wall_flux(lattice, imbalance(lattice, matrix, mobility, motion, wall, seen.gradient, p));
  seen.flux = {flux.lower, flux.upper};
}

/* ---------------------------------------------------------------------- */

std::vector<PoreField::Layer> PoreField::profile() const
{
  std::vector<Layer> layers(lattice.ny);
  if (elements.empty()) return layers;
  const std::vector<Vec3> gradient = gradients(lattice, p, seen.gradient);
  const int size = lattice.layer_size();
  for (int j = 0; j < lattice.ny; j++) {
    Layer &layer = layers[j];
    const int up = j + 1 < lattice.layers() ? j + 1 : 0;
    layer.y = lattice.cell.origin.y + (j + 0.5) / lattice.ny * lattice.cell.yprd;
    layer.p = 0.5 * (layer_mean(lattice, p, j) + layer_mean(lattice, p, up)) + seen.given_mean;
    layer.phi = layer.u_y = layer.q_y = 0.0;
    for (int n = j * size; n < (j + 1) * size; n++) {
      layer.phi += elements[n].phi / size;
      layer.u_y += motion.empty() ? 0.0 : motion[n].velocity.y / size;
      layer.q_y -= mobility[n] * gradient[n].y / size;
    }
  }
  return layers;
}

/* ---------------------------------------------------------------------- */

double PoreField::memory_usage() const
{
  return static_cast<double>(lattice.elements() *
                                 (2 * sizeof(Pore_NS::Moments) + sizeof(Pore_NS::Element) +
                                  3 * sizeof(Motion) + sizeof(Vec3) + sizeof(double)) +
                             6 * lattice.nodes() * sizeof(double) +
                             particles.capacity() * sizeof(Particle) +
                             pushed.capacity() * sizeof(Vec3));
}
