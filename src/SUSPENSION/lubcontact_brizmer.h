/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Friction of one elastic-plastic asperity, whose coefficient falls with its load N:
//   mu(N) = mu coth(mu (N/F)^m),  m = 0.35
// A fit to finite elements of a sphere that sticks to a rigid plane, with mu = 0.27 and F the load
// at which it yields: V. Brizmer, Y. Kligerman, I. Etsion, Tribol. Lett. 25, 61 (2007). In
// suspensions: L. Lobry, E. Lemaire, F. Blanc, S. Gallier, F. Peters, J. Fluid Mech. 860, 682
// (2019). The coefficient diverges as N -> 0, but the force does not: mu(N) N -> F (N/F)^(1-m).

#ifndef LUBCONTACT_BRIZMER_H
#define LUBCONTACT_BRIZMER_H

#include "lubcontact_defs.h"

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

static constexpr double BRIZMER_EXPONENT = 0.35;

// 1 over the load at which mu (N/F)^m = 1; 0 for F = 0, where the coefficient is mu at any load.
LUBCONTACT_FN inline double per_plastic_load(double mu, double F)
{
  return F > 0.0 ? std::pow(mu, 1.0 / BRIZMER_EXPONENT) / F : 0.0;
}

// N mu(N)/mu: the load that would rub as much with the coefficient mu, never less than N. The
// coefficient is constant below LEAST, where nothing rubs.
LUBCONTACT_FN inline double plastic_load(double per_plastic, double N)
{
  static constexpr double LEAST = 1e-60;
  return N / std::tanh(std::pow(larger(LEAST, N * per_plastic), BRIZMER_EXPONENT));
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
