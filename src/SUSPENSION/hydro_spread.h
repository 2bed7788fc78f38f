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
#include "hydro_grid.h"

namespace LAMMPS_NS::Hydro_NS {

// atoms: of the spheres of the stencils, NUMBERS for each atom
[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline]] static void
spread_all(const Stencils &stencils, const std::vector<int> &atoms, const std::vector<Body> &bodies,
           const double *loads, double *field)
{
  for (std::size_t n = 0; n < atoms.size(); n++)
    spread(stencils, n, bodies[atoms[n]], get_load(loads + atoms[n] * NUMBERS), field);
}

[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline]] static void
interpolate_all(const Stencils &stencils, const std::vector<int> &atoms,
                const std::vector<Body> &bodies, const double *field, double *motions)
{
  for (std::size_t n = 0; n < atoms.size(); n++)
    add_motion(interpolate(stencils, n, bodies[atoms[n]], field), motions + atoms[n] * NUMBERS);
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
