/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_RHEOMETER_TARGET_H
#define LMP_RHEOMETER_TARGET_H

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
class Pair;
class PairLubcontact;

// What an input script gives as a number or as v_name, an equal-style variable
struct RheometerTarget {
  double value = 0.0;
  std::string variable;    // empty for a number

  RheometerTarget() = default;
  RheometerTarget(LAMMPS *, const char *word);
  bool is_number() const { return variable.empty(); }
  void check(LAMMPS *, const char *style, const char *keyword) const;
  bool evaluate(LAMMPS *);    // true for a variable
};

// pair style lubcontact, alone or the first under hybrid, or null
Pair *find_lubcontact(LAMMPS *);

// all of them
std::vector<PairLubcontact *> all_lubcontact(LAMMPS *);

// their viscosity; null without them, if it is a variable, or if they do not agree
const double *viscosity_of_pair(LAMMPS *);
std::string why_no_viscosity(LAMMPS *);

}    // namespace LAMMPS_NS

#endif
