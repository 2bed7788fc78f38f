/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The plates of a plane Couette cell: a lower one at rest, an upper one that moves as a rigid body.

#ifndef LMP_RHEOMETER_PLATE_H
#define LMP_RHEOMETER_PLATE_H

#include "rheometer_servo.h"

namespace LAMMPS_NS::Rheometer_NS {

enum Plate { LOWER, UPPER };

// what the suspension does to a plate, per area; both plates show the same when nothing accelerates
struct WallStress {
  double pressure = 0.0;    // compression positive
  double xy = 0.0;          // positive if it holds back an upper plate that moves along +x
  double zy = 0.0;          // the same along +z
};

// force: of the particles between the plates on the plate
inline WallStress wall_stress(Plate plate, const double *force, double area)
{
  const double sign = plate == UPPER ? 1.0 : -1.0;
  return {sign * force[1] / area, -sign * force[0] / area, -sign * force[2] / area};
}

// velocity after dt under constant force and a damper, m dv/dt = force - damping v: exact
inline double damped_velocity(double v, double force, double mass, double damping, double dt)
{
  const double x = damping * dt / mass;
  return v * std::exp(-x) + force * dt / mass * decay_mean(x);
}

// mean velocity of a step that multiplies the gap by exp(dilation dt)
inline double dilation_velocity(double gap, double dilation, double dt)
{
  return gap * std::expm1(dilation * dt) / dt;
}

// largest stable step of a plate on springs whose other ends yield at most as the plate does
inline double plate_step_limit(double mass, double stiffness)
{
  return 2.0 / std::sqrt(2.0 * stiffness / mass);
}

}    // namespace LAMMPS_NS::Rheometer_NS

#endif
