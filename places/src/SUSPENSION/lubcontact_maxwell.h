/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Maxwell element, spring and film in series, over one time step: shared by shear, roll and twist.
//     dq/dt = rate - (stiffness/resistance) q,  force = -stiffness q
// with q the elastic part of the displacement, integrated by q1 = keep q0 + gain (rate dt), keep
// and gain being rational in stiffness dt/resistance: second order, positive, L-stable, and exact
// in steady motion, where the force is that of the film alone. So the film never limits the time
// step, however thick or thin it is.

#ifndef LUBCONTACT_MAXWELL_H
#define LUBCONTACT_MAXWELL_H

#include "lubcontact_defs.h"

namespace LAMMPS_NS::Lubcontact_NS {

struct Relaxation {
  double keep;    // what remains of the old displacement
  double gain;    // what the displacement of this step adds
};

// With x = stiffness dt/resistance: keep = 1/(1 + x + x^2/2), gain = (1 + x/2) keep. No resistance
// leaves nothing; stiffness_dt must be positive.
LUBCONTACT_FN inline Relaxation relaxation(double resistance, double stiffness_dt)
{
  const double R = resistance, S = stiffness_dt;
  const double scale = R / (R * (R + S) + 0.5 * S * S);
  return {R * scale, (R + 0.5 * S) * scale};
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
