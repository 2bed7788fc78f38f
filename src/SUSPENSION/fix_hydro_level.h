/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// How fix hydro describes the fluid: what it does to a particle. A new level is a class and a row
// of the table in fix_hydro.cpp.

#ifndef LMP_FIX_HYDRO_LEVEL_H
#define LMP_FIX_HYDRO_LEVEL_H

#include "background_fluid.h"
#include "pointers.h"

#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class Fix;
class NeighList;

class HydroLevel : protected Pointers {
 public:
  ~HydroLevel() override;

  virtual void init();    // is it possible here? Anew in each run
  virtual void init_list(NeighList *) {}
  virtual void start() = 0;       // of a run, before forces: all that stresslets need
  virtual void set_up() {}        // and with forces
  virtual void new_step() = 0;    // values of this step

  // what the fluid does to particle i in this step: a drag towards a motion; the flow is that
  // without particles. False: there is no drag
  struct Pull {
    Fluid_NS::Drag drag;
    Fluid_NS::Flow target, flow;
  };
  virtual bool pull(int i, Pull &) const = 0;
  const std::vector<int> &dragged() const { return pulled; }    // in this step, of this rank
  virtual bool drags_all() const { return false; }
  // does it leave the rest of pairs to residual films?
  virtual bool leaves_residual() const { return false; }
  virtual void stresslet(int i, double *five) const = 0;    // on the fluid, as in hydro_tensors.h
  virtual void sum_stresslets(double *five) const;          // of this rank
  virtual double stresslet_heat() const = 0;                // in the last step, of this rank
  virtual double mean_stresslet_heat() const = 0;           // from the step before to the last one

  // rate of strain of the cell without its trace, at this moment
  void find_strain(double *five) const;

  BackgroundFluid &background() { return *fluid; }

  // for output
  virtual double iterations() const { return 0.0; }
  virtual double residual() const { return 0.0; }
  virtual double solutions() const { return 0.0; }
  virtual double phi() = 0;    // volume fraction of the group, on all ranks

  // what it keeps of each particle
  const int columns;
  double **held;

  // what a restart file holds beside: does it hold anything?
  virtual bool restarts() const { return false; }
  virtual void write(FILE *) const {}
  virtual const char *read(char *) { return nullptr; }    // what is wrong with it

  // communication of the fix; numbers of a particle
  virtual int comm_size() const { return 0; }
  virtual int pack_loads(int, const int *, double *) const { return 0; }
  virtual void unpack_loads(int, int, const double *) {}
  virtual int pack_motions(int, int, double *) const { return 0; }
  virtual void unpack_motions(int, const int *, const double *) {}

  virtual double memory_usage() const;

 protected:
  HydroLevel(LAMMPS *, Fix *, int columns);

  Fix *fix;
  std::unique_ptr<BackgroundFluid> fluid;
  double strain[5];    // in the last step, before fixes changed the flow for the next one

  // arguments from arg[4] on: each keyword with its values, of which the last may be left out;
  // parse_one returns the number of words
  using Keywords = std::map<std::string, std::string>;
  std::map<std::string, int> parse(int narg, char **arg, const Keywords &,
                                   const std::function<int(int)> &parse_one) const;
  int parse_viscosity(int iarg, char **arg, BackgroundFluid::Choice &) const;
  double positive(int iarg, char **arg, const std::string &key) const;
  void find_dragged();               // once the fluid knows this step
  double volume_of_group() const;    // of this rank

 private:
  std::vector<int> pulled;

  void check_alone() const;
  void check_films() const;
  void check_others();
  void check_order() const;
};

}    // namespace LAMMPS_NS

#endif
