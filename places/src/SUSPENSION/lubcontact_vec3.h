/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Three-component vector of the engine-free physics headers.

#ifndef LUBCONTACT_VEC3_H
#define LUBCONTACT_VEC3_H

#include "lubcontact_defs.h"

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;
};

LUBCONTACT_FN inline Vec3 operator+(const Vec3 &a, const Vec3 &b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

LUBCONTACT_FN inline Vec3 operator-(const Vec3 &a, const Vec3 &b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

LUBCONTACT_FN inline Vec3 operator*(double s, const Vec3 &a)
{
  return {s * a.x, s * a.y, s * a.z};
}

LUBCONTACT_FN inline Vec3 select(bool first, const Vec3 &a, const Vec3 &b)
{
  return {select(first, a.x, b.x), select(first, a.y, b.y), select(first, a.z, b.z)};
}

LUBCONTACT_FN inline double dot(const Vec3 &a, const Vec3 &b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

LUBCONTACT_FN inline Vec3 cross(const Vec3 &a, const Vec3 &b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

LUBCONTACT_FN inline double norm(const Vec3 &a)
{
  return std::sqrt(dot(a, a));
}

// Part of a perpendicular to the unit vector n.
LUBCONTACT_FN inline Vec3 tangential(const Vec3 &a, const Vec3 &n)
{
  return a - dot(a, n) * n;
}

// Rotates a by the Cayley vector c = 2 tan(angle/2) axis: orthogonal for any c, no trigonometry.
LUBCONTACT_FN inline Vec3 turned(const Vec3 &a, const Vec3 &c)
{
  const Vec3 ca = cross(c, a);
  return a + (1.0 / (1.0 + 0.25 * dot(c, c))) * (ca + 0.5 * cross(c, ca));
}

// as three numbers in a row
LUBCONTACT_FN inline Vec3 get_vector(const double *numbers)
{
  return {numbers[0], numbers[1], numbers[2]};
}

LUBCONTACT_FN inline void put_vector(const Vec3 &a, double *numbers)
{
  numbers[0] = a.x;
  numbers[1] = a.y;
  numbers[2] = a.z;
}

LUBCONTACT_FN inline void add_vector(const Vec3 &a, double *sum)
{
  sum[0] += a.x;
  sum[1] += a.y;
  sum[2] += a.z;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
