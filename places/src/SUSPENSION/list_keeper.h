/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_LIST_KEEPER_H
#define LMP_LIST_KEEPER_H

#include "pointers.h"

#include <array>
#include <vector>

namespace LAMMPS_NS::Rheometer_NS {
struct Deformation;
struct Scatter;
}    // namespace LAMMPS_NS::Rheometer_NS

namespace LAMMPS_NS {

// Decides for a fix that makes a flow when the neighbor lists are to be made anew: see
// rheometer_list.h. The fix has force_reneighbor set and calls listed() in pre_neighbor, decide()
// in post_integrate and release() in post_run.
class ListKeeper : protected Pointers {
 public:
  ListKeeper(LAMMPS *, class Fix *);
  ~ListKeeper() override;

  void listed();    // a list is about to be made of these positions
  bool decide(const std::vector<Rheometer_NS::Deformation> &,
              const double *origin);    // with one of these since then, false: make a new list now
  void release();                       // LAMMPS decides again
  double memory_usage() const;

  void allow(bool may) { on = may; }    // not: always LAMMPS
  bool allowed() const { return on; }

 private:
  bool on;
  class Fix *fix;
  bool keeps;    // now, instead of LAMMPS
  bool asked;    // whether it may, in this run
  int every;     // of neigh_modify
  std::vector<std::array<double, 3>>
      held;               // positions when the list was made, relative to origin then
  double narrowest[3];    // sub-domain along each direction
  void take_over();
  bool may_keep() const;
  double longest_cutoff() const;
  bool crosses(const Rheometer_NS::Scatter &) const;
};

}    // namespace LAMMPS_NS

#endif
