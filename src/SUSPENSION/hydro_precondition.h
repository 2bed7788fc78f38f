/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// An approximate inverse of the mobility, for conjugate gradients. The mobility D of spheres alone
// misses two things, in units of D:
// - Forces across a wave vector k move all the fluid with them: 1 + X, X = sum 6 pi a/(V k^2),
//   which grows with the cell. The inverse is the screening of H.C. Brinkman, Appl. Sci. Res. A 1,
//   27 (1947).
// - Forces along k push the spheres through the back flow of the others: s(k) < 1.
// With B that spreads loads to a grid, and the parts T and L of its waves across and along k,
//   P^-1 = D^-1 + D^-1 B (w_T T + w_L L) B^T D^-1,
//   w_T = -X/(1 + X)/sum 6 pi eta a,   w_L = (1/s - 1)/sum 6 pi eta a.
// That is symmetric, and positive if all the waves in T have no more of a load than there is of it:
// they are longer than the distance of the spheres, and where spheres are denser than in the mean
// of the cell each of them counts less.

#ifndef LMP_HYDRO_PRECONDITION_H
#define LMP_HYDRO_PRECONDITION_H

#include "hydro_waves.h"
#include "hydro_wide.h"

#include <algorithm>
#include <cmath>

namespace LAMMPS_NS::Hydro_NS {

static constexpr double COARSE_SPACING = 1.25;     // of the grid, in mean radii
static constexpr int COARSE_POINTS = 4;            // of its splines, in each direction
static constexpr double COARSE_STRESSLET = 0.4;    // weight of stresslets on the grid

// w_T and w_L over 1/sum 6 pi eta a, fitted to random dispersions of equal spheres with volume
// fractions of 0.02 to 0.5. k times the mean radius.
struct Screening {
  double phi = 0.0;

  double shortest() const { return 0.8 * std::cbrt(2.0 * phi); }    // in T, about

  WaveFactors factors(double k) const
  {
    const double back_flow = std::expm1(5.5 * std::min(phi, 0.6));    // of the longest waves
    if (k == 0.0) return {back_flow, 0.0};                            // not in the mobility
    const double k2 = k * k, of_t = k / shortest(), of_l = k / 2.5;
    // torques and stresslets move the fluid, too
    const double all = 1.0 + (1.0 / 3.0 + 5.0 / 9.0 * COARSE_STRESSLET * COARSE_STRESSLET) * k2;
    const double x = 4.5 * phi * all / k2;
    return {-x / ((1.0 + x) * all) * std::exp(-of_t * of_t * of_t * of_t),
            back_flow / (1.0 + k2 / 0.64) * std::exp(-of_l * of_l * of_l * of_l)};
  }

  // of the density about a sphere
  double smoothing(double k) const { return std::exp(-k * k / (shortest() * shortest())); }
};

// Spheres alone: the resistance D^-1.
inline void add_resistance(const Self &self, const double *motion, double *load)
{
  add_self({1.0 / self.translation, 1.0 / self.rotation, 1.0 / self.strain}, motion, load);
}

// Loads as the grid gets them, or what comes back from it.
inline void weigh_coarse(double weight, double *load)
{
  for (int n = 0; n < 6; n++) load[n] *= weight;
  for (int n = 6; n < NUMBERS; n++) load[n] *= weight * COARSE_STRESSLET;
}

// of a sphere with this density about it, over the mean
inline double coarse_weight(double density)
{
  return 1.0 / std::sqrt(std::max(1.0, density));
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
