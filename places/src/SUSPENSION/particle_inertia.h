/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The motion of the particles relative to the cell, and what inertia adds to the stress.

#ifndef LMP_PARTICLE_INERTIA_H
#define LMP_PARTICLE_INERTIA_H

#include "lubcontact_inertia.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace LAMMPS_NS::Suspension_NS {

// velocity of atom i relative to that of the deforming cell
Lubcontact_NS::Vec3 relative_velocity(LAMMPS *, int i);

// of all atoms of this rank but those of fix overdamped/sphere, which have no inertia
Lubcontact_NS::Inertia measure_inertia(LAMMPS *);

}    // namespace LAMMPS_NS::Suspension_NS

#endif
