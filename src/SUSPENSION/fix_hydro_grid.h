/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_HYDRO_GRID_H
#define LMP_FIX_HYDRO_GRID_H

#include "fix_hydro_level.h"
#include "pore_cg.h"

namespace LAMMPS_NS {

class HydroField;
class HydroPreconditioner;
struct HydroSettings;

// All spheres move each other through the fluid, by its mobility on a grid: solved from time to
// time, held in between.
class HydroGrid : public HydroLevel {
 public:
  HydroGrid(LAMMPS *, Fix *, int narg, char **arg);
  ~HydroGrid() override;
  void init() override;
  bool leaves_residual() const override { return true; }
  void init_list(NeighList *ptr) override { list = ptr; }
  void start() override;
  void new_step() override;
  bool pull(int i, Pull &) const override;
  bool drags_all() const override { return true; }
  void stresslet(int i, double *five) const override;
  double stresslet_heat() const override { return heat; }
  double mean_stresslet_heat() const override { return 0.5 * (heat_before + heat); }

  double iterations() const override { return state.iterations; }
  double residual() const override { return state.residual; }
  double solutions() const override { return state.solutions; }
  double phi() override { return state.phi; }

  bool restarts() const override { return true; }
  void write(FILE *) const override;
  const char *read(char *) override;

  int comm_size() const override;
  int pack_loads(int n, const int *list, double *buf) const override;
  void unpack_loads(int n, int first, const double *buf) override;
  int pack_motions(int n, int first, double *buf) const override;
  void unpack_motions(int n, const int *list, const double *buf) override;
  double memory_usage() const override;

 private:
  std::unique_ptr<HydroSettings> settings;
  std::unique_ptr<HydroField> field;
  std::unique_ptr<HydroPreconditioner> preconditioner;
  NeighList *list;
  double heat = 0.0, heat_before = 0.0;    // of the stresslets, of this rank

  // numbers only: a restart file holds it
  struct State {
    double solutions = 0.0;    // so far
    double step = 0.0;         // of the last one, and the strain since then
    double strain = 0.0;
    double radius = 0.0;                                                     // mean, in this run
    double phi = 0.0, viscosity = 0.0, translation = 1.0, rotation = 2.0;    // of the last one
    double iterations = 0.0, residual = 0.0;
  } state;

  void parse_all(int, char **);
  int parse_keyword(int, int, char **, BackgroundFluid::Choice &);
  void check_cell() const;
  void check_pores() const;
  void measure_radius();
  double sum_heat() const;
  void solve(double tolerance);
  void hold_each(bool given);
  Pore_NS::Convergence find_loads(const std::vector<double> &right, double tolerance,
                                  std::vector<double> &x);
};

}    // namespace LAMMPS_NS

#endif
