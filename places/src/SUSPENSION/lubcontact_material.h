/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// From properties of the solid, as measured, to the coefficients of two spheres.
// Springs: in series, k = E a for equal spheres, as in Yade (V. Smilauer et al., Yade
// Documentation, DEM formulation); or Hertz' secant at a load, K.L. Johnson, Contact Mechanics
// (1985), chapter 4.
// Tangential: R.D. Mindlin, J. Appl. Mech. 16, 259 (1949), 2 (1 - nu)/(2 - nu) of equal solids.

#ifndef LUBCONTACT_MATERIAL_H
#define LUBCONTACT_MATERIAL_H

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

// The solid of a sphere, and its size.
struct Elastic {
  double modulus;    // Young's modulus, pressure
  double poisson;    // Poisson's ratio, -1 < nu <= 1/2
  double radius;     // length
};

struct Springs {
  double g, kt;    // force/length
};

// SI value of one unit of LAMMPS, from those of mass, length and time.
struct UnitScale {
  double mass, length, time;

  double force() const { return mass * length / (time * time); }
  double pressure() const { return mass / (length * time * time); }
  double density() const { return mass / (length * length * length); }
};

// E* of Hertz:  1/E* = sum (1 - nu^2)/E
inline double plane_modulus(const Elastic &i, const Elastic &j)
{
  return 1.0 /
      ((1.0 - i.poisson * i.poisson) / i.modulus + (1.0 - j.poisson * j.poisson) / j.modulus);
}

// Tangential over normal stiffness, 4 G*/E* with 1/G* = sum 2 (2 - nu)(1 + nu)/E.
inline double mindlin_ratio(const Elastic &i, const Elastic &j)
{
  auto softness = [](const Elastic &s) {
    return 2.0 * (2.0 - s.poisson) * (1.0 + s.poisson) / s.modulus;
  };
  return 4.0 / (softness(i) + softness(j)) / plane_modulus(i, j);
}

// Springs 2 E R in series: g = E a for equal solids, a = 2 R_i R_j/(R_i + R_j).
inline double series_stiffness(const Elastic &i, const Elastic &j)
{
  const double ki = i.modulus * i.radius, kj = j.modulus * j.radius;
  return 2.0 * ki * kj / (ki + kj);
}

// F/overlap of Hertz' law F = (4/3) E* sqrt(R*) overlap^(3/2), 1/R* = 1/R_i + 1/R_j.
inline double hertz_secant(const Elastic &i, const Elastic &j, double load)
{
  const double curvature = 1.0 / i.radius + 1.0 / j.radius;
  const double law = 4.0 / 3.0 * plane_modulus(i, j) / std::sqrt(curvature);
  return std::cbrt(law * law * load);
}

// load = 0: springs in series; otherwise Hertz' secant at this normal force.
inline Springs springs(const Elastic &i, const Elastic &j, double load)
{
  const double g = load > 0.0 ? hertz_secant(i, j, load) : series_stiffness(i, j);
  return {g, g * mindlin_ratio(i, j)};
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
