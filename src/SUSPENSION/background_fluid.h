/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_BACKGROUND_FLUID_H
#define LMP_BACKGROUND_FLUID_H

#include "exclusive_particles.h"
#include "lubcontact_background.h"
#include "lubcontact_drag.h"
#include "pointers.h"
#include "suspension_input.h"

#include <array>
#include <string>
#include <vector>

namespace LAMMPS_NS {

// The fluid of fix drag/background and fix overdamped/sphere: its viscosity, its flow, and how it
// drags a particle.
class BackgroundFluid : protected Pointers {
 public:
  BackgroundFluid(LAMMPS *, class Fix *, int narg, char **arg);    // arguments from arg[3] on

  void init();        // makes the rules for particles of the fix anew
  void setup();       // at the start of a run, once neighbor lists exist
  void new_step();    // values of this step

  Lubcontact_NS::Flow flow(int i) const;
  Lubcontact_NS::Drag drag(int i) const;
  Lubcontact_NS::Shape shape() const { return body; }
  bool only_isolated() const { return isolated > 0; }
  double hindrance() const { return factor; }
  double solid;              // volume of all particles, for restart files
  ExclusiveParticles own;    // not those of the plates, and what the fix adds
  double memory_usage() const;

  // the arguments, as typed or with the present values of variables
  const std::string &typed() const { return words; }
  std::string settings_text() const;

 protected:
  enum Profile { REST, SHEAR, CELL, PLATES, COUETTE, POISEUILLE, VELOCITY };
  enum Hindrance { CONSTANT, FRACTION, MEASURED };
  static constexpr int NUM_NUMBERS = 4;

  class Fix *fix;
  std::string style;
  Suspension_NS::InputNumber eta;
  std::string words;
  bool evaluated;    // variables have values
  bool eta_of_pair;
  Profile profile;
  Suspension_NS::InputNumber number[NUM_NUMBERS];    // of the profile
  std::string plates_id;
  class FixRheometerPlates *plates;
  Lubcontact_NS::Shape body;
  Hindrance rule;
  Suspension_NS::InputNumber hindered;    // factor or volume fraction
  int isolated;                           // particles with fewer partners only, 0: all

  // velocity and spin given by variables
  struct Component {
    Suspension_NS::InputNumber target;
    bool per_atom = false;
    std::vector<double> value;
  };
  std::array<Component, 6> component;

  // of this step
  double viscosity, factor;
  Lubcontact_NS::Couette couette;
  Lubcontact_NS::Poiseuille poiseuille;
  std::vector<double> partners;

  void parse(int, char **);
  void parse_profile(Profile, char **, int &, std::string &);
  void parse_components(char **, int, int);
  void parse_hindrance(int, char **, int &);
  void check_component(Component &);
  void check_number(const Suspension_NS::InputNumber &, const char *);
  void find_plates();
  void check_cell() const;
  void exclude_plates();
  void measure_solid();
  void check_isolated() const;
  void count_partners();
  void update_profile();
  void update_hindrance();
  void update_components();
  bool has_variables() const;
  double value_of(const std::string &) const;
};

}    // namespace LAMMPS_NS

#endif
