/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(pore/pressure,FixPorePressure);
// clang-format on
#else

#ifndef LMP_FIX_PORE_PRESSURE_H
#define LMP_FIX_PORE_PRESSURE_H

#include "fix.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class FixRheometerPlates;
class PoreSolver;

// Pressure of the fluid between the particles, which must flow when they dilate or settle: Darcy's
// law on a grid or in a network of pores, and its forces on particles and plates.
class FixPorePressure : public Fix {
 public:
  FixPorePressure(class LAMMPS *, int, char **);
  ~FixPorePressure() override;
  static FixPorePressure *find(class LAMMPS *);    // or null
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  double compute_vector(int) override;
  double compute_array(int, int) override;
  double memory_usage() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  // of the last step
  double pressure_volume() const;                 // its integral
  std::vector<double> pressure_shares() const;    // of it, by local index; clear fluid has the rest
  double mean_power();    // that particles and cell have given to the fluid, energy/time
  double cell_pressure() const { return mean.pressure; }    // the mean one, of a periodic cell
  bool acts() const;                                        // not with coupling off

  // of the particles of now: mean pressure over -d ln V/dt that a layer opposes to its change of
  // volume; 0 without a layer, or if it does not act
  double drainage();

  // for suspension_scene: the arguments, as typed or with the present values of variables
  const std::string &typed() const { return words; }
  std::string settings_text() const;

  // f_ID[1] and so on: see the manual
  // clang-format off
  struct Output {
    enum { LOWER, UPPER, MEAN, LARGEST, LOWER_FLUX, UPPER_FLUX, DISSIPATION, FX, FY, FZ, ITERATIONS,
           RESIDUAL, K_MIN, K_MAX, STEP, POWER, NUM };
    enum { Y, PRESSURE, PHI, U_Y, Q_Y, NUM_COLUMNS };
  };
  // clang-format on

 private:
  std::string words;    // the arguments
  std::unique_ptr<struct PoreSettings> settings;
  std::unique_ptr<PoreSolver> field;
  FixRheometerPlates *plates;
  const double *dilation;    // d ln V/dt of fix deform/rheometer, or null
  double **force_of_atom;    // for output, force
  double work;               // of the last step on the particles of this rank, energy/time
  double tilt[3];            // of the last step: xy, xz, yz
  bool evaluated;            // the variables
  bool warned;

  // of a periodic cell; numbers only: a restart file holds it
  struct MeanState {
    double pressure = 0.0;                 // force/area
    double cell = 0.0;                     // volume to which that belongs; 0: none
    double volume = 0.0, squares = 0.0;    // of the particles, and of their radii
  } mean;
  double of_cell;               // power that its change of volume gives to the fluid
  double resistance, even_k;    // of an even layer: layer_resistance(), permeability

  void parse(int, char **);
  int parse_keyword(int, int, char **);
  void make_solver(const std::map<std::string, int> &given);
  void check_even(const std::map<std::string, int> &) const;
  void check_order() const;
  void check_others() const;
  void check_plates() const;
  double mean_diameter() const;
  void prepare();
  struct Now;
  Now now(double);
  void add_plates(Now &, double) const;
  void warn_of_lag();
  bool has_flipped();
  double evaluate();    // variables; the viscosity
  double layer_resistance();
  double gap() const;
  double dilation_of_gap() const;
  double mean_of_layer() const;
  void follow_layer(bool is_setup);
  double layer_heat() const;    // power/volume
  double volume() const;
  double layer_output(int);
  double layer_profile(int) const;
  double next_mean(double storage, bool is_known);
  void find_flow();
  void measure_work();
  void measure_flow();
  void keep_forces();
};

}    // namespace LAMMPS_NS

#endif
#endif
