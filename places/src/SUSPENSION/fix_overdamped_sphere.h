/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(overdamped/sphere,FixOverdampedSphere);
// clang-format on
#else

#ifndef LMP_FIX_OVERDAMPED_SPHERE_H
#define LMP_FIX_OVERDAMPED_SPHERE_H

#include "fix_background_fluid.h"

namespace LAMMPS_NS {

class FixOverdampedSphere : public FixBackgroundFluid {
 public:
  FixOverdampedSphere(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void reset_dt() override;

 protected:
  double limit;    // of the time step, by the contacts at the start of the run
  bool warned;     // of the limit, in this run

  void check_others();
  class FixHydro *far;    // which has the fluid, or null
  void check_far();
  struct Pull;
  void pull(int, Pull &) const;
  void find_limit();
};

}    // namespace LAMMPS_NS

#endif
#endif
