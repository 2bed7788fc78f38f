/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(stress/partition/atom,ComputeStressPartitionAtom);
// clang-format on
#else

#ifndef LMP_COMPUTE_STRESS_PARTITION_ATOM_H
#define LMP_COMPUTE_STRESS_PARTITION_ATOM_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {
struct Vec3;
}

namespace LAMMPS_NS {

class ComputeStressPartitionAtom : public Compute {
 public:
  ComputeStressPartitionAtom(class LAMMPS *, int, char **);
  ~ComputeStressPartitionAtom() override;
  void init() override;
  void compute_peratom() override;
  int pack_reverse_comm(int, int, double *) override;
  void unpack_reverse_comm(int, int *, double *) override;
  double memory_usage() override;

 protected:
  int nmax;                       // atoms there is room for
  class FixPorePressure *pore;    // or null
  class FixHydro *hydro;
  std::vector<class PairLubcontact *> pairs;    // several with pair_style hybrid
  void collect_parts();
  Lubcontact_NS::Vec3 find_drift() const;
};

}    // namespace LAMMPS_NS

#endif
#endif
