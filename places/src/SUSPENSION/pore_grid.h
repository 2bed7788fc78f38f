/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The grid of the pore pressure: a cell of LAMMPS, cut into nx ny nz equal elements along its
// edges. The pressure is at the corners of the elements. x and z are periodic; y is periodic, or
// goes from the surface of a lower plate to that of an upper one. Lattice coordinates count
// elements: corners are at integers, centers halfway between. All arrays have x as their fastest
// index and y as their slowest.

#ifndef LMP_PORE_GRID_H
#define LMP_PORE_GRID_H

#include "lubcontact_vec3.h"

#include <cmath>
#include <cstddef>

namespace LAMMPS_NS::Pore_NS {

using Lubcontact_NS::Vec3;

// edges (xprd 0 0), (xy yprd 0), (xz yz zprd) from the origin
struct Cell {
  Vec3 origin;
  double xprd = 1.0, yprd = 1.0, zprd = 1.0;
  double xy = 0.0, xz = 0.0, yz = 0.0;
};

// what a boundary in y does to the fluid; a cell is periodic on both sides or on none
enum class Wall { PERIODIC, IMPERMEABLE, DRAINED };

// 8 corners of an element: bit 0 is the step along x, bit 1 along y, bit 2 along z
static constexpr int CORNERS = 8;

struct Grid {
  int nx = 1, ny = 1, nz = 1;    // elements
  Wall lower = Wall::PERIODIC, upper = Wall::PERIODIC;
  Cell cell;    // between plates: yprd is the gap, origin.y the lower surface, xy = yz = 0

  bool has_plates() const { return lower != Wall::PERIODIC; }
  int layers() const { return has_plates() ? ny + 1 : ny; }    // of nodes
  int layer_size() const { return nx * nz; }                   // nodes or elements
  std::size_t nodes() const { return static_cast<std::size_t>(layers()) * layer_size(); }
  std::size_t elements() const { return static_cast<std::size_t>(ny) * layer_size(); }

  double volume() const { return cell.xprd * cell.yprd * cell.zprd; }
  double element_volume() const { return volume() / static_cast<double>(elements()); }
  double wall_area() const { return cell.xprd * cell.zprd; }

  // node or element, i and k from 0 to nx and nz, j to layers() - 1; nx and nz are the nodes 0
  int index(int i, int j, int k) const
  {
    return (j * nz + (k == nz ? 0 : k)) * nx + (i == nx ? 0 : i);
  }

  // the pressure is given there
  bool is_fixed_layer(int j) const
  {
    return (j == 0 && lower == Wall::DRAINED) || (j == ny && upper == Wall::DRAINED);
  }
  bool has_fixed_nodes() const { return lower == Wall::DRAINED || upper == Wall::DRAINED; }
};

// a triangular tilt that is not periodic has no meaning
inline bool is_possible(const Grid &grid)
{
  const bool sides = (grid.lower == Wall::PERIODIC) == (grid.upper == Wall::PERIODIC);
  const bool upright = grid.cell.xy == 0.0 && grid.cell.yz == 0.0;
  return sides && grid.nx > 0 && grid.ny > 0 && grid.nz > 0 && (!grid.has_plates() || upright);
}

// Gradients of the lattice coordinates, 1/length: the gradient of p is the sum of dp/dxi_a
// along[a].
struct Metric {
  Vec3 along[3];
};

inline Metric metric(const Grid &grid)
{
  const Cell &c = grid.cell;
  const double x = grid.nx / c.xprd, y = grid.ny / c.yprd, z = grid.nz / c.zprd;
  return {{{x, -x * c.xy / c.yprd, x * (c.xy * c.yz / c.yprd - c.xz) / c.zprd},
           {0.0, y, -y * c.yz / c.zprd},
           {0.0, 0.0, z}}};
}

// lattice coordinates of a point
inline Vec3 lattice(const Grid &grid, const Metric &m, const Vec3 &point)
{
  const Vec3 r = point - grid.cell.origin;
  return {dot(m.along[0], r), dot(m.along[1], r), dot(m.along[2], r)};
}

// center of an element
inline Vec3 center(const Grid &grid, int i, int j, int k)
{
  const Cell &c = grid.cell;
  const double x = (i + 0.5) / grid.nx, y = (j + 0.5) / grid.ny, z = (k + 0.5) / grid.nz;
  return c.origin + Vec3{x * c.xprd + y * c.xy + z * c.xz, y * c.yprd + z * c.yz, z * c.zprd};
}

// Smallest distance of opposite faces of the elements: what the spacing of the grid is judged by.
inline double spacing(const Grid &grid)
{
  const Metric m = metric(grid);
  double widest = 0.0;
  for (const Vec3 &along : m.along) widest = std::fmax(widest, dot(along, along));
  return 1.0 / std::sqrt(widest);
}

// Calls f(element, corners) for all elements; corners are 8 nodes.
template <class F> void for_each_element(const Grid &grid, F &&f)
{
  int corner[CORNERS];
  for (int j = 0; j < grid.ny; j++) {
    const int up = j + 1 < grid.layers() ? j + 1 : 0;
    for (int k = 0; k < grid.nz; k++)
      for (int i = 0; i < grid.nx; i++) {
        for (int c = 0; c < CORNERS; c++)
          corner[c] = grid.index(i + (c & 1), (c & 2) ? up : j, k + (c >> 2));
        f(grid.index(i, j, k), corner);
      }
  }
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
