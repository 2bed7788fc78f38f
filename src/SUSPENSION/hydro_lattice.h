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

  double volume() const { return cell.xprd * cell.yprd * cell.zprd; }
  std::size_t points() const { return static_cast<std::size_t>(nx) * ny * nz; }
  double point_volume() const { return volume() / static_cast<double>(points()); }
};

// Components of a field: three of a vector; with its companion six (hydro_spline.h). In the memory
// of a brick those of a point are together and padded, the rest being 0.
static constexpr int VECTOR = 3, WITH_COMPANION = 6;
constexpr int padded(int components)
{
  return components > 4 ? 8 : 4;
}

// A box of points, x fastest.
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

// Waves are resolved alike in all directions if the points are as close along the edges of the
// cell; lean: by how much the second edge leans along the first one.
inline Lattice lattice_for(const Cell &c, double spacing, double lean)
{
  return {c, good_number(c.xprd / spacing), good_number(std::hypot(c.yprd, lean) / spacing),
          good_number(std::sqrt(c.zprd * c.zprd + c.xz * c.xz + c.yz * c.yz) / spacing)};
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
