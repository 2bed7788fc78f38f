/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(deform/rheometer,FixDeformRheometer);
// clang-format on
#else

#ifndef LMP_FIX_DEFORM_RHEOMETER_H
#define LMP_FIX_DEFORM_RHEOMETER_H

#include "fix_deform.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS::Rheometer_NS {
struct Cell;
struct Gradient;
struct CellMotion;
struct StrainMeans;
}    // namespace LAMMPS_NS::Rheometer_NS

namespace LAMMPS_NS {

// A FixDeform, because LAMMPS looks for one to make the velocities of ghost atoms; nothing of its
// motion of the box is used, only its flip.
class FixDeformRheometer : public FixDeform {
 public:
  FixDeformRheometer(class LAMMPS *, int, char **);
  ~FixDeformRheometer() override;
  int setmask() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup_pre_neighbor() override;
  void setup(int) override;
  void post_integrate() override;
  void pre_exchange() override;
  void pre_neighbor() override;
  void end_of_step() override;
  void post_run() override;
  double compute_vector(int) override;
  void *extract(const char *, int &) override;
  int modify_param(int, char **) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  double memory_usage() override;

  // for suspension_scene: what it imposes, NaN where it imposes nothing, and all that as typed
  struct Imposed {
    double rate, iv, pressure;
    bool steady_shear, holds_rate, holds_pressure;
  };
  Imposed imposed() const;
  std::string settings_text() const;
  const Rheometer_NS::StrainMeans &means() const;
  double strain_path() const;    // sum of |strain|

  // f_ID[1] and so on: see the manual; then the means
  // clang-format off
  struct Output {
    enum { STRAIN, RATE, PHI, PRESSURE, STRESS, PRESSURE_TARGET, TARGET, DILATION, PATH, STATE,
           MEANS };
  };
  // clang-format on

 private:
  FixDeformRheometer(class LAMMPS *, int, char **, std::vector<char *>);

  int flow;                       // Rheometer_NS::Flow
  class FixPorePressure *pore;    // or null
  std::unique_ptr<class DeformTargets> targets;
  std::unique_ptr<class DeformStress> stress;
  std::unique_ptr<class DeformJudge> judge;
  std::unique_ptr<class ListKeeper> keeper;    // of the neighbor lists
  std::unique_ptr<Rheometer_NS::CellMotion> motion;
  std::unique_ptr<Rheometer_NS::Cell> listed;    // cell when the lists were made
  bool fresh;                                    // the targets are new
  bool stepped;         // the cell has moved in this run; it does not in a rerun
  double **held;        // positions before LAMMPS converts them to lamda coordinates and back
  bool from_restart;    // held comes from the restart file

  int parse(int, int, char **, bool);
  int parse_flow(int, const char *) const;
  void check_directions() const;
  void check_cell() const;
  void check_move(const Rheometer_NS::Cell &, const Rheometer_NS::Cell &) const;
  void restore_positions();
  void start_list();
  void keep_list(const Rheometer_NS::Cell &);
  void update_targets();
  void measure_stress();
  double next_rate() const;
  double next_dilation() const;
  double trouton() const;
  double interval() const;
  void set_gradient();
  void push_particles(const Rheometer_NS::Gradient &, double);
  void publish_rates();
};

}    // namespace LAMMPS_NS

#endif
#endif
