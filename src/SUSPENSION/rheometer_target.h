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

namespace LAMMPS_NS {
class LAMMPS;
class Pair;

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

// its viscosity; null without it, or if it is a variable
const double *viscosity_of_pair(LAMMPS *);

}    // namespace LAMMPS_NS

#endif
