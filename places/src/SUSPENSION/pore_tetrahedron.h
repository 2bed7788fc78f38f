/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// A pore between four spheres, and the throat to the next one between three of them:
// B. Chareyre, A. Cortis, E. Catalano, E. Barthelemy, Transp. Porous Med. 94, 595 (2012).
// The volume of a pore is that of the whole tetrahedron, its pressure belongs to the power center,
// which has equal tangents to all four spheres. A throat extends over its facet from one power
// center to the other.

#ifndef LMP_PORE_TETRAHEDRON_H
#define LMP_PORE_TETRAHEDRON_H

#include "lubcontact_vec3.h"

#include <array>
#include <cmath>

namespace LAMMPS_NS::Pore_NS {

using Lubcontact_NS::cross;
using Lubcontact_NS::dot;
using Lubcontact_NS::norm;
using Lubcontact_NS::Vec3;

// Corners such that (x1-x0).((x2-x0)x(x3-x0)) > 0, or the volume is negative.
using Tetrahedron = std::array<Vec3, 4>;

inline double tetrahedron_volume(const Tetrahedron &x)
{
  return dot(x[1] - x[0], cross(x[2] - x[0], x[3] - x[0])) / 6.0;
}

// of the volume, along each corner: a third of the area of the facet opposite to it
inline std::array<Vec3, 4> volume_gradient(const Tetrahedron &x)
{
  const Vec3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
  const Vec3 first = (1.0 / 6.0) * cross(b, c), second = (1.0 / 6.0) * cross(c, a),
             third = (1.0 / 6.0) * cross(a, b);
  return {-1.0 * (first + second + third), first, second, third};
}

inline Vec3 power_center(const Tetrahedron &x, const std::array<double, 4> &radius)
{
  const Vec3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
  const double first = radius[0] * radius[0];
  auto known = [&](const Vec3 &edge, int n) {
    return dot(edge, edge) - radius[n] * radius[n] + first;
  };
  const Vec3 sum =
      known(a, 1) * cross(b, c) + known(b, 2) * cross(c, a) + known(c, 3) * cross(a, b);
  return x[0] + (0.5 / dot(a, cross(b, c))) * sum;
}

// of the triangle of three directions, seen from their origin; A. van Oosterom, J. Strackee, IEEE
// Trans. Biomed. Eng. 30, 125 (1983)
inline double solid_angle(const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
  const double ra = norm(a), rb = norm(b), rc = norm(c);
  return 2.0 *
      std::atan2(std::fabs(dot(a, cross(b, c))),
                 ra * rb * rc + dot(a, b) * rc + dot(b, c) * ra + dot(c, a) * rb);
}

// A facet with the power centers on its two sides. Heights over it: positive on the own side.
struct Facet {
  std::array<Vec3, 3> corner;
  std::array<double, 3> radius;
  Vec3 center[2];
  double height[2];
};

// What a throat is: its conductance is area * radius^2/(2 viscosity length).
struct Throat {
  double facet = 0.0;     // area of the whole facet
  double area = 0.0;      // of its part in the fluid
  double radius = 0.0;    // hydraulic: volume of the fluid over the wetted area
  double length = 0.0;    // between the power centers; < 0 if the triangulation is not regular
};

inline Throat make_throat(const Facet &f)
{
  Throat t;
  t.facet = t.area = 0.5 * norm(cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]));
  t.length = f.height[0] + f.height[1];
  double fluid = t.facet * t.length / 3.0, wetted = 0.0;
  for (int n = 0; n < 3; n++) {
    const Vec3 to_next = f.corner[(n + 1) % 3] - f.corner[n],
               to_last = f.corner[(n + 2) % 3] - f.corner[n];
    const double r = f.radius[n], square = r * r;
    t.area -= 0.5 * square * std::atan2(norm(cross(to_next, to_last)), dot(to_next, to_last));
    // a power center on the other side takes away what the other one has too much
    double angle = 0.0;
    for (int side = 0; side < 2; side++)
      angle += std::copysign(solid_angle(to_next, to_last, f.center[side] - f.corner[n]),
                             f.height[side]);
    fluid -= angle * square * r / 3.0;
    wetted += angle * square;
  }
  t.radius = wetted > 0.0 ? fluid / wetted : 0.0;
  return t;
}

// Bounds of a throat, over the mean radius of its spheres. Two power centers that meet are a single
// pore with a flat facet through it: a length up to the least changes the permeability of a packing
// by 0.3 %. The least conductance is that of a facet that overlaps close; three
// spheres that touch leave about a hundred times as much.
static constexpr double LEAST_LENGTH = 0.1, LEAST_CONDUCTANCE = 1e-5;

// length^3, over the viscosity
inline double conductance(const Throat &t, double mean_radius)
{
  const double least = LEAST_CONDUCTANCE * mean_radius * mean_radius * mean_radius;
  if (!(t.area > 0.0) || !(t.radius > 0.0)) return least;
  return std::fmax(
      least, 0.5 * t.area * t.radius * t.radius / std::fmax(t.length, LEAST_LENGTH * mean_radius));
}

// length^2: of the facet, for a gradient along the throat
inline double throat_permeability(const Throat &t)
{
  if (!(t.area > 0.0) || !(t.radius > 0.0)) return 0.0;
  return t.area * t.radius * t.radius / (2.0 * t.facet);
}

// The factor of the conductances at the volume fraction phi with which the network has the
// permeability of direct solutions of the flow: own fit to packings of spheres, phi 0.4 to 0.6.
inline double network_alpha(double phi)
{
  return 1.55 * std::pow(phi, 1.25);
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
