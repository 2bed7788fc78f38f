/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Which pairs act: the one answer for the forces, for whoever visits the pairs, for single() and
// for the bound of the time step.

#ifndef LUBCONTACT_RANGE_H
#define LUBCONTACT_RANGE_H

#include "lubcontact_law.h"

#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {

// The partners of one particle. Made by RangeTable, valid as long as it is.
struct RangeOf {
  const PairCoeffs *coeffs;    // by type of the partner, as the next
  const double *reach_a;       // largest gap that acts over the effective radius
  const char *faces;    // by place in the neighbor list: is there a common face? Null: all have one
  double radius;
  Radius rule;

  // Effective radius of the pair if it acts, else 0; rsq: distance of the centers squared, n: place
  // of the partner in the list. What touches acts without a common face.
  double acting(double rsq, double radius_j, int type_j, int n) const
  {
    // a is at most the mean radius: most pairs out of range need no division
    const double radsum = radius + radius_j;
    const double most = radsum * (1.0 + 0.5 * reach_a[type_j]);
    if (!(rsq < most * most)) return 0.0;
    const double a = effective_radius(rule, radius, radius_j);
    const bool screened = faces && !faces[n];
    const double end = radsum + (screened ? touching_gap_a(coeffs[type_j]) : reach_a[type_j]) * a;
    return rsq < end * end ? a : 0.0;
  }
};

// By types.
struct RangeTable {
  int types = 0;
  Radius rule = Radius::HARMONIC;
  std::vector<PairCoeffs> coeffs;
  std::vector<double> reach_a;
  bool plastic = false;    // does some pair of types have the law brizmer?

  void resize(int ntypes)
  {
    types = ntypes;
    plastic = false;
    coeffs.assign((ntypes + 1) * (ntypes + 1), {});
    reach_a.assign((ntypes + 1) * (ntypes + 1), 0.0);
  }
  void set(int i, int j, const Settings &s, const TypeCoeffs &k)
  {
    rule = s.radius;
    for (const int n : {i * (types + 1) + j, j * (types + 1) + i}) {
      coeffs[n] = pair_coeffs(s, k);
      plastic = plastic || coeffs[n].threshold.per_plastic > 0.0;
      reach_a[n] = Lubcontact_NS::reach_a_of(s, k);
    }
  }
  const PairCoeffs &of(int i, int j) const { return coeffs[i * (types + 1) + j]; }
  double reach_a_of(int i, int j) const { return reach_a[i * (types + 1) + j]; }
  RangeOf around(int type, double radius, const char *faces) const
  {
    const int row = type * (types + 1);
    return {&coeffs[row], &reach_a[row], faces, radius, rule};
  }
};

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
