/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(microstructure,ComputeMicrostructure);
// clang-format on
#else

#ifndef LMP_COMPUTE_MICROSTRUCTURE_H
#define LMP_COMPUTE_MICROSTRUCTURE_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {
struct DirectionBins;
struct Load;
struct PairGeometry;
}    // namespace LAMMPS_NS::Lubcontact_NS

namespace LAMMPS_NS {

class ComputeMicrostructure : public Compute {
 public:
  ComputeMicrostructure(class LAMMPS *, int, char **);
  ~ComputeMicrostructure() override;
  void init() override;
  double compute_scalar() override;
  void compute_vector() override;
  void compute_array() override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  int pack_reverse_comm(int, int, double *) override;
  void unpack_reverse_comm(int, int *, double *) override;
  double memory_usage() override;

 protected:
  enum Mode { CONTACTS, FABRIC, FORCES, ANGLE, SPHERE };
  static constexpr int FABRIC_ROWS = 5, FORCE_COLUMNS = 3, FORCE_NUMBERS = 7;
  static constexpr int DIRECTION_SUMS = 8;    // before the parts of the stress
  Mode mode;
  int bins;                                     // of mode forces
  double largest;                               // upper end of the histogram, in mean forces
  Lubcontact_NS::DirectionBins *directions;     // of modes angle and sphere
  int stress_a, stress_b;                       // component of the stress of these
  std::vector<class PairLubcontact *> pairs;    // several with pair_style hybrid
  std::vector<double> per_atom;    // contacts, or velocities of this step also of the ghosts

  void read_mode(int, char **);
  void read_directions(int, int, char **);
  int read_count(int, char **) const;
  void set_output();
  template <class Visit> void visit(Visit);
  void sum_over_ranks(std::vector<double> &) const;
  void compute_contacts();
  void count_rattlers(double &, double &);
  void compute_fabric();
  void compute_forces();
  void compute_directions();
  void add_direction(double, int, int, const Lubcontact_NS::PairGeometry &,
                     const Lubcontact_NS::Load &, double *) const;
  void share_velocities();
};

}    // namespace LAMMPS_NS

#endif
#endif
