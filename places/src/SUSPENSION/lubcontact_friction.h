/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Load that a contact needs before it is frictional: critical-load laws of friction.
//   step   mu N from N = F* on, none below    J. Dong, thesis, Lund (2020), eq. 3.25
//   shift  mu (N - F*), not below 0           R. Seto, R. Mari, J.F. Morris, M.M. Denn, Phys. Rev.
//                                             Lett. 111, 218301 (2013)
//   ramp   mu N (N/F*) below F*, mu N above   J. Dong, eq. 4.5
// N >= 0 is the repulsive force of the asperities; every law gives |F_t| <= mu times
// rubbing_load().

#ifndef LUBCONTACT_FRICTION_H
#define LUBCONTACT_FRICTION_H

#include "lubcontact_defs.h"

namespace LAMMPS_NS::Lubcontact_NS {

enum class FrictionLaw { NONE, COULOMB, STEP, SHIFT, RAMP, NUM_LAWS };

inline constexpr const char *FRICTION_NAME[] = {"none", "coulomb", "clm step", "clm shift",
                                                "clm ramp"};

// One formula for all laws, so that pairs with different ones share a vector of pairs.
struct Threshold {
  double least = 0.0;       // friction from this load on, force
  double shift = 0.0;       // load that does not count, force
  double per_ramp = 0.0;    // 1/load of full friction, 1/force; 0: no ramp
};

LUBCONTACT_FN inline Threshold make_threshold(FrictionLaw law, double critical)
{
  Threshold t;
  if (law == FrictionLaw::STEP) t.least = critical;
  if (law == FrictionLaw::SHIFT) t.shift = critical;
  if (law == FrictionLaw::RAMP && critical > 0.0) t.per_ramp = 1.0 / critical;
  return t;
}

// Load that counts for friction, 0 <= load <= N.
LUBCONTACT_FN inline double rubbing_load(const Threshold &t, double N)
{
  const double share = N * t.per_ramp;
  const bool partly = (t.per_ramp > 0.0) & (share < 1.0);
  const double load = larger(0.0, N - t.shift) * (partly ? share : 1.0);
  return N >= t.least ? load : 0.0;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
