/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Bins of the direction of a pair, on the circle in a plane or on the sphere. A pair has no head: n
// and -n are the same, and the bins cover the half in which the azimuth is in [0, pi).
// W. Chevremont, thesis (2020), sec. 3.3, where the polar axis is that of the gradient; here it is
// the normal of the plane, and the bins are uniform in the cosine of the polar angle, so that all
// of them have the same solid angle.

#ifndef LUBCONTACT_ORIENTATION_H
#define LUBCONTACT_ORIENTATION_H

#include "lubcontact_defs.h"
#include "lubcontact_vec3.h"

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

enum class Plane { XY, XZ, YZ };

struct Direction {
  double azimuth;    // in the plane, from its first axis towards its second, [0, pi)
  double height;     // component along the normal of the plane, -1 to 1
};

inline Direction direction(Plane plane, const Vec3 &n)
{
  const double first = plane == Plane::YZ ? n.y : n.x;
  const double second = plane == Plane::XY ? n.y : n.z;
  double height = plane == Plane::XY ? n.z : (plane == Plane::XZ ? n.y : n.x);
  double azimuth = std::atan2(second, first);
  if (azimuth < 0.0) {
    azimuth += PI;
    height = -height;
  }
  if (azimuth >= PI) {    // on the first axis, or by rounding
    azimuth = 0.0;
    height = -height;
  }
  return {azimuth, height};
}

struct DirectionBins {
  Plane plane;
  int heights;     // bins in the cosine of the polar angle; 1 for the circle
  int azimuths;    // bins in the azimuth
  double band;     // directions with |height| <= band count

  int size() const { return heights * azimuths; }

  // row of n, or -1 outside of the band
  int find(const Vec3 &n) const
  {
    const Direction d = direction(plane, n);
    if (std::fabs(d.height) > band) return -1;
    int a = static_cast<int>(d.azimuth / PI * azimuths);
    int h = static_cast<int>(0.5 * (d.height + 1.0) * heights);
    if (a >= azimuths) a = azimuths - 1;
    if (h < 0) h = 0;
    if (h >= heights) h = heights - 1;
    return h * azimuths + a;
  }

  // center of a row
  double azimuth(int row) const { return (row % azimuths + 0.5) * PI / azimuths; }
  double polar_angle(int row) const
  {
    return std::acos(2.0 * (row / azimuths + 0.5) / heights - 1.0);
  }

  // both ends of the pairs in a row: angle on the circle, solid angle on the sphere. The integral
  // of sum/measure over the whole circle or sphere is the sum over all pairs.
  double measure_circle() const { return 2.0 * PI / size(); }
  double measure_sphere() const { return 4.0 * PI / size(); }
};

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
