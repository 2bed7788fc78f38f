/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "scene_words.h"

#include "lubcontact_type_coeffs.h"
#include "scene_laws.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

std::string Scene_NS::style_line(const Lubcontact_NS::Law &law, const std::string &viscosity)
{
  return "  pair_style lubcontact " + style_words(law.settings, viscosity) + "\n";
}

/* ---------------------------------------------------------------------- */

std::string Scene_NS::coeff_lines(const Lubcontact_NS::Law &law)
{
  std::string lines;
  each_pair(law, [&](int i, int j, const Lubcontact_NS::TypeCoeffs &c) {
    const std::string types = law.types > 1 ? fmt::format("{} {}", i, j) : "* *";
    lines += fmt::format("  pair_coeff {} {}\n", types, coeff_words(c));
  });
  return lines;
}
