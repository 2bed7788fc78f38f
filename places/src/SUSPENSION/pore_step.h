/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// A step of the pore pressure together with the particles, which in velocity Verlet have v(n-1/2)
// when forces are computed. F_o are all other forces, D and K are those of the new positions:
//   v* = v(n-1/2) + (dt/m) (F_o + D^T p_n)
//   P (p_n+1 - p_n) = -D v* - K p_n - S V (nothing at p_n+1 = p_n)
//   F = D^T p_n+1 added to F_o
// With P = A = K + dt D M^-1 D^T + S V/dt that is backward Euler of Darcy's law; any other P >= A
// adds a storage dt (P - A), which vanishes with dt. Stable for every permeability and viscosity,
// at the time step of the contacts. P = (k_e/eta + dt b_e) K1 >= A per element, since D M^-1 D^T is
// bounded by the sums of its rows, b_e, and the gradient at the center by its mean square; one
// constant for all, the largest, is what ConstantSolver solves.

#ifndef LMP_PORE_STEP_H
#define LMP_PORE_STEP_H

#include "pore_cg.h"
#include "pore_operator.h"

namespace LAMMPS_NS::Pore_NS {

// v*
inline Vec3 predicted(const Vec3 &v, const Vec3 &other_force, const Vec3 &pore_force,
                      double inverse_mass, double dt)
{
  return v + (dt * inverse_mass) * (other_force + pore_force);
}

// k_e/eta + dt b_e; dt = 0 if particles do not feel the pressure
inline std::vector<double> implicit_mobilities(const std::vector<double> &mobility,
                                               const std::vector<double> &bound, double dt)
{
  std::vector<double> sum(mobility);
  for (std::size_t e = 0; e < sum.size(); e++) sum[e] += dt * bound[e];
  return sum;
}

// A plate that the pressure moves, impermeable and opposite to a drained one: what it adds to b_e.
// The square of the mean pressure on it is at most V/area^2 times the integral of (dp/dy)^2. mass:
// what it has beyond the mass with which its particles were deposited.
inline double wall_bound(const Grid &grid, double mass)
{
  return grid.volume() / mass;
}

// the constant of P
inline double largest(const std::vector<double> &mobility)
{
  double most = 0.0;
  for (double m : mobility) most = larger(m, most);
  return most;
}

// storage per inner node over dt: S V/dt
inline double node_storage(const Grid &grid, double storage, double dt)
{
  return storage > 0.0 ? storage * grid.element_volume() / dt : 0.0;
}

// 0 where the pressure is given; without such nodes and storage, without what has no solution
inline void project(const Grid &grid, bool has_storage, Field &r)
{
  set_fixed(grid, 0.0, 0.0, r);
  if (grid.has_fixed_nodes() || has_storage) return;
  double sum = 0.0;
  for (double value : r) sum += value;
  for (int j = 0; j < grid.layers(); j++)
    for (int n = 0; n < grid.layer_size(); n++)
      r[static_cast<std::size_t>(j) * grid.layer_size() + n] -=
          sum * node_share(grid, j) / static_cast<double>(grid.elements());
}

// What a pressure leaves over, in all rows: -D v - K p, of the mean gradient, too. Where p is
// given, it is what flows out through the drained plate, against it.
inline Field imbalance(const Grid &grid, const ElementMatrix &matrix,
                       const std::vector<double> &mobility, const std::vector<Motion> &motion,
                       const WallVelocity &wall, const Vec3 &mean_gradient, const Field &p)
{
  Field kp;
  apply_darcy(grid, matrix, mobility, p, kp);
  add_weak_divergence(
      grid,
      [&](int e) {
        return mobility[e] * mean_gradient;
      },
      kp);
  Field r = divergence(grid, motion, wall);
  for (std::size_t n = 0; n < r.size(); n++) r[n] = -r[n] - kp[n];
  return r;
}

// y = A p for conjugate gradients. response(p, motion, wall): what accelerations by the forces D^T
// p make of the velocities, summed over the ranks: add_motion of f/m, and of plates that the
// pressure moves. dt = 0: y = K p.
template <class Response>
void apply_implicit(const Grid &grid, const ElementMatrix &matrix,
                    const std::vector<double> &mobility, double dt, double storage_per_node,
                    const Response &response, const Field &p, Field &y)
{
  apply_darcy(grid, matrix, mobility, p, y);
  if (dt > 0.0) {
    std::vector<Motion> motion(grid.elements());
    WallVelocity wall;
    response(p, motion, wall);
    const Field flow = divergence(grid, motion, wall);
    for (std::size_t n = 0; n < y.size(); n++) y[n] += dt * flow[n];
  }
  for (int j = 0; j < grid.layers(); j++)
    for (int n = 0; n < grid.layer_size(); n++) {
      const std::size_t node = static_cast<std::size_t>(j) * grid.layer_size() + n;
      y[node] += node_share(grid, j) * storage_per_node * p[node];
    }
  set_fixed(grid, 0.0, 0.0, y);
}

// ---- what there is to know of a pressure

// power/1: sum of k_e/eta int |grad p|^2, the mean gradient included
inline double dissipation(const Grid &grid, const ElementMatrix &matrix,
                          const std::vector<double> &mobility, const Vec3 &mean_gradient,
                          const Field &p)
{
  Field y;
  apply_darcy(grid, matrix, mobility, p, y);
  double sum = scalar_product(p, y);
  const std::vector<Lanes> gradient = gradients(grid, p);
  for (std::size_t e = 0; e < gradient.size(); e++)
    sum +=
        grid.element_volume() * mobility[e] * dot(mean_gradient, 2.0 * gradient[e] + mean_gradient);
  return sum;
}

// of the fluid relative to the particles, per area: mean over the grid
inline Vec3 mean_flux(const std::vector<double> &mobility, const std::vector<Lanes> &gradient)
{
  Vec3 sum;
  for (std::size_t e = 0; e < gradient.size(); e++) sum = sum - mobility[e] * gradient[e];
  return (1.0 / static_cast<double>(gradient.size())) * sum;
}

// volume/time that flows out of the grid through each plate, against the plate, from the imbalance
struct WallFlux {
  double lower = 0.0, upper = 0.0;
};

inline WallFlux wall_flux(const Grid &grid, const Field &imbalance)
{
  if (!grid.has_plates()) return {};
  const int size = grid.layer_size();
  return {grid.lower == Wall::DRAINED ? size * layer_mean(grid, imbalance, 0) : 0.0,
          grid.upper == Wall::DRAINED ? size * layer_mean(grid, imbalance, grid.ny) : 0.0};
}

// Force of the pressure that finds no particles: sum of the weights of clear elements is less than
// 1.
inline Vec3 clear_force(const Grid &grid, const Permeability &law,
                        const std::vector<Element> &elements, const std::vector<Lanes> &gradient)
{
  Vec3 sum;
  for (std::size_t e = 0; e < gradient.size(); e++)
    sum = sum - larger(1.0 - elements[e].phi / law.phi_min, 0.0) * gradient[e];
  return grid.element_volume() * sum;
}

// Step up to which explicit coupling, F = D^T p with K p = -D v of v(n-1/2), is stable for sure.
inline double explicit_step(const std::vector<double> &mobility, const std::vector<double> &bound)
{
  double rate = 0.0;
  for (std::size_t e = 0; e < mobility.size(); e++)
    if (bound[e] > 0.0) rate = larger(bound[e] / mobility[e], rate);
  return 2.0 / rate;
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
