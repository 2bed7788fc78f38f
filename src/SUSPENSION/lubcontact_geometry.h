/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Geometry and motion of a pair of spheres. All signs of the package are defined here:
// n points from j to i, un > 0 is a gap, every relative motion is i minus j, every force acts on i.
//
// So are its two units of length: a bare name is a length, the suffix _a says over the effective
// radius a, of a variable as of what a function returns: un and un_a = un/a. Logarithms need no
// suffix, they are always of the latter: ln_u = ln(u_a).

#ifndef LUBCONTACT_GEOMETRY_H
#define LUBCONTACT_GEOMETRY_H

#include "lubcontact_defs.h"
#include "lubcontact_vec3.h"

namespace LAMMPS_NS::Lubcontact_NS {

struct Body {
  Vec3 x;               // position
  Vec3 v;               // velocity over the last step
  Vec3 omega;           // angular velocity over the last step
  double radius;        // length
  double mass = 1.0;    // over ftm2v: force/acceleration. RESTITUTION alone reads it
};

// Effective radius a: MEAN (R_i+R_j)/2, or HARMONIC 2 R_i R_j/(R_i+R_j), for which the squeeze
// force (3/2) pi eta a^2 u'/u is asymptotically exact for any two radii, a plane included.
enum class Radius { MEAN, HARMONIC };

LUBCONTACT_FN inline double effective_radius(Radius rule, double ri, double rj)
{
  return rule == Radius::MEAN ? 0.5 * (ri + rj) : 2.0 * ri * rj / (ri + rj);
}

struct PairGeometry {
  Vec3 n;          // unit vector from j to i
  double r;        // distance of the centers
  double un;       // r - R_i - R_j: separation of the undeformed surfaces, negative if they overlap
  double a;        // effective radius
  double per_a;    // 1/a
  double un_a;     // un/a
  double arm_i;    // R_i + un/2: from the center of i to the middle of the gap
  double arm_j;    // R_j + un/2: arm_i + arm_j = r, so that a rigid rotation has no slip
};

LUBCONTACT_FN inline PairGeometry pair_geometry(const Vec3 &xi, const Vec3 &xj, double ri,
                                                double rj, double a)
{
  const Vec3 d = xi - xj;
  PairGeometry g;
  g.r = norm(d);
  g.n = (1.0 / g.r) * d;
  g.un = g.r - (ri + rj);
  g.a = a;
  g.per_a = 1.0 / a;
  g.un_a = g.un * g.per_a;
  g.arm_i = ri + 0.5 * g.un;
  g.arm_j = rj + 0.5 * g.un;
  return g;
}

// (R_j - R_i)/(R_i + R_j): 0 for equal spheres, odd.
LUBCONTACT_FN inline double size_difference(const PairGeometry &g)
{
  return (g.arm_j - g.arm_i) / (g.r - g.un);
}

// Relative motion over the last step, in the frame that turns with the pair and is n at its end.
struct PairMotion {
  Vec3 slip;       // tangential displacement at the middle of the gap, perpendicular to n, length
  Vec3 roll;       // rolling part of the relative rotation, perpendicular to n, angle
  double twist;    // twisting part of the relative rotation, about n, angle
  Vec3 turn;      // Cayley vector that carries history vectors with the pair (tilt of n, mean spin)
  Vec3 middle;    // n at mid-step
};

// The velocities undo the step: x - dt v is the previous position for velocity Verlet. All is taken
// at mid-step and carried to its end by half of the turn, second order: the mid-step normal is
// n - lean/2, and turning it into n adds half a tilt. A rigid rotation by the angle t gives a slip
// of order r t^3/12.
LUBCONTACT_FN inline PairMotion pair_motion(const PairGeometry &g, const Body &i, const Body &j,
                                            double r_old, double dt)
{
  const Vec3 move = dt * (i.v - j.v);
  const double along = dot(move, g.n);
  const double scale = 2.0 / (r_old + g.r - along);
  const Vec3 tilt = scale * cross(g.n, move);        // takes the old normal to n
  const Vec3 lean = scale * (move - along * g.n);    // tilt x n

  const Vec3 difference = dt * (i.omega - j.omega);
  const Vec3 sum = dt * (i.omega + j.omega);
  // the arms at mid-step, arm_i omega_i + arm_j omega_j
  const Vec3 arms = (0.25 * (r_old + g.r)) * sum + (0.5 * (g.arm_i - g.arm_j)) * difference;
  const double about = dot(difference, g.n);
  const double spin = 0.5 * (dot(sum, g.n) - 0.5 * dot(sum, lean));

  const Vec3 slip = (0.5 * (r_old + g.r)) * lean - cross(arms, g.n) + (0.5 * dot(arms, g.n)) * tilt;
  const Vec3 roll = difference - about * g.n + (0.5 * about) * lean;

  PairMotion m;
  m.slip = slip + (0.5 * spin) * cross(g.n, slip);
  m.roll = roll + (0.5 * spin) * cross(g.n, roll);
  m.twist = about - 0.5 * dot(difference, lean);
  m.turn = tilt + spin * g.n - (0.5 * spin) * lean;    // tilt first, then spin about n
  m.middle = g.n - 0.5 * lean;
  return m;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
