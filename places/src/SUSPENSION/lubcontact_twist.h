/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Twisting torque of the film, regularized by a spring in series so that it never limits the step.
// Resistance: twist_resistance() in lubcontact_film.h.

#ifndef LUBCONTACT_TWIST_H
#define LUBCONTACT_TWIST_H

#include "lubcontact_defs.h"
#include "lubcontact_maxwell.h"

namespace LAMMPS_NS::Lubcontact_NS {

// Elastic part of the relative twist after a step: twist the relative rotation of the step about
// n. Torque on i: -stiffness q n.
LUBCONTACT_FN inline double next_twist(double q0, double twist, double resistance,
                                       double stiffness_dt)
{
  const Relaxation f = relaxation(resistance, stiffness_dt);
  return f.keep * q0 + f.gain * twist;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
