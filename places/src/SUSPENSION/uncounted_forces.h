/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */
// Forces that LAMMPS' virial has, but not the sums of this package.

#ifndef LMP_UNCOUNTED_FORCES_H
#define LMP_UNCOUNTED_FORCES_H

#include <string>

namespace LAMMPS_NS {
class Compute;
class LAMMPS;

// stops where the sum would mean nothing: constraint forces
void refuse_constraints(LAMMPS *, const std::string &who);

// what else is left out, in words; empty: nothing. With other pair styles than lubcontact or
// without
std::string uncounted_forces(LAMMPS *, bool other_pairs);

// both, for a compute that sums up forces by origin; warns once for all of them
void check_rows(LAMMPS *, const Compute *);
}    // namespace LAMMPS_NS

#endif
