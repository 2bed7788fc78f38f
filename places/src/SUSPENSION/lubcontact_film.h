/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Resistances of the film between two spheres, leading order in the gap, per pair.
// Squeeze, shear: N.A. Frankel, A. Acrivos, Chem. Eng. Sci. 22, 847 (1967); R.C. Ball,
// J.R. Melrose, Physica A 247, 444 (1997). Roll: D.J. Jeffrey, Y. Onishi, J. Fluid Mech. 139,
// 261 (1984), (Y^C11 - Y^C12)/2 of equal spheres; see doc/src/lubcontact_model.rst.
//
// u_a and ln_u = ln(u_a) are both arguments: u_a may underflow where ln_u does not.

#ifndef LUBCONTACT_FILM_H
#define LUBCONTACT_FILM_H

#include "lubcontact_defs.h"
#include "lubcontact_polynomial.h"
#include "lubcontact_residual.h"
#include "lubcontact_strain.h"

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

// Which pairs are lubricated, and how it ends: CUT un_a < reach_a, forces as they are;
// SHIFTED: minus their resistance at the end of the range, where they vanish; VORONOI: CUT, but
// only pairs that share a face of the tessellation; RESIDUAL: CUT, what is left beside a far field.
enum class Range { CUT, SHIFTED, VORONOI, RESIDUAL };

inline constexpr const char *RANGE_NAME[] = {"cut", "shifted", "voronoi", "residual"};

// Measured to be the best for its cost at volume fractions of 0.40 to 0.54: tests/validation/range.
static constexpr Range DEFAULT_RANGE = Range::CUT;
static constexpr double DEFAULT_REACH_A = 0.5;

struct Film {
  double viscosity;     // of the fluid, pressure*time
  double reach_a;       // lubricated pairs have un_a < reach_a
  double shift;         // SHIFTED: 1/reach_a; CUT: 0
  double shear_end;     // SHIFTED: shear_shape() at reach_a; CUT: 0
  double roll_end;      // SHIFTED: roll_shape() at reach_a; CUT: 0
  double twist_end;     // SHIFTED: min(0, ln reach_a); CUT: 0
  double roll_coeff;    // coefficient of the rolling torque, 3/5 asymptotically
  bool residual = false;
  Strain strain{};    // RESIDUAL: of the flow
};

// Squeeze: F = nu a^2 (du/dt)/u with nu = (3/2) pi eta, pressure*time.
LUBCONTACT_FN inline double squeeze_coeff(double viscosity)
{
  return 1.5 * PI * viscosity;
}

// Shear over pi eta a:  [ (2+u) ln((2+u)/u) - 2 ] / 2,  u = u_a here and below.
LUBCONTACT_FN inline double shear_shape(double u_a, double ln_u)
{
  return 0.5 * (2.0 + u_a) * (logarithm(2.0 + u_a) - ln_u) - 1.0;
}

// Rolling over pi eta a^3:  (c + (63/125) u) ln(1/u), c = 3/5. Zero beyond u = 1, where the
// logarithm changes sign and the torque would pump energy.
LUBCONTACT_FN inline double roll_shape(double coeff, double u_a, double ln_u)
{
  return (coeff + 0.504 * u_a) * larger(0.0, -ln_u);
}

// Force/velocity resisting the relative tangential velocity of the surfaces.
LUBCONTACT_FN inline double shear_resistance(const Film &f, double a, double u_a, double ln_u)
{
  return PI * f.viscosity * a * larger(0.0, shear_shape(u_a, ln_u) - f.shear_end);
}

// Torque/angular velocity resisting the relative rolling.
LUBCONTACT_FN inline double roll_resistance(const Film &f, double a, double u_a, double ln_u)
{
  return PI * f.viscosity * a * a * a *
      larger(0.0, roll_shape(f.roll_coeff, u_a, ln_u) - f.roll_end);
}

// Torque/angular velocity resisting the relative twist: pi eta a^3 u ln(1/u) below u = 1. As
// u ln(1/u) is not monotone, SHIFTED shifts the logarithm.
LUBCONTACT_FN inline double twist_resistance(const Film &f, double a, double u_a, double ln_u)
{
  return PI * f.viscosity * a * a * a * u_a * larger(0.0, f.twist_end - ln_u);
}

LUBCONTACT_FN inline Film make_film(double viscosity, double reach_a, Range rule, double roll_coeff)
{
  Film f{viscosity, reach_a, 0.0, 0.0, 0.0, 0.0, roll_coeff};
  f.residual = rule == Range::RESIDUAL;
  if (rule == Range::SHIFTED) {
    const double ln_reach = std::log(reach_a);
    f.shift = 1.0 / reach_a;
    f.shear_end = shear_shape(reach_a, ln_reach);
    f.roll_end = roll_shape(roll_coeff, reach_a, ln_reach);
    f.twist_end = smaller(ln_reach, 0.0);
  }
  return f;
}

// RESIDUAL: all of them at the gap u_a.
LUBCONTACT_FN inline TangentialResidual residual_films(const Film &f, double a, double delta,
                                                       const ResidualPlace &place)
{
  TangentialResidual t = tangential_residual(f.viscosity, a, delta, place);
  t.shear = larger(0.0, t.shear - f.shear_end);
  t.roll = larger(0.0, t.roll - f.roll_end);
  t.twist = select(f.twist_end < 0.0, 0.0, t.twist);
  return t;
}

// The same without the films that are off.
LUBCONTACT_FN inline Film without_films(Film f, bool shear, bool roll, bool twist)
{
  if (!shear) f.shear_end = HUGE_VAL;
  if (!roll) f.roll_end = HUGE_VAL;
  if (!twist) f.twist_end = -HUGE_VAL;
  return f;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
