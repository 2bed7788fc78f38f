/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(drag/background,FixDragBackground);
// clang-format on
#else

#ifndef LMP_FIX_DRAG_BACKGROUND_H
#define LMP_FIX_DRAG_BACKGROUND_H

#include "fix.h"

namespace LAMMPS_NS {

class FixDragBackground : public Fix {
 public:
  FixDragBackground(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;

 protected:
  double eta;     // viscosity of the fluid
  double rate;    // of the background shear, vx = rate*y
};

}    // namespace LAMMPS_NS

#endif
#endif
