/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(suspension_history,SuspensionHistory);
// clang-format on
#else

#ifndef LMP_SUSPENSION_HISTORY_H
#define LMP_SUSPENSION_HISTORY_H

#include "command.h"

namespace LAMMPS_NS {

// suspension_history forget group-ID: their pairs begin anew

class SuspensionHistory : public Command {
 public:
  SuspensionHistory(class LAMMPS *lmp) : Command(lmp) {}
  void command(int, char **) override;
};

}    // namespace LAMMPS_NS

#endif
#endif
