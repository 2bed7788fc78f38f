/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The sums over all particles that a step takes, as fast as the processor can: velocities to the
// elements, and forces from them.

#ifndef LMP_PORE_SPREAD_H
#define LMP_PORE_SPREAD_H

#include "each_processor.h"
#include "pore_deposit.h"

namespace LAMMPS_NS::Pore_NS {

[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline]] static void
add_motions(const std::vector<Stencil> &stencils, const std::vector<Lanes> &velocities,
            Motion *sums)
{
  for (std::size_t n = 0; n < stencils.size(); n++) add_motion(stencils[n], velocities[n], sums);
}

[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline]] static void
pore_forces(const std::vector<Stencil> &stencils, double element_volume,
            const std::vector<Lanes> &gradients, std::vector<Lanes> &forces)
{
  for (std::size_t n = 0; n < stencils.size(); n++)
    forces[n] = pore_force(stencils[n], element_volume, gradients);
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
