/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// spread() and interpolate() for many spheres, compiled for the processor.

#ifndef LMP_HYDRO_SPREAD_H
#define LMP_HYDRO_SPREAD_H

#include "each_processor.h"
#include "hydro_spline.h"

#include <vector>

namespace LAMMPS_NS::Hydro_NS {

// a sphere on the grid
struct OnGrid {
  int atom;
  OfLaplacian c;
  Spline spline;
};

// loads and motions of atoms
template <int COMPONENTS>
[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline]] static void
spread_all(const std::vector<OnGrid> &spheres, const LatticeGradients &to, const Brick &brick,
           const Load *loads, double *field)
{
  for (const OnGrid &s : spheres)
    spread<COMPONENTS>(s.spline, to, brick, s.c, loads[s.atom], field);
}

template <int COMPONENTS>
[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline]] static void
interpolate_all(const std::vector<OnGrid> &spheres, const LatticeGradients &to, const Brick &brick,
                const double *field, Motion *motions)
{
  for (const OnGrid &s : spheres) {
    const Motion m = interpolate<COMPONENTS>(s.spline, to, brick, s.c, field);
    Motion &sum = motions[s.atom];
    sum.velocity = sum.velocity + m.velocity;
    sum.gradient = sum.gradient + m.gradient;
  }
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
