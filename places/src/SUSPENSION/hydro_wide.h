/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Spheres of any radius on one grid: H. Su, E.E. Keaveny, J. Comput. Phys. (2024), fast force
// coupling. The flow of a force is biharmonic, so that (1 + c lap) D_W with c = (s^2 - W^2)/2 has
// the far field of a Gaussian of variance s^2, whatever its width W is. Everything goes to the grid
// with one W; what that misses falls off like a Gaussian and is summed over pairs.

#ifndef LMP_HYDRO_WIDE_H
#define LMP_HYDRO_WIDE_H

#include "hydro_tensors.h"

#include <array>
#include <cmath>

namespace LAMMPS_NS::Hydro_NS {

// Variances of the Gaussians of a sphere, for its force and its dipole: with them it moves as a
// rigid sphere does, alone under a force, a torque, or in a straining flow.
struct Widths {
  double force, dipole;
};

inline Widths widths(double radius)
{
  return {radius * radius / PI, radius * radius / std::cbrt(36.0 * PI)};
}

// The same and the coefficients c on a grid of this width.
struct Body {
  Widths variance;
  double c_force, c_dipole;
};

inline Body make_body(double radius, double width)
{
  const Widths v = widths(radius);
  return {v, 0.5 * (v.force - width * width), 0.5 * (v.dipole - width * width)};
}

// Of two wide Gaussians with coefficients ci and cj: h -> (1 + ci lap)(1 + cj lap) h, p likewise,
// where lap p = -8 pi g, g being the Gaussian of variance q = 2 W^2.
struct WideRadial {
  Radial plain;
  double g[5], lap_g[3];    // derivatives of -8 pi g and -8 pi lap g
};

inline WideRadial wide_radial(double r, double width)
{
  const double q = 2.0 * width * width, r2 = r * r;
  WideRadial w{gaussian_radial(r, q), {}, {}};
  w.g[0] = -8.0 * PI * std::exp(-0.5 * r2 / q) / (2.0 * PI * q * std::sqrt(2.0 * PI * q));
  for (int n = 1; n < 5; n++) w.g[n] = -w.g[n - 1] / q;
  w.lap_g[0] = (r2 / q - 3.0) / q * w.g[0];
  w.lap_g[1] = 2.0 / (q * q) * w.g[0] - w.lap_g[0] / q;
  w.lap_g[2] = 2.0 / (q * q) * w.g[1] - w.lap_g[1] / q;
  return w;
}

inline Radial with_coefficients(const WideRadial &w, double ci, double cj)
{
  Radial f = w.plain;
  for (int n = 1; n < 5; n++) f.h[n] += (ci + cj) * w.plain.p[n] + ci * cj * w.g[n];
  for (int n = 0; n < 3; n++) f.p[n] += (ci + cj) * w.g[n] + ci * cj * w.lap_g[n];
  return f;
}

// What the grid misses of a pair, x from j to i.
inline PairResponse missing_response(const Vec3 &x, const Body &i, const Body &j, double width)
{
  const double r = norm(x);
  const WideRadial wide = wide_radial(r, width);
  const auto missing = [&](double vi, double ci, double vj, double cj) {
    return gaussian_radial(r, vi + vj) - with_coefficients(wide, ci, cj);
  };
  const Widths &vi = i.variance, &vj = j.variance;
  return pair_response(x, missing(vi.force, i.c_force, vj.force, j.c_force),
                       missing(vi.force, i.c_force, vj.dipole, j.c_dipole),
                       missing(vi.dipole, i.c_dipole, vj.force, j.c_force),
                       missing(vi.dipole, i.c_dipole, vj.dipole, j.c_dipole));
}

// Velocity, spin and rate of strain of a sphere alone, per force, torque and stresslet.
struct Self {
  double translation, rotation, strain;
};

inline Self sphere_self(double radius, double viscosity)
{
  const double a3 = radius * radius * radius, unit = 1.0 / (PI * viscosity);
  return {unit / (6.0 * radius), unit / (8.0 * a3), 3.0 * unit / (20.0 * a3)};
}

// That of its wide Gaussian: integrals over all waves of exp(-W^2 k^2) (1 - c k^2)^2.
inline Self wide_self(const Body &body, double width, double viscosity)
{
  const double w2 = width * width, w3 = w2 * width, root = std::sqrt(PI);
  const double m = body.c_force / w2, d = body.c_dipole / w2;
  const double j = root / (4.0 * w3) * (1.0 - 3.0 * d + 3.75 * d * d);
  return {(1.0 - m + 0.75 * m * m) / (6.0 * PI * root * width * viscosity),
          j / (12.0 * PI * PI * viscosity), j / (10.0 * PI * PI * viscosity)};
}

// Adds to 11 numbers of the motion what the grid misses of the sphere itself; or, with that of the
// whole sphere, its motion alone.
inline void add_self(const Self &self, const double *load, double *motion)
{
  for (int n = 0; n < 3; n++) motion[n] += self.translation * load[n];
  for (int n = 3; n < 6; n++) motion[n] += self.rotation * load[n];
  for (int n = 6; n < NUMBERS; n++) motion[n] += self.strain * load[n];
}

inline Self operator-(const Self &a, const Self &b)
{
  return {a.translation - b.translation, a.rotation - b.rotation, a.strain - b.strain};
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
