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
#include "exclusive_particles.h"
#include "force.h"
#include "group.h"
#include "list_keeper.h"
#include "plates_state.h"
#include "plates_targets.h"
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
  targets->evaluate();
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
  return (targets->mass() > 0.0 ? targets->mass() : state->plate_mass) / force->ftm2v;
}

Rheometer_NS::Material FixRheometerPlates::material() const
{
  const double rho = state->density / force->ftm2v;
  return {targets->viscosity(), rho, state->diameter, rho * state->diameter * state->gap};
}

void FixRheometerPlates::drain(double of_layer)
{
  drainage = of_layer;
}

double FixRheometerPlates::fluid_pressure() const
{
  return state->gap > 0.0 ? -drainage * state->vy / state->gap : 0.0;
}

/* ----------------------------------------------------------------------
   of particles and fluid
------------------------------------------------------------------------- */

Rheometer_NS::WallStress FixRheometerPlates::stress_on(int plate) const
{
  Rheometer_NS::WallStress stress =
      Rheometer_NS::wall_stress(static_cast<Rheometer_NS::Plate>(plate), force_on[plate], area());
  stress.pressure += fluid_pressure();
  return stress;
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::half_kick_x(double dt)
{
  const double push = targets->x() / force->nktv2p * area() + force_on[UPPER][0];
  state->vx =
      Rheometer_NS::damped_velocity(state->vx, push, moving_mass(), targets->damper_x(), 0.5 * dt);
}

void FixRheometerPlates::half_kick_y(double dt)
{
  const double push = force_on[UPPER][1] - targets->pressure() / force->nktv2p * area();
  state->vy = Rheometer_NS::damped_velocity(state->vy, push, moving_mass(), damper(1), 0.5 * dt);
}

/* ---------------------------------------------------------------------- */

bool FixRheometerPlates::is_pushed(int d) const
{
  return (d == 0 && targets->drive() == PlatesTargets::STRESS) ||
      (d == 1 && targets->load() == PlatesTargets::LOAD);
}

double FixRheometerPlates::damper(int d) const
{
  if (d == 0) return targets->damper_x();
  return targets->damper_y() + (drainage > 0.0 ? drainage * area() / state->gap : 0.0);
}

bool FixRheometerPlates::has_servo() const
{
  return targets->load() == PlatesTargets::PRESSURE;
}

bool FixRheometerPlates::has_gap() const
{
  return targets->load() == PlatesTargets::GAP;
}

void FixRheometerPlates::evaluate_targets()
{
  targets->evaluate();
}

double FixRheometerPlates::response(int d, double mass, double dt) const
{
  if (!is_pushed(d)) return 0.0;
  if (targets->mass() > 0.0) mass = targets->mass();
  return Rheometer_NS::damped_velocity(0.0, 1.0, mass / force->ftm2v, damper(d), dt) / dt;
}

double FixRheometerPlates::velocity_after(int d, double push, double mass, double dt) const
{
  const double now = d == 0 ? state->vx : d == 1 ? state->vy : 0.0;
  if (!is_pushed(d)) return now;
  if (targets->mass() > 0.0) mass = targets->mass();
  push += (d == 0 ? targets->x() : -targets->pressure()) / force->nktv2p * area();
  return Rheometer_NS::damped_velocity(now, push, mass / force->ftm2v, damper(d), dt);
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::move_y(double dt)
{
  if (targets->load() == PlatesTargets::GAP) {
    state->vy = 0.0;
  } else if (targets->load() == PlatesTargets::LOAD) {
    half_kick_y(dt);
  } else {
    const double of_particles = force_on[UPPER][1] / area();
    state->dilation = Rheometer_NS::next_dilation(material(), state->dilation, of_particles,
                                                  targets->pressure() / force->nktv2p, state->rate,
                                                  targets->gain(), dt, drainage);
    state->vy = Rheometer_NS::dilation_velocity(state->gap, state->dilation, dt);
  }
}

/* ---------------------------------------------------------------------- */

double FixRheometerPlates::rate_of_drive(double dt)
{
  if (targets->drive() == PlatesTargets::OSCILLATE)
    return Rheometer_NS::oscillation_rate(targets->x(), targets->amplitude(), targets->frequency(),
                                          state->clock, dt);
  if (targets->drive() == PlatesTargets::IV)
    return targets->x() * targets->pressure() / force->nktv2p / targets->viscosity();
  return targets->x();
}

/* ----------------------------------------------------------------------
   rates are those of the gap in the middle of the step
------------------------------------------------------------------------- */

void FixRheometerPlates::initial_integrate(int /*vflag*/)
{
  const double dt = update->dt;
  targets->evaluate();
  move_y(dt);
  const double middle = state->gap + 0.5 * dt * state->vy;
  state->gap += dt * state->vy;
  if (!(state->gap > 0.0))
    error->all(FLERR,
               "Fix rheometer/plates: the plates touch each other at step {}; reduce the pressure, "
               "or put more particles between them",
               update->ntimestep);

  if (targets->drive() == PlatesTargets::STRESS || targets->drive() == PlatesTargets::VELOCITY) {
    if (targets->drive() == PlatesTargets::STRESS)
      half_kick_x(dt);
    else
      state->vx = targets->x();
    state->rate = state->vx / middle;
  } else {
    state->rate = rate_of_drive(dt);
    state->vx = state->rate * middle;
  }
  state->strain += state->rate * dt;
  state->clock += dt;
  listed.slid += dt * state->vx;
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
  if (!keeper->allowed()) return;
  double top;
  measure_surfaces(listed.bottom, top);
  listed.gap = top - listed.bottom;
  listed.slid = 0.0;
}

void FixRheometerPlates::post_integrate()
{
  if (!keeper->allowed()) return;
  Rheometer_NS::Deformation flow;
  flow.yy = state->gap / listed.gap;
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
      atom->x[i][0] += dt * state->vx;
      atom->x[i][1] += dt * state->vy;
    }
}

void FixRheometerPlates::set_velocities()
{
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & plate_bits())) continue;
    own->check(atom->mask[i]);
    const bool moves = atom->mask[i] & bit[UPPER];
    double *v = atom->v[i], *omega = atom->omega[i];
    v[0] = moves ? state->vx : 0.0;
    v[1] = moves ? state->vy : 0.0;
    v[2] = omega[0] = omega[1] = omega[2] = 0.0;
  }
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::final_integrate()
{
  const double dt = update->dt;
  if (targets->drive() == PlatesTargets::STRESS) half_kick_x(dt);
  if (targets->load() == PlatesTargets::LOAD) half_kick_y(dt);
  if (targets->drive() == PlatesTargets::STRESS || targets->load() == PlatesTargets::LOAD)
    set_velocities();
  watch_targets(dt);

  const Rheometer_NS::WallStress low = stress_on(LOWER), up = stress_on(UPPER);
  Rheometer_NS::add(state->means, 0.5 * (low.pressure + up.pressure), 0.5 * (low.xy + up.xy),
                    state->rate * dt, dt);
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::write_restart(FILE *fp)
{
  if (comm->me) return;
  state->drive = targets->drive();
  state->load = targets->load();
  state->amplitude = targets->amplitude();
  state->frequency = targets->frequency();
  Suspension_NS::write_sealed(fp, *state);
}

void FixRheometerPlates::restart(char *buffer)
{
  if (const char *wrong = Suspension_NS::read_sealed(buffer, *state))
    error->all(FLERR, "The part of fix {} in the restart file {}", style, wrong);

  // another drive or load than in the run that wrote the file begins anew, as after fix_modify
  if (targets->turned_from(*state)) start_drive();
  if (state->load != targets->load()) start_load(false);
}

/* ---------------------------------------------------------------------- */

double FixRheometerPlates::memory_usage()
{
  return keeper->memory_usage();
}
