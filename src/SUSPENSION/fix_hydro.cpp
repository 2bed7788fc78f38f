/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_hydro.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "exclusive_particles.h"
#include "fix_hydro_settings.h"
#include "fluid_drag.h"
#include "fluid_flow.h"
#include "force.h"
#include "hydro_hold.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "pore_cg.h"
#include "restart_seal.h"
#include "spin_inertia.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace LAMMPS_NS;
using Hydro_NS::NUMBERS;
using Hydro_NS::Vec3;
using Lubcontact_NS::get_vector;

static constexpr int MOST_ITERATIONS = 500;
static constexpr double FIRST = 0.1;    // tolerance of the first solution, over that of the others

// of a particle
static constexpr int LOAD = 0, BEFORE = NUMBERS, MOTION = 2 * NUMBERS, NUM_HELD = MOTION + 6;

/* ---------------------------------------------------------------------- */

FixHydro::FixHydro(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), settings(new HydroSettings()), field(new HydroField(lmp, this)),
    own(new ExclusiveParticles(lmp)), inertia(new SpinInertia()), list(nullptr), deforms(false),
    held(nullptr), force_of_atom(nullptr), work(0.0), total{}, step_power(0.0)
{
  if (!HydroField::has_library()) error->all(FLERR, 2, "Fix hydro {}", HydroField::NO_LIBRARY);
  parse(narg, arg);
  vector_flag = 1;
  size_vector = Output::NUM;
  extvector = 0;
  global_freq = 1;
  peratom_flag = 1;
  size_peratom_cols = 6;
  peratom_freq = 1;
  dynamic_group_allow = 1;
  restart_global = 1;
  restart_peratom = 1;
  comm_forward = comm_reverse = NUMBERS;
  FixHydro::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  for (int i = 0; i < atom->nlocal; i++) FixHydro::set_arrays(i);
}

FixHydro::~FixHydro()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  memory->destroy(held);
  memory->destroy(force_of_atom);
}

FixHydro *FixHydro::find(LAMMPS *lmp)
{
  const auto fixes = lmp->modify->get_fix_by_style("^hydro");
  return fixes.empty() ? nullptr : dynamic_cast<FixHydro *>(fixes.front());
}

int FixHydro::setmask()
{
  return FixConst::POST_FORCE;
}

/* ----------------------------------------------------------------------
   the width of the Gaussians is that of a run: particles that come later do not change it
------------------------------------------------------------------------- */

void FixHydro::measure_radius()
{
  double mine[2] = {}, all[2];
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) {
      if (!(atom->radius[i] > 0.0))
        error->one(FLERR, "Fix hydro: atom {} has no radius; give the fix a group without it",
                   atom->tag[i]);
      mine[0] += atom->radius[i];
      mine[1] += 1.0;
    }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (all[1] == 0.0) error->all(FLERR, "Fix hydro has no particles in its group");
  const double now = all[0] / all[1];
  if (!Suspension_NS::is_same_sum(state.radius, now)) state.radius = now;
}

/* ----------------------------------------------------------------------
   a solution that is known, from a restart file or the last run, is held on
------------------------------------------------------------------------- */

void FixHydro::setup(int /*vflag*/)
{
  deforms = !modify->get_fix_by_style("^deform").empty();
  const double viscosity = viscosity_now();
  if (state.solutions == 0.0) solve(FIRST * settings->tolerance, viscosity);
  act(true);
  step_power = 0.0;    // no step yet
}

void FixHydro::post_force(int /*vflag*/)
{
  const double viscosity = viscosity_now();
  double e[5], square = 0.0;
  find_strain(e);
  for (const double value : e) square += value * value;
  state.strain += sqrt(2.0 * square) * update->dt;
  const double steps = static_cast<double>(update->ntimestep) - state.step;
  const bool due = settings->every ? steps >= settings->every || steps < 0.0
                                   : state.strain >= settings->strain * (1.0 - 1e-9);
  if (due) solve(settings->tolerance, viscosity);
  const double before = work;
  act(false);
  step_power = 0.5 * (before + work);
}

/* ---------------------------------------------------------------------- */

void FixHydro::find_strain(double *five) const
{
  const auto e = Suspension_NS::cell_strain(domain);
  Hydro_NS::put_strain({{e.xx, e.xy, e.xz}, {e.xy, e.yy, e.yz}, {e.xz, e.yz, e.zz}}, five);
}

static Fluid_NS::Flow flow_at(const Domain *domain, bool deforms, const double *x)
{
  if (!deforms) return {};
  return Fluid_NS::cell_flow(domain->h_rate, domain->h_inv, get_vector(x),
                             get_vector(domain->boxlo), get_vector(domain->h_ratelo));
}

/* ---------------------------------------------------------------------- */

double FixHydro::viscosity_now()
{
  if (!settings->viscosity.is_number()) modify->clearstep_compute();
  settings->viscosity.evaluate(lmp);
  if (!settings->viscosity.is_number()) modify->addstep_compute(update->ntimestep + 1);
  const double *eta = settings->viscosity_of_pair ? Suspension_NS::viscosity_of_pair(lmp)
                                                  : &settings->viscosity.value;
  if (!eta || !(*eta > 0.0))
    error->all(FLERR, "Fix hydro viscosity must be > 0, but is {} at step {}", eta ? *eta : 0.0,
               update->ntimestep);
  return *eta;
}

/* ----------------------------------------------------------------------
   M (F, T, S) = (v', w', -E). Lengths in widths, so that all numbers have the same unit
------------------------------------------------------------------------- */

