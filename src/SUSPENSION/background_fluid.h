/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_BACKGROUND_FLUID_H
#define LMP_BACKGROUND_FLUID_H

#include "background_flow.h"
#include "background_hindrance.h"
#include "exclusive_particles.h"
#include "fluid_drag.h"
#include "pointers.h"
#include "suspension_input.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

// The fluid of fix drag/background, fix overdamped/sphere and fix hydro: its viscosity, its flow,
// and how it drags a particle.
class BackgroundFluid : protected Pointers {
 public:
  BackgroundFluid(LAMMPS *, class Fix *, int narg, char **arg);    // arguments from arg[3] on

  // of a fix that has its own words: the flow is that of the cell
  struct Choice {
    Suspension_NS::InputNumber viscosity;    // if it is not that of the pair style
    bool of_pair = true;
    int isolated = 0;          // spheres with fewer partners only, 0: all
    bool elsewhere = false;    // another fix has the fluid: no values here
    std::string typed;         // its words then
  };
  BackgroundFluid(LAMMPS *, Fix *, const Choice &);

  void init();        // makes the rules for particles of the fix anew
  void setup();       // at the start of a run, once neighbor lists exist
  void new_step();    // values of this step
  void evaluate();    // those that need no pairs

  Fluid_NS::Flow flow_at(int i) const { return flow->at(i); }
  Fluid_NS::Drag drag(int i) const;
  // which particles have fewer partners than needed, in this step
  struct Isolation {
    const double *partners;    // null: all are isolated
    double fewer;
    bool of(int i) const { return !partners || partners[i] < fewer; }
  };
  Isolation isolation() const { return {isolated ? partners->data() : nullptr, 1.0 * isolated}; }
  bool is_isolated(int i) const { return isolation().of(i); }
  double viscosity_now() const { return viscosity; }
  bool is_elsewhere() const { return elsewhere; }
  bool only_isolated() const { return isolated > 0; }
  double hindrance() const { return rule->factor(); }
  ExclusiveParticles &exclusive() { return own; }
  const ExclusiveParticles &exclusive() const { return own; }
  double memory_usage() const;

  // what a restart file holds
  double kept() const { return rule->kept(); }
  void keep(double from) { rule->keep(from); }

  // the arguments, as typed or with the present values of variables
  const std::string &typed() const { return words; }
  std::string settings_text() const;
  std::string value_of(const std::string &variable) const;

 private:
  Fix *fix;
  std::string style, words;
  ExclusiveParticles own;            // not those of the plates, and what the fix adds
  Suspension_NS::InputNumber eta;    // viscosity, pressure*time
  bool eta_of_pair, needs_viscosity, elsewhere;
  const char *eta_word;
  std::unique_ptr<BackgroundFlow> flow;
  std::unique_ptr<BackgroundHindrance> rule;
  Fluid_NS::Shape body;
  int isolated;      // particles with fewer partners feel the full drag, 0: all
  bool evaluated;    // variables have values

  // of this step
  double viscosity;
  const std::vector<double> *partners;    // of each particle: those of the only pair style,
  std::vector<double> of_all_styles;      // or of all

  Suspension_NS::InputNumber others;    // factor of the drag on those that are not isolated

  void parse(int, char **);
  void parse_shape(int, char **);
  void parse_isolated(int, char **, int &);
  void parse_others(int, char **);
  void exclude_plates();
  const double *find_viscosity() const;
  void check_isolated() const;
  void count_partners();
  bool has_variables() const;
};

}    // namespace LAMMPS_NS

#endif
