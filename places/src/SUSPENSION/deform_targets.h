/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix deform/rheometer is told to hold: one drive and one confinement, as numbers or
// variables.

#ifndef LMP_DEFORM_TARGETS_H
#define LMP_DEFORM_TARGETS_H

#include "pointers.h"
#include "suspension_input.h"

#include <string>

namespace LAMMPS_NS {

class DeformTargets : protected Pointers {
 public:
  enum Drive { NONE_YET, RATE, IV, STRESS, OSCILLATE };
  enum Confinement { OPEN, PRESSURE, VOLUME };

  DeformTargets(LAMMPS *, const char *style_of_fix);

  // keyword arg[iarg] with its values, of the fix or, without a word to underline, of fix_modify;
  // returns the next position
  int parse(int iarg, int narg, char **arg, bool underline);
  void check_complete(int narg, char **arg) const;
  void check_variables() const;
  bool has_variables() const;
  void find_viscosity();    // of the pair style, if none is given
  void update();            // values of this step

  Drive drive() const { return kind; }
  double driven() const
  {
    return number[DRIVEN].value;
  }    // rate, viscous number or stress; mean rate
  double amplitude() const { return number[AMPLITUDE].value; }    // of an oscillation
  double frequency() const { return number[FREQUENCY].value; }
  bool holds_pressure() const { return confined == PRESSURE; }
  double pressure() const { return number[HELD].value; }
  double viscosity() const { return number[ETA].value; }    // of the fluid
  double gain() const { return servo_gain; }
  std::string settings_text() const;    // all that, as typed

  // in a restart file
  struct Saved {
    double drive = 0.0, driven = 0.0, amplitude = 0.0, frequency = 0.0;
    double confinement = 0.0, pressure = 0.0;
  };
  Saved saved() const;
  bool turned_from(const Saved &) const;    // another drive, or another oscillation
  bool differ_from(const Saved &) const;    // in anything but variables

 private:
  std::string style;
  enum { DRIVEN, AMPLITUDE, FREQUENCY, HELD, ETA, NUM };
  Suspension_NS::InputNumber number[NUM];
  Drive kind;
  Confinement confined;
  bool viscosity_given;
  const double *pair_viscosity;    // that of the pair style, if not given
  double servo_gain;

  int parse_drive(int, int, char **, bool);
  void need_values(const char *, int, int) const;
};

}    // namespace LAMMPS_NS

#endif
