/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Fabric tensors: means over pairs of the product of two directions, with a weight.
// M. Oda, Soils Found. 22(4), 96 (1982); with forces: L. Rothenburg, R.J. Bathurst, Geotechnique
// 39, 601 (1989).

#ifndef LUBCONTACT_FABRIC_H
#define LUBCONTACT_FABRIC_H

#include "lubcontact_vec3.h"

namespace LAMMPS_NS::Lubcontact_NS {

static constexpr int FABRIC_SIZE = 6;    // xx yy zz xy xz yz

// Sum of w (a b + b a)/2 and of what it is divided by in the end.
struct Fabric {
  double sum[FABRIC_SIZE + 1] = {};

  void add(double w, const Vec3 &a, const Vec3 &b, double norm)
  {
    sum[0] += w * a.x * b.x;
    sum[1] += w * a.y * b.y;
    sum[2] += w * a.z * b.z;
    sum[3] += 0.5 * w * (a.x * b.y + a.y * b.x);
    sum[4] += 0.5 * w * (a.x * b.z + a.z * b.x);
    sum[5] += 0.5 * w * (a.y * b.z + a.z * b.y);
    sum[FABRIC_SIZE] += norm;
  }
  // n n weighted by w: trace 1
  void add(double w, const Vec3 &n) { add(w, n, n, w); }

  double mean(int m) const { return sum[FABRIC_SIZE] != 0.0 ? sum[m] / sum[FABRIC_SIZE] : 0.0; }
};

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
