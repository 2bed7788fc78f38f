/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Plane Couette cell: what the plates do in a step, and what they feel.

#include "fix_rheometer_plates.h"

#include "atom.h"
#include "background_fluid.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "list_keeper.h"
#include "modify.h"
#include "restart_seal.h"
#include "rheometer_flow.h"
#include "rheometer_list.h"
#include "rheometer_plate.h"
#include "rheometer_servo.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;
using rheometer::LOWER;
using rheometer::UPPER;

/* ---------------------------------------------------------------------- */

int FixRheometerPlates::setmask()
{
  return INITIAL_INTEGRATE | POST_INTEGRATE | PRE_NEIGHBOR | POST_FORCE | FINAL_INTEGRATE |
      MIN_POST_FORCE;
}

/* ----------------------------------------------------------------------
   Sums over particles are measured at the start of a run, and kept if they are as before: another
   order of the particles would round them differently, and a continued run would not be the same.
------------------------------------------------------------------------- */

static void measured(double &kept, double now, double scale)
{
  if (fabs(now - kept) > 1e-8 * scale) kept = now;
}

/* ----------------------------------------------------------------------
   the gap is between the mean surfaces of the plates, and follows their motion during a run
------------------------------------------------------------------------- */

void FixRheometerPlates::measure_surfaces(double &bottom, double &top) const
{
  double mine[4] = {0.0, 0.0, 0.0, 0.0}, all[4];    // height and number, lower and upper
  for (int i = 0; i < atom->nlocal; i++)
    for (int plate : {LOWER, UPPER}) {
      if (!(atom->mask[i] & bit[plate])) continue;
      const double inwards = plate == LOWER ? atom->radius[i] : -atom->radius[i];
      mine[2 * plate] += atom->x[i][1] + inwards;
      mine[2 * plate + 1] += 1.0;
    }
  MPI_Allreduce(mine, all, 4, MPI_DOUBLE, MPI_SUM, world);
  bottom = all[0] / all[1];
  top = all[2] / all[3];
}

void FixRheometerPlates::measure_gap()
{
  double bottom, top;
  measure_surfaces(bottom, top);
  if (!(top > bottom))
    error->all(FLERR,
               "Fix rheometer/plates: the mean surface of the upper plate, y = {:.6g}, must be "
               "above that of the lower plate, y = {:.6g}; exchange the groups, or move the plates",
               top, bottom);
  measured(state.gap, top - bottom, fabs(top) + fabs(bottom));
}

/* ----------------------------------------------------------------------
   what is between the plates, and the mass of the upper plate
------------------------------------------------------------------------- */

enum { VOLUME, MASS, DIAMETER, NUMBER, PLATE, NUM };

struct FixRheometerPlates::Sums {
  double force[2][3] = {};
  double particles[NUM] = {};
};

void FixRheometerPlates::add_particle(int i, bool massless, double *sum) const
{
  const double r = atom->radius[i];
  if (atom->mask[i] & bit[UPPER]) sum[PLATE] += atom->rmass[i];
  if (!(atom->mask[i] & groupbit)) return;
  if (atom->mask[i] & plate_bits())
    error->one(FLERR,
               "Fix rheometer/plates: particle {} of the plates has joined group {} of the "
               "suspended particles: a dynamic group must not take them",
               atom->tag[i], group->names[igroup]);
  sum[VOLUME] += M_PI * r * r * (domain->dimension == 2 ? 1.0 : 4.0 / 3.0 * r);
  if (!massless) sum[MASS] += atom->rmass[i];
  sum[DIAMETER] += 2.0 * r;
  sum[NUMBER] += 1.0;
}

void FixRheometerPlates::take_particles(const double *all)
{
  if (load == PRESSURE && all[NUMBER] == 0.0)
    error->all(FLERR,
               "Fix rheometer/plates cannot hold a pressure: group {} of the suspended particles "
               "is empty",
               group->names[igroup]);
  const double number = MAX(all[NUMBER], 1.0), volume = all[NUMBER] > 0.0 ? all[VOLUME] : 1.0;
  measured(state.solid, all[VOLUME], all[VOLUME]);
  measured(state.density, all[MASS] / volume, all[MASS] / volume);
  measured(state.diameter, all[DIAMETER] / number, all[DIAMETER] / number);
  measured(state.plate_mass, all[PLATE], all[PLATE]);
}

