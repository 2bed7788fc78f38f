/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// From spheres to the points of a grid and back. The grid moves with its cell: its points have
// fixed lamda coordinates, Gaussians the real distances. What is spread to a point and what is
// interpolated from it have the same weights, so that the mobility is symmetric to rounding.

#ifndef LMP_HYDRO_GRID_H
#define LMP_HYDRO_GRID_H

#include "hydro_wide.h"
#include "pore_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace LAMMPS_NS::Hydro_NS {

using Pore_NS::Cell;

// Points of a cell with edges along those of LAMMPS: point (i, j, k) for any integers, of which the
// cell has nx ny nz.
struct Lattice {
  Cell cell;
  int nx = 1, ny = 1, nz = 1;
  double width = 1.0, reach = 4.5;    // of the Gaussian; where it is cut off

  double volume() const { return cell.xprd * cell.yprd * cell.zprd; }
  std::size_t points() const { return static_cast<std::size_t>(nx) * ny * nz; }
  double point_volume() const { return volume() / static_cast<double>(points()); }
};

// A box of points, x fastest, three values each: one array after the other.
struct Brick {
  int low[3] = {0, 0, 0}, size[3] = {0, 0, 0};

  std::size_t points() const { return static_cast<std::size_t>(size[0]) * size[1] * size[2]; }
  std::size_t index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k - low[2]) * size[1] + (j - low[1])) * size[0] + (i - low[0]);
  }
};

// first and last integer within reach of a center, in units of the spacing
struct Span {
  int first, last;
};

inline Span span(double center, double reach)
{
  return {static_cast<int>(std::ceil(center - reach)),
          static_cast<int>(std::floor(center + reach))};
}

// Points of a row along x, and the Gaussian at them.
struct Row {
  int i, j, k;    // the first one
  int number;
  double y, z;    // distance from the center, the same for all
  std::vector<double> x, weight;
};

// Calls f(row) for all rows with points within reach of the center. Two exponentials a row: those
// of its points follow from that of the nearest one to the center.
class Stencil {
 public:
  explicit Stencil(const Lattice &lattice) :
      dx(lattice.cell.xprd / lattice.nx), dy(lattice.cell.yprd / lattice.ny),
      dz(lattice.cell.zprd / lattice.nz), y_to_x(lattice.cell.xy / lattice.ny),
      z_to_x(lattice.cell.xz / lattice.nz), z_to_y(lattice.cell.yz / lattice.nz),
      origin(lattice.cell.origin), reach(lattice.reach),
      half(0.5 / (lattice.width * lattice.width)), norm(std::pow(half / PI, 1.5))
  {
    const int most = static_cast<int>(reach / dx) + 2;
    for (int m = 0; m <= most; m++) steps.push_back(std::exp(-half * m * m * dx * dx));
    row.x.resize(2 * most + 1);
    row.weight.resize(2 * most + 1);
  }

  template <class F> void for_each_row(const Vec3 &center, F &&f)
  {
    const Vec3 c = center - origin;
    const Span layers = span(c.z / dz, reach / dz);
    for (row.k = layers.first; row.k <= layers.last; row.k++) {
      row.z = row.k * dz - c.z;
      const double r2 = reach * reach - row.z * row.z, to_y = row.k * z_to_y - c.y;
      const Span rows = span(-to_y / dy, std::sqrt(r2 > 0.0 ? r2 : 0.0) / dy);
      for (row.j = rows.first; row.j <= rows.last; row.j++) {
        row.y = row.j * dy + to_y;
        const double rest = r2 - row.y * row.y;
        const double to_x = row.j * y_to_x + row.k * z_to_x - c.x;
        const Span points = span(-to_x / dx, std::sqrt(rest > 0.0 ? rest : 0.0) / dx);
        row.i = points.first;
        row.number = points.last - points.first + 1;
        if (row.number > 0) {
          fill(to_x);
          f(static_cast<const Row &>(row));
        }
      }
    }
  }

 private:
  double dx, dy, dz, y_to_x, z_to_x, z_to_y;
  Vec3 origin;
  double reach, half, norm;
  std::vector<double> steps;    // exp(-(m dx)^2/2W^2)
  Row row;

  void fill(double to_x)
  {
    const int nearest = static_cast<int>(std::lround(-to_x / dx)) - row.i;
    const int near = std::max(0, std::min(nearest, row.number - 1));    // but for rounding it is
    const double x0 = (row.i + near) * dx + to_x;
    const double top = norm * std::exp(-half * (x0 * x0 + row.y * row.y + row.z * row.z));
    const double up = std::exp(-2.0 * half * x0 * dx), down = 1.0 / up;
    for (int n = 0; n < row.number; n++) row.x[n] = (row.i + n) * dx + to_x;
    double power = top;
    for (int n = near; n < row.number; n++, power *= up) row.weight[n] = power * steps[n - near];
    power = top * down;
    for (int n = near - 1; n >= 0; n--, power *= down) row.weight[n] = power * steps[near - n];
  }
};

// Along a row the force density is the Gaussian times a polynomial of third degree in x: with
// l = lap D/D = y^2/W^4 - 3/W^2 it is (1 + c_m l) F_j + (1 + c_d l - 2 c_d/W^2) C_jk y_k/W^2.
struct RowWeights {
  double force, force_xx;      // of F: at x = 0, and with x^2
  double dipole, dipole_xx;    // of C_jk y_k

