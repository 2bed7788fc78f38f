/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// How a background fluid flows. A new flow is a class and a row of the table in
// background_flow.cpp.

#ifndef LMP_BACKGROUND_FLOW_H
#define LMP_BACKGROUND_FLOW_H

#include "fluid_flow.h"
#include "pointers.h"
#include "suspension_input.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class BackgroundFlow : protected Pointers {
 public:
  // of a fix, which errors are about: the keyword of the flow is arg[iarg]
  struct Words {
    class Fix *fix;
    char **arg;
    int iarg;
  };
  struct Style {
    const char *keyword, *usage;    // and its values
    std::unique_ptr<BackgroundFlow> (*make)(LAMMPS *, const Words &);
  };
  static const std::vector<Style> &styles();
  static std::unique_ptr<BackgroundFlow> at_rest(LAMMPS *, Fix *);
  static std::unique_ptr<BackgroundFlow> of_cell(LAMMPS *,
                                                 Fix *);    // at rest if it keeps its shape

  virtual void init();                           // is it possible here? Anew in each run
  virtual void setup() {}                        // at the start of a run, once positions are known
  virtual void new_step();                       // values of this step
  virtual Fluid_NS::Flow at(int i) const = 0;    // at particle i

  virtual bool take_spin(char ** /*values*/) { return false; }    // three; false: it has its own
  bool has_variables() const;
  const std::vector<Suspension_NS::InputNumber> &numbers() const { return number; }
  virtual bool is_per_atom(const std::string & /*variable*/) const { return false; }
  virtual double memory_usage() const { return 0.0; }

 protected:
  BackgroundFlow(LAMMPS *, const Words &, int count);    // its values, if they are numbers

  class Fix *fix;
  std::vector<Suspension_NS::InputNumber> number;
};

}    // namespace LAMMPS_NS

#endif