void FixRheometerPlates::measure_particles()
{
  double mine[NUM] = {}, all[NUM];
  const int massless = overdamped_groups(lmp);
  for (int i = 0; i < atom->nlocal; i++) add_particle(i, atom->mask[i] & massless, mine);
  MPI_Allreduce(mine, all, NUM, MPI_DOUBLE, MPI_SUM, world);
  take_particles(all);
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::setup(int vflag)
{
  measure_gap();
  measure_particles();
  evaluate_targets();
  post_force(vflag);
  check_time_step();
}

/* ----------------------------------------------------------------------
   forces of the suspension on the plates, those between plate and plate included; and the particles
   once more, which come, go and grow
------------------------------------------------------------------------- */

void FixRheometerPlates::post_force(int /*vflag*/)
{
  Sums mine, all;
  const int massless = overdamped_groups(lmp);
  for (int i = 0; i < atom->nlocal; i++) {
    add_particle(i, atom->mask[i] & massless, mine.particles);
    for (int plate : {LOWER, UPPER})
      if (atom->mask[i] & bit[plate])
        for (int d = 0; d < 3; d++) mine.force[plate][d] += atom->f[i][d];
  }
  MPI_Allreduce(mine.force[0], all.force[0], sizeof(Sums) / sizeof(double), MPI_DOUBLE, MPI_SUM,
                world);
  std::copy_n(all.force[0], 6, force_on[0]);
  take_particles(all.particles);
}

/* ----------------------------------------------------------------------
   a minimization moves the suspended particles only
------------------------------------------------------------------------- */

void FixRheometerPlates::min_setup(int vflag)
{
  min_post_force(vflag);
}

void FixRheometerPlates::min_post_force(int /*vflag*/)
{
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & (bit[LOWER] | bit[UPPER]))
      atom->f[i][0] = atom->f[i][1] = atom->f[i][2] = 0.0;
}

/* ----------------------------------------------------------------------
   in force/length^2 and force*time^2/length here, whatever the units
------------------------------------------------------------------------- */

double FixRheometerPlates::area() const
{
  return domain->xprd * (domain->dimension == 3 ? domain->zprd : 1.0);
}

double FixRheometerPlates::moving_mass() const
{
  return (mass > 0.0 ? mass : state.plate_mass) / force->ftm2v;
}

rheometer::Material FixRheometerPlates::material() const
{
  const double rho = state.density / force->ftm2v;
  return {viscosity.value, rho, state.diameter, rho * state.diameter * state.gap};
}

rheometer::WallStress FixRheometerPlates::stress_on(int plate) const
{
  return rheometer::wall_stress(static_cast<rheometer::Plate>(plate), force_on[plate], area());
}

/* ----------------------------------------------------------------------
   targets of this step
------------------------------------------------------------------------- */

