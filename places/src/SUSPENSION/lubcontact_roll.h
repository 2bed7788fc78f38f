/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Rolling torque of the film, regularized by a spring in series so that it never limits the step.
// Resistance: roll_resistance() in lubcontact_film.h.

#ifndef LUBCONTACT_ROLL_H
#define LUBCONTACT_ROLL_H

#include "lubcontact_defs.h"
#include "lubcontact_maxwell.h"
#include "lubcontact_vec3.h"

namespace LAMMPS_NS::Lubcontact_NS {

// Elastic part of the relative rolling after a step: q0 already turned with the pair, roll the
// relative rolling of the step. Torque on i: -stiffness q.
LUBCONTACT_FN inline Vec3 next_roll(const Vec3 &q0, const Vec3 &roll, double resistance,
                                    double stiffness_dt)
{
  const Relaxation f = relaxation(resistance, stiffness_dt);
  return f.keep * q0 + f.gain * roll;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
