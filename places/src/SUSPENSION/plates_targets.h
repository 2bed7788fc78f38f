/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix rheometer/plates is told to hold: a drive along x and a load along y, as numbers or
// variables, and how the plate moves.

#ifndef LMP_PLATES_TARGETS_H
#define LMP_PLATES_TARGETS_H

#include "pointers.h"
#include "suspension_input.h"

#include <map>
#include <string>

namespace LAMMPS_NS {

class PlatesTargets : protected Pointers {
 public:
  enum Drive { RATE, VELOCITY, STRESS, OSCILLATE, IV };    // along x
  enum Load { GAP, PRESSURE, LOAD };                       // along y

  PlatesTargets(LAMMPS *, const char *style_of_fix);

  // keywords of the fix or of fix_modify from arg[iarg] on
  struct Parsed {
    int next = 0;    // the first word that is none
    bool drive = false, load = false, same_load = false;
  };
  Parsed parse(int narg, char **arg, int iarg);
  void check();       // at the start of a run
  void evaluate();    // values of this step

  Drive drive() const { return kind; }
  Load load() const { return hold; }
  double x() const { return number[ALONG_X].value; }    // rate, its mean, velocity, stress or iv
  double amplitude() const { return number[AMPLITUDE].value; }    // of an oscillation, 1/time
  double frequency() const { return w; }
  double pressure() const { return number[PRESSED].value; }
  double viscosity() const { return number[ETA].value; }
  double mass() const { return plate; }    // of the moving plate; 0: that of its particles
  double damper_x() const { return damper[0]; }
  double damper_y() const { return damper[1]; }
  double gain() const { return servo_gain; }
  bool affine_lists() const { return affine; }
  bool turned_from(const struct PlatesState &) const;    // another drive, or another oscillation

 private:
  enum { ALONG_X, AMPLITUDE, PRESSED, ETA, NUM };
  using Places = std::map<std::string, int>;    // where each keyword of one command stands

  std::string style;
  Drive kind;
  Load hold;
  Suspension_NS::InputNumber number[NUM];
  double w;
  bool own_viscosity;        // given here, not by the pair style
  const double *pair_eta;    // viscosity of the pair style, or null
  double plate, damper[2], servo_gain;
  bool affine;

  void parse_drive(int, char **, int);
  void parse_load(int, char **, int);
  void parse_number(const std::string &, char **, int);
  void check_combination(const Places &, char **) const;
  void check_viscosity();
  void check_values() const;
  int place(char **, int) const;
};

}    // namespace LAMMPS_NS

#endif
