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

#include <memory>
#include <string>

namespace LAMMPS_NS::Rheometer_NS {
struct Material;
struct StrainMeans;
struct WallStress;
}    // namespace LAMMPS_NS::Rheometer_NS

namespace LAMMPS_NS {

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
  int plate_bit(int plate) const { return bit[plate]; }    // 0 lower, 1 upper

  // of the last step: gap (0: not yet known) and velocity of the upper plate along x, shear rate,
  // volume fraction of the particles between the plates (0: not yet known)
  double gap() const;
  double velocity() const;
  double opening() const;    // velocity of the upper plate along y
  double rate() const;
  double phi() const;
  double imposed_pressure() const;    // 0 if there is none
  const Rheometer_NS::StrainMeans &means() const;

  // How forces move the upper plate along d = 0, 1, 2 (x, y, z), for a fix that adds forces before
  // this one: velocity after a force on its particles has acted besides what its drive and load
  // give, and what a force adds to it, over force and time; 0 where its motion is given. mass: of
  // its particles.
  void evaluate_targets();    // at the start of a run
  double velocity_after(int d, double force, double mass, double dt) const;
  double response(int d, double mass, double dt) const;
  // Fluid in the pores between the plates, if nobody knows its pressure in space: its mean is
  // -drainage (force*time/area) times d ln(gap)/dt, until the next call. It acts on both plates and
  // is included in the pressures that are put out and held.
  void drain(double drainage);

  bool has_servo() const;    // that holds a pressure
  bool has_gap() const;      // that is given

  // f_ID[1] and so on: see the manual; then the means
  // clang-format off
  struct Output {
    enum { STRAIN, RATE, GAP, VX, VY, PHI, LOWER_PRESSURE, UPPER_PRESSURE, LOWER_XY, UPPER_XY,
           LOWER_ZY, UPPER_ZY, TARGET_X, TARGET_Y, CODE_X, CODE_Y, MEANS };
  };
  // clang-format on

 private:
  static constexpr const char *PLATE_NAME[] = {"lower", "upper"};
  std::string plate_name[2];      // groups of the lower and upper one
  int igroup_plate[2], bit[2];    // and what they are in this run
  std::unique_ptr<class PlatesTargets> targets;
  std::unique_ptr<struct PlatesState> state;        // what a restart file holds
  std::unique_ptr<class ExclusiveParticles> own;    // particles of the plates
  double force_on[2][3];                            // of the suspension on the plates
  double drainage;                                  // of the pores

  // neighbor lists, and what the upper plate has moved since they were made
  std::unique_ptr<class ListKeeper> keeper;
  struct Listed {
    double bottom = 0.0, gap = 0.0, slid = 0.0;    // mean surface of the lower plate
  } listed;

  void start_drive();
  void start_load(bool);
  void find_plate(int, int);

  // checks at the start of a run
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
  bool is_pushed(int) const;
  double damper(int) const;
  Rheometer_NS::Material material() const;
  Rheometer_NS::WallStress stress_on(int) const;
  double fluid_pressure() const;
  void measure_gap();
  struct Sums;
  void add_particle(int, bool, double *) const;
  void measure_particles();
  void take_particles(const double *);
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
