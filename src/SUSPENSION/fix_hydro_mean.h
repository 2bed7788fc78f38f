/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_HYDRO_MEAN_H
#define LMP_FIX_HYDRO_MEAN_H

#include "fix_hydro_level.h"

namespace LAMMPS_NS {

// The mean flow alone: each sphere has the stresslet of a sphere by itself in the flow of the cell,
// and those with few partners are dragged towards it.
class HydroMean : public HydroLevel {
 public:
  HydroMean(LAMMPS *, Fix *, int narg, char **arg);
  void start() override;
  void set_up() override;
  void new_step() override;
  bool pull(int i, Pull &) const override;
  void stresslet(int i, double *five) const override;
  void sum_stresslets(double *five) const override;
  double stresslet_heat() const override { return rate * cubes(); }
  double mean_stresslet_heat() const override { return 0.5 * (rate_before + rate) * cubes(); }
  double phi() override;

 private:
  double rate = 0.0, rate_before = 0.0;    // heat of the stresslets over cubes()

  double cubes() const;    // of the radii of the particles of this rank, summed up
  double find_rate() const;
};

}    // namespace LAMMPS_NS

#endif
