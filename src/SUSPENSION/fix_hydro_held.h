/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The numbers that fix hydro grid holds of a particle.

#ifndef LMP_FIX_HYDRO_HELD_H
#define LMP_FIX_HYDRO_HELD_H

#include "hydro_tensors.h"

namespace LAMMPS_NS::Hydro_NS {

// of a particle: load of the last solution and of the one before, velocity and spin of the last
// one, and the factor of the drag with which its force follows them, if it is more than that of all
static constexpr int LOAD = 0, BEFORE = NUMBERS, MOTION = 2 * NUMBERS, HOLD = MOTION + 6,
                     NUM_HELD = HOLD + 1;

}    // namespace LAMMPS_NS::Hydro_NS

#endif
