/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What an input script gives: numbers, variables, words.

#ifndef LMP_SUSPENSION_INPUT_H
#define LMP_SUSPENSION_INPUT_H

#include <string>

namespace LAMMPS_NS {
class Error;
class LAMMPS;
}    // namespace LAMMPS_NS

namespace LAMMPS_NS::Suspension_NS {

// A number, or v_name: an equal-style variable.
struct InputNumber {
  double value = 0.0;      // of a variable: as last evaluated
  std::string variable;    // empty for a number

  InputNumber() = default;
  InputNumber(LAMMPS *, const char *word);
  bool is_number() const { return variable.empty(); }
  void check(LAMMPS *, const char *style, const char *keyword) const;    // in init()
  bool evaluate(LAMMPS *);                                               // true for a variable
};

// Stops if fewer words are given than a command or keyword needs, and says which are missing; usage
// is how it is written. Words from "..." on may be left out.
void require_words(const std::string &file, int line, Error *, const std::string &command,
                   int given, const std::string &usage);

}    // namespace LAMMPS_NS::Suspension_NS

#endif
