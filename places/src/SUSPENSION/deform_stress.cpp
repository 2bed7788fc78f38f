/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "deform_stress.h"

#include "atom.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_hydro.h"
#include "force.h"
#include "lubcontact_inertia.h"
#include "modify.h"
#include "pair.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

DeformStress::DeformStress(LAMMPS *lmp, Fix *owner) :
    Pointers(lmp), fix(owner), virial_id(std::string(owner->id) + "_virial"), hydro(nullptr),
    pressure_now(0.0), stress_now(0.0), fluid_now(0.0), drainage_now(0.0)
{
  pair_virial = modify->add_compute(virial_id + " all pressure NULL pair");
}

DeformStress::~DeformStress()
{
  if (modify->get_compute_by_id(virial_id)) modify->delete_compute(virial_id);
}

/* ---------------------------------------------------------------------- */

void DeformStress::init()
{
  pair_virial = modify->get_compute_by_id(virial_id);
  hydro = FixHydro::find(lmp);
  if (!pair_virial) error->all(FLERR, "Compute {} of fix {} was deleted", virial_id, fix->style);
  Particles mine, all;
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & fix->groupbit) add_particle(i, atom->mask[i] & massless, mine);
  MPI_Allreduce(&mine.volume, &all.volume, sizeof(Particles) / sizeof(double), MPI_DOUBLE, MPI_SUM,
                world);
  take_particles(all);
}

void DeformStress::announce(bigint step)
{
  pair_virial->addstep(step);
}

/* ---------------------------------------------------------------------- */

void DeformStress::add_particle(int i, bool massless, Particles &sum) const
{
  const double r = atom->radius[i];
  sum.volume += Suspension_NS::particle_volume(domain, r);
  if (!massless) sum.mass += atom->rmass[i];
  sum.radius += r;
  sum.number += 1.0;
}

/* ----------------------------------------------------------------------
   The last bits of a sum depend on the ranks that the particles are on: sums that differ in nothing
   else stay as they were
------------------------------------------------------------------------- */

void DeformStress::take_particles(const Particles &now)
{
  using Suspension_NS::is_same_sum;
  if (now.volume == 0.0)
    error->all(FLERR, "Fix {}: {}no particles with a radius in its group at step {}", fix->style,
               sums.volume > 0.0 ? "Lost atoms: there are " : "", update->ntimestep);
  const Particles &before = sums;
  const bool same = is_same_sum(before.volume, now.volume) && is_same_sum(before.mass, now.mass) &&
      is_same_sum(before.radius, now.radius) && is_same_sum(before.number, now.number);
  if (!same) sums = now;
  scales.density = sums.mass / sums.volume * force->mvv2e * force->nktv2p;
  scales.diameter = 2.0 * sums.radius / sums.number;
  scales.inertia = scales.density * scales.diameter * scales.diameter;
}

/* ----------------------------------------------------------------------
   of the particles: pair forces, stresslets, and inertia relative to the flow g. The compute only
   asks for the virial in time; reducing it here together with the rest saves one reduction.
   Particles may come, go and grow, so they are measured, too
------------------------------------------------------------------------- */

void DeformStress::measure(Rheometer_NS::Flow flow, const Rheometer_NS::Gradient &g)
{
  struct Sums {
    double pairs[4] = {};    // xx yy zz xy, with the stresslets
    Particles particles;
    Lubcontact_NS::Inertia inertia;
  } mine, all;
  const double lo[3] = {domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]};
  const int nlocal = atom->nlocal;
  const int *mask = atom->mask;
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  for (int i = 0; i < nlocal; i++) {
    if (!(mask[i] & fix->groupbit)) continue;
    add_particle(i, mask[i] & massless, mine.particles);
    if (mask[i] & massless) continue;
    const double *x = atom->x[i], *v = atom->v[i];
    const double y = x[1] - lo[1];
    mine.inertia.add(
        atom->rmass[i],
        {v[0] - g.xx * (x[0] - lo[0]) - g.xy * y, v[1] - g.yy * y, v[2] - g.zz * (x[2] - lo[2])});
  }
  if (force->pair) std::copy_n(force->pair->virial, 4, mine.pairs);
  if (hydro) {
    double nine[9] = {};
    hydro->add_stresslets(nine);
    for (int n = 0; n < 4; n++) mine.pairs[n] += nine[n];
  }
  MPI_Allreduce(mine.pairs, all.pairs, sizeof(Sums) / sizeof(double), MPI_DOUBLE, MPI_SUM, world);
  take_particles(all.particles);

  const double size = Suspension_NS::cell_volume(domain);
  const double scale = -force->nktv2p / size, unit = force->mvv2e;
  const Lubcontact_NS::Fluctuation k = Lubcontact_NS::fluctuation(all.inertia);
  const Rheometer_NS::Stress now = {
      scale * (all.pairs[0] + unit * k.xx), scale * (all.pairs[1] + unit * k.yy),
      scale * (all.pairs[2] + unit * k.zz), scale * (all.pairs[3] + unit * k.xy)};
  pressure_now = Rheometer_NS::pressure(flow, domain->dimension, now);
  stress_now = Rheometer_NS::driving_stress(flow, now);
}

void DeformStress::drain(double drainage, double dilation)
{
  drainage_now = drainage;
  fluid_now = -drainage * dilation;
}

/* ---------------------------------------------------------------------- */

double DeformStress::phi() const
{
  return sums.volume / Suspension_NS::cell_volume(domain);
}

void DeformStress::add_to_means(double strain, double dt)
{
  Rheometer_NS::add(averages, pressure(), stress_now, strain, dt);
}
