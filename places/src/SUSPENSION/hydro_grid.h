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
#include <array>
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
  // as floor() and ceil(), which are calls on older processors
  const double low = center - reach, high = center + reach;
  const int first = static_cast<int>(low), last = static_cast<int>(high);
  return {first + (first < low), last - (last > high)};
}

// Points of a line along x within reach: x^m exp(-x^2/2W^2) for m = 0 to 3 at each of them, as
// columns to add to, and as rows to sum up.
struct Line {
  int first = 0, number = 0;
  double y = 0.0, gauss = 0.0;    // distance of the line along y, exp(-y^2/2W^2)
  std::vector<double> column[4];
  std::vector<std::array<double, 4>> row;
};

// What a layer cuts out of a line: its points and their Gaussians, but for a factor.
struct Row {
  int i, j, k;    // the first one
  int number;
  double y, z;    // distance from the center, the same for all
  double factor;
  const double *column[4];
  const std::array<double, 4> *row;
};

// Calls f(row) for all rows with points within reach of the center. In a cell that is leaned along
// x only, all layers have the same lines.
class Stencil {
 public:
  explicit Stencil(const Lattice &lattice) :
      dx(lattice.cell.xprd / lattice.nx), per_dx(1.0 / dx), dy(lattice.cell.yprd / lattice.ny),
      dz(lattice.cell.zprd / lattice.nz), y_to_x(lattice.cell.xy / lattice.ny),
      z_to_x(lattice.cell.xz / lattice.nz), z_to_y(lattice.cell.yz / lattice.nz),
      origin(lattice.cell.origin), reach(lattice.reach),
      half(0.5 / (lattice.width * lattice.width)), norm(std::pow(half / PI, 1.5))
  {
    const int most = static_cast<int>(reach / dx) + 2;
    for (int m = 0; m <= most; m++) steps.push_back(std::exp(-half * m * m * dx * dx));
    lines.resize(2 * (static_cast<std::size_t>(reach / dy) + 2));
    for (Line &line : lines) {
      for (auto &column : line.column) column.resize(2 * most + 1);
      line.row.resize(2 * most + 1);
    }
  }

  template <class F> void for_each_row(const Vec3 &center, F &&f)
  {
    const Vec3 c = center - origin;
    const bool upright = z_to_x == 0.0 && z_to_y == 0.0;
    const Span all = span(c.y / dy, reach / dy);
    if (upright)
      for (int j = all.first; j <= all.last; j++)
        fill(lines[j - all.first], j * dy - c.y, j * y_to_x - c.x, reach * reach);

    const Span layers = span(c.z / dz, reach / dz);
    for (int k = layers.first; k <= layers.last; k++) {
      const double z = k * dz - c.z, r2 = reach * reach - z * z;
      const double of_layer = norm * std::exp(-half * z * z), to_y = k * z_to_y - c.y;
      const Span rows = span(-to_y / dy, root(r2) / dy);
      for (int j = rows.first; j <= rows.last; j++) {
        const double to_x = j * y_to_x + k * z_to_x - c.x;
        Line &line = lines[upright ? j - all.first : 0];
        if (!upright) fill(line, j * dy + to_y, to_x, r2);
        const Span points = span(-to_x * per_dx, root(r2 - line.y * line.y) * per_dx);
        const int from = std::max(points.first, line.first) - line.first;
        const int number = std::min(points.last - line.first + 1, line.number) - from;
        if (number <= 0) continue;
        f(Row{line.first + from,
              j,
              k,
              number,
              line.y,
              z,
              of_layer * line.gauss,
              {&line.column[0][from], &line.column[1][from], &line.column[2][from],
               &line.column[3][from]},
              &line.row[from]});
      }
    }
  }

 private:
  double dx, per_dx, dy, dz, y_to_x, z_to_x, z_to_y;
  Vec3 origin;
  double reach, half, norm;
  std::vector<double> steps;    // exp(-(m dx)^2/2W^2)
  std::vector<Line> lines;

  static double root(double square) { return std::sqrt(square > 0.0 ? square : 0.0); }

