/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(NEIGH_HISTORY/LUBCONTACT,FixNeighHistoryLubcontact);
// clang-format on
#else

#ifndef LMP_FIX_NEIGH_HISTORY_LUBCONTACT_H
#define LMP_FIX_NEIGH_HISTORY_LUBCONTACT_H

#include "fix_neigh_history.h"

namespace LAMMPS_NS {

// LAMMPS' pair history, with guards against stale lists and against a restart with other effects. Internal: created by pair style lubcontact.

class FixNeighHistoryLubcontact : public FixNeighHistory {
 public:
  FixNeighHistoryLubcontact(class LAMMPS *, int, char **);
  void pre_exchange() override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

 protected:
  double layout;    // which values a pair keeps
};

}    // namespace LAMMPS_NS

#endif
#endif
