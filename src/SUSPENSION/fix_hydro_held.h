/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the files of fix hydro share: the numbers that it holds of a particle, and the flow there.

#ifndef LMP_FIX_HYDRO_HELD_H
#define LMP_FIX_HYDRO_HELD_H

#include "domain.h"
#include "fluid_flow.h"
#include "hydro_tensors.h"

namespace LAMMPS_NS::Hydro_NS {

// of a particle: load of the last solution and of the one before, velocity and spin of the last one
static constexpr int LOAD = 0, BEFORE = NUMBERS, MOTION = 2 * NUMBERS, NUM_HELD = MOTION + 6;

inline Fluid_NS::Flow flow_at(const Domain *domain, bool deforms, const double *x)
{
  using Lubcontact_NS::get_vector;
  if (!deforms) return {};
  return Fluid_NS::cell_flow(domain->h_rate, domain->h_inv, get_vector(x),
                             get_vector(domain->boxlo), get_vector(domain->h_ratelo));
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
