/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Momentum that particles carry relative to their common motion: the inertial part of the stress,
// and the kinetic energy. Velocities v are relative to the flow. A flow looks the same from every
// particle, so a drift w of all of them together is no fluctuation. In a sheared cell it is not
// even constant: nothing pushes the particles while the flow around them changes as they cross it,
// dw/dt = -G w, so that a drift along the gradient makes one along the flow which grows with
// strain.

#ifndef LUBCONTACT_INERTIA_H
#define LUBCONTACT_INERTIA_H

#include "lubcontact_vec3.h"

namespace LAMMPS_NS::Lubcontact_NS {

// sums over particles, to be added up over ranks
struct Inertia {
  enum { MASS, MOMENTUM, PRODUCT = MOMENTUM + 3, SIZE = PRODUCT + 6 };    // xx yy zz xy xz yz
  double sum[SIZE] = {};

  void add(double m, const Vec3 &v)
  {
    const Vec3 p = m * v;
    const double values[SIZE] = {m,         p.x,       p.y,       p.z,       p.x * v.x,
                                 p.y * v.y, p.z * v.z, p.x * v.y, p.x * v.z, p.y * v.z};
    for (int n = 0; n < SIZE; n++) sum[n] += values[n];
  }

  Vec3 momentum() const { return {sum[MOMENTUM], sum[MOMENTUM + 1], sum[MOMENTUM + 2]}; }

  // w: velocity of the center of mass; zero without mass
  Vec3 drift() const { return sum[MASS] > 0.0 ? (1.0 / sum[MASS]) * momentum() : Vec3{}; }
};

// sum of m (v - w)_a (v - w)_b, in the order of the products
struct Fluctuation {
  double xx, yy, zz, xy, xz, yz;
};

inline Fluctuation fluctuation(const Inertia &i)
{
  const double *s = i.sum + Inertia::PRODUCT;
  const Vec3 p = i.momentum(), w = i.drift();
  return {s[0] - p.x * w.x, s[1] - p.y * w.y, s[2] - p.z * w.z,
          s[3] - p.x * w.y, s[4] - p.x * w.z, s[5] - p.y * w.z};
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