  // Two exponentials a line: those of its points follow from that of the nearest one to the center.
  void fill(Line &line, double y, double to_x, double r2) const
  {
    line.y = y;
    line.gauss = std::exp(-half * y * y);
    const Span points = span(-to_x / dx, root(r2 - y * y) / dx);
    line.first = points.first;
    line.number = points.last - points.first + 1;
    if (line.number <= 0) return;
    const int nearest = static_cast<int>(std::lround(-to_x / dx)) - points.first;
    const int near = std::max(0, std::min(nearest, line.number - 1));    // but for rounding it is
    const double x0 = (points.first + near) * dx + to_x;
    const double top = std::exp(-half * x0 * x0);
    const double up = std::exp(-2.0 * half * x0 * dx), down = 1.0 / up;
    double power = top;
    const auto put = [&](int n, double weight) {
      const double x = (points.first + n) * dx + to_x;
      for (int m = 0; m < 4; m++, weight *= x) line.column[m][n] = line.row[n][m] = weight;
    };
    for (int n = near; n < line.number; n++, power *= up) put(n, power * steps[n - near]);
    power = top * down;
    for (int n = near - 1; n >= 0; n--, power *= down) put(n, power * steps[near - n]);
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
    force = row.factor * (1.0 + body.c_force * l);
    force_xx = row.factor * body.c_force * u * u;
    dipole = row.factor * u * (1.0 + body.c_dipole * (l - 2.0 * u));
    dipole_xx = row.factor * u * u * u * body.c_dipole;
  }
};

// Adds the force density of a sphere to the points of a brick that holds all of them.
inline void spread(Stencil &stencil, const Lattice &lattice, const Brick &brick, const Vec3 &center,
                   const Body &body, const Load &load, double *field)
{
  const std::size_t points = brick.points();
  stencil.for_each_row(center, [&](const Row &row) {
    const RowWeights w(body, lattice.width, row);
    const double *p0 = row.column[0], *p1 = row.column[1], *p2 = row.column[2];
    const double *p3 = row.column[3];
    const auto add = [&](double force, const Vec3 &c, double *f) {
      const double c0 = c.y * row.y + c.z * row.z;
      const double a0 = force * w.force + c0 * w.dipole, a1 = c.x * w.dipole;
      const double a2 = force * w.force_xx + c0 * w.dipole_xx, a3 = c.x * w.dipole_xx;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
      for (int n = 0; n < row.number; n++)
        f[n] += (a0 * p0[n] + a1 * p1[n]) + (a2 * p2[n] + a3 * p3[n]);
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
    const double *u = field + brick.index(row.i, row.j, row.k);
    std::array<double, 4> mx{}, my{}, mz{};    // moments along x
    for (int n = 0; n < row.number; n++) {
      const std::array<double, 4> p = row.row[n];
      const double ux = u[n], uy = u[n + points], uz = u[n + 2 * points];
      for (int m = 0; m < 4; m++) {
        mx[m] += ux * p[m];
        my[m] += uy * p[m];
        mz[m] += uz * p[m];
      }
    }
    const auto add = [&](const std::array<double, 4> &of, double &velocity, Vec3 &gradient) {
      velocity += w.force * of[0] + w.force_xx * of[2];
      const double even = w.dipole * of[0] + w.dipole_xx * of[2];
      gradient =
          gradient + Vec3{w.dipole * of[1] + w.dipole_xx * of[3], row.y * even, row.z * even};
    };
    add(mx, motion.velocity.x, motion.gradient.x);
    add(my, motion.velocity.y, motion.gradient.y);
    add(mz, motion.velocity.z, motion.gradient.z);
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

// of the lattice coordinates
struct LatticeGradients {
  Vec3 x, y, z;
};

inline LatticeGradients lattice_gradients(const Lattice &lattice)
{
  const Cell &c = lattice.cell;
  const Vec3 x{1.0 / c.xprd, -c.xy / (c.xprd * c.yprd),
               (c.xy * c.yz / c.yprd - c.xz) / (c.xprd * c.zprd)};
  const Vec3 y{0.0, 1.0 / c.yprd, -c.yz / (c.yprd * c.zprd)}, z{0.0, 0.0, 1.0 / c.zprd};
  return {static_cast<double>(lattice.nx) * x, static_cast<double>(lattice.ny) * y,
          static_cast<double>(lattice.nz) * z};
}

// half widths of a stencil in lattice coordinates
inline Vec3 lattice_reach(const Lattice &lattice)
{
  const LatticeGradients g = lattice_gradients(lattice);
  return {lattice.reach * norm(g.x), lattice.reach * norm(g.y), lattice.reach * norm(g.z)};
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

// Points for a spacing: a number with small factors only, which transforms like.
inline int good_number(double least)
{
  for (int n = 2;; n++) {
    if (n < least) continue;
    int rest = n;
    for (const int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
