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

#include "fix_background_fluid.h"

namespace LAMMPS_NS {

class FixDragBackground : public FixBackgroundFluid {
 public:
  FixDragBackground(class LAMMPS *, int, char **);
  ~FixDragBackground() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 protected:
  std::unique_ptr<class SpinInertia> inertia;
  double power;     // from the particles to the fluid, of this rank
  double energy;    // and its integral

  // further columns: what the drag does to particles that are not isolated
  // clang-format off
  enum { OTHERS = NUM_COLUMNS, NUM_OTHERS = OTHERS + 3, NUM_ALL };
  // clang-format on
  double others[NUM_ALL - OTHERS];    // of this rank

  void check_order();
  void drag_all(bool);
};

}    // namespace LAMMPS_NS

#endif
#endif
