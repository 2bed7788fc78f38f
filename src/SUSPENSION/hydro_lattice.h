/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The points of a grid that moves with its cell: they have fixed lamda coordinates.

#ifndef LMP_HYDRO_LATTICE_H
#define LMP_HYDRO_LATTICE_H

#include "lubcontact_defs.h"
#include "pore_grid.h"

#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace LAMMPS_NS::Hydro_NS {

using Lubcontact_NS::Vec3;
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