  RowWeights(const Body &body, double width, const Row &row)
  {
    const double u = 1.0 / (width * width);
    const double l = ((row.y * row.y + row.z * row.z) * u - 3.0) * u;
    force = 1.0 + body.c_force * l;
    force_xx = body.c_force * u * u;
    dipole = u * (1.0 + body.c_dipole * (l - 2.0 * u));
    dipole_xx = u * u * u * body.c_dipole;
  }
};

// Adds the force density of a sphere to the points of a brick that holds all of them.
inline void spread(Stencil &stencil, const Lattice &lattice, const Brick &brick, const Vec3 &center,
                   const Body &body, const Load &load, double *field)
{
  const std::size_t points = brick.points();
  stencil.for_each_row(center, [&](const Row &row) {
    const RowWeights w(body, lattice.width, row);
    const double *x = row.x.data(), *weight = row.weight.data();
    const auto add = [&](double force, const Vec3 &c, double *f) {
      const double c0 = c.y * row.y + c.z * row.z;
      const double a0 = force * w.force + c0 * w.dipole, a1 = c.x * w.dipole;
      const double a2 = force * w.force_xx + c0 * w.dipole_xx, a3 = c.x * w.dipole_xx;
      for (int n = 0; n < row.number; n++)
        f[n] += weight[n] * (a0 + x[n] * (a1 + x[n] * (a2 + x[n] * a3)));
    };
    double *f = field + brick.index(row.i, row.j, row.k);
    add(load.force.x, load.dipole.x, f);
    add(load.force.y, load.dipole.y, f + points);
    add(load.force.z, load.dipole.z, f + 2 * points);
  });
}

// Mean velocity and gradient at a sphere of the velocities at the points.
inline Motion interpolate(Stencil &stencil, const Lattice &lattice, const Brick &brick,
                          const Vec3 &center, const Body &body, const double *field)
{
  const std::size_t points = brick.points();
  Motion motion;
  stencil.for_each_row(center, [&](const Row &row) {
    const RowWeights w(body, lattice.width, row);
    const double *x = row.x.data(), *weight = row.weight.data();
    const auto add = [&](const double *u, double &velocity, Vec3 &gradient) {
      double m0 = 0.0, m1 = 0.0, m2 = 0.0, m3 = 0.0;
      for (int n = 0; n < row.number; n++) {
        const double t = weight[n] * u[n], tx = t * x[n], txx = tx * x[n];
        m0 += t;
        m1 += tx;
        m2 += txx;
        m3 += txx * x[n];
      }
      velocity += w.force * m0 + w.force_xx * m2;
      const double even = w.dipole * m0 + w.dipole_xx * m2;
      gradient = gradient + Vec3{w.dipole * m1 + w.dipole_xx * m3, row.y * even, row.z * even};
    };
    const double *u = field + brick.index(row.i, row.j, row.k);
    add(u, motion.velocity.x, motion.gradient.x);
    add(u + points, motion.velocity.y, motion.gradient.y);
    add(u + 2 * points, motion.velocity.z, motion.gradient.z);
  });
  const double volume = lattice.point_volume();
  return {volume * motion.velocity, volume * motion.gradient};
}

// What a brick needs to hold for centers whose lattice coordinates lie between two corners.
inline Vec3 lattice_place(const Lattice &lattice, const Vec3 &point)
{
  const Cell &c = lattice.cell;
  const Vec3 r = point - c.origin;
  const double z = r.z / c.zprd, y = (r.y - z * c.yz) / c.yprd;
  return {(r.x - y * c.xy - z * c.xz) / c.xprd * lattice.nx, y * lattice.ny, z * lattice.nz};
}

// half widths of a stencil in lattice coordinates
inline Vec3 lattice_reach(const Lattice &lattice)
{
  const Cell &c = lattice.cell;
  // gradients of the lamda coordinates
  const Vec3 y{0.0, 1.0 / c.yprd, -c.yz / (c.yprd * c.zprd)};
  const Vec3 x{1.0 / c.xprd, -c.xy / (c.xprd * c.yprd),
               (c.xy * c.yz / c.yprd - c.xz) / (c.xprd * c.zprd)};
  return {lattice.reach * norm(x) * lattice.nx, lattice.reach * norm(y) * lattice.ny,
          lattice.reach / c.zprd * lattice.nz};
}

inline Brick brick_for(const Lattice &lattice, const Vec3 &low, const Vec3 &high)
{
  const Vec3 reach = lattice_reach(lattice);
  const double from[3] = {low.x - reach.x, low.y - reach.y, low.z - reach.z};
  const double to[3] = {high.x + reach.x, high.y + reach.y, high.z + reach.z};
  Brick b;
  for (int d = 0; d < 3; d++) {
    b.low[d] = static_cast<int>(std::floor(from[d]));
    b.size[d] = static_cast<int>(std::ceil(to[d])) - b.low[d] + 1;
  }
  return b;
}

// Points for a spacing: even numbers with small factors only, which transforms like. In a tilted
// cell opposite faces come closer, and waves with them.
inline int good_number(double least)
{
  for (int n = 2;; n += 2) {
    if (n < least) continue;
    int rest = n;
    for (const int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
