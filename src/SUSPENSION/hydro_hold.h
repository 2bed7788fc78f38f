/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Forces of the far field between two solutions of it. A solution gives the force F_k and torque
// T_k of each sphere on the fluid for the velocity v'_k and spin w'_k relative to the flow. Until
// the next one
//   F = F_k + Z (v' - v'_k),   T = T_k + Z_T (w' - w'_k),
// which is a drag Z towards the velocity flow + v'_k - F_k/Z. In slow motion one solution after the
// other is an iteration that converges if Z exceeds half of the largest eigenvalue of the
// resistance, in terms of the drag of a sphere alone: 15 at a volume fraction of 0.3, 31 at 0.5.
// Those of rotation are 2 at most at every volume fraction, and more would act like an inertia.

#ifndef LMP_HYDRO_HOLD_H
#define LMP_HYDRO_HOLD_H

#include "fluid_drag.h"

#include <cmath>

namespace LAMMPS_NS::Hydro_NS {

using Lubcontact_NS::Vec3;

// factors of the drag of a sphere alone
struct Hold {
  double translation = 1.0, rotation = 2.0;
};

inline Hold default_hold(double phi)
{
  return {1.0 + 32.0 * phi, 2.0};
}

// The volume fraction about a sphere is that of a Gaussian, so wide that single neighbors do not
// matter and so narrow that it finds a cloud of spheres. Of a wave, k times the size of a sphere:
inline double neighborhood(double k)
{
  static constexpr double DEVIATION = 2.0;
  return std::exp(-0.5 * DEVIATION * DEVIATION * k * k);
}

inline Fluid_NS::Drag held_drag(const Hold &hold, double viscosity, double radius)
{
  const Fluid_NS::Drag d = Fluid_NS::drag(Fluid_NS::Shape::SPHERE, viscosity, radius);
  return {hold.translation * d.translation, hold.rotation * d.rotation};
}

// What the drag pulls towards: of the velocity with the force, or of the spin with the torque.
// relative and load are those of the solution, flow is that of now.
inline Vec3 held_target(double drag, const Vec3 &flow, const Vec3 &relative, const Vec3 &load)
{
  return flow + relative - (1.0 / drag) * load;
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
