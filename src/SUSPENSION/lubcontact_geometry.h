// Geometry and motion of a pair of spheres. All signs of the package are defined here:
// n points from j to i, un > 0 is a gap, every relative motion is i minus j, every force acts on i.

#ifndef LUBCONTACT_GEOMETRY_H
#define LUBCONTACT_GEOMETRY_H

#include "lubcontact_vec3.h"

namespace lubcontact {

struct Body {
  Vec3 x;           // position
  Vec3 v;           // velocity over the last step
  Vec3 omega;       // angular velocity over the last step
  double radius;    // length
};

// Effective radius a: MEAN (R_i+R_j)/2, or HARMONIC 2 R_i R_j/(R_i+R_j), for which the squeeze
// force (3/2) pi eta a^2 u'/u is asymptotically exact for any two radii, a plane included.
enum class Radius { MEAN, HARMONIC };

inline double effective_radius(Radius rule, double ri, double rj)
{
  return rule == Radius::MEAN ? 0.5 * (ri + rj) : 2.0 * ri * rj / (ri + rj);
}

struct PairGeometry {
  Vec3 n;          // unit vector from j to i
  double r;        // distance of the centres
  double un;       // r - R_i - R_j: gap of the undeformed surfaces, negative if they overlap
  double a;        // effective radius
  double arm_i;    // R_i + un/2: from the centre of i to the middle of the gap
  double arm_j;    // R_j + un/2: arm_i + arm_j = r, so that a rigid rotation has no slip
};

inline PairGeometry pair_geometry(const Vec3 &xi, const Vec3 &xj, double ri, double rj, double a)
{
  const Vec3 d = xi - xj;
  PairGeometry g;
  g.r = norm(d);
  g.n = (1.0 / g.r) * d;
  g.un = g.r - (ri + rj);
  g.a = a;
  g.arm_i = ri + 0.5 * g.un;
  g.arm_j = rj + 0.5 * g.un;
  return g;
}

// Relative motion over the last step, in the co-rotating frame of the pair.
struct PairMotion {
  Vec3 slip;       // tangential displacement at the middle of the gap, perpendicular to n, length
  Vec3 roll;       // rolling part of the relative rotation, perpendicular to n, angle
  double twist;    // twisting part of the relative rotation, about n, angle
  Vec3 turn;       // Cayley vector that carries history vectors with the pair (tilt of n, mean spin)
};

// The step is undone with the velocities (x - dt v is the previous position for velocity Verlet),
// and everything is taken at its middle: second order, and zero slip in a rigid rotation.
inline PairMotion pair_motion(const PairGeometry &g, const Body &i, const Body &j, double r_old,
                              double dt)
{
  const Vec3 move = dt * (i.v - j.v);
  const Vec3 d1 = g.r * g.n;
  const Vec3 d0 = d1 - move;
  const Vec3 dm = d1 - 0.5 * move;
  const Vec3 nm = (1.0 / norm(dm)) * dm;

  const Vec3 spin_i = dt * i.omega;
  const Vec3 spin_j = dt * j.omega;
  const Vec3 difference = spin_i - spin_j;

  PairMotion m;
  const Vec3 slip = tangential(move, nm) - cross(g.arm_i * spin_i + g.arm_j * spin_j, nm);
  m.slip = tangential(slip, g.n);
  m.twist = dot(difference, nm);
  m.roll = tangential(tangential(difference, nm), g.n);

  const Vec3 tilt = (2.0 / (r_old * g.r + dot(d0, d1))) * cross(d0, d1);
  const Vec3 spin = (0.5 * dot(spin_i + spin_j, nm)) * g.n;
  m.turn = tilt + spin + 0.5 * cross(spin, tilt);    // tilt first, then spin about the new n
  return m;
}

}    // namespace lubcontact

#endif
