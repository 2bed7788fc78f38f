/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// From particles to elements and back. A particle is spread over 3 x 3 x 3 elements by a quadratic
// B-spline w about their centers x_e, reflected at plates: sums of w are 1. The velocity of an
// element,
//   u_e = sum_i W_ei v_i,   W_ei = V_i w_ei/(phi_e V_e) (1 + g.(x_i - <x>)),   g = M^-1 (x_e -
// <x>), with the weighted mean <x> and covariance M of its particles, is exact for velocities that
// are linear in x, since sum_i W_ei = 1 and sum_i W_ei x_i = x_e: moving least squares, P.
// Lancaster, K. Salkauskas, Math. Comp. 37, 141 (1981). All that is in lattice coordinates about
// the center of the element, where periodic images need no care. The forces of a pressure, -sum_e
// V_e W_ei grad p(x_e), are the adjoint.
//
// An element with less than phi_min has no bracket, and phi_min for phi_e: its weights add up to
// less than 1, the rest of the fluid being at rest in the frame of the velocities.

#ifndef LMP_PORE_DEPOSIT_H
#define LMP_PORE_DEPOSIT_H

#include "pore_closure.h"
#include "pore_grid.h"

#include <algorithm>
#include <vector>

namespace LAMMPS_NS::Pore_NS {

static constexpr double FLAT = 0.01;    // least variance that the bracket uses, in spacings^2

// ---- the spline

struct Spline {
  int index[3];
  double weight[3], offset[3];    // offset: of the particle from the center
};

// not a call of the library, which std::floor() is for old processors
inline int floor_of(double x)
{
  const int whole = static_cast<int>(x);
  return x < whole ? whole - 1 : whole;
}

// xi: lattice coordinate; n elements, periodic or reflected at both ends
inline Spline spline(double xi, int n, bool reflected)
{
  Spline s;
  if (!reflected && (xi < 0.0 || xi >= n)) xi -= n * std::floor(xi / n);
  const int middle = floor_of(xi);
  const double d = xi - (middle + 0.5);
  s.weight[0] = 0.5 * (0.5 - d) * (0.5 - d);
  s.weight[1] = 0.75 - d * d;
  s.weight[2] = 0.5 * (0.5 + d) * (0.5 + d);
  for (int m = 0; m < 3; m++) {
    int e = middle + m - 1;
    s.offset[m] = d - (m - 1);
    if (reflected) {
      while (e < 0 || e >= n) e = e < 0 ? -1 - e : 2 * n - 1 - e;
      s.offset[m] = xi - (e + 0.5);
    } else if (e < 0)
      e += n;
    else if (e >= n)
      e -= n;
    s.index[m] = e;
  }
  return s;
}

// Part of a sphere that lies above a plane, its center at the height y.
inline double part_above(double y, double radius)
{
  const double s = y / radius;
  if (s >= 1.0) return 1.0;
  return s <= -1.0 ? 0.0 : 0.25 * (2.0 + s * (3.0 - s * s));
}

// Part of a sphere that is in the fluid of the grid: particles of a plate may stick out of it.
inline double part_inside(const Grid &grid, double y, double radius)
{
  if (!grid.has_plates()) return 1.0;
  const double from_lower = y - grid.cell.origin.y;
  return part_above(from_lower, radius) * part_above(grid.cell.yprd - from_lower, radius);
}

// The elements of a particle: those of three columns along x in nine rows.
struct Reached {
  Spline x, y, z;
  int row[9];

