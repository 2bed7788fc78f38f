/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The stiffest mode of a pair as one of its spheres feels it, for bounds of the time step. With x
// the displacements across n, s = arm theta those of the surfaces by spin and b = a/arm, the
// springs hold
//     kt/2 [ (x_i - x_j - s_i - s_j)^2 + (b_i s_i - b_j s_j)^2 ]    slip and roll
//     kt/2 (b_i s_i - b_j s_j)^2                                    twist
// and  (x - s)^2 <= (1 + 1/t) x^2 + (1 + t) s^2  for any t > 0,  2 x y <= x^2 + y^2  part this into
// what each sphere adds: with k_i such that energy <= sum_i k_i (x_i^2 + s_i^2/q_i), the squared
// frequency of any assembly is at most 2 max_i (sum of k_i)/m_i, q being 1/J over 1/m in units of
// 1/arm^2. Equal spheres in touch have k = max(g, (1 + q) kt), which is what two of them reach.

#ifndef LUBCONTACT_STIFFNESS_H
#define LUBCONTACT_STIFFNESS_H

#include "lubcontact_defs.h"
#include "lubcontact_geometry.h"
#include "lubcontact_polynomial.h"
#include "lubcontact_residual.h"

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

// How much easier a sphere turns than it moves: m R^2/J, and of drag 6 pi eta R R^2/(8 pi eta R^3).
static constexpr double SPIN_OF_INERTIA = 2.5;

struct PairStiffness {
  double i, j;
};

// roll, twist: do these films act?
LUBCONTACT_FN inline PairStiffness pair_stiffness(double g, double kt, double spin,
                                                  const PairGeometry &p, double radius_i,
                                                  double radius_j, bool roll, bool twist)
{
  const double qi = spin * p.arm_i * p.arm_i / (radius_i * radius_i);
  const double qj = spin * p.arm_j * p.arm_j / (radius_j * radius_j);
  const double bi = p.a / p.arm_i, bj = p.a / p.arm_j, both = bi * bj;

  // t at which sliding and spinning of the sphere that spins more easily are equally stiff:
  // 2 (1 + 1/t) = q (2 (1 + t) + e), e = b^2 - b_i b_j with roll
  const bool of_i = qi * (1.0 + bi * bi) > qj * (1.0 + bj * bj);
  const double q = of_i ? qi : qj, b = of_i ? bi : bj;
  const double e = roll ? larger(b * b - both, 0.0) : 0.0;
  const double B = q * (2.0 + e) - 2.0;
  const double t = (std::sqrt(B * B + 16.0 * q) - B) / (4.0 * q);

  auto of = [&](double q_own, double b_own) {
    const double sliding = 1.0 + 1.0 / t;
    const double rolling = b_own * b_own + std::fabs(1.0 + t - both);
    const double spinning = 0.5 * q_own * (1.0 + t + (roll ? rolling : 1.0 + t));
    const double twisting = twist ? 0.5 * q_own * (b_own * b_own + std::fabs(both)) : 0.0;
    return larger(kt * larger(twisting, larger(spinning, sliding)), g);
  };
  return {of(qi, bi), of(qj, bj)};
}

LUBCONTACT_FN inline PairStiffness larger_stiffness(const PairStiffness &a, const PairStiffness &b)
{
  return {larger(a.i, b.i), larger(a.j, b.j)};
}

// RESIDUAL: where the shear force of the film acts, which no contact rubs.
LUBCONTACT_FN inline PairGeometry with_lever(PairGeometry g)
{
  const double delta = size_difference(g), u_a = larger(1e-6, g.un_a);
  const ResidualPlace p = residual_place(u_a, logarithm(u_a), delta);
  const double lever = residual_lever(g.a, delta, p);
  g.arm_i -= lever;
  g.arm_j += lever;
  return g;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
