/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// How long a neighbor list lives in a flow.
//
// A list holds all pairs that were closer than cut + skin. With F the affine deformation since then
// and d what a particle has moved besides, a pair that was r apart is now at F r + d_i - d_j. So
// every pair that is not in the list is farther apart than cut for as long as
//   s (cut + skin) - |d_i - d_j| >= cut,    s the smallest stretch (singular value) of F.
// Any F may be the reference that maps the periodic images as the cell does: the better it follows
// the particles, the smaller is d, and the longer a list lives. LAMMPS takes F = 1.

#ifndef LMP_RHEOMETER_LIST_H
#define LMP_RHEOMETER_LIST_H

#include "rheometer_flow.h"

#include <algorithm>
#include <cmath>

namespace LAMMPS_NS::Rheometer_NS {

// F of a flow along x with its gradient along y, and of extensions; the other components are zero
struct Deformation {
  double xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0;
};

// from one cell to another: F h0 = h
inline Deformation deformation(const Cell &h0, const Cell &h)
{
  Deformation f;
  f.xx = h.lx / h0.lx;
  f.yy = h.ly / h0.ly;
  f.zz = h.lz / h0.lz;
  f.xy = (h.xy - f.xx * h0.xy) / h0.ly;
  return f;
}

// shortest length that a vector of length 1 is mapped to; 0 if F turns a direction over or is
// singular
inline double smallest_stretch(const Deformation &f, int dimension)
{
  // singular values of (xx xy; 0 yy): half the sum and half the difference of two lengths
  const double sum = std::hypot(f.xx + f.yy, f.xy), difference = std::hypot(f.xx - f.yy, f.xy);
  const double plane = 0.5 * (sum - difference);
  const double least = dimension == 3 ? std::min(plane, f.zz) : plane;
  return least > 0.0 && f.xx > 0.0 && f.yy > 0.0 ? least : 0.0;
}

// What the particles have moved besides: the longest displacement, and the box around all of them
struct Scatter {
  double longest = 0.0;    // squared, while particles are added
  double least[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double most[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  // displacement besides F of a particle that went from x0 to x, both relative to the origin of F
  void add(const Deformation &f, const double *x0, const double *x)
  {
    const double d[3] = {x[0] - f.xx * x0[0] - f.xy * x0[1], x[1] - f.yy * x0[1],
                         x[2] - f.zz * x0[2]};
    longest = std::max(longest, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int k = 0; k < 3; k++) {
      least[k] = std::min(least[k], d[k]);
      most[k] = std::max(most[k], d[k]);
    }
  }
};

// upper bound of |d_i - d_j|: twice the longest, or the diagonal of the box around them, which a
// common drift does not lengthen
inline double largest_difference(const Scatter &s)
{
  double square = 0.0;
  for (int k = 0; k < 3; k++)
    if (s.most[k] > s.least[k]) square += (s.most[k] - s.least[k]) * (s.most[k] - s.least[k]);
  return std::min(2.0 * std::sqrt(s.longest), std::sqrt(square));
}

// does the list, made for cut_and_skin, still hold all pairs closer than that less the skin?
inline bool list_holds(const Deformation &f, int dimension, double difference, double cut_and_skin,
                       double skin)
{
  return smallest_stretch(f, dimension) * cut_and_skin - difference > cut_and_skin - skin;
}

}    // namespace LAMMPS_NS::Rheometer_NS

#endif
