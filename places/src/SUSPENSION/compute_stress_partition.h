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

namespace LAMMPS_NS {

class ComputeStressPartition : public Compute {
 public:
  ComputeStressPartition(class LAMMPS *, int, char **);
  ~ComputeStressPartition() override;
  void init() override;
  void compute_array() override;
  double memory_usage() override;

 protected:
  class FixPorePressure *pore;    // or null
  class FixHydro *hydro;
  std::vector<class PairLubcontact *> pairs;    // several with pair_style hybrid
};

}    // namespace LAMMPS_NS

#endif
#endif
