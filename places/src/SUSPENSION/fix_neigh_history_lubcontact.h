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

#include <unordered_map>
#include <vector>

namespace LAMMPS_NS {

// LAMMPS' pair history, which finds a partner by its ID. Here each record knows the ID and the
// radius that its atom had when it was made: it follows its atom when IDs are made anew, and is
// dropped when the atom was given another size. With guards against stale lists, and against
// restart files of other effects. Internal: created by pair style lubcontact.

class FixNeighHistoryLubcontact : public FixNeighHistory {
 public:
  FixNeighHistoryLubcontact(class LAMMPS *, int, char **);
  void init() override;
  void pre_exchange() override;
  void post_neighbor() override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  double memory_usage() override;

  void take_restart(
      const std::vector<std::vector<double>> &);    // of each atom; empty: as LAMMPS has them
  void adopt(int, std::vector<double> &);    // number of partners of an atom, ID and values of each
  std::unordered_map<tagint, tagint> present_ids() const;    // of the IDs that the records know
  bigint
  forget(int);    // records of the atoms in a group, and those of their partners; how many pairs

 protected:
  struct Owner {
    tagint id = 0;    // under which the partners of an atom know it; 0: it has none
    double radius = 0.0;
  };
  double layout;                 // which values a pair keeps
  std::vector<Owner> owner;      // of each atom
  std::vector<tagint> row_id;    // of the atoms when the list was made
  std::vector<tagint> ids;       // of the records, ghosts included
  int part;          // of what the fixes keep of an atom in the restart file, -1: nothing
  bool restarted;    // the records come from a restart file

  void check_rows() const;
  void drop_resized();
  void find_partners();
  void check_found() const;
  void record(int, const double *);
};

}    // namespace LAMMPS_NS

#endif
#endif
