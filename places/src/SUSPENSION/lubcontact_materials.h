/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// pair_coeff * * file name1 name2 ...: coefficients of pair style lubcontact from a file of
// materials.

#ifndef LMP_LUBCONTACT_MATERIALS_H
#define LMP_LUBCONTACT_MATERIALS_H

#include "lubcontact_coeffs.h"

#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {
struct Settings;
}

namespace LAMMPS_NS {
class LAMMPS;
class LubcontactTypeCoeffs;

struct TypePair {
  int i, j;
  Lubcontact_NS::TypeCoeffs coeffs;
};

// all words of the command; errors name the word. Prints a table
std::vector<TypePair> read_materials(LAMMPS *, int narg, char **arg, const LubcontactTypeCoeffs &,
                                     const Lubcontact_NS::Settings &);

}    // namespace LAMMPS_NS

#endif
