/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Responses to waves of force in a periodic cell: a Stokes fluid moves with u_k = (f_k - k
// (k.f_k)/k^2)/(eta k^2), its mean velocity is left out.

#ifndef LMP_HYDRO_WAVES_H
#define LMP_HYDRO_WAVES_H

#include "hydro_tensors.h"

namespace LAMMPS_NS::Hydro_NS {

// A wave of the cell, k.edge = 2 pi number, and by what it multiplies the parts of a force across
// and along k.
struct WaveVector {
  Vec3 k;
  double square;    // 0: the mean
  int number[3];
};

struct WaveFactors {
  double across, along;
};

inline WaveFactors stokes_factors(const WaveVector &wave, double viscosity)
{
  return {wave.square > 0.0 ? 1.0 / (viscosity * wave.square) : 0.0, 0.0};
}

// Of forces that have become Gaussians of this width, as the velocities will be the means under
// them.
inline WaveFactors gaussian_factors(const WaveVector &wave, double viscosity, double width)
{
  const WaveFactors f = stokes_factors(wave, viscosity);
  const double both = std::exp(-width * width * wave.square);
  return {both * f.across, both * f.along};
}

inline int signed_wave(int m, int n)
{
  return 2 * m < n ? m : m - n;
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
