/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_LUBCONTACT_COUNT_H
#define LMP_PAIR_LUBCONTACT_COUNT_H

#include "lubcontact_loop.h"

#include <vector>

namespace LAMMPS_NS {

// How many partners each particle of this rank has: counted with each neighbor list, then kept by
// the few pairs that change in a step.
struct PartnerCount {
  bool asked = false;    // in this run
  bool known = false;    // with the changes since
  std::vector<double> number;
  std::vector<LubcontactChange> changes;

  // what the loop of the forces is to note
  std::vector<LubcontactChange> *of_next_step(bool new_list)
  {
    if (new_list) known = false;
    return asked && known ? &changes : nullptr;
  }
  double memory_usage() const
  {
    return static_cast<double>(number.capacity() * sizeof(double) +
                               changes.capacity() * sizeof(LubcontactChange));
  }
};

}    // namespace LAMMPS_NS

#endif
