/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_SCENE_SAMPLER_H
#define LMP_SCENE_SAMPLER_H

#include "lmptype.h"

#include <vector>

namespace LAMMPS_NS {
class Fix;
class SceneInstance;

// collects the parts of stress and power in a copy
class SceneSampler {
 public:
  SceneSampler(const SceneInstance &, const Fix *flow, int every);

  // of these columns, over the steps after from and up to the end
  std::vector<double> mean(bigint from, bigint end, const std::vector<int> &columns) const;

  // columns; rate and phi of fix deform/rheometer, else empty
  std::vector<int> sxy, syy, power, rate, phi;

 private:
  Fix *samples;
  bigint first;    // step of the first sample
  int interval;
};

}    // namespace LAMMPS_NS

#endif
