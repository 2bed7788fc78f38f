/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Stress and power by origin of one pair style, in the steps for which a compute has asked: who
// asks, and this rank's sums.

#ifndef LMP_LUBCONTACT_TALLY_H
#define LMP_LUBCONTACT_TALLY_H

#include "lubcontact_channels.h"
#include "lubcontact_power.h"
#include "pointers.h"

#include <array>
#include <vector>

namespace LAMMPS_NS {
class Compute;

class LubcontactTally : protected Pointers {
 public:
  explicit LubcontactTally(LAMMPS *);

  static constexpr int NUM_COMPONENTS = 9;    // xx yy zz xy xz yz yx zx zy of sum r_a F_b
  using Stress = std::array<std::array<double, NUM_COMPONENTS>, Lubcontact_NS::NUM_CHANNELS>;

  void find_clients();    // in init_style()
  void start_step();      // who asks for this one? Their sums begin at 0

  bool asked() const { return stress_now || atoms_now || power_now; }
  bool asked_stress() const { return stress_now || atoms_now; }
  bool asked_power() const { return power_now; }

  // of the pair (i,j), of which this rank has the share `weight`
  void add_stress(int i, int j, double weight, const Lubcontact_NS::PairGeometry &,
                  const Lubcontact_NS::Load &);
  void add_stresslet(int i, int j, double weight, const Lubcontact_NS::FilmStresslet &);
  void add_stored(double weight, const Lubcontact_NS::Energies &);
  void add_heat(double weight, const Lubcontact_NS::Energies &);

  // for the computes; valid in steps for which has_... is true
  bool has_stress() const;
  bool has_atoms() const;
  bool has_power() const;
  const Stress &stress() const { return sums; }
  const Stress &stress_of_atom(int i) const
  {
    return atoms[i];
  }    // half of a pair to either, ghosts
       // included
  const Lubcontact_NS::Energies &heat() const { return lost; }      // by the step
  const Lubcontact_NS::Energies &stored() const { return kept; }    // after it
  bool power_of_step() const { return step_made; }                  // a set-up makes no heat

  double memory_usage() const;

 private:
  std::vector<Compute *> stress_clients, atom_clients, power_clients;
  bool stress_now, atoms_now, power_now, step_made;
  bigint stress_step, atoms_step, power_step;
  Stress sums;
  std::vector<Stress> atoms;
  Lubcontact_NS::Energies lost, kept;

  bool announced(const std::vector<Compute *> &) const;
  void add(int i, int j, double weight, Lubcontact_NS::Channel, const double *product);
};

}    // namespace LAMMPS_NS

#endif
