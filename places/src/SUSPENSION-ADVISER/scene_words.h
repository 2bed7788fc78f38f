/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Lines of an input script that make a pair law, in the words of its commands.

#ifndef LMP_SCENE_WORDS_H
#define LMP_SCENE_WORDS_H

#include "lubcontact_law.h"

#include <string>

namespace LAMMPS_NS::Scene_NS {

// viscosity: a number or v_name
std::string style_line(const Lubcontact_NS::Law &, const std::string &viscosity);
std::string coeff_lines(const Lubcontact_NS::Law &);    // of all types

}    // namespace LAMMPS_NS::Scene_NS

#endif
