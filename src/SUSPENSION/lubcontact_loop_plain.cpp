/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The loop for pairs with neither adhesion nor repulsion.

#include "lubcontact_loop_instances.h"

using namespace LAMMPS_NS;

template void LAMMPS_NS::find_extended<0>(LubcontactInstance &);
