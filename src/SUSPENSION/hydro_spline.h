/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// From spheres to the points of a grid and back, with B-splines of an even number of points in each
// direction, at most MOST_POINTS: C. de Boor, A Practical Guide to Splines, Springer (1978). In a
// deformed cell they are deformed with it. A wave is spread with the factor of spline_wave(),
// whatever its shape; as its response makes up for that, they stand for any other shape: U. Essmann
// et al., J. Chem. Phys. 103, 8577 (1995). What is spread to a point and what is interpolated from
// it have the same weights, so that a mobility is symmetric to rounding.
//
// A field may have a companion, of which the Laplacian counts: (1 + c lap) w of a sphere goes to
// the two as w and c w, and comes back as u + c lap u.

#ifndef LMP_HYDRO_SPLINE_H
#define LMP_HYDRO_SPLINE_H

#include "hydro_lattice.h"
#include "hydro_tensors.h"

#include <cmath>
#include <cstring>

namespace LAMMPS_NS::Hydro_NS {

static constexpr int MOST_POINTS = 12;

// Weights of the points, and their slopes along the lattice coordinates of the center.
struct Spline {
  int order;    // points in each direction
  int first[3];
  double weight[3][MOST_POINTS], slope[3][MOST_POINTS];
};

// By the recursion in the order; t: how far the center is from the point below it.
inline void spline_weights(double t, int order, double *weight, double *slope)
{
  weight[0] = 1.0;
  for (int n = 2; n <= order; n++) {
    const double part = 1.0 / (n - 1);
    slope[0] = -weight[0];
    for (int i = 1; i < n - 1; i++) slope[i] = weight[i - 1] - weight[i];
    slope[n - 1] = weight[n - 2];
    weight[n - 1] = part * t * weight[n - 2];
    for (int i = n - 2; i > 0; i--)
      weight[i] = part * ((t + n - 1 - i) * weight[i - 1] + (1 + i - t) * weight[i]);
    weight[0] = part * (1.0 - t) * weight[0];
  }
}

inline Spline spline_at(const Lattice &lattice, const Vec3 &center, int order)
{
  const Vec3 place = lattice_place(lattice, center);
  const double xi[3] = {place.x, place.y, place.z};
  Spline s;
  s.order = order;
  for (int d = 0; d < 3; d++) {
    const double floor = std::floor(xi[d]);
    s.first[d] = static_cast<int>(floor) - order / 2 + 1;
    spline_weights(xi[d] - floor, order, s.weight[d], s.slope[d]);
  }
  return s;
}

// The points of all splines between two corners.
inline Brick spline_brick(const Vec3 &low, const Vec3 &high, int order)
{
  const double from[3] = {low.x, low.y, low.z}, to[3] = {high.x, high.y, high.z};
  Brick b;
  for (int d = 0; d < 3; d++) {
    b.low[d] = static_cast<int>(std::floor(from[d])) - order / 2 + 1;
    b.size[d] = static_cast<int>(std::floor(to[d])) + order / 2 + 1 - b.low[d];
  }
  return b;
}

// What is left of a wave that has this number in n points.
inline double spline_wave(int number, int n, int order)
{
  const double x = PI * number / n, sinc = number == 0 ? 1.0 : std::sin(x) / x;
  return std::pow(sinc, order);
}

// ---- the numbers of a point, all at once

#if defined(__GNUC__) && !defined(__NVCOMPILER)
template <int N> struct LanesOf {
  typedef double type __attribute__((vector_size(N * sizeof(double))));
};
template <int N> using Lanes = typename LanesOf<N>::type;
#else
template <int N> struct Lanes {
  double n[N];
  double operator[](int i) const { return n[i]; }
  void operator+=(const Lanes &b)
  {
    for (int i = 0; i < N; i++) n[i] += b.n[i];
  }
};
template <int N> inline Lanes<N> operator*(double s, const Lanes<N> &a)
{
  Lanes<N> c;
  for (int i = 0; i < N; i++) c.n[i] = s * a.n[i];
  return c;
}
template <int N> inline Lanes<N> operator+(Lanes<N> a, const Lanes<N> &b)
{
  a += b;
  return a;
}
#endif

// c of a sphere, for its force and its dipole
struct OfLaplacian {
  double force = 0.0, dipole = 0.0;
};

template <int COMPONENTS>
inline void put_lanes(const Vec3 &a, double c, Lanes<padded(COMPONENTS)> &lanes)
{
  double n[padded(COMPONENTS)] = {a.x, a.y, a.z};
  if constexpr (COMPONENTS == WITH_COMPANION) {
    n[3] = c * a.x;
    n[4] = c * a.y;
    n[5] = c * a.z;
  }
  std::memcpy(&lanes, n, sizeof(lanes));
}

template <int COMPONENTS> inline Vec3 get_lanes(const Lanes<padded(COMPONENTS)> &lanes, double c)
{
  if constexpr (COMPONENTS == WITH_COMPANION)
    return {lanes[0] + c * lanes[3], lanes[1] + c * lanes[4], lanes[2] + c * lanes[5]};
  else
    return {lanes[0], lanes[1], lanes[2]};
}

// Calls f(first point, weight across x, its slopes along y and z) for the rows of a spline.
template <class F> void for_each_row(const Spline &s, const Brick &brick, F &&f)
{
  for (int k = 0; k < s.order; k++)
    for (int j = 0; j < s.order; j++)
      f(brick.index(s.first[0], s.first[1] + j, s.first[2] + k), s.weight[1][j] * s.weight[2][k],
        s.slope[1][j] * s.weight[2][k], s.weight[1][j] * s.slope[2][k]);
}

// F w + C.grad w, the gradient being that along the center, with c of the Laplacian.
template <int COMPONENTS>
inline void spread(const Spline &s, const LatticeGradients &to, const Brick &brick,
                   const OfLaplacian &c, const Load &load, double *field)
{
  constexpr int N = padded(COMPONENTS);
  Lanes<N> force, along_x, along_y, along_z;
  put_lanes<COMPONENTS>(load.force, c.force, force);
  put_lanes<COMPONENTS>(load.dipole * to.x, c.dipole, along_x);
  put_lanes<COMPONENTS>(load.dipole * to.y, c.dipole, along_y);
  put_lanes<COMPONENTS>(load.dipole * to.z, c.dipole, along_z);
  for_each_row(s, brick, [&](std::size_t point, double across, double slope_y, double slope_z) {
    const Lanes<N> even = across * force + slope_y * along_y + slope_z * along_z;
    const Lanes<N> odd = across * along_x;
    double *at = field + N * point;
    for (int i = 0; i < s.order; i++, at += N) {
      Lanes<N> f;
      std::memcpy(&f, at, sizeof(f));
      f += s.weight[0][i] * even + s.slope[0][i] * odd;
      std::memcpy(at, &f, sizeof(f));
    }
  });
}

template <int COMPONENTS>
inline Motion interpolate(const Spline &s, const LatticeGradients &to, const Brick &brick,
                          const OfLaplacian &c, const double *field)
{
  constexpr int N = padded(COMPONENTS);
  Lanes<N> velocity = {}, along_x = {}, along_y = {}, along_z = {};
  for_each_row(s, brick, [&](std::size_t point, double across, double slope_y, double slope_z) {
    Lanes<N> even = {}, odd = {};
    const double *at = field + N * point;
    for (int i = 0; i < s.order; i++, at += N) {
      Lanes<N> u;
      std::memcpy(&u, at, sizeof(u));
      even += s.weight[0][i] * u;
      odd += s.slope[0][i] * u;
    }
    velocity += across * even;
    along_x += across * odd;
    along_y += slope_y * even;
    along_z += slope_z * even;
  });
  const Vec3 x = get_lanes<COMPONENTS>(along_x, c.dipole);
  const Vec3 y = get_lanes<COMPONENTS>(along_y, c.dipole);
  const Vec3 z = get_lanes<COMPONENTS>(along_z, c.dipole);
  return {get_lanes<COMPONENTS>(velocity, c.force),
          outer(x, to.x) + outer(y, to.y) + outer(z, to.z)};
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
