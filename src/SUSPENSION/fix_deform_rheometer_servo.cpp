/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the rheometer measures, and how it follows its targets.

#include "fix_deform_rheometer.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "lubcontact_inertia.h"
#include "pair.h"
#include "rheometer_flow.h"
#include "rheometer_mean.h"
#include "rheometer_servo.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using Rheometer_NS::Gradient;
using Rheometer_NS::Stress;

/* ----------------------------------------------------------------------
   viscosity of pair style lubcontact, alone or of all of its kind under hybrid
------------------------------------------------------------------------- */

void FixDeformRheometer::find_viscosity()
{
  pair_viscosity = Suspension_NS::viscosity_of_pair(lmp);
  if (pair_viscosity) return;
  const bool needed = drive == IV || drive == STRESS || confinement == PRESSURE;
  const std::size_t styles = Suspension_NS::all_lubcontact(lmp).size();
  const bool several = styles > 1;
  if (styles && (needed || !several))
    error->all(FLERR,
               "Fix {} cannot take the viscosity of the pair style, {}; give it: viscosity {}",
               style, Suspension_NS::why_no_viscosity(lmp), several ? "eta" : "v_name");
  if (needed)
    error->all(FLERR, "Fix {} needs the viscosity of the fluid; add: viscosity eta (0 if dry)",
               style);
}

/* ----------------------------------------------------------------------
   volume, size and density of the particles. The last bits of a sum depend on the ranks that the
   particles are on: sums that differ in nothing else stay as they were
------------------------------------------------------------------------- */

void FixDeformRheometer::add_particle(int i, bool massless, double *sum) const
{
  const double r = atom->radius[i];
  sum[0] += Suspension_NS::particle_volume(domain, r);
  if (!massless) sum[1] += atom->rmass[i];
  sum[2] += r;
  sum[3] += 1.0;
}

void FixDeformRheometer::take_particles(const double *all)
{
  if (all[0] == 0.0)
    error->all(FLERR, "Fix {}: {}no particles with a radius in its group at step {}", style,
               particles[0] > 0.0 ? "Lost atoms: there are " : "", update->ntimestep);
  bool same = true;
  for (int n = 0; n < NUM_PARTICLES; n++)
    if (!Suspension_NS::is_same_sum(particles[n], all[n])) same = false;
  if (!same) std::copy_n(all, NUM_PARTICLES, particles);
  material->density = particles[1] / particles[0] * force->mvv2e * force->nktv2p;
  material->diameter = 2.0 * particles[2] / particles[3];
  material->inertia = material->density * material->diameter * material->diameter;
}

void FixDeformRheometer::measure_particles()
{
  double mine[NUM_PARTICLES] = {}, all[NUM_PARTICLES];
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) add_particle(i, atom->mask[i] & massless, mine);
  MPI_Allreduce(mine, all, NUM_PARTICLES, MPI_DOUBLE, MPI_SUM, world);
  take_particles(all);
}

/* ----------------------------------------------------------------------
   stress of the particles: pair forces, and inertia relative to the flow. The compute only asks for
   the virial in time; reducing it here together with the rest saves one reduction. Particles may come,
   go and grow, so they are measured, too
------------------------------------------------------------------------- */

void FixDeformRheometer::measure_stress()
{
  struct Sums {
    double pairs[4] = {};    // xx yy zz xy
    double particles[NUM_PARTICLES] = {};
    Lubcontact_NS::Inertia inertia;
  } mine, all;
  // what has become of the flow, whose particles move at a constant velocity
  const Gradient g = Rheometer_NS::at_end(*gradient, moved);
  const double lo[3] = {domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]};
  const int nlocal = atom->nlocal;
  const int *mask = atom->mask;
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  for (int i = 0; i < nlocal; i++) {
    if (!(mask[i] & groupbit)) continue;
    add_particle(i, mask[i] & massless, mine.particles);
    if (mask[i] & massless) continue;
    const double *x = atom->x[i], *v = atom->v[i];
    const double y = x[1] - lo[1];
    mine.inertia.add(
        atom->rmass[i],
        {v[0] - g.xx * (x[0] - lo[0]) - g.xy * y, v[1] - g.yy * y, v[2] - g.zz * (x[2] - lo[2])});
  }
  if (force->pair) std::copy_n(force->pair->virial, 4, mine.pairs);
  MPI_Allreduce(mine.pairs, all.pairs, sizeof(Sums) / sizeof(double), MPI_DOUBLE, MPI_SUM, world);
  take_particles(all.particles);

  const double size = Suspension_NS::cell_volume(domain);
  const double scale = -force->nktv2p / size, unit = force->mvv2e;
  const Lubcontact_NS::Fluctuation k = Lubcontact_NS::fluctuation(all.inertia);
  const Stress stress = {scale * (all.pairs[0] + unit * k.xx), scale * (all.pairs[1] + unit * k.yy),
                         scale * (all.pairs[2] + unit * k.zz),
                         scale * (all.pairs[3] + unit * k.xy)};
  const auto f = static_cast<Rheometer_NS::Flow>(flow);
  measured_pressure = Rheometer_NS::pressure(f, domain->dimension, stress);
  measured_stress = Rheometer_NS::driving_stress(f, stress);
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::update_targets()
{
  for (Suspension_NS::InputNumber *target :
       {&driven, &amplitude, &frequency, &pressure, &viscosity})
    target->evaluate(lmp);
  if (!viscosity_given && pair_viscosity) viscosity.value = *pair_viscosity;

  if (confinement == VOLUME && drive == IV)
    error->all(FLERR,
               "Fix {} cannot hold a viscous number at constant volume, where it follows from the "
               "volume fraction: give a pressure, or a rate",
               style);
  if (confinement == PRESSURE && !(pressure.value > 0.0))
    error->all(FLERR, "Fix {} pressure must be > 0, but is {}", style, pressure.value);
  if (!(viscosity.value >= 0.0))
    error->all(FLERR, "Fix {} viscosity must be >= 0, but is {}", style, viscosity.value);
  if (drive == IV && viscosity.value == 0.0)
    error->all(FLERR, "Fix {} cannot hold a viscous number without viscosity: give a rate", style);
  material->eta = force->nktv2p * viscosity.value;
}

