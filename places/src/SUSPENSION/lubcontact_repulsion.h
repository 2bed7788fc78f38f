/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Screened repulsion of two surfaces, F0 exp(-u/lambda), in parallel with the asperities: it acts
// on the gap u of the deformed surfaces, in series with the bulk (W. Chevremont, thesis, Grenoble
// 2020, sec. 5.2.2). Electrostatic double layers: J.N. Israelachvili, Intermolecular and Surface
// Forces (2011), ch. 14; in shear thickening: R. Mari et al., J. Rheol. 58, 1693 (2014).

#ifndef LUBCONTACT_REPULSION_H
#define LUBCONTACT_REPULSION_H

#include "lubcontact_defs.h"
#include "lubcontact_polynomial.h"

namespace LAMMPS_NS::Lubcontact_NS {

struct Repulsion {
  double force = 0.0;         // F0 at closed gap, force
  double per_length = 1.0;    // 1/lambda, 1/length
};

// Repulsive force at the gap u >= 0.
LUBCONTACT_FN inline double repulsion_force(const Repulsion &p, double u)
{
  return p.force * exponential(larger(-690.0, -u * p.per_length));
}

// Energy: its integral from u to infinity.
LUBCONTACT_FN inline double repulsion_energy(const Repulsion &p, double u)
{
  return p.force > 0.0 ? repulsion_force(p, u) / p.per_length : 0.0;
}

// y with y + ln y = L, which is Lambert's W(exp L), for L < 1e6; 0 below L = -600. Newton's rule.
LUBCONTACT_FN inline double lambert_of_exponential(double L)
{
  const double M = larger(-690.0, L), e = exponential(M < 1.0 ? M : 1.0);
  double y = L < 1.0 ? e / (1.0 + e) : L - logarithm(larger(1.0, L));
  for (int n = 0; n < 5; n++) y *= (1.0 + M - logarithm(y)) / (1.0 + y);
  return L < -600.0 ? 0.0 : y;
}

// Gap u at which A u = r + p exp(-k u) with p >= 0, k > 0, in any unit of length: over a, p is F0
// over g a and k is a/lambda.
LUBCONTACT_FN inline double repelled_gap(double r, double A, double p, double k)
{
  const double free = r / A;
  return free + lambert_of_exponential(logarithm(larger(1e-300, p * k / A)) - k * free) / k;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