void FixHydro::solve(double tolerance, double viscosity)
{
  state.viscosity = viscosity;
  neighbor->build_one(list);
  field->prepare(settings->field, groupbit, state.radius, viscosity, list);

  const int nlocal = atom->nlocal;
  const std::size_t size = static_cast<std::size_t>(nlocal) * NUMBERS;
  const double length = field->length();
  double e[5], volume = 0.0;
  find_strain(e);
  std::vector<double> right(size, 0.0), x(size, 0.0), scaled(size);
  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    own->check(atom->mask[i]);
    volume += Suspension_NS::particle_volume(domain, atom->radius[i]);
    const Fluid_NS::Flow flow = flow_at(domain, deforms, atom->x[i]);
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

/* ----------------------------------------------------------------------
   velocities are those of the last half step, or of the full step in a set-up; see fluid_drag.h
------------------------------------------------------------------------- */

void FixHydro::act(bool full)
{
  const double dt = update->dt * force->ftm2v;
  double e[5];
  find_strain(e);
  work = 0.0;
  std::fill_n(total, 6, 0.0);
  // damps what acts on v; the mean force of the fluid in this step
  auto damp = [&](double coefficient, double mass, const Vec3 &v, const Vec3 &flow,
                  const Vec3 &relative, const Vec3 &load, double *f) {
    const double x = coefficient * dt / mass;
    const double mean = full ? Fluid_NS::mean_drag_full(x) : Fluid_NS::mean_drag(x);
    const Vec3 others = get_vector(f);
    const Vec3 target = Hydro_NS::held_target(coefficient, flow, relative, load);
    const Vec3 all = Fluid_NS::damped(mean, coefficient, others, v, target);
    const Vec3 now = full ? v : v + (0.5 * dt / mass) * all;    // at the full step
    Lubcontact_NS::put_vector(all, f);
    work -= dot(all - others, now - flow);
    return all - others;
  };
  const Hydro_NS::Hold hold{state.translation, state.rotation};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    own->check(atom->mask[i]);
    const double *h = held[i];
    const Fluid_NS::Flow flow = flow_at(domain, deforms, atom->x[i]);
    const Fluid_NS::Drag drag = Hydro_NS::held_drag(hold, state.viscosity, atom->radius[i]);
    const Vec3 f = damp(drag.translation, atom->rmass[i], get_vector(atom->v[i]), flow.velocity,
                        get_vector(h + MOTION), get_vector(h + LOAD), atom->f[i]);
    const Vec3 t = damp(drag.rotation, inertia->of(atom, i), get_vector(atom->omega[i]), flow.spin,
                        get_vector(h + MOTION + 3), get_vector(h + LOAD + 3), atom->torque[i]);
    for (int n = 0; n < 5; n++) work -= h[LOAD + 6 + n] * e[n];
    Lubcontact_NS::add_vector(f, total);
    Lubcontact_NS::add_vector(t, total + 3);
    Lubcontact_NS::put_vector(f, force_of_atom[i]);
    Lubcontact_NS::put_vector(t, force_of_atom[i] + 3);
  }
}

/* ----------------------------------------------------------------------
   the stress is -S/V, tension positive, in the order xx yy zz xy xz yz
------------------------------------------------------------------------- */

double FixHydro::compute_vector(int n)
{
  if (n == Output::ITERATIONS) return state.iterations;
  if (n == Output::RESIDUAL) return state.residual;
  if (n == Output::SOLUTIONS) return state.solutions;
  if (n == Output::PHI) return state.phi;
  double mine[5] = {}, all[5];
  int number = 1;
  if (n == Output::HEAT)
    mine[0] = work;
  else if (n >= Output::FORCE)
    mine[0] = total[n - Output::FORCE];
  else {
    number = 5;
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & groupbit)
        for (int k = 0; k < 5; k++) mine[k] += held[i][LOAD + 6 + k];
  }
  MPI_Allreduce(mine, all, number, MPI_DOUBLE, MPI_SUM, world);
  if (number == 1) return all[0];
  const Hydro_NS::Tensor s = Hydro_NS::get_strain(all);
  const double six[6] = {s.x.x, s.y.y, s.z.z, s.x.y, s.x.z, s.y.z};
  return -force->nktv2p * six[n - Output::STRESS] / Suspension_NS::cell_volume(domain);
}

void FixHydro::add_stresslets(double *nine) const
{
  double sum[5] = {};
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      for (int k = 0; k < 5; k++) sum[k] += held[i][LOAD + 6 + k];
  const Hydro_NS::Tensor s = Hydro_NS::get_strain(sum);
  const double parts[9] = {s.x.x, s.y.y, s.z.z, s.x.y, s.x.z, s.y.z, s.x.y, s.x.z, s.y.z};
  for (int n = 0; n < 9; n++) nine[n] += parts[n];
}

double FixHydro::stresslet_power() const
{
  double e[5], sum = 0.0;
  find_strain(e);
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      for (int k = 0; k < 5; k++) sum -= held[i][LOAD + 6 + k] * e[k];
  return sum;
}

double FixHydro::torque(int d)
{
  double all;
  MPI_Allreduce(&total[3 + d], &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixHydro::mean_power()
{
  double all;
  MPI_Allreduce(&step_power, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixHydro::memory_usage()
{
  return field->memory_usage() + (NUM_HELD + 6.0) * atom->nmax * sizeof(double);
}
