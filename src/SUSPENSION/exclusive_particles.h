/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */
// Particles that a fix does not share with certain other fixes. Groups alone cannot tell, and the
// particles of an init() are not enough: a dynamic group may be empty then, and fix pour inserts
// later. So the rules are made at the start of a run, and every particle is asked in every step.

#ifndef LMP_EXCLUSIVE_PARTICLES_H
#define LMP_EXCLUSIVE_PARTICLES_H

#include "pointers.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class ExclusiveParticles : protected Pointers {
 public:
  explicit ExclusiveParticles(LAMMPS *owner) : Pointers(owner), mine(0), others(0) {}

  // makes the error message from whom it is about: "3 particles"
  using Complaint = std::function<std::string(const std::string &)>;

  void start(int bits);    // groups of the fix; no rules yet
  void forbid(int bits,
              const Complaint &);    // stops if the particles now or to come break the rule

  bool has_rules() const { return others != 0; }

  // particle i of the fix, in each step
  void check(int mask) const
  {
    if (mask & others) stop(mask);
  }

 private:
  int mine, others;
  std::vector<std::pair<int, Complaint>> rules;

  bigint count(int bits) const;
  [[noreturn]] void stop(int mask) const;
};

}    // namespace LAMMPS_NS

#endif
