/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// From spheres to the points of a grid and back, with Gaussians of the real distances. What is
// spread to a point and what is interpolated from it have the same weights, so that the mobility is
// symmetric to rounding.

#ifndef LMP_HYDRO_GRID_H
#define LMP_HYDRO_GRID_H

#include "hydro_lattice.h"
#include "hydro_wide.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace LAMMPS_NS::Hydro_NS {

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

// Eight numbers at once.
static constexpr int LANES = 8;
#if defined(__GNUC__) && !defined(__NVCOMPILER)
typedef double Lanes __attribute__((vector_size(LANES * sizeof(double))));
#else
struct Lanes {
  double n[LANES];
  double operator[](int i) const { return n[i]; }
  void operator+=(const Lanes &b)
  {
    for (int i = 0; i < LANES; i++) n[i] += b.n[i];
  }
};
inline Lanes operator*(const Lanes &a, const Lanes &b)
{
  Lanes c;
  for (int i = 0; i < LANES; i++) c.n[i] = a.n[i] * b.n[i];
  return c;
}
inline Lanes operator*(double s, const Lanes &a)
{
  Lanes c;
  for (int i = 0; i < LANES; i++) c.n[i] = s * a.n[i];
  return c;
}
inline Lanes operator+(double s, const Lanes &a)
{
  Lanes c;
  for (int i = 0; i < LANES; i++) c.n[i] = s + a.n[i];
  return c;
}
inline Lanes operator+(Lanes a, const Lanes &b)
{
  a += b;
  return a;
}
#endif

// Where a sphere is on the grid, as long as it does not move: rows of points along x within reach,
// eight at a time. What is left of the last eight is a little more than the reach, and beyond the
// line 0. In a cell that is leaned along x only, all layers have the same lines.
class Stencils {
 public:
  struct Line {
    double x, y, gauss;    // of its first point, from the center; gauss: along y
  };
  struct Layer {
    double z, gauss;
  };
  struct Row {
    int point;         // of the brick, the first one
    int line, from;    // of all lines; from a point of it on
    short layer, eights;
  };

  // of a lattice, in a brick that holds all they reach, and PADDING numbers more
  static constexpr int PADDING = LANES;
  void start(const Lattice &, const Brick &);
  void add(const Vec3 &center);

  const Lattice &lattice() const { return grid; }
  std::size_t brick_points() const { return brick.points(); }
  double spacing() const { return dx; }
  const Line &line(const Row &r) const { return lines[r.line]; }
  const double *gauss(const Row &r) const
  {
    return &gaussians[static_cast<std::size_t>(r.line) * stride + r.from];
  }
  // with the layer of each
  template <class F> void for_each_row(std::size_t sphere, F &&f) const
  {
    const Sphere &s = spheres[sphere], &next = spheres[sphere + 1];
    for (std::size_t n = s.row; n < next.row; n++) f(rows[n], layers[s.layer + rows[n].layer]);
  }
  double memory_usage() const
  {
    return static_cast<double>(rows.capacity() * sizeof(Row) + lines.capacity() * sizeof(Line) +
                               layers.capacity() * sizeof(Layer) +
                               spheres.capacity() * sizeof(Sphere) +
                               gaussians.capacity() * sizeof(double));
  }

 private:
  struct Sphere {
    std::size_t row, layer;    // the first ones
  };
  Lattice grid;
  Brick brick;
  double dx = 1.0, dy = 1.0, dz = 1.0, half = 0.5;
  std::size_t stride = 0;
  std::vector<double> steps;    // exp(-(m dx)^2/2W^2)
  std::vector<double> gaussians;
  std::vector<Line> lines;
  std::vector<Layer> layers;
  std::vector<Row> rows;
  std::vector<Sphere> spheres;

  static double root(double square) { return std::sqrt(square > 0.0 ? square : 0.0); }
  Span add_line(double y, double to_x, double r2);
};

