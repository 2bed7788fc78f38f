/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Pressure and stress fluctuate with the few contacts of a cell: means over the last unit of
// strain, and standard deviations of the values that they are made of. Both are weighted by time.
// The sums are kept in blocks of a tenth of a unit of strain, the oldest of which is dropped when
// another one is full: what is averaged spans between 1 and 1.1.

#ifndef LMP_RHEOMETER_MEAN_H
#define LMP_RHEOMETER_MEAN_H

#include <algorithm>
#include <cmath>

namespace LAMMPS_NS::Rheometer_NS {

enum Averaged { PRESSURE_MEAN, STRESS_MEAN, NUM_AVERAGED };

// sums over a part of the strain
struct StrainBlock {
  double strain = 0.0, time = 0.0;
  double sum[NUM_AVERAGED] = {}, squares[NUM_AVERAGED] = {};
};

static constexpr int MEAN_BLOCKS = 10;    // of a unit of strain

// Numbers only: restart files hold it as it is. First the block of now, then older ones.
struct StrainMeans {
  StrainBlock block[1 + MEAN_BLOCKS];
};

// the values have held for dt, in which the strain was d_strain
inline void add(StrainMeans &means, double pressure, double stress, double d_strain, double dt)
{
  StrainBlock *block = means.block;
  if (block->strain >= 1.0 / MEAN_BLOCKS) {
    std::copy_backward(block, block + MEAN_BLOCKS, block + MEAN_BLOCKS + 1);
    *block = {};
  }
  block->strain += std::fabs(d_strain);
  block->time += dt;
  const double values[NUM_AVERAGED] = {pressure, stress};
  for (int n = 0; n < NUM_AVERAGED; n++) {
    block->sum[n] += values[n] * dt;
    block->squares[n] += values[n] * values[n] * dt;
  }
}

// over blocks [from, to)
inline StrainBlock total(const StrainMeans &means, int from = 0, int to = MEAN_BLOCKS + 1)
{
  StrainBlock all;
  for (int m = from; m < to; m++) {
    const StrainBlock &block = means.block[m];
    all.strain += block.strain;
    all.time += block.time;
    for (int n = 0; n < NUM_AVERAGED; n++) {
      all.sum[n] += block.sum[n];
      all.squares[n] += block.squares[n];
    }
  }
  return all;
}

// otherwise: before anything was added
inline double mean(const StrainBlock &all, Averaged n, double otherwise)
{
  return all.time > 0.0 ? all.sum[n] / all.time : otherwise;
}

inline double deviation(const StrainBlock &all, Averaged n)
{
  if (!(all.time > 0.0)) return 0.0;
  const double mean = all.sum[n] / all.time;
  return std::sqrt(std::max(all.squares[n] / all.time - mean * mean, 0.0));
}

// outputs of a rheometer: means, deviations, and the strain that they span
static constexpr int MEAN_OUTPUTS = 5;

inline double mean_output(const StrainMeans &means, int n, double pressure, double stress)
{
  const StrainBlock all = total(means);
  const double values[MEAN_OUTPUTS] = {
      mean(all, PRESSURE_MEAN, pressure), mean(all, STRESS_MEAN, stress),
      deviation(all, PRESSURE_MEAN), deviation(all, STRESS_MEAN), all.strain};
  return values[n];
}

}    // namespace LAMMPS_NS::Rheometer_NS

#endif
