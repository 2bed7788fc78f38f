/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Rate of strain of the flow that a pair is in, and what a pair makes of it: a stresslet.

#ifndef LUBCONTACT_STRAIN_H
#define LUBCONTACT_STRAIN_H

#include "lubcontact_defs.h"
#include "lubcontact_vec3.h"

namespace LAMMPS_NS::Lubcontact_NS {

struct SymmetricTensor {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;
};

LUBCONTACT_FN inline SymmetricTensor operator+(const SymmetricTensor &a, const SymmetricTensor &b)
{
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}

using Strain = SymmetricTensor;    // traceless, 1/time

// Of a flow with an upper triangular velocity gradient, as that of a cell: dv_x/dy is xy.
LUBCONTACT_FN inline Strain strain_of_gradient(double xx, double yy, double zz, double xy,
                                               double xz, double yz)
{
  const double third = (xx + yy + zz) / 3.0;
  return {xx - third, yy - third, zz - third, 0.5 * xy, 0.5 * xz, 0.5 * yz};
}

LUBCONTACT_FN inline Vec3 strained(const Strain &E, const Vec3 &n)
{
  return {E.xx * n.x + E.xy * n.y + E.xz * n.z, E.xy * n.x + E.yy * n.y + E.yz * n.z,
          E.xz * n.x + E.yz * n.y + E.zz * n.z};
}

// In the frame of a pair: e = n.E.n and e_t = (1-nn).E.n.
struct PairStrain {
  double along;
  Vec3 across;
};

LUBCONTACT_FN inline PairStrain pair_strain(const Strain &E, const Vec3 &n)
{
  const Vec3 of_n = strained(E, n);
  const double e = dot(n, of_n);
  return {e, of_n - e * n};
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