inline void Stencils::start(const Lattice &lattice, const Brick &of_rank)
{
  grid = lattice;
  brick = of_rank;
  const Cell &c = grid.cell;
  dx = c.xprd / grid.nx;
  dy = c.yprd / grid.ny;
  dz = c.zprd / grid.nz;
  half = 0.5 / (grid.width * grid.width);
  const int most = static_cast<int>(grid.reach / dx) + 2;
  steps.clear();
  for (int m = 0; m <= most; m++) steps.push_back(std::exp(-half * m * m * dx * dx));
  stride = 2 * most + LANES;
  gaussians.clear();
  lines.clear();
  layers.clear();
  rows.clear();
  spheres.assign(1, {0, 0});
}

inline void Stencils::add(const Vec3 &center)
{
  const Cell &cell = grid.cell;
  const double y_to_x = cell.xy / grid.ny, z_to_x = cell.xz / grid.nz, z_to_y = cell.yz / grid.nz;
  const double reach = grid.reach, norm = std::pow(half / PI, 1.5);
  const Vec3 c = center - cell.origin;
  const bool upright = z_to_x == 0.0 && z_to_y == 0.0;
  const Span all = span(c.y / dy, reach / dy);
  const int first_line = static_cast<int>(lines.size());
  std::vector<Span> in_line;
  if (upright)
    for (int j = all.first; j <= all.last; j++)
      in_line.push_back(add_line(j * dy - c.y, j * y_to_x - c.x, reach * reach));

  const Span of_z = span(c.z / dz, reach / dz);
  for (int k = of_z.first; k <= of_z.last; k++) {
    const double z = k * dz - c.z, r2 = reach * reach - z * z;
    layers.push_back({z, norm * std::exp(-half * z * z)});
    const double to_y = k * z_to_y - c.y;
    const Span of_y = span(-to_y / dy, root(r2) / dy);
    for (int j = of_y.first; j <= of_y.last; j++) {
      const double y = j * dy + to_y, to_x = j * y_to_x + k * z_to_x - c.x;
      const Span line = upright ? in_line[j - all.first] : add_line(y, to_x, r2);
      const int index = upright ? first_line + j - all.first : static_cast<int>(lines.size()) - 1;
      const Span points = span(-to_x / dx, root(r2 - y * y) / dx);
      const int first = std::max(points.first, line.first);
      const int number = std::min(points.last, line.last) - first + 1;
      if (number <= 0) continue;
      rows.push_back({static_cast<int>(brick.index(first, j, k)), index, first - line.first,
                      static_cast<short>(k - of_z.first),
                      static_cast<short>((number + LANES - 1) / LANES)});
    }
  }
  spheres.push_back({rows.size(), layers.size()});
}

// Two exponentials a line: those of its points follow from that of the nearest one to the center.
inline Span Stencils::add_line(double y, double to_x, double r2)
{
  const Span points = span(-to_x / dx, root(r2 - y * y) / dx);
  const int number = points.last - points.first + 1;
  lines.push_back({points.first * dx + to_x, y, std::exp(-half * y * y)});
  gaussians.resize(gaussians.size() + stride, 0.0);
  double *g = &gaussians[gaussians.size() - stride];
  if (number <= 0) return points;
  const int nearest = static_cast<int>(std::lround(-to_x / dx)) - points.first;
  const int near = std::max(0, std::min(nearest, number - 1));    // but for rounding it is
  const double x0 = (points.first + near) * dx + to_x;
  const double top = std::exp(-half * x0 * x0);
  const double up = std::exp(-2.0 * half * x0 * dx), down = 1.0 / up;
  double power = top;
  for (int n = near; n < number; n++, power *= up) g[n] = power * steps[n - near];
  power = top * down;
  for (int n = near - 1; n >= 0; n--, power *= down) g[n] = power * steps[near - n];
  return points;
}

