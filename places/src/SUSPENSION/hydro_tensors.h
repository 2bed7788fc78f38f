/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Spheres that move each other through a Stokes fluid, as in the force coupling method: M.R. Maxey,
// B.K. Patel, Int. J. Multiphase Flow 27, 1603 (2001); S. Lomholt, M.R. Maxey, J. Comput. Phys.
// 184, 381 (2003). A sphere is the force density F D(y) - C.grad D(y), D being a Gaussian of
// variance s^2; its velocity is the mean of the fluid's with the weight D, and so is its gradient.
// Forces, torques and stresslets are those on the fluid.

#ifndef LMP_HYDRO_TENSORS_H
#define LMP_HYDRO_TENSORS_H

#include "lubcontact_defs.h"
#include "lubcontact_vec3.h"

#include <cmath>

namespace LAMMPS_NS::Hydro_NS {

using Lubcontact_NS::PI;
using Lubcontact_NS::Vec3;

// ---- loads and motions

// in a row for each first index
struct Tensor {
  Vec3 x, y, z;
};

inline Tensor operator+(const Tensor &a, const Tensor &b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Tensor operator*(double s, const Tensor &a)
{
  return {s * a.x, s * a.y, s * a.z};
}

inline Tensor transposed(const Tensor &a)
{
  return {{a.x.x, a.y.x, a.z.x}, {a.x.y, a.y.y, a.z.y}, {a.x.z, a.y.z, a.z.z}};
}

inline Vec3 operator*(const Tensor &a, const Vec3 &b)
{
  return {dot(a.x, b), dot(a.y, b), dot(a.z, b)};
}

inline Tensor outer(const Vec3 &a, const Vec3 &b)
{
  return {a.x * b, a.y * b, a.z * b};
}

inline double contraction(const Tensor &a, const Tensor &b)
{
  return dot(a.x, b.x) + dot(a.y, b.y) + dot(a.z, b.z);
}

// dipole: C_jk, first moment f_j y_k of the force density, without a trace
struct Load {
  Vec3 force;
  Tensor dipole;
};

// gradient: du_j/dx_k
struct Motion {
  Vec3 velocity;
  Tensor gradient;
};

// The 11 numbers of a sphere: force, torque and the symmetric part of its dipole, which is the
// stresslet; velocity, spin and rate of strain. Symmetric tensors have five numbers such that the
// power is the scalar product of a load and a motion.
static constexpr int NUMBERS = 11;

inline void put_strain(const Tensor &e, double *five)
{
  const double r2 = std::sqrt(0.5);
  five[0] = r2 * (e.x.x - e.y.y);
  five[1] = (2.0 * e.z.z - e.x.x - e.y.y) / std::sqrt(6.0);
  five[2] = r2 * (e.x.y + e.y.x);
  five[3] = r2 * (e.x.z + e.z.x);
  five[4] = r2 * (e.y.z + e.z.y);
}

inline Tensor get_strain(const double *five)
{
  const double r2 = std::sqrt(0.5), xy = r2 * five[2], xz = r2 * five[3], yz = r2 * five[4];
  const double a = r2 * five[0], b = five[1] / std::sqrt(6.0);
  return {{a - b, xy, xz}, {xy, -a - b, yz}, {xz, yz, 2.0 * b}};
}

// what turns with the spin w: du_j/dx_k = e_jlk w_l
inline Tensor rotation(const Vec3 &w)
{
  return {{0.0, -w.z, w.y}, {w.z, 0.0, -w.x}, {-w.y, w.x, 0.0}};
}

inline Vec3 spin(const Tensor &gradient)
{
  return {0.5 * (gradient.z.y - gradient.y.z), 0.5 * (gradient.x.z - gradient.z.x),
          0.5 * (gradient.y.x - gradient.x.y)};
}

inline Load get_load(const double *n)
{
  const Vec3 torque = Lubcontact_NS::get_vector(n + 3);
  return {Lubcontact_NS::get_vector(n), get_strain(n + 6) + 0.5 * rotation(torque)};
}

inline void add_motion(const Motion &motion, double *n)
{
  double five[5];
  put_strain(motion.gradient, five);
  Lubcontact_NS::add_vector(motion.velocity, n);
  Lubcontact_NS::add_vector(spin(motion.gradient), n + 3);
  for (int k = 0; k < 5; k++) n[6 + k] += five[k];
}

// ---- radial functions

// 8 pi eta G_ab = delta_ab lap h - d_a d_b h is the response to a Gaussian force. h[n] and p[n] are
// the n-fold derivatives (1/r d/dr)^n of h and lap h; h[0] is not needed.
struct Radial {
  double h[5] = {}, p[5] = {};
};

inline Radial operator-(const Radial &a, const Radial &b)
{
  Radial c;
  for (int n = 0; n < 5; n++) {
    c.h[n] = a.h[n] - b.h[n];
    c.p[n] = a.p[n] - b.p[n];
  }
  return c;
}

// For the sum q of the variances of the Gaussians of both. Far apart from
// lap h = 2 erf(r/sqrt(2q))/r and r^2 h2 + 3 h1 = p, which each derivative continues; near each
// other these differences lose their digits, and the series in z = r^2/2q is used.
inline Radial gaussian_radial(double r, double q)
{
  Radial f;
  const double top = std::sqrt(2.0 / (PI * q)), z = r * r / (2.0 * q);
  if (z < 2.0) {
    double scale = 2.0 * top;
    for (int n = 0; n < 5; n++) {
      double term = n % 2 ? -scale : scale;    // (-1)^k z^(k-n)/(k-n)!
      for (int k = n; k < n + 30; k++) {
        f.p[n] += term / (2 * k + 1);
        if (n < 4) f.h[n + 1] += term / ((2 * k + 1) * (2 * k + 3));
        term *= -z / (k - n + 1);
      }
      scale /= q;
    }
    return f;
  }
  const double r2 = r * r, d = top * std::exp(-z), erf = std::erf(std::sqrt(z));
  f.p[0] = 2.0 * erf / r;
  double tail = 2.0 * d;
  for (int n = 0; n < 4; n++) {
    f.p[n + 1] = (tail - (2 * n + 1) * f.p[n]) / r2;
    tail /= -q;
  }
  f.h[1] = erf / r + q * (d - erf / r) / r2;
  for (int n = 1; n < 4; n++) f.h[n + 1] = (f.p[n - 1] - (2 * n + 1) * f.h[n]) / r2;
  return f;
}

// ---- two spheres

// What the two do to each other, over 8 pi eta: functions of forces (mm), of a dipole on a velocity
// (md), of a force on a gradient (dm), of dipoles (dd).
struct PairResponse {
  Vec3 x;    // from j to i
  double mm_p, mm_h;
  double md_p, md_h, md_hh;    // the first sphere is i
  double dm_p, dm_h, dm_hh;
  double dd_p, dd_h, dd_pp, dd_hh, dd_hhh;
};

inline PairResponse pair_response(const Vec3 &x, const Radial &mm, const Radial &md,
                                  const Radial &dm, const Radial &dd)
{
  return {x,       mm.p[0] - mm.h[1], mm.h[2], md.p[1], md.h[2],           md.h[3], dm.p[1],
          dm.h[2], dm.h[3],           dd.p[1], dd.h[2], dd.p[2] - dd.h[3], dd.h[3], dd.h[4]};
}

// Adds the motion of a sphere at x from the other one: u_a = G_ab F_b - C_bc d_c G_ab and its
// gradient.
inline void add_response(const Vec3 &x, double mm_p, double mm_h, const double *md,
                         const double *dm, const PairResponse &r, double factor, const Load &load,
                         Motion &motion)
{
  const Vec3 &force = load.force;
  const Tensor &c = load.dipole;
  const Tensor ct = transposed(c);
  const Vec3 cx = c * x, ctx = ct * x;
  const double xf = dot(x, force), xcx = dot(x, cx);
  motion.velocity = motion.velocity +
      factor * (mm_p * force + (md[2] * xcx - mm_h * xf) * x - (md[0] - md[1]) * cx + md[1] * ctx);
  const Vec3 of_x =
      (dm[0] - dm[1]) * force + (r.dd_hhh * xcx - dm[2] * xf) * x - r.dd_pp * cx + r.dd_hh * ctx;
  const Vec3 along_x = r.dd_hh * (cx + ctx) - dm[1] * force;
  const double same = r.dd_hh * xcx - dm[1] * xf;
  Tensor g = outer(of_x, x) + outer(x, along_x) + (r.dd_h - r.dd_p) * c + r.dd_h * ct;
  g.x.x += same;
  g.y.y += same;
  g.z.z += same;
  motion.gradient = motion.gradient + factor * g;
}

// for both of the pair; factor: 1/(8 pi eta)
inline void add_pair(const PairResponse &r, double factor, const Load &load_i, const Load &load_j,
                     Motion &motion_i, Motion &motion_j)
{
  const double md[3] = {r.md_p, r.md_h, r.md_hh}, dm[3] = {r.dm_p, r.dm_h, r.dm_hh};
  add_response(r.x, r.mm_p, r.mm_h, md, dm, r, factor, load_j, motion_i);
  add_response(-1.0 * r.x, r.mm_p, r.mm_h, dm, md, r, factor, load_i, motion_j);
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
