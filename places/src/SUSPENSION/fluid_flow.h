/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Background flows towards which particles are dragged: velocity and spin, half of the vorticity.

#ifndef LMP_FLUID_FLOW_H
#define LMP_FLUID_FLOW_H

#include "lubcontact_defs.h"
#include "lubcontact_vec3.h"

namespace LAMMPS_NS::Fluid_NS {

using Lubcontact_NS::Vec3;

struct Flow {
  Vec3 velocity;
  Vec3 spin;
};

// Along x, with its gradient along y.
LUBCONTACT_FN inline Flow shear_flow(double rate, double y)
{
  return {{rate * y, 0.0, 0.0}, {0.0, 0.0, -0.5 * rate}};
}

// Between two plates that move along x; beyond, the fluid moves with them.
struct Couette {
  double low, v_low, high, v_high;
};

LUBCONTACT_FN inline Flow couette_flow(const Couette &c, double y)
{
  if (y <= c.low) return {{c.v_low, 0.0, 0.0}, {}};
  if (y >= c.high) return {{c.v_high, 0.0, 0.0}, {}};
  const double rate = (c.v_high - c.v_low) / (c.high - c.low);
  return {{c.v_low + rate * (y - c.low), 0.0, 0.0}, {0.0, 0.0, -0.5 * rate}};
}

// Between two walls at rest, with v_most in the middle; beyond, at rest.
struct Poiseuille {
  double low, high, v_most;
};

LUBCONTACT_FN inline Flow poiseuille_flow(const Poiseuille &p, double y)
{
  if (y <= p.low || y >= p.high) return {};
  const double scale = 4.0 * p.v_most / ((p.high - p.low) * (p.high - p.low));
  const double rate = scale * (p.high + p.low - 2.0 * y);
  return {{scale * (y - p.low) * (p.high - y), 0.0, 0.0}, {0.0, 0.0, -0.5 * rate}};
}

// Of a cell with edges (xx,0,0), (xy,yy,0), (xz,yz,zz) that change at a constant velocity, in the
// order xx yy zz yz xz xy: a point that keeps its place in the cell moves with
// rate_of_cell cell^-1 (x - low) + low_rate, for ever the same. So do its periodic images.
LUBCONTACT_FN inline Flow cell_flow(const double *rate, const double *inverse, const Vec3 &x,
                                    const Vec3 &low, const Vec3 &low_rate)
{
  const Vec3 d = x - low;
  const Vec3 place{inverse[0] * d.x + inverse[5] * d.y + inverse[4] * d.z,
                   inverse[1] * d.y + inverse[3] * d.z, inverse[2] * d.z};
  const Vec3 v{rate[0] * place.x + rate[5] * place.y + rate[4] * place.z,
               rate[1] * place.y + rate[3] * place.z, rate[2] * place.z};
  // the velocity gradient is upper triangular, too
  const double xy = rate[0] * inverse[5] + rate[5] * inverse[1];
  const double yz = rate[1] * inverse[3] + rate[3] * inverse[2];
  const double xz = rate[0] * inverse[4] + rate[5] * inverse[3] + rate[4] * inverse[2];
  return {v + low_rate, {-0.5 * yz, 0.5 * xz, -0.5 * xy}};
}

}    // namespace LAMMPS_NS::Fluid_NS

#endif
