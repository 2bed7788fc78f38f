/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Laws of friction by the load of a contact, and the load that counts for it. Critical-load laws:
//   step   mu N from N = F* on, none below    J. Dong, thesis, Lund (2020), eq. 3.25
//   shift  mu (N - F*), not below 0           R. Seto, R. Mari, J.F. Morris, M.M. Denn, Phys. Rev.
//                                             Lett. 111, 218301 (2013)
//   ramp   mu N (N/F*) below F*, mu N above   J. Dong, eq. 4.5
// N >= 0 is the repulsive force of the asperities; every law gives |F_t| <= mu times
// rubbing_load(). The law brizmer is in lubcontact_brizmer.h.

#ifndef LUBCONTACT_FRICTION_H
#define LUBCONTACT_FRICTION_H

#include "lubcontact_brizmer.h"
#include "lubcontact_defs.h"

namespace LAMMPS_NS::Lubcontact_NS {

enum class FrictionLaw { NONE, COULOMB, STEP, SHIFT, RAMP, BRIZMER, NUM_LAWS };

inline constexpr const char *FRICTION_NAME[] = {"none",      "coulomb",  "clm step",
                                                "clm shift", "clm ramp", "brizmer"};

// One formula for all laws, so that pairs with different ones share a vector of pairs.
struct Threshold {
  double least = 0.0;          // friction from this load on, force
  double shift = 0.0;          // load that does not count, force
  double per_ramp = 0.0;       // 1/load of full friction, 1/force; 0: no ramp
  double per_plastic = 0.0;    // of the law brizmer, 1/force; 0: not this law
};

LUBCONTACT_FN inline Threshold make_threshold(FrictionLaw law, double critical, double mu = 0.0)
{
  Threshold t;
  if (law == FrictionLaw::STEP) t.least = critical;
  if (law == FrictionLaw::SHIFT) t.shift = critical;
  if (law == FrictionLaw::RAMP && critical > 0.0) t.per_ramp = 1.0 / critical;
  if (law == FrictionLaw::BRIZMER) t.per_plastic = per_plastic_load(mu, critical);
  return t;
}

// Load that counts for friction by a critical-load law, 0 <= load <= N.
LUBCONTACT_FN inline double rubbing_load(const Threshold &t, double N)
{
  const double share = N * t.per_ramp;
  const bool partly = (t.per_ramp > 0.0) & (share < 1.0);
  const double load = larger(0.0, N - t.shift) * (partly ? share : 1.0);
  return N >= t.least ? load : 0.0;
}

// The same by any law; with a branch, for one pair.
LUBCONTACT_FN inline double rubbing_load_any(const Threshold &t, double N)
{
  return t.per_plastic > 0.0 ? plastic_load(t.per_plastic, N) : rubbing_load(t, N);
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