// Along a row the force density is the Gaussian times a polynomial of third degree in x: with
// l = lap D/D = y^2/W^4 - 3/W^2 it is (1 + c_m l) F_j + (1 + c_d l - 2 c_d/W^2) C_jk y_k/W^2.
// Calls f(points, y, z, of F, of C_jx, of C_jy y + C_jz z) for eight points at a time.
template <class F>
void for_each_eight(const Stencils &stencils, std::size_t sphere, const Body &body, F &&f)
{
  const double u = 1.0 / (stencils.lattice().width * stencils.lattice().width);
  const double dx = stencils.spacing();
  double steps[LANES];
  for (int n = 0; n < LANES; n++) steps[n] = n * dx;
  Lanes step, gauss;
  std::memcpy(&step, steps, sizeof(Lanes));
  stencils.for_each_row(sphere, [&](const Stencils::Row &row, const Stencils::Layer &layer) {
    const Stencils::Line &line = stencils.line(row);
    const double l = ((line.y * line.y + layer.z * layer.z) * u - 3.0) * u;
    const double factor = line.gauss * layer.gauss;
    const double force = factor * (1.0 + body.c_force * l),
                 force_xx = factor * body.c_force * u * u;
    const double dipole = factor * u * (1.0 + body.c_dipole * (l - 2.0 * u));
    const double dipole_xx = factor * u * u * u * body.c_dipole;
    const double *g = stencils.gauss(row);
    for (int n = 0; n < row.eights; n++, g += LANES) {
      std::memcpy(&gauss, g, sizeof(Lanes));
      const Lanes x = (line.x + (row.from + n * LANES) * dx) + step, xx = x * x;
      const Lanes of_dipole = gauss * (dipole + dipole_xx * xx);
      f(row.point + n * LANES, line.y, layer.z, gauss * (force + force_xx * xx), of_dipole * x,
        of_dipole);
    }
  });
}

// Adds the force density of a sphere to the points of the brick: PADDING numbers more than it has.
inline void spread(const Stencils &stencils, std::size_t sphere, const Body &body, const Load &load,
                   double *field)
{
  const std::size_t points = stencils.brick_points();
  const auto add = [](double force, const Vec3 &c, double y, double z, const Lanes &of_force,
                      const Lanes &of_x, const Lanes &of_yz, double *to) {
    Lanes f;
    std::memcpy(&f, to, sizeof(Lanes));
    f += force * of_force + (c.x * of_x + (c.y * y + c.z * z) * of_yz);
    std::memcpy(to, &f, sizeof(Lanes));
  };
  for_each_eight(stencils, sphere, body,
                 [&](int point, double y, double z, const Lanes &of_force, const Lanes &of_x,
                     const Lanes &of_yz) {
                   double *f = field + point;
                   add(load.force.x, load.dipole.x, y, z, of_force, of_x, of_yz, f);
                   add(load.force.y, load.dipole.y, y, z, of_force, of_x, of_yz, f + points);
                   add(load.force.z, load.dipole.z, y, z, of_force, of_x, of_yz, f + 2 * points);
                 });
}

// Mean velocity and gradient at a sphere of the velocities at the points.
inline Motion interpolate(const Stencils &stencils, std::size_t sphere, const Body &body,
                          const double *field)
{
  const std::size_t points = stencils.brick_points();
  Lanes velocity[3] = {}, along_x[3] = {}, along_y[3] = {}, along_z[3] = {};
  for_each_eight(stencils, sphere, body,
                 [&](int point, double y, double z, const Lanes &of_force, const Lanes &of_x,
                     const Lanes &of_yz) {
                   for (int c = 0; c < 3; c++) {
                     Lanes u;
                     std::memcpy(&u, field + c * points + point, sizeof(Lanes));
                     const Lanes even = of_yz * u;
                     velocity[c] += of_force * u;
                     along_x[c] += of_x * u;
                     along_y[c] += y * even;
                     along_z[c] += z * even;
                   }
                 });
  const double volume = stencils.lattice().point_volume();
  const auto sum = [volume](const Lanes &lanes) {
    double all = 0.0;
    for (int n = 0; n < LANES; n++) all += lanes[n];
    return volume * all;
  };
  const auto gradient = [&](int c) {
    return Vec3{sum(along_x[c]), sum(along_y[c]), sum(along_z[c])};
  };
  return {{sum(velocity[0]), sum(velocity[1]), sum(velocity[2])},
          {gradient(0), gradient(1), gradient(2)}};
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
