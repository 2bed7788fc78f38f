/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Drag on a particle alone in a fluid, and the motion that it gives, with inertia and without.
// Sphere: G.G. Stokes, Trans. Camb. Phil. Soc. 9, 8 (1851); its stresslet: A. Einstein, Ann. Phys.
// 19, 289 (1906), corrected in 34, 591 (1911). Disc, per length of its axis: Stokes' law over the
// diameter, M. Trulsson, B. Andreotti, P. Claudin, Phys. Rev. Lett. 109, 118305 (2012).

#ifndef LMP_FLUID_DRAG_H
#define LMP_FLUID_DRAG_H

#include "lubcontact_defs.h"
#include "lubcontact_vec3.h"

#include <cmath>

namespace LAMMPS_NS::Fluid_NS {

using Lubcontact_NS::PI;
using Lubcontact_NS::Vec3;

enum class Shape { SPHERE, DISC };

// force = translation*(v_fluid - v), torque = rotation*(omega_fluid - omega)
struct Drag {
  double translation = 0.0, rotation = 0.0;
};

LUBCONTACT_FN inline Drag drag(Shape shape, double viscosity, double radius)
{
  if (shape == Shape::DISC) return {3.0 * PI * viscosity, 4.0 * PI * viscosity * radius * radius};
  return {6.0 * PI * viscosity * radius, 8.0 * PI * viscosity * radius * radius * radius};
}

// Stresslet of a sphere on the fluid over the rate of strain E of the flow, without its trace: the
// stress of a volume V grows by 20/3 pi viscosity radius^3 E/V.
LUBCONTACT_FN inline double straining(double viscosity, double radius)
{
  return -20.0 / 3.0 * PI * viscosity * radius * radius * radius;
}

// With inertia: m dv/dt = F + c (v_fluid - v). From one half step to the next, F and v_fluid being
// those of the middle, the solution is
//   v1 = u + (v0 - u) exp(-x),   u = v_fluid + F/c,   x = c dt/m,
// which is what the force M (F + c (v_fluid - v0)) does in velocity Verlet, M = mean_drag(x). The
// velocity at the full step is the mean of both, v_full - u = (v0 - u) (1 + exp(-x))/2, so that
// from it the same force follows with M = mean_drag_full(x).

// (1 - exp(-x))/x
LUBCONTACT_FN inline double mean_drag(double x)
{
  return x < 1e-8 ? 1.0 - 0.5 * x : -std::expm1(-x) / x;
}

// tanh(x/2)/(x/2)
LUBCONTACT_FN inline double mean_drag_full(double x)
{
  return x < 1e-8 ? 1.0 : 2.0 * std::tanh(0.5 * x) / x;
}

// Force or torque that acts together with the drag, for one such step.
LUBCONTACT_FN inline Vec3 damped(double mean, double coefficient, const Vec3 &force, const Vec3 &v,
                                 const Vec3 &v_fluid)
{
  return mean * (force + coefficient * (v_fluid - v));
}

// What acts on a particle in such a step, and its velocity at the full step. v is that of the last
// half step, or with full that of the full step.
struct DragStep {
  Vec3 force, v_full;
};

LUBCONTACT_FN inline DragStep drag_step(bool full, double dt, double mass, double coefficient,
                                        const Vec3 &force, const Vec3 &v, const Vec3 &v_fluid)
{
  const double x = coefficient * dt / mass;
  const Vec3 all = damped(full ? mean_drag_full(x) : mean_drag(x), coefficient, force, v, v_fluid);
  return {all, full ? v : v + (0.5 * dt / mass) * all};
}

// Without inertia.
LUBCONTACT_FN inline Vec3 overdamped(double coefficient, const Vec3 &force, const Vec3 &v_fluid)
{
  return v_fluid + (1.0 / coefficient) * force;
}

// Largest stable step without inertia: the relative motion of two equal particles on the springs
// of both decays by twice the rate stiffness/coefficient.
LUBCONTACT_FN inline double overdamped_step_limit(double stiffness, double coefficient)
{
  return coefficient / stiffness;
}

// Factor of the drag at a volume fraction phi: the mean pressure gradient adds phi/(1 - phi) of it.
LUBCONTACT_FN inline double mean_hindrance(double phi)
{
  return 1.0 / (1.0 - phi);
}

// How much more easily a force at the surface turns a particle than it moves it: R^2/rotation over
// 1/translation, for both shapes. A sliding spring kt weighs kt (1 + 3/4), see
// lubcontact_stiffness.h.
static constexpr double SPIN_OF_DRAG = 0.75;

}    // namespace LAMMPS_NS::Fluid_NS

#endif
