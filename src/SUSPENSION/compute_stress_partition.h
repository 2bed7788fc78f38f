/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(stress/partition,ComputeStressPartition);
// clang-format on
#else

#ifndef LMP_COMPUTE_STRESS_PARTITION_H
#define LMP_COMPUTE_STRESS_PARTITION_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {
struct Inertia;
struct Vec3;
}    // namespace LAMMPS_NS::Lubcontact_NS

namespace LAMMPS_NS {

class ComputeStressPartition : public Compute {
 public:
  ComputeStressPartition(class LAMMPS *, int, char **);
  ~ComputeStressPartition() override;
  void init() override;
  void compute_array() override;
  double memory_usage() override;

  // rows: contact and lubrication, normal and tangential; inertia; repulsion
  static constexpr int INERTIA = 4, NUM_ROWS = 6;
  static constexpr int row_of(int part) { return part < INERTIA ? part : part + 1; }

  // shared with compute stress/partition/atom
  static std::vector<class PairLubcontact *> find_pairs(LAMMPS *, const char *);
  static Lubcontact_NS::Vec3 relative_velocity(LAMMPS *, int);
  static Lubcontact_NS::Inertia measure_inertia(LAMMPS *);    // of this rank

 protected:
  std::vector<class PairLubcontact *> pairs;    // several with pair_style hybrid
};

}    // namespace LAMMPS_NS

#endif
#endif
