/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Pressure of the pores in a layer that dilates evenly, at the rate e. Darcy's law at the distance
// y from a side that is closed, (k/eta) dp/dy = e y, and p = 0 where it drains:
//   p = -eta e (H^2 - y^2)/(2 k),   of the mean -eta H^2 e/(3 k),   3/2 of it at the closed side
// A layer that drains on both sides is two of half the height. H. Darcy, Les fontaines publiques de
// la ville de Dijon (1856).

#ifndef LMP_PORE_LAYER_H
#define LMP_PORE_LAYER_H

#include "pore_grid.h"

namespace LAMMPS_NS::Pore_NS {

static constexpr double LAYER_PEAK = 1.5;    // largest pressure over its mean

// mean pressure over -e, of a layer that drains on one side
inline double layer_drainage(double viscosity, double height, double permeability)
{
  return viscosity * height * height / (3.0 * permeability);
}

// sides through which fluid passes
inline int outlets(Wall lower, Wall upper)
{
  return (lower == Wall::DRAINED ? 1 : 0) + (upper == Wall::DRAINED ? 1 : 0);
}

// the same between plates; 0 if there is no way out, and nothing can dilate
inline double layer_drainage(double viscosity, double gap, double permeability, Wall lower,
                             Wall upper)
{
  const int n = outlets(lower, upper);
  return n == 0 ? 0.0 : layer_drainage(viscosity, gap / n, permeability);
}

// pressure at a plate over the mean
inline double layer_pressure(Wall plate)
{
  return plate == Wall::DRAINED ? 0.0 : LAYER_PEAK;
}

// Velocity at which fluid leaves through a plate, relative to it.
inline double layer_flux(Wall plate, Wall other, double gap, double dilation)
{
  return plate == Wall::DRAINED ? -dilation * gap / outlets(plate, other) : 0.0;
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
