/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Permeability of a random array of spheres of radius a at the volume fraction phi:
//   k = 2 a^2/(9 phi K),   K = drag of a sphere over 6 pi eta a U, U the flux per total area.
// Kozeny-Carman with the constant 180, P.C. Carman, Trans. Inst. Chem. Eng. 15, 150 (1937), and its
// form that is right in dilute arrays, too: M.A. van der Hoef, R. Beetstra, J.A.M. Kuipers, J.
// Fluid Mech. 528, 233 (2005).

#ifndef LMP_PORE_CLOSURE_H
#define LMP_PORE_CLOSURE_H

#include "lubcontact_defs.h"
#include "lubcontact_vec3.h"

#include <cmath>

namespace LAMMPS_NS::Pore_NS {

using Lubcontact_NS::larger;
using Lubcontact_NS::PI;
using Lubcontact_NS::smaller;
using Lubcontact_NS::Vec3;

enum class Closure { BEETSTRA, KOZENY, CONSTANT };

static constexpr double PHI_MAX = 0.95;    // spheres that overlap can fill more of an element

struct Permeability {
  Closure closure = Closure::BEETSTRA;
  double constant = 0.0;    // length^2, of Closure::CONSTANT
  double factor = 1.0;      // of all closures
  double phi_min = 0.1;     // more dilute is as permeable as this
};

// K
inline double drag_function(Closure closure, double phi)
{
  const double pores = 1.0 - phi;
  const double kozeny = 10.0 * phi / (pores * pores * pores);
  if (closure == Closure::KOZENY) return kozeny;
  return kozeny + pores * (1.0 + 1.5 * std::sqrt(phi));
}

// length^2
inline double permeability(const Permeability &law, double phi, double radius)
{
  if (law.closure == Closure::CONSTANT) return law.factor * law.constant;
  const double f = smaller(larger(phi, law.phi_min), PHI_MAX);
  return law.factor * 2.0 * radius * radius / (9.0 * f * drag_function(law.closure, f));
}

// sum of R^3 over sum of R^2, from the volume of the spheres and their R^2; 0 without any
inline double sauter_radius(double volume, double squares)
{
  return squares > 0.0 ? 0.75 / PI * volume / squares : 0.0;
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
