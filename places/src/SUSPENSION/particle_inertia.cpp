/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "particle_inertia.h"

#include "atom.h"
#include "lammps.h"
#include "suspension_host.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

Lubcontact_NS::Vec3 Suspension_NS::relative_velocity(LAMMPS *lmp, int i)
{
  const double *v = lmp->atom->v[i];
  const auto flow = CellFlow(lmp->domain).at(lmp->atom->x[i]);
  return {v[0] - flow[0], v[1] - flow[1], v[2] - flow[2]};
}

/* ---------------------------------------------------------------------- */

Lubcontact_NS::Inertia Suspension_NS::measure_inertia(LAMMPS *lmp)
{
  const Atom *atom = lmp->atom;
  const int massless = groups_without_inertia(lmp);
  Lubcontact_NS::Inertia sum;
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->mask[i] & massless) continue;
    const double m = atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
    sum.add(m, relative_velocity(lmp, i));
  }
  return sum;
}
