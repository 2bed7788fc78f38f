// Stokes drag of an isolated sphere towards the background flow.
// G.G. Stokes, Trans. Camb. Phil. Soc. 9, 8 (1851).

#ifndef LUBCONTACT_DRAG_H
#define LUBCONTACT_DRAG_H

#include "lubcontact_film.h"
#include "lubcontact_vec3.h"

namespace lubcontact {

// Force on a sphere of radius R moving with v where the fluid would move with v_fluid.
inline Vec3 drag_force(double viscosity, double radius, const Vec3 &v, const Vec3 &v_fluid)
{
  return (6.0 * PI * viscosity * radius) * (v_fluid - v);
}

// Torque on it, omega_fluid = half the vorticity of the fluid.
inline Vec3 drag_torque(double viscosity, double radius, const Vec3 &omega, const Vec3 &omega_fluid)
{
  return (8.0 * PI * viscosity * radius * radius * radius) * (omega_fluid - omega);
}

}    // namespace lubcontact

#endif