/* ---------------------------------------------------------------------- */

double FixDeformRheometer::next_rate() const
{
  switch (drive) {
    case IV:
      return driven.value * pressure.value / material->eta;
    case OSCILLATE:
      return Rheometer_NS::oscillation_rate(driven.value, amplitude.value, frequency.value, time,
                                            interval());
    case STRESS:
      return Rheometer_NS::next_rate(
          *material, rate, measured_stress, driven.value,
          Rheometer_NS::trouton_ratio(static_cast<Rheometer_NS::Flow>(flow)), interval());
    default:
      return driven.value;
  }
}

/* ---------------------------------------------------------------------- */

double FixDeformRheometer::next_dilation() const
{
  if (confinement == VOLUME) return 0.0;
  return Rheometer_NS::next_dilation(*material, dilation, measured_pressure, pressure.value, rate,
                                     gain, interval());
}

/* ----------------------------------------------------------------------
   is the target followed, and will it ever be reached?
------------------------------------------------------------------------- */

void FixDeformRheometer::judge()
{
  using namespace Rheometer_NS;
  state = IDLE;
  if (!warned_every && (confinement == PRESSURE || drive == STRESS) &&
      fabs(rate) * interval() > 0.5 * LAG) {
    if (comm->me == 0)
      error->warning(FLERR,
                     "Fix {}: the strain {:.3g} between two adjustments of the flow is more than "
                     "half the lag of the servos, {}: reduce every, or the time step",
                     style, fabs(rate) * interval(), LAG);
    warned_every = true;
  }
  if (confinement == PRESSURE) {
    const double target = pressure.value;
    const double w = servo_rate(*material, rate, target, PRESSURE_FLOOR);
    *watch_pressure = watch(*watch_pressure, measured_pressure / target - 1.0, w, interval());
    state = fabs(dilation) < dilation_limit(*material, target, rate, gain) ? FOLLOWING : LIMITED;
    if (unreachable(*watch_pressure)) {
      state = UNREACHABLE;
      if (!warned && comm->me == 0)
        error->warning(FLERR,
                       "Fix {}: the pressure, now {:.4g}, has been far from its target {:.4g} for "
                       "{:.3g} units of strain: it cannot be reached in this scene",
                       style, measured_pressure, target, watch_pressure->age);
      warned = true;
    }
  }
  if (drive == STRESS) judge_stress();
}

/* ----------------------------------------------------------------------
   out of reach: nothing resists enough. Jammed: the stress is carried without flow
------------------------------------------------------------------------- */

void FixDeformRheometer::judge_stress()
{
  using namespace Rheometer_NS;
  const double target = driven.value;
  const double creep = STRESS_FLOOR * rearrangement_rate(*material, target);
  if (state == IDLE) state = FOLLOWING;
  if (creep == 0.0) return;
  const double w = servo_rate(*material, rate, target, STRESS_FLOOR);
  const double total =
      measured_stress + trouton_ratio(static_cast<Flow>(flow)) * material->eta * rate;
  *watch_stress = watch(*watch_stress, total / target - 1.0, w, interval());
  if (unreachable(*watch_stress)) {
    state = UNREACHABLE;
    if (!warned && comm->me == 0)
      error->warning(FLERR,
                     "Fix {}: the stress, now {:.4g} at the rate {:.4g}, has been far from its "
                     "target {:.4g} for {:.3g} units of strain: it cannot be reached in this scene",
                     style, total, rate, target, watch_stress->age);
    warned = true;
  }
  *watch_rate = watch(*watch_rate, fabs(rate) / creep, w, interval());
  if (!jammed(*watch_rate)) return;
  state = UNREACHABLE;
  if (!warned && comm->me == 0)
    error->warning(FLERR,
                   "Fix {}: jammed, the particles carry the stress {:.4g} without flowing; mean "
                   "rate {:.3g}",
                   style, target, watch_rate->deviation * creep);
  warned = true;
}

/* ---------------------------------------------------------------------- */

double FixDeformRheometer::compute_vector(int n)
{
  switch (n) {
    case Output::STRAIN:
      return strain;
    case Output::RATE:
      return rate;
    case Output::PHI:
      return particles[0] / Suspension_NS::cell_volume(domain);
    case Output::PRESSURE:
      return measured_pressure;
    case Output::STRESS:
      return measured_stress;
    case Output::PRESSURE_TARGET:
      return confinement == VOLUME ? 0.0 : pressure.value;
    case Output::TARGET:
      return driven.value;
    case Output::DILATION:
      return dilation;
    case Output::PATH:
      return path;
    case Output::STATE:
      return state;
    default:
      return Rheometer_NS::mean_output(*averages, n - Output::MEANS, measured_pressure,
                                       measured_stress);
  }
}
