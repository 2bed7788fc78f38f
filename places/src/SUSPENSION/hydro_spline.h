/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// From spheres to a coarse grid and back, with the cubic B-splines of four points in each
// direction: C. de Boor, A Practical Guide to Splines, Springer (1978). In a deformed cell they are
// deformed with it. A wave is spread with the factor of spline_wave(), whatever its shape.

#ifndef LMP_HYDRO_SPLINE_H
#define LMP_HYDRO_SPLINE_H

#include "hydro_grid.h"

#include <cmath>

namespace LAMMPS_NS::Hydro_NS {

// Weights of four points, and their slopes along the lattice coordinates.
struct Spline {
  int first[3];
  double weight[3][4], slope[3][4];
};

inline Spline spline_at(const Lattice &lattice, const Vec3 &center)
{
  const Vec3 place = lattice_place(lattice, center);
  const double xi[3] = {place.x, place.y, place.z};
  Spline s;
  for (int d = 0; d < 3; d++) {
    const double floor = std::floor(xi[d]), t = xi[d] - floor, u = 1.0 - t;
    s.first[d] = static_cast<int>(floor) - 1;
    const double weights[4] = {u * u * u / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
                               (4.0 - 6.0 * u * u + 3.0 * u * u * u) / 6.0, t * t * t / 6.0};
    const double slopes[4] = {-0.5 * u * u, 1.5 * t * t - 2.0 * t, 2.0 * u - 1.5 * u * u,
                              0.5 * t * t};
    std::copy_n(weights, 4, s.weight[d]);
    std::copy_n(slopes, 4, s.slope[d]);
  }
  return s;
}

// The points of all splines between two corners.
inline Brick spline_brick(const Vec3 &low, const Vec3 &high)
{
  const double from[3] = {low.x, low.y, low.z}, to[3] = {high.x, high.y, high.z};
  Brick b;
  for (int d = 0; d < 3; d++) {
    b.low[d] = static_cast<int>(std::floor(from[d])) - 1;
    b.size[d] = static_cast<int>(std::floor(to[d])) + 3 - b.low[d];
  }
  return b;
}

// What is left of a wave that has this number in n points.
inline double spline_wave(int number, int n)
{
  const double x = PI * number / n, sinc = number == 0 ? 1.0 : std::sin(x) / x;
  return sinc * sinc * sinc * sinc;
}

// Calls f(n, weight, gradient) for the points of a spline in a brick.
template <class F>
void for_each_point(const Spline &s, const LatticeGradients &to, const Brick &brick, F &&f)
{
  for (int k = 0; k < 4; k++)
    for (int j = 0; j < 4; j++) {
      const double both = s.weight[1][j] * s.weight[2][k];
      const Vec3 across =
                     s.slope[1][j] * s.weight[2][k] * to.y + s.weight[1][j] * s.slope[2][k] * to.z,
                 along = both * to.x;
      const std::size_t row = brick.index(s.first[0], s.first[1] + j, s.first[2] + k);
      for (int i = 0; i < 4; i++)
        f(row + i, s.weight[0][i] * both, s.slope[0][i] * along + s.weight[0][i] * across);
    }
}

// F w + C.grad w, the gradient being that along the center.
inline void spread(const Spline &s, const LatticeGradients &to, const Brick &brick,
                   const Load &load, double *field)
{
  const std::size_t points = brick.points();
  for_each_point(s, to, brick, [&](std::size_t n, double weight, const Vec3 &gradient) {
    const Vec3 f = weight * load.force + load.dipole * gradient;
    field[n] += f.x;
    field[n + points] += f.y;
    field[n + 2 * points] += f.z;
  });
}

inline Motion interpolate(const Spline &s, const LatticeGradients &to, const Brick &brick,
                          const double *field)
{
  const std::size_t points = brick.points();
  Motion motion;
  for_each_point(s, to, brick, [&](std::size_t n, double weight, const Vec3 &gradient) {
    const Vec3 u{field[n], field[n + points], field[n + 2 * points]};
    motion.velocity = motion.velocity + weight * u;
    motion.gradient = motion.gradient + outer(u, gradient);
  });
  return motion;
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
