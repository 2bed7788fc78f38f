/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(NEIGH_HISTORY/LUBCONTACT/PLACE,FixNeighHistoryPlace);
// clang-format on
#else

#ifndef LMP_FIX_NEIGH_HISTORY_PLACE_H
#define LMP_FIX_NEIGH_HISTORY_PLACE_H

#include "fix.h"

#include <vector>

namespace LAMMPS_NS {

// Keeps the place of the pair history among the fixes until the effects, and with them its size,
// are known. Until then LAMMPS leaves what a restart file holds of an atom in row n of an array,
// whatever becomes of atom n: here it stays with its atom when atoms are deleted, sorted or moved
// to other ranks. Internal: created by pair style lubcontact.

class FixNeighHistoryPlace : public Fix {
 public:
  FixNeighHistoryPlace(class LAMMPS *, int, char **);
  ~FixNeighHistoryPlace() override;
  int setmask() override { return 0; }
  void init() override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  double memory_usage() override;

  using Rows = std::vector<std::vector<double>>;
  bool holds_rows() const { return loaded; }    // atoms have left their rows
  Rows take_rows();                             // of all atoms; none if all atoms are in their rows
  bigint forget(int);                           // those of the atoms in a group
  bool orphan;    // its pair style is gone, but not what the restart file holds

 private:
  Rows rows;
  bool loaded;
  void load(int);
};

}    // namespace LAMMPS_NS

#endif
#endif