  int element(int r, int a) const { return row[r] + x.index[a]; }
};

inline Reached reached(const Grid &grid, const Metric &m, const Vec3 &x)
{
  const Vec3 xi = lattice(grid, m, x);
  Reached r{spline(xi.x, grid.nx, false),
            spline(xi.y, grid.ny, grid.has_plates()),
            spline(xi.z, grid.nz, false),
            {}};
  for (int n = 0; n < 9; n++) r.row[n] = (r.y.index[n / 3] * grid.nz + r.z.index[n % 3]) * grid.nx;
  return r;
}

// ---- first sum over particles: what they fill

// Doubles only, to be summed over the ranks as such: of the volumes V w, of R^2 w, of V w times the
// offset and its products.
struct Moments {
  double volume = 0.0, squares = 0.0;
  Vec3 first;
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;
};
static constexpr int MOMENTS = 11;
static_assert(sizeof(Moments) == MOMENTS * sizeof(double), "summed over ranks as an array");

// volume: of the particle, or of the part that is inside
inline void add_moments(const Grid &grid, const Metric &m, const Vec3 &x, double volume,
                        double square, Moments *sums)
{
  const Reached at = reached(grid, m, x);
  for (int r = 0; r < 9; r++) {
    const int b = r / 3, c = r % 3;
    const double w = at.y.weight[b] * at.z.weight[c], v = volume * w, s = square * w;
    const double y = at.y.offset[b], z = at.z.offset[c];
    const double vy = v * y, vz = v * z, vyy = vy * y, vzz = vz * z, vyz = vy * z;
    Moments *row = sums + at.row[r];
    for (int a = 0; a < 3; a++) {
      Moments &sum = row[at.x.index[a]];
      const double one = at.x.weight[a], first = one * at.x.offset[a];
      sum.volume += one * v;
      sum.squares += one * s;
      sum.first.x += first * v;
      sum.first.y += one * vy;
      sum.first.z += one * vz;
      sum.xx += first * at.x.offset[a] * v;
      sum.yy += one * vyy;
      sum.zz += one * vzz;
      sum.xy += first * vy;
      sum.xz += first * vz;
      sum.yz += one * vyz;
    }
  }
}

// ---- elements

struct Symmetric {
  double xx, yy, zz, xy, xz, yz;
};

// M^-1 a of a symmetric matrix without its eigenvalues below the least: Jacobi's rotations.
inline Vec3 pseudo_solve(const Symmetric &s, const Vec3 &a, double least)
{
  double m[3][3] = {{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}};
  double v[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  for (int turn = 0; turn < 60; turn++) {
    const double xy = std::fabs(m[0][1]), xz = std::fabs(m[0][2]), yz = std::fabs(m[1][2]);
    const int p = yz > xy && yz > xz ? 1 : 0, q = p == 0 && xy >= xz ? 1 : 2;
    if (std::fabs(m[p][q]) <=
        1e-17 * (std::fabs(m[0][0]) + std::fabs(m[1][1]) + std::fabs(m[2][2])))
      break;
    const double theta = 0.5 * (m[q][q] - m[p][p]) / m[p][q];
    const double t =
        std::copysign(1.0, theta) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
    const double c = 1.0 / std::sqrt(t * t + 1.0), sn = t * c;
    for (auto &row : m) {
      const double mp = row[p], mq = row[q];
      row[p] = c * mp - sn * mq;
      row[q] = sn * mp + c * mq;
    }
    for (int k = 0; k < 3; k++) {
      const double mp = m[p][k], mq = m[q][k];
      m[p][k] = c * mp - sn * mq;
      m[q][k] = sn * mp + c * mq;
      const double vp = v[k][p], vq = v[k][q];
      v[k][p] = c * vp - sn * vq;
      v[k][q] = sn * vp + c * vq;
    }
  }
  Vec3 sum;
  for (int k = 0; k < 3; k++)
    if (m[k][k] >= least) {
      const Vec3 axis{v[0][k], v[1][k], v[2][k]};
      sum = sum + (dot(axis, a) / m[k][k]) * axis;
    }
  return sum;
}

// M^-1 a, in full where all eigenvalues are above the least
inline Vec3 bounded_solve(const Symmetric &s, const Vec3 &a, double least)
{
  const double xx = s.xx - least, yy = s.yy - least, zz = s.zz - least;
  const double minor = xx * yy - s.xy * s.xy;
  const double all = zz * minor - xx * s.yz * s.yz - yy * s.xz * s.xz + 2.0 * s.xy * s.xz * s.yz;
  if (!(xx > 0.0 && minor > 0.0 && all > 0.0)) return pseudo_solve(s, a, least);
  const Vec3 r0{s.xx, s.xy, s.xz}, r1{s.xy, s.yy, s.yz}, r2{s.xz, s.yz, s.zz};
  const Vec3 c0 = cross(r1, r2);
  return (1.0 / dot(r0, c0)) * (a.x * c0 + a.y * cross(r2, r0) + a.z * cross(r0, r1));
}

struct Element {
  double phi = 0.0, radius = 0.0, permeability = 0.0;
  double constant = 0.0;    // of the weights, W = V w (constant + slope.offset): what the bracket
  Vec3 slope;               // over phi_e V_e is
};

// Radii are Sauter's. An element with less than phi_min is filled up with the mean of all
// particles, so that its permeability does not jump when the last particle leaves.
inline std::vector<Element> make_elements(const Grid &grid, const Permeability &law,
                                          const std::vector<Moments> &sums)
{
  double volume = 0.0, squares = 0.0;
  for (const Moments &s : sums) {
    volume += s.volume;
    squares += s.squares;
  }
  const double squares_of_volume = volume > 0.0 ? squares / volume : 0.0;
  const double element_volume = grid.element_volume(), least = law.phi_min * element_volume;
  std::vector<Element> elements(sums.size());
  for (std::size_t e = 0; e < sums.size(); e++) {
    const Moments &s = sums[e];
    Element &one = elements[e];
    const double fill = larger(least - s.volume, 0.0);
    one.phi = s.volume / element_volume;
    one.radius = sauter_radius(s.volume + fill, s.squares + fill * squares_of_volume);
    one.permeability = permeability(law, one.phi, one.radius);
    const double f = 1.0 / larger(s.volume, least);
    one.constant = f;
    if (!(s.volume > least)) continue;
    const Vec3 a = f * s.first;
    const Symmetric m{f * s.xx - a.x * a.x, f * s.yy - a.y * a.y, f * s.zz - a.z * a.z,
                      f * s.xy - a.x * a.y, f * s.xz - a.x * a.z, f * s.yz - a.y * a.z};
    const Vec3 slope = bounded_solve(m, -1.0 * a, FLAT);
    one.constant = f * (1.0 - dot(slope, a));
    one.slope = f * slope;
  }
  return elements;
}

// ---- second sum over particles: how they move

// The weights W_ei of a particle; an element that it reaches around the cell occurs once per image.
// They are in lattice coordinates and stay if the cell deforms with all that is in it.
struct Stencil {
  double weight[9][3];
  int row[9], column[3];

  int element(int r, int a) const { return row[r] + column[a]; }
};

inline Stencil make_stencil(const Grid &grid, const Metric &m, const std::vector<Element> &elements,
                            const Vec3 &x, double volume)
{
  const Reached at = reached(grid, m, x);
  Stencil s;
  std::copy_n(at.row, 9, s.row);
  std::copy_n(at.x.index, 3, s.column);
  for (int r = 0; r < 9; r++) {
    const double y = at.y.offset[r / 3], z = at.z.offset[r % 3];
    const double w = volume * at.y.weight[r / 3] * at.z.weight[r % 3];
    const Element *row = elements.data() + s.row[r];
    for (int a = 0; a < 3; a++) {
      const Element &one = row[s.column[a]];
      s.weight[r][a] = w * at.x.weight[a] * (one.constant + dot(one.slope, {at.x.offset[a], y, z}));
    }
  }
  return s;
}

// Three numbers where processors have room for four.
struct alignas(4 * sizeof(double)) Lanes : Vec3 {
  double fourth = 0.0;
};

// a += w b
inline void add_to(Lanes &a, double w, const Lanes &b)
{
  a.x += w * b.x;
  a.y += w * b.y;
  a.z += w * b.z;
  a.fourth += w * b.fourth;
}

// Doubles only, to be summed over the ranks as such.
struct Motion {
  Lanes velocity;    // u_e
};
static constexpr int MOTIONS = 4;
static_assert(sizeof(Motion) == MOTIONS * sizeof(double), "summed over ranks as an array");

inline void add_motion(const Stencil &s, const Lanes &velocity, Motion *sums)
{
  for (int r = 0; r < 9; r++) {
    Motion *row = sums + s.row[r];
    for (int a = 0; a < 3; a++) add_to(row[s.column[a]].velocity, s.weight[r][a], velocity);
  }
}

// Added to b_e, 1/density: sum_i |W_ei|/m_i sum_e' |W_e'i| V_e'. inverse_mass is 0 if no force
// moves the particle.
inline void add_bound(const Stencil &s, double inverse_mass, double element_volume, double *sums)
{
  double reach = 0.0;
  for (const auto &row : s.weight)
    for (double w : row) reach += std::fabs(w);
  const double bound = inverse_mass * element_volume * reach;
  for (int r = 0; r < 9; r++)
    for (int a = 0; a < 3; a++) sums[s.element(r, a)] += std::fabs(s.weight[r][a]) * bound;
}

// Force on the particle, from the gradients of the pressure at the centers of the elements.
inline Lanes pore_force(const Stencil &s, double element_volume,
                        const std::vector<Lanes> &gradients)
{
  Lanes sum, force;
  for (int r = 0; r < 9; r++) {
    const Lanes *row = gradients.data() + s.row[r];
    for (int a = 0; a < 3; a++) add_to(sum, s.weight[r][a], row[s.column[a]]);
  }
  add_to(force, -element_volume, sum);
  return force;
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
