/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Instances of the loop with residual films.

#include "lubcontact_loop_instances.h"

void LAMMPS_NS::find_residual(LubcontactInstance &found)
{
  Lubcontact_NS::with_residual_effects(found.covering, [&found](auto effects) {
    take_instance<decltype(effects)>(found);
  });
}
