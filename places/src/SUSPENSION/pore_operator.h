/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Balance of the fluid's volume on the grid, trilinear finite elements on parallelepipeds:
//   (K p)_n = sum_e (k_e/eta) int_e grad N_n . grad p,   (D v)_n = -sum_e V_e grad N_n(x_e).u_e +
// walls,
//   K p = -D v:   what the solid displaces, or a wall, flows off through the pores by Darcy's law.
// The gradient of a trilinear function at the center is its mean over the element, so that D^T p,
// the forces, dissipate exactly what flows: F.v = -p K p.

#ifndef LMP_PORE_OPERATOR_H
#define LMP_PORE_OPERATOR_H

#include "pore_deposit.h"

namespace LAMMPS_NS::Pore_NS {

using Field = std::vector<double>;    // at the nodes

// K of an element with k/eta = 1
struct ElementMatrix {
  double value[CORNERS][CORNERS] = {};
};

// 2 x 2 x 2 points of Gauss: exact
inline ElementMatrix element_matrix(const Grid &grid)
{
  const Metric m = metric(grid);
  const double point[2] = {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};
  const double weight = grid.element_volume() / 8.0;
  ElementMatrix matrix;
  for (int q = 0; q < 8; q++) {
    Vec3 gradient[CORNERS];
    for (int c = 0; c < CORNERS; c++) {
      double n[3], slope[3];
      for (int a = 0; a < 3; a++) {
        const bool far = (c >> a) & 1;
        const double xi = point[(q >> a) & 1];
        n[a] = far ? xi : 1.0 - xi;
        slope[a] = far ? 1.0 : -1.0;
      }
      gradient[c] = (slope[0] * n[1] * n[2]) * m.along[0] + (n[0] * slope[1] * n[2]) * m.along[1] +
          (n[0] * n[1] * slope[2]) * m.along[2];
    }
    for (int c = 0; c < CORNERS; c++)
      for (int d = 0; d < CORNERS; d++)
        matrix.value[c][d] += weight * dot(gradient[c], gradient[d]);
  }
  return matrix;
}

// k_e/eta
inline std::vector<double> mobilities(const std::vector<Element> &elements, double viscosity)
{
  std::vector<double> mobility(elements.size());
  for (std::size_t e = 0; e < elements.size(); e++)
    mobility[e] = elements[e].permeability / viscosity;
  return mobility;
}

// y = K p, all rows
inline void apply_darcy(const Grid &grid, const ElementMatrix &matrix,
                        const std::vector<double> &mobility, const Field &p, Field &y)
{
  y.assign(grid.nodes(), 0.0);
  for_each_element(grid, [&](int e, const int *corner) {
    double local[CORNERS];
    for (int c = 0; c < CORNERS; c++) local[c] = mobility[e] * p[corner[c]];
    for (int c = 0; c < CORNERS; c++) {
      double sum = 0.0;
      for (int d = 0; d < CORNERS; d++) sum += matrix.value[c][d] * local[d];
      y[corner[c]] += sum;
    }
  });
}

// grad N at the center of an element
struct CenterGradients {
  Vec3 of[CORNERS];
};

inline CenterGradients center_gradients(const Grid &grid)
{
  const Metric m = metric(grid);
  CenterGradients g;
  for (int c = 0; c < CORNERS; c++)
    for (int a = 0; a < 3; a++) g.of[c] = g.of[c] + ((c >> a) & 1 ? 0.25 : -0.25) * m.along[a];
  return g;
}

// grad p at the centers of the elements, plus a mean one
inline std::vector<Lanes> gradients(const Grid &grid, const Field &p, const Vec3 &mean = {})
{
  const CenterGradients g = center_gradients(grid);
  std::vector<Lanes> at(grid.elements());
  for_each_element(grid, [&](int e, const int *corner) {
    Vec3 sum = mean;
    for (int c = 0; c < CORNERS; c++) sum = sum + p[corner[c]] * g.of[c];
    at[e] = {sum};
  });
  return at;
}

// sum_e V_e grad N_n(x_e).flux(e), added to y
template <class F> void add_weak_divergence(const Grid &grid, F &&flux, Field &y)
{
  const CenterGradients g = center_gradients(grid);
  const double volume = grid.element_volume();
  for_each_element(grid, [&](int e, const int *corner) {
    const Vec3 f = volume * flux(e);
    for (int c = 0; c < CORNERS; c++) y[corner[c]] += dot(g.of[c], f);
  });
}

// Velocities of the plates along y.
struct WallVelocity {
  double lower = 0.0, upper = 0.0;
};

// D v, all rows
inline Field divergence(const Grid &grid, const std::vector<Motion> &motion, const WallVelocity &v)
{
  Field y(grid.nodes(), 0.0);
  add_weak_divergence(
      grid,
      [&](int e) {
        return -1.0 * motion[e].velocity;
      },
      y);
  if (!grid.has_plates()) return y;
  const int size = grid.layer_size();
  const double area = grid.wall_area() / size;
  for (int n = 0; n < size; n++) {
    y[n] -= area * v.lower;
    y[y.size() - static_cast<std::size_t>(size - n)] += area * v.upper;
  }
  return y;
}

// Mean of a field over a plate, or over the layer of nodes j.
inline double layer_mean(const Grid &grid, const Field &p, int j)
{
  double sum = 0.0;
  for (int n = 0; n < grid.layer_size(); n++)
    sum += p[static_cast<std::size_t>(j) * grid.layer_size() + n];
  return sum / grid.layer_size();
}

// of the fluid on the plates along y; plus the forces on the particles, and on clear fluid, this is
// 0
struct WallForce {
  double lower = 0.0, upper = 0.0;
};

inline WallForce wall_force(const Grid &grid, const Field &p)
{
  if (!grid.has_plates()) return {};
  const double area = grid.wall_area();
  return {-area * layer_mean(grid, p, 0), area * layer_mean(grid, p, grid.ny)};
}

// volume of a node over that of an inner one
inline double node_share(const Grid &grid, int j)
{
  return grid.has_plates() && (j == 0 || j == grid.ny) ? 0.5 : 1.0;
}

// mean over the volume
inline double mean_pressure(const Grid &grid, const Field &p)
{
  double sum = 0.0;
  for (int j = 0; j < grid.layers(); j++) sum += node_share(grid, j) * layer_mean(grid, p, j);
  return sum / grid.ny;
}

// means over the elements: of their corners, exact for what is linear along each edge
inline std::vector<double> element_means(const Grid &grid, const Field &p)
{
  std::vector<double> means(grid.elements());
  for_each_element(grid, [&](int e, const int *corner) {
    double sum = 0.0;
    for (int c = 0; c < CORNERS; c++) sum += p[corner[c]];
    means[e] = sum / CORNERS;
  });
  return means;
}

// What of an integral over the elements belongs to a particle: sum_e W_ei times that of the
// element. All particles together have all of it, and its first moment sum_i x_i share_i is sum_e
// x_e times that of the element: a profile over the particles is at the right place, also at a
// plate, from which their centers keep a distance. Clear fluid belongs to none.
inline double share_of(const Stencil &s, const std::vector<double> &integrals)
{
  double sum = 0.0;
  for (int r = 0; r < 9; r++)
    for (int a = 0; a < 3; a++) sum += s.weight[r][a] * integrals[s.element(r, a)];
  return sum;
}

// sets the nodes where the pressure is given
inline void set_fixed(const Grid &grid, double lower, double upper, Field &p)
{
  const auto size = static_cast<std::ptrdiff_t>(grid.layer_size());
  if (grid.lower == Wall::DRAINED) std::fill(p.begin(), p.begin() + size, lower);
  if (grid.upper == Wall::DRAINED) std::fill(p.end() - size, p.end(), upper);
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
