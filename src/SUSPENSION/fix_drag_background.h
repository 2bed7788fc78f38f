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
#include "spin_inertia.h"

#include <memory>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class BackgroundFluid;

class FixDragBackground : public Fix {
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
  double memory_usage() override;
  const BackgroundFluid &background() const { return *fluid; }

 protected:
  enum { POWER, FORCE, TORQUE = FORCE + 3, NUMBER = TORQUE + 3, NUM_SUMS };

  std::unique_ptr<BackgroundFluid> fluid;
  SpinInertia inertia;
  double sums[NUM_SUMS];    // of this rank: see the manual
  double mean_power;        // dissipated in the last step, of this rank
  double power;             // from the particles to the fluid, of this rank
  double energy;            // and its integral

  void check_order();
  void drag_all(bool);
};

}    // namespace LAMMPS_NS

#endif
#endif
