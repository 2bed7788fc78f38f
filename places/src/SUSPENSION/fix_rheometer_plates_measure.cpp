/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix rheometer/plates measures: gap, particles, and whether the targets are reached.

#include "fix_rheometer_plates.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "plates_state.h"
#include "plates_targets.h"
#include "rheometer_plate.h"
#include "rheometer_servo.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using Rheometer_NS::LOWER;
using Rheometer_NS::UPPER;

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
  measured(state->gap, top - bottom, fabs(top) + fabs(bottom));
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
  sum[VOLUME] += Suspension_NS::particle_volume(domain, r);
  if (!massless) sum[MASS] += atom->rmass[i];
  sum[DIAMETER] += 2.0 * r;
  sum[NUMBER] += 1.0;
}

void FixRheometerPlates::take_particles(const double *all)
{
  if (targets->load() == PlatesTargets::PRESSURE && all[NUMBER] == 0.0)
    error->all(FLERR,
               "Fix rheometer/plates cannot impose a pressure: group {} of the suspended "
               "particles is empty",
               group->names[igroup]);
  const double number = MAX(all[NUMBER], 1.0), volume = all[NUMBER] > 0.0 ? all[VOLUME] : 1.0;
  measured(state->solid, all[VOLUME], all[VOLUME]);
  measured(state->density, all[MASS] / volume, all[MASS] / volume);
  measured(state->diameter, all[DIAMETER] / number, all[DIAMETER] / number);
  measured(state->plate_mass, all[PLATE], all[PLATE]);
}

void FixRheometerPlates::measure_particles()
{
  double mine[NUM] = {}, all[NUM];
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  for (int i = 0; i < atom->nlocal; i++) add_particle(i, atom->mask[i] & massless, mine);
  MPI_Allreduce(mine, all, NUM, MPI_DOUBLE, MPI_SUM, world);
  take_particles(all);
}

/* ----------------------------------------------------------------------
   forces of the suspension on the plates, those between plate and plate included; and the particles
   once more, which come, go and grow
------------------------------------------------------------------------- */

void FixRheometerPlates::post_force(int /*vflag*/)
{
  Sums mine, all;
  const int massless = Suspension_NS::groups_without_inertia(lmp);
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
   are the targets reached? warns once
------------------------------------------------------------------------- */

void FixRheometerPlates::watch_targets(double dt)
{
  const Rheometer_NS::Material m = material();
  const Rheometer_NS::WallStress wall = stress_on(UPPER);
  // returns the state of the target; w: rate at which its control answers
  auto watch = [&](double measured, double target, double w, double &deviation, double &age,
                   double &warned, const char *what, const char *cause) {
    if (target == 0.0 || !std::isfinite(w) || w == 0.0) return Rheometer_NS::FOLLOWING;
    const Rheometer_NS::Watch now =
        Rheometer_NS::watch({deviation, age}, (measured - target) / target, w, dt);
    deviation = now.deviation;
    age = now.age;
    if (!Rheometer_NS::unreachable(now)) return Rheometer_NS::FOLLOWING;
    if (warned == 0.0 && comm->me == 0)
      error->warning(FLERR,
                     "Fix rheometer/plates does not reach the {} {:.6g}: it is {:.3g} on average; "
                     "{}",
                     what, target * force->nktv2p, (1.0 + deviation) * target * force->nktv2p,
                     cause);
    warned = 1.0;
    return Rheometer_NS::UNREACHABLE;
  };

  state->code_x = state->code_y = Rheometer_NS::IDLE;
  if (targets->drive() == PlatesTargets::STRESS) {
    const double s = targets->x() / force->nktv2p;
    state->code_x = watch(
        wall.xy, s, Rheometer_NS::servo_rate(m, state->rate, s, Rheometer_NS::STRESS_FLOOR),
        state->deviation_x, state->age_x, state->warned_x, "shear stress",
        "the suspension cannot resist it, or the plate is so heavy that it still accelerates");
  }
  if (targets->load() == PlatesTargets::GAP) return;
  const double p = targets->pressure() / force->nktv2p;
  const double w = Rheometer_NS::servo_rate(m, state->rate, p, Rheometer_NS::PRESSURE_FLOOR);
  state->code_y =
      watch(wall.pressure, p, w, state->deviation_y, state->age_y, state->warned_y, "pressure",
            "the suspension is jammed or too dilute to carry the pressure, or the plate moves too "
            "slowly");
  if (targets->load() == PlatesTargets::PRESSURE && state->code_y == Rheometer_NS::FOLLOWING &&
      fabs(state->dilation) >= Rheometer_NS::dilation_limit(m, p, state->rate, targets->gain()))
    state->code_y = Rheometer_NS::LIMITED;
}

/* ---------------------------------------------------------------------- */

double FixRheometerPlates::gap() const
{
  return state->gap;
}

double FixRheometerPlates::velocity() const
{
  return state->vx;
}

double FixRheometerPlates::opening() const
{
  return state->vy;
}

double FixRheometerPlates::rate() const
{
  return state->rate;
}

const Rheometer_NS::StrainMeans &FixRheometerPlates::means() const
{
  return state->means;
}

double FixRheometerPlates::phi() const
{
  return state->gap > 0.0 ? state->solid / (area() * state->gap) : 0.0;
}

double FixRheometerPlates::imposed_pressure() const
{
  return targets->load() == PlatesTargets::GAP ? 0.0 : targets->pressure();
}

/* ---------------------------------------------------------------------- */

double FixRheometerPlates::compute_vector(int n)
{
  const double unit = force->nktv2p;
  const Rheometer_NS::WallStress low = stress_on(LOWER), up = stress_on(UPPER);
  switch (n) {
    case Output::STRAIN:
      return state->strain;
    case Output::RATE:
      return state->rate;
    case Output::GAP:
      return state->gap;
    case Output::VX:
      return state->vx;
    case Output::VY:
      return state->vy;
    case Output::PHI:
      return phi();
    case Output::LOWER_PRESSURE:
      return low.pressure * unit;
    case Output::UPPER_PRESSURE:
      return up.pressure * unit;
    case Output::LOWER_XY:
      return low.xy * unit;
    case Output::UPPER_XY:
      return up.xy * unit;
    case Output::LOWER_ZY:
      return low.zy * unit;
    case Output::UPPER_ZY:
      return up.zy * unit;
    case Output::TARGET_X:
      return targets->x();
    case Output::TARGET_Y:
      return imposed_pressure();
    case Output::CODE_X:
      return state->code_x;
    case Output::CODE_Y:
      return state->code_y;
  }
  const int m = n - Output::MEANS;
  const double mean = Rheometer_NS::mean_output(state->means, m, 0.5 * (low.pressure + up.pressure),
                                                0.5 * (low.xy + up.xy));
  return m == Rheometer_NS::MEAN_OUTPUTS - 1 ? mean : mean * unit;
}
