/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The pairs of one pair style: its neighbor list with range, faces and history. Answers which of
// them act, what they remember, and goes through them for others.

#ifndef LMP_LUBCONTACT_PAIRS_H
#define LMP_LUBCONTACT_PAIRS_H

#include "lubcontact_history.h"
#include "lubcontact_range.h"
#include "pointers.h"
#include "radical_tessellation.h"

#include <functional>
#include <memory>
#include <vector>

namespace LAMMPS_NS {
class NeighList;

class LubcontactPairs : protected Pointers {
 public:
  explicit LubcontactPairs(LAMMPS *);

  LubcontactHistory &history() { return memory_of_pairs; }
  Lubcontact_NS::RangeTable &range() { return ranges; }
  const Lubcontact_NS::RangeTable &range() const { return ranges; }
  const NeighList *list() const { return neighbors; }    // LAMMPS'; null before the first run
  void take_list(const NeighList *list) { neighbors = list; }

  // which pairs share a face: when the list has been built, where the range asks
  void find_faces(const Lubcontact_NS::Settings &);
  void request_ghosts(const Lubcontact_NS::Settings &, double largest_radius);
  const FaceFlags &faces() const { return common_faces; }

  Lubcontact_NS::RangeOf around(int i) const;

  // effective radius of entry n of the list of i if it acts, else 0
  double acting(int i, int n) const;

  // Goes through the pairs that act: entry n of the list of i. One that two ranks or images see has
  // weight 1/2 each time.
  struct Acting {
    int i, j, n;
    double weight, a;
  };
  using Entries = std::function<void(const Acting &)>;
  void each(const Entries &) const;
  double share(int j) const;

  // The same with the forces of this step; changes nothing.
  using Visitor = std::function<void(int, int, double, const Lubcontact_NS::PairGeometry &,
                                     const Lubcontact_NS::Load &)>;
  void visit(unsigned instance, const Lubcontact_NS::Film &, const Visitor &) const;
  Lubcontact_NS::PairGeometry geometry(int i, int j, double a) const;

  // place of the pair (i,j) in the list, perhaps as (j,i); false if it is in none
  struct Entry {
    int owner, n;
    bool swapped;
  };
  bool find_entry(int i, int j, Entry &) const;

  // copied to buffer if the pair is asked for from the other side; null if it has none
  const double *find_history(const Entry &, double *buffer) const;

  // A gap is kept over the effective radius: where radii grow in a run it stays the same length.
  void follow_radii(bool has_gap);

  double memory_usage() const;

 private:
  LubcontactHistory memory_of_pairs;
  Lubcontact_NS::RangeTable ranges;
  const NeighList *neighbors;
  RadicalTessellation tessellation;
  FaceFlags common_faces;
  std::vector<double> radii;    // of the last step, where they may change in a run

  bool acts_by_special(int entry) const;
  bool excluded(int i, int j) const;
};

}    // namespace LAMMPS_NS

#endif
