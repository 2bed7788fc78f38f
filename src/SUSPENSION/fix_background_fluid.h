/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_BACKGROUND_FLUID_H
#define LMP_FIX_BACKGROUND_FLUID_H

#include "fix.h"

#include <memory>

namespace LAMMPS_NS {

class BackgroundFluid;

// What fix drag/background and fix overdamped/sphere share: a fluid, and what its drag does in all.
class FixBackgroundFluid : public Fix {
 public:
  ~FixBackgroundFluid() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double memory_usage() override;

  const BackgroundFluid &background() const { return *fluid; }
  double drag_force(int d) { return compute_vector(FORCE + d); }    // of all particles, along d
  double drag_torque(int d) { return compute_vector(TORQUE + d); }
  double mean_power() { return compute_vector(MEAN_POWER); }    // dissipated in the last step

 protected:
  // f_ID[1] and so on: see the manual; the first ones are sums over particles
  // clang-format off
  enum { POWER, FORCE, TORQUE = FORCE + 3, NUMBER = TORQUE + 3, NUM_SUMS,
         HINDRANCE = NUM_SUMS, MEAN_POWER, NUM_COLUMNS };
  // clang-format on

  // the word instead of a viscosity that says that another fix has the fluid, if there is one
  FixBackgroundFluid(class LAMMPS *, int, char **, const char *elsewhere = nullptr);
  void check_restart(const char *wrong) const;    // stops if there is something wrong

  std::unique_ptr<BackgroundFluid> fluid;
  double sums[NUM_SUMS];    // of this rank
  double step_power;        // mean of the last step, of this rank
};

}    // namespace LAMMPS_NS

#endif
