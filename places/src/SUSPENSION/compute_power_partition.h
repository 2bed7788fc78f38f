/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(power/partition,ComputePowerPartition);
// clang-format on
#else

#ifndef LMP_COMPUTE_POWER_PARTITION_H
#define LMP_COMPUTE_POWER_PARTITION_H

#include "compute.h"

#include <memory>
#include <vector>

namespace LAMMPS_NS {

class ComputePowerPartition : public Compute {
 public:
  ComputePowerPartition(class LAMMPS *, int, char **);
  ~ComputePowerPartition() override;
  void init() override;
  void compute_array() override;
  double compute_scalar() override;
  double memory_usage() override;

 protected:
  class FixPorePressure *pore;    // or null
  class FixHydro *hydro;
  std::vector<class PairLubcontact *> pairs;    // several with pair_style hybrid
  std::vector<class FixBackgroundFluid *> drags;
  std::unique_ptr<class SpinInertia> inertia;

  void require_tally() const;
  double spin_energy() const;
};

}    // namespace LAMMPS_NS

#endif
#endif
