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

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class HydroLevel;

class FixHydro : public Fix {
 public:
  FixHydro(class LAMMPS *, int, char **);
  ~FixHydro() override;
  int setmask() override;
  void init() override;
  void init_list(int, class NeighList *) override;
  void setup_pre_force(int) override;
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
  const HydroLevel &fluid() const { return *level; }

  // the arguments, as typed or with the present values of variables
  const std::string &typed() const { return words; }
  std::string settings_text() const;

  // stresslets on the fluid, xx yy zz xy xz yz yx zx zy: of this rank, and of each of its particles
  void add_stresslets(double *nine) const;
  std::vector<std::array<double, 9>> stresslets() const;

  // for computes
  double stresslet_power() const;    // of this rank: what they take from the flow
  double force_of_fluid(int d);      // on all particles
  double torque(int d);
  double mean_power();    // dissipated, mean of the last step

 protected:
  // f_ID[1] and so on: see the manual
  // clang-format off
  struct Output {
    enum { ITERATIONS, RESIDUAL, STRESS, HEAT = STRESS + 6, FORCE, SOLUTIONS = FORCE + 3, PHI,
           DRAGGED, NUM };
  };
  // clang-format on

 private:
  std::unique_ptr<HydroLevel> level;
  std::string words;
  std::unique_ptr<class SpinInertia> inertia;
  double **force_of_atom;    // for output: force and torque of the fluid
  // of this rank: heat of the drag, force and torque of the fluid, number of particles dragged
  double work, total[6], dragged;
  int massless;         // bits of groups that have no inertia
  double step_power;    // of the drag, of this rank, mean of the last step
  bool stepped;         // in this run

  std::vector<int> had_force;    // in the last step

  void act(bool full);
  void forget_forces(bool all);
  double sum_of_ranks(double) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
