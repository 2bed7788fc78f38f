/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The loop of the forces over the pairs, one instance per covering combination of effects: what all
// instances share.

#ifndef LMP_LUBCONTACT_LOOP_H
#define LMP_LUBCONTACT_LOOP_H

#include "lubcontact_history.h"
#include "lubcontact_pairs.h"
#include "lubcontact_tally.h"

#include <functional>
#include <vector>

namespace LAMMPS_NS {

// A pair that has begun to act (1) in a step, or ceased to (-1).
struct LubcontactChange {
  int i, j;
  double number;
};

// What a step of the loop works on. The loop owns nothing and knows no pair style.
struct LubcontactStep {
  LubcontactPairs &pairs;
  LubcontactTally &tally;
  const Lubcontact_NS::Film &film;
  bool euler;        // integrator of the gap
  bool plastic;      // has some pair of types the law brizmer?
  double *virial;    // of the cell, to be set; null: nobody asks
  std::vector<LubcontactChange> *changes;    // to be added to, of pairs with a history; likewise

  // energy and virial of the atoms, null: nobody asks: i, j, energy, force on i, x_i - x_j
  std::function<void(int, int, double, const Lubcontact_NS::Vec3 &, const Lubcontact_NS::Vec3 &)>
      tally_atoms;
  // of residual films besides: the virial of the atoms that is of no force
  std::function<void(int, int, const Lubcontact_NS::SymmetricTensor &)> tally_stresslet;
  bool asked_energy;
};

// The instance of the loop for some effects.
struct LubcontactInstance {
  unsigned effects;     // of the deck: canonical mask
  unsigned covering;    // of the instance
  LubcontactHistory::Form history;
  void (*loop)(LAMMPS *, const LubcontactStep &);

  // load and energy of a pair; history null: as of a pair seen for the first time
  Lubcontact_NS::Load (*single)(const Lubcontact_NS::PairCoeffs &, const Lubcontact_NS::Film &,
                                const Lubcontact_NS::PairGeometry &, const double *history,
                                double &energy);
};

LubcontactInstance find_instance(unsigned effects, bool residual);

// If it is in this share: files share the work of compiling them.
template <unsigned SHARE> void find_in_share(LubcontactInstance &);
void find_residual(LubcontactInstance &);

}    // namespace LAMMPS_NS

#endif
