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
using Rheometer_NS::LOWER;
using Rheometer_NS::UPPER;

/* ---------------------------------------------------------------------- */

int FixRheometerPlates::setmask()
{
  return INITIAL_INTEGRATE | POST_INTEGRATE | PRE_NEIGHBOR | POST_FORCE | FINAL_INTEGRATE |
      MIN_POST_FORCE;
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

Rheometer_NS::Material FixRheometerPlates::material() const
{
  const double rho = state.density / force->ftm2v;
  return {viscosity.value, rho, state.diameter, rho * state.diameter * state.gap};
}

Rheometer_NS::WallStress FixRheometerPlates::stress_on(int plate) const
{
  return Rheometer_NS::wall_stress(static_cast<Rheometer_NS::Plate>(plate), force_on[plate],
                                   area());
}

/* ----------------------------------------------------------------------
   targets of this step
------------------------------------------------------------------------- */

void FixRheometerPlates::evaluate_targets()
{
  modify->clearstep_compute();
  bool any = false;
  for (Suspension_NS::InputNumber *target : {&target_x, &amplitude, &target_y, &viscosity})
    if (target->evaluate(lmp)) any = true;
  if (any) modify->addstep_compute(update->ntimestep + 1);
  if (!own_viscosity) viscosity.value = pair_eta ? *pair_eta : 0.0;
  check_values();
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::half_kick_x(double dt)
{
  const double push = target_x.value / force->nktv2p * area() + force_on[UPPER][0];
  state.vx = Rheometer_NS::damped_velocity(state.vx, push, moving_mass(), damper_x, 0.5 * dt);
}

void FixRheometerPlates::half_kick_y(double dt)
{
  const double push = force_on[UPPER][1] - target_y.value / force->nktv2p * area();
  state.vy = Rheometer_NS::damped_velocity(state.vy, push, moving_mass(), damper_y, 0.5 * dt);
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::move_y(double dt)
{
  if (load == GAP) {
    state.vy = 0.0;
  } else if (load == LOAD) {
    half_kick_y(dt);
  } else {
    state.dilation =
        Rheometer_NS::next_dilation(material(), state.dilation, stress_on(UPPER).pressure,
                                    target_y.value / force->nktv2p, state.rate, gain, dt);
    state.vy = Rheometer_NS::dilation_velocity(state.gap, state.dilation, dt);
  }
}

/* ---------------------------------------------------------------------- */

double FixRheometerPlates::rate_of_drive(double dt)
{
  if (drive == OSCILLATE)
    return Rheometer_NS::oscillation_rate(target_x.value, amplitude.value, frequency, state.clock,
                                          dt);
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
  Rheometer_NS::Deformation flow;
  flow.yy = state.gap / listed.gap;
  flow.xy = listed.slid / listed.gap;
  const double origin[3] = {0.0, listed.bottom, 0.0};
  if (!keeper->decide({flow, Rheometer_NS::Deformation()}, origin))
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

  const Rheometer_NS::WallStress low = stress_on(LOWER), up = stress_on(UPPER);
  Rheometer_NS::add(state.means, 0.5 * (low.pressure + up.pressure), 0.5 * (low.xy + up.xy),
                    state.rate * dt, dt);
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::write_restart(FILE *fp)
{
  if (comm->me) return;
  state.drive = drive;
  state.load = load;
  state.amplitude = amplitude.value;
  state.frequency = frequency;
  Suspension_NS::write_sealed(fp, state);
}

void FixRheometerPlates::restart(char *buffer)
{
  if (const char *wrong = Suspension_NS::read_sealed(buffer, state))
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