void FixRheometerPlates::evaluate_targets()
{
  modify->clearstep_compute();
  bool any = false;
  for (RheometerTarget *target : {&target_x, &amplitude, &target_y, &viscosity})
    if (target->evaluate(lmp)) any = true;
  if (any) modify->addstep_compute(update->ntimestep + 1);
  if (!own_viscosity) viscosity.value = pair_eta ? *pair_eta : 0.0;
  check_values();
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::half_kick_x(double dt)
{
  const double push = target_x.value / force->nktv2p * area() + force_on[UPPER][0];
  state.vx = rheometer::damped_velocity(state.vx, push, moving_mass(), damper_x, 0.5 * dt);
}

void FixRheometerPlates::half_kick_y(double dt)
{
  const double push = force_on[UPPER][1] - target_y.value / force->nktv2p * area();
  state.vy = rheometer::damped_velocity(state.vy, push, moving_mass(), damper_y, 0.5 * dt);
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::move_y(double dt)
{
  if (load == GAP) {
    state.vy = 0.0;
  } else if (load == LOAD) {
    half_kick_y(dt);
  } else {
    state.dilation = rheometer::next_dilation(material(), state.dilation, stress_on(UPPER).pressure,
                                              target_y.value / force->nktv2p, state.rate, gain, dt);
    state.vy = rheometer::dilation_velocity(state.gap, state.dilation, dt);
  }
}

/* ---------------------------------------------------------------------- */

double FixRheometerPlates::rate_of_drive(double dt)
{
  if (drive == OSCILLATE)
    return rheometer::oscillation_rate(target_x.value, amplitude.value, frequency, state.clock, dt);
  if (drive == IV) return target_x.value * target_y.value / force->nktv2p / viscosity.value;
  return target_x.value;
}

/* ----------------------------------------------------------------------
   rates are those of the gap in the middle of the step
------------------------------------------------------------------------- */

void FixRheometerPlates::initial_integrate(int /*vflag*/)
{
  const double dt = update->dt;
  evaluate_targets();
  move_y(dt);
  const double middle = state.gap + 0.5 * dt * state.vy;
  state.gap += dt * state.vy;
  if (!(state.gap > 0.0))
    error->all(FLERR,
               "Fix rheometer/plates: the plates have met at step {}; reduce the pressure, or put "
               "more particles between them",
               update->ntimestep);

  if (drive == STRESS || drive == VELOCITY) {
    if (drive == STRESS)
      half_kick_x(dt);
    else
      state.vx = target_x.value;
    state.rate = state.vx / middle;
  } else {
    state.rate = rate_of_drive(dt);
    state.vx = state.rate * middle;
  }
  state.strain += state.rate * dt;
  state.clock += dt;
  listed.slid += dt * state.vx;
  move_particles(dt);
}

/* ----------------------------------------------------------------------
   A list lives for as long as the flow between the plates, or what particles do in all, allows
------------------------------------------------------------------------- */

void FixRheometerPlates::setup_pre_neighbor()
{
  pre_neighbor();
}

void FixRheometerPlates::pre_neighbor()
{
  keeper->listed();
  if (!keeper->on) return;
  double top;
  measure_surfaces(listed.bottom, top);
  listed.gap = top - listed.bottom;
  listed.slid = 0.0;
}

void FixRheometerPlates::post_integrate()
{
  if (!keeper->on) return;
  rheometer::Deformation flow;
  flow.yy = state.gap / listed.gap;
  flow.xy = listed.slid / listed.gap;
  const double origin[3] = {0.0, listed.bottom, 0.0};
  if (!keeper->decide({flow, rheometer::Deformation()}, origin))
    next_reneighbor = update->ntimestep;
}

void FixRheometerPlates::post_run()
{
  keeper->release();
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::move_particles(double dt)
{
  set_velocities();
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & bit[UPPER]) {
      atom->x[i][0] += dt * state.vx;
      atom->x[i][1] += dt * state.vy;
    }
}

void FixRheometerPlates::set_velocities()
{
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & plate_bits())) continue;
    own.check(atom->mask[i]);
    const bool moves = atom->mask[i] & bit[UPPER];
    double *v = atom->v[i], *omega = atom->omega[i];
    v[0] = moves ? state.vx : 0.0;
    v[1] = moves ? state.vy : 0.0;
    v[2] = omega[0] = omega[1] = omega[2] = 0.0;
  }
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::final_integrate()
{
  const double dt = update->dt;
  if (drive == STRESS) half_kick_x(dt);
  if (load == LOAD) half_kick_y(dt);
  if (drive == STRESS || load == LOAD) set_velocities();
  watch_targets(dt);

  const rheometer::WallStress low = stress_on(LOWER), up = stress_on(UPPER);
  rheometer::add(state.means, 0.5 * (low.pressure + up.pressure), 0.5 * (low.xy + up.xy),
                 state.rate * dt, dt);
}

/* ----------------------------------------------------------------------
   are the targets reached? warns once
------------------------------------------------------------------------- */

