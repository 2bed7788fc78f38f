/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(hydro,FixHydro);
// clang-format on
#else

#ifndef LMP_FIX_HYDRO_H
#define LMP_FIX_HYDRO_H

#include "fix.h"

#include <memory>

namespace LAMMPS_NS {

class HydroField;
struct HydroSettings;

class FixHydro : public Fix {
 public:
  FixHydro(class LAMMPS *, int, char **);
  ~FixHydro() override;
  int setmask() override;
  void init() override;
  void init_list(int, class NeighList *) override;
  void setup(int) override;
  void post_force(int) override;
  double compute_vector(int) override;
  double memory_usage() override;

  void write_restart(FILE *) override;
  void restart(char *) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  int pack_reverse_comm(int, int, double *) override;
  void unpack_reverse_comm(int, int *, double *) override;

  static FixHydro *find(class LAMMPS *);    // null without one

  // for computes; the first two of this rank
  void add_stresslets(double *nine) const;    // xx yy zz xy xz yz yx zx zy
  double stresslet_power() const;             // what they take from the flow
  double torque(int d);                       // of the fluid on all particles
  double mean_power();                        // dissipated, mean of the last step

 protected:
  // f_ID[1] and so on: see the manual
  // clang-format off
  struct Output {
    enum { ITERATIONS, RESIDUAL, STRESS, HEAT = STRESS + 6, FORCE, SOLUTIONS = FORCE + 3, PHI,
           NUM };
  };
  // clang-format on

 private:
  std::unique_ptr<HydroSettings> settings;
  std::unique_ptr<HydroField> field;
  std::unique_ptr<class ExclusiveParticles> own;
  std::unique_ptr<class SpinInertia> inertia;
  class NeighList *list;
  bool deforms;              // the cell
  double **held;             // of each particle: load, the one before, velocity and spin
  double **force_of_atom;    // for output: force and torque of the fluid
  double work, total[6];     // of this rank: heat, force and torque of the fluid
  double step_power;         // of this rank, mean of the last step

  // numbers only: a restart file holds it
  struct State {
    double solutions = 0.0;    // so far
    double step = 0.0;         // of the last one, and the strain since then
    double strain = 0.0;
    double radius = 0.0;                                                     // mean, in this run
    double phi = 0.0, viscosity = 0.0, translation = 1.0, rotation = 2.0;    // of the last one
    double iterations = 0.0, residual = 0.0;
  } state;

  void parse(int, char **);
  int parse_keyword(int, int, char **);
  void check_cell() const;
  void check_others();
  void check_films() const;
  void check_order() const;
  void measure_radius();
  void find_strain(double *) const;
  double viscosity_now();
  void solve(double tolerance, double viscosity);
  void act(bool full);
};

}    // namespace LAMMPS_NS

#endif
#endif
