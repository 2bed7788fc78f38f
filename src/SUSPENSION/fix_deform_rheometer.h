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

#include "suspension_input.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS::Rheometer_NS {
struct Cell;
struct Gradient;
struct Material;
struct StrainMeans;
struct Watch;
}    // namespace LAMMPS_NS::Rheometer_NS

namespace LAMMPS_NS {

class ListKeeper;

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
  const Rheometer_NS::StrainMeans &means() const { return *averages; }
  double strain_path() const { return path; }    // sum of |strain|

  // f_ID[1] and so on: see the manual; then the means
  // clang-format off
  struct Output {
    enum { STRAIN, RATE, PHI, PRESSURE, STRESS, PRESSURE_TARGET, TARGET, DILATION, PATH, STATE,
           MEANS };
  };
  // clang-format on

 protected:
  FixDeformRheometer(class LAMMPS *, int, char **, std::vector<char *>);

  enum Drive { NONE_YET, RATE, IV, STRESS, OSCILLATE };
  enum Confinement { OPEN, PRESSURE, VOLUME };

  int flow;    // Rheometer_NS::Flow
  Drive drive;
  Suspension_NS::InputNumber
      driven;    // rate, viscous number or stress; mean rate of an oscillation
  Suspension_NS::InputNumber amplitude, frequency;    // of an oscillation
  Confinement confinement;
  Suspension_NS::InputNumber pressure;
  Suspension_NS::InputNumber viscosity;    // of the fluid
  bool viscosity_given;
  const double *pair_viscosity;    // that of the pair style, if not given
  double gain;

  // state, in the restart file
  double strain, path, time, rate, dilation;
  std::unique_ptr<Rheometer_NS::Gradient> gradient;    // since the flow was last adjusted
  std::unique_ptr<Rheometer_NS::Cell>
      cell_rate;    // and the change of the cell per time since then
  double moved;     // time since then
  std::unique_ptr<Rheometer_NS::Watch> watch_pressure, watch_stress, watch_rate;
  std::unique_ptr<Rheometer_NS::StrainMeans> averages;    // of pressure and stress

  double measured_pressure, measured_stress;    // of the particles, when last adjusted
  int state;                                    // Rheometer_NS::State
  bool fresh;                                   // the targets are new
  bool stepped;    // the cell has moved in this run; it does not in a rerun
  bool warned, warned_every;
  static constexpr int NUM_PARTICLES = 4;
  double particles[NUM_PARTICLES];    // sums of volume, mass, radius, number
  std::unique_ptr<Rheometer_NS::Material> material;
  class Compute *pair_virial;
  std::string virial_id;
  std::unique_ptr<ListKeeper> keeper;            // of the neighbor lists
  std::unique_ptr<Rheometer_NS::Cell> listed;    // cell when they were made
  double **held;        // positions before LAMMPS converts them to lamda coordinates and back
  bool from_restart;    // held comes from the restart file

  int parse(int, int, char **, bool);
  int parse_drive(int, int, char **, bool);
  void need_values(const char *, int, int) const;
  int parse_flow(int, const char *) const;
  bool parse_lists(int, const char *) const;
  void check_directions() const;
  void check_variables() const;
  bool has_variables() const;
  void update_targets();
  void check_cell() const;
  void check_move(const Rheometer_NS::Cell &, const Rheometer_NS::Cell &) const;
  void restore_positions();
  void find_viscosity();
  void add_particle(int, bool, double *) const;
  void take_particles(const double *);
  void measure_particles();
  void measure_stress();
  double next_rate() const;
  double next_dilation() const;
  void judge();
  void judge_stress();
  double interval() const;
  void set_gradient();
  void start_list();
  void keep_list(const Rheometer_NS::Cell &);
  void publish_rates();
};

}    // namespace LAMMPS_NS

#endif
#endif
