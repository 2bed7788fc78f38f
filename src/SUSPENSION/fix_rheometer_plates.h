/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(rheometer/plates,FixRheometerPlates);
// clang-format on
#else

#ifndef LMP_FIX_RHEOMETER_PLATES_H
#define LMP_FIX_RHEOMETER_PLATES_H

#include "fix.h"

#include "exclusive_particles.h"
#include "rheometer_mean.h"
#include "suspension_input.h"

#include <memory>
#include <string>

namespace LAMMPS_NS::Rheometer_NS {
struct Material;
struct WallStress;
}    // namespace LAMMPS_NS::Rheometer_NS

namespace LAMMPS_NS {

class ListKeeper;

class FixRheometerPlates : public Fix {
 public:
  FixRheometerPlates(class LAMMPS *, int, char **);
  ~FixRheometerPlates() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void setup_pre_neighbor() override;
  void initial_integrate(int) override;
  void post_integrate() override;
  void pre_neighbor() override;
  void post_force(int) override;
  void min_post_force(int) override;
  void final_integrate() override;
  void post_run() override;
  double compute_vector(int) override;
  double memory_usage() override;
  int modify_param(int, char **) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  void measure_surfaces(double &, double &) const;    // mean heights, lower and upper
  int plate_bits() const { return bit[0] | bit[1]; }

  // of the last step: gap (0: not yet known) and velocity of the upper plate along x, shear rate,
  // volume fraction of the particles between the plates (0: not yet known)
  double gap() const { return state.gap; }
  double velocity() const { return state.vx; }
  double rate() const { return state.rate; }
  double phi() const;
  double imposed_pressure() const;    // 0 if there is none
  const Rheometer_NS::StrainMeans &means() const { return state.means; }

 protected:
  enum Drive { RATE, VELOCITY, STRESS, OSCILLATE, IV };    // along x
  enum Load { GAP, PRESSURE, LOAD };                       // along y
  static constexpr const char *DRIVE_NAME[] = {"rate", "velocity", "stress", "oscillate", "iv"};
  static constexpr const char *LOAD_NAME[] = {"gap", "pressure", "load"};
  static constexpr const char *PLATE_NAME[] = {"lower", "upper"};

  // f_ID[1] and so on: see the manual; then the means
  // clang-format off
  struct Output {
    enum { STRAIN, RATE, GAP, VX, VY, PHI, LOWER_PRESSURE, UPPER_PRESSURE, LOWER_XY, UPPER_XY,
           LOWER_ZY, UPPER_ZY, TARGET_X, TARGET_Y, CODE_X, CODE_Y, MEANS };
  };
  // clang-format on

  // settings
  std::string plate_name[2];      // groups of the lower and upper one
  int igroup_plate[2], bit[2];    // and what they are in this run
  Drive drive;
  Load load;
  Suspension_NS::InputNumber target_x;     // rate (g0 of oscillate), velocity, stress, or iv
  Suspension_NS::InputNumber amplitude;    // g1 of oscillate, 1/time
  double frequency;                        // w of oscillate, 1/time
  Suspension_NS::InputNumber target_y;     // pressure of pressure and load
  Suspension_NS::InputNumber viscosity;    // pressure*time
  bool own_viscosity;                      // given here, not by the pair style
  double mass;                             // of the moving plate; 0: that of its particles
  double damper_x, damper_y, gain;         // force/velocity, and of the servo

  // what a restart file holds
  struct State {
    double gap = 0.0, vx = 0.0, vy = 0.0;    // gap 0: not yet known
    double strain = 0.0, rate = 0.0;         // rate of the last step
    double drive = 0.0, load = 0.0;          // what it belongs to, and the oscillation
    double amplitude = 0.0, frequency = 0.0;
    double clock = 0.0;       // time since the oscillation was set
    double dilation = 0.0;    // of the servo, 1/time
    double deviation_x = 0.0, age_x = 0.0, warned_x = 0.0;
    double deviation_y = 0.0, age_y = 0.0, warned_y = 0.0;
    double code_x = 0.0, code_y = 0.0;       // Rheometer_NS::State
    double solid = 0.0;                      // volume of the suspended particles
    double density = 0.0, diameter = 0.0;    // and their means
    double plate_mass = 0.0;                 // of the particles of the upper plate
    Rheometer_NS::StrainMeans means;         // of the plates
  } state;

  // neighbor lists, and what the upper plate has moved since they were made
  std::unique_ptr<ListKeeper> keeper;
  struct Listed {
    double bottom = 0.0, gap = 0.0, slid = 0.0;    // mean surface of the lower plate
  } listed;

  double force_on[2][3];     // of the suspension on the plates
  ExclusiveParticles own;    // particles of the plates
  const double *pair_eta;    // viscosity of the pair style, or null

  // input
  struct Places;
  int parse(int, char **, int);
  void start_drive();
  void start_load(bool);
  void parse_drive(int, char **, int);
  void parse_load(int, char **, int);
  void parse_number(const std::string &, char **, int);
  void check_combination(const Places &, char **) const;
  void find_plate(int, int);
  int place(char **, int) const;

  // checks at the start of a run
  void check_values() const;
  void check_viscosity();
  void check_cell() const;
  void check_groups() const;
  void exclude_integrators();
  void check_exclusion(int) const;
  bool excluded_by_group(int) const;
  bool excluded_by_type(int) const;
  void check_time_step() const;

  // motion
  double area() const;
  double moving_mass() const;
  Rheometer_NS::Material material() const;
  Rheometer_NS::WallStress stress_on(int) const;
  void measure_gap();
  struct Sums;
  void add_particle(int, bool, double *) const;
  void measure_particles();
  void take_particles(const double *);
  void evaluate_targets();
  void move_y(double);
  double rate_of_drive(double);
  void half_kick_x(double);
  void half_kick_y(double);
  void move_particles(double);
  void set_velocities();
  void watch_targets(double);
};

}    // namespace LAMMPS_NS

#endif
#endif