void FixRheometerPlates::watch_targets(double dt)
{
  const rheometer::Material m = material();
  const rheometer::WallStress wall = stress_on(UPPER);
  // returns the state of the target; w: rate at which its control answers
  auto watch = [&](double measured, double target, double w, double &deviation, double &age,
                   double &warned, const char *what, const char *cause) {
    if (target == 0.0 || !std::isfinite(w) || w == 0.0) return rheometer::FOLLOWING;
    const rheometer::Watch now =
        rheometer::watch({deviation, age}, (measured - target) / target, w, dt);
    deviation = now.deviation;
    age = now.age;
    if (!rheometer::unreachable(now)) return rheometer::FOLLOWING;
    if (warned == 0.0 && comm->me == 0)
      error->warning(FLERR,
                     "Fix rheometer/plates does not reach the {} {:.6g}: it is {:.3g} on average; "
                     "{}",
                     what, target * force->nktv2p, (1.0 + deviation) * target * force->nktv2p,
                     cause);
    warned = 1.0;
    return rheometer::UNREACHABLE;
  };

  state.code_x = state.code_y = rheometer::IDLE;
  if (drive == STRESS) {
    const double s = target_x.value / force->nktv2p;
    state.code_x = watch(
        wall.xy, s, rheometer::servo_rate(m, state.rate, s, rheometer::STRESS_FLOOR),
        state.deviation_x, state.age_x, state.warned_x, "shear stress",
        "the suspension cannot resist it, or the plate is so heavy that it still accelerates");
  }
  if (load == GAP) return;
  const double p = target_y.value / force->nktv2p;
  const double w = rheometer::servo_rate(m, state.rate, p, rheometer::PRESSURE_FLOOR);
  state.code_y =
      watch(wall.pressure, p, w, state.deviation_y, state.age_y, state.warned_y, "pressure",
            "the suspension is jammed, too dilute to push, or the plate too slow");
  if (load == PRESSURE && state.code_y == rheometer::FOLLOWING &&
      fabs(state.dilation) >= rheometer::dilation_limit(m, p, state.rate, gain))
    state.code_y = rheometer::LIMITED;
}

/* ---------------------------------------------------------------------- */

double FixRheometerPlates::compute_vector(int n)
{
  const double unit = force->nktv2p;
  const double phi = state.gap > 0.0 ? state.solid / (area() * state.gap) : 0.0;
  const rheometer::WallStress low = stress_on(LOWER), up = stress_on(UPPER);
  const double values[] = {state.strain,
                           state.rate,
                           state.gap,
                           state.vx,
                           state.vy,
                           phi,
                           low.pressure * unit,
                           up.pressure * unit,
                           low.xy * unit,
                           up.xy * unit,
                           low.zy * unit,
                           up.zy * unit,
                           target_x.value,
                           load == GAP ? 0.0 : target_y.value,
                           state.code_x,
                           state.code_y};
  const int now = sizeof(values) / sizeof(double);
  if (n < now) return values[n];
  const double mean = rheometer::mean_output(
      state.means, n - now, 0.5 * (low.pressure + up.pressure), 0.5 * (low.xy + up.xy));
  return n - now == rheometer::MEAN_OUTPUTS - 1 ? mean : mean * unit;
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::write_restart(FILE *fp)
{
  if (comm->me) return;
  state.drive = drive;
  state.load = load;
  state.amplitude = amplitude.value;
  state.frequency = frequency;
  suspension::write_sealed(fp, state);
}

void FixRheometerPlates::restart(char *buffer)
{
  if (const char *wrong = suspension::read_sealed(buffer, state))
    error->all(FLERR, "The part of fix {} in the restart file {}", style, wrong);

  // another drive or load than in the run that wrote the file begins anew, as after fix_modify
  const bool other_wave = amplitude.is_number() && state.amplitude != amplitude.value;
  if (state.drive != drive || (drive == OSCILLATE && (other_wave || state.frequency != frequency)))
    start_drive();
  if (state.load != load) start_load(false);
}

/* ---------------------------------------------------------------------- */

double FixRheometerPlates::memory_usage()
{
  return keeper->memory_usage();
}
