/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Does fix deform/rheometer follow its targets, and will it ever reach them? Warns once.

#ifndef LMP_DEFORM_JUDGE_H
#define LMP_DEFORM_JUDGE_H

#include "pointers.h"
#include "rheometer_servo.h"

#include <string>

namespace LAMMPS_NS {

class DeformJudge : protected Pointers {
 public:
  DeformJudge(LAMMPS *, const char *style_of_fix);

  // trouton: of the flow; dt: until the flow is adjusted again
  void judge(const class DeformTargets &, const class DeformStress &, double rate, double dilation,
             double trouton, double dt);
  void start_anew();    // other targets
  Rheometer_NS::State state() const { return verdict; }

  // in a restart file
  struct Watches {
    Rheometer_NS::Watch pressure, stress, rate;
  };
  const Watches &watches() const { return watched; }
  void set_watches(const Watches &watches) { watched = watches; }

 private:
  std::string style;
  Watches watched;
  Rheometer_NS::State verdict;
  bool warned, warned_every;

  void judge_pressure(const DeformTargets &, const DeformStress &, double rate, double dilation,
                      double dt);
  void judge_stress(const DeformTargets &, const DeformStress &, double rate, double trouton,
                    double dt);
  void warn(const std::string &);
};

}    // namespace LAMMPS_NS

#endif
