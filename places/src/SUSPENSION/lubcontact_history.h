/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The history of the pairs of one pair style: the fix that carries it, and its place among the
// fixes.

#ifndef LMP_LUBCONTACT_HISTORY_H
#define LMP_LUBCONTACT_HISTORY_H

#include "fix_neigh_history_lubcontact.h"
#include "pointers.h"

#include <string>

namespace LAMMPS_NS {
class FixNeighHistoryPlace;
class Pair;

class LubcontactHistory : protected Pointers {
 public:
  explicit LubcontactHistory(LAMMPS *);
  ~LubcontactHistory() override;
  LubcontactHistory(const LubcontactHistory &) = delete;
  LubcontactHistory &operator=(const LubcontactHistory &) = delete;

  // what the effects in use need: doubles of a pair, which ones, parity under exchange of i and j
  using Exchange = void (*)(const double *, double *);
  struct Form {
    int size = 0, layout = 0;
    Exchange exchange = nullptr;
  };
  void require(Pair *owner, const Form &);    // in init_style()

  int size() const { return form.size; }
  const Form &shape() const { return form; }
  void exchange(const double *source, double *target) const { form.exchange(source, target); }

  // of the partners of i in the list of the pair style: is it known, and its values
  int *known(int i) const { return fix->firstflag[i]; }
  double *values(int i) const { return fix->firstvalue[i]; }

  bigint forget(int groupbit);    // of the particles in a group, from the next run on; records
  FixNeighHistoryLubcontact *carrier() const { return fix; }    // null before the first run

 private:
  Form form;
  std::string history_id, dummy_id;
  FixNeighHistoryLubcontact *fix;
  FixNeighHistoryPlace *place;    // until the size of the history is known

  void find_place();
};

}    // namespace LAMMPS_NS

#endif
