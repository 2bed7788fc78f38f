/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The loop for pairs with adhesion and repulsion.

#include "pair_lubcontact_loop.h"

using namespace LAMMPS_NS;

template void PairLubcontact::choose_extended<Lubcontact_NS::ADHESION | Lubcontact_NS::REPULSION>();
