/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Homogeneous flow of a periodic cell: u = G (x - lo), lo the fixed lower corner.
//
// In a step the cell h goes to (1 + dt G) h. A particle that takes part in the flow keeps its
// place lambda = h^-1 (x - lo) in the cell, so its velocity is dh/dt lambda, before and after a
// change of G. What a change adds to the velocity at x is therefore
//   K (x - lo),   K = G1 - G0 (1 + dt G0)^-1,
// the discrete form of (dG/dt + G^2) x: without it momentum would have to diffuse in from the
// boundary.

#ifndef LMP_RHEOMETER_FLOW_H
#define LMP_RHEOMETER_FLOW_H

#include <cmath>

namespace LAMMPS_NS::Rheometer_NS {

enum Flow { SHEAR, PLANAR, UNIAXIAL };

// velocity gradient in 1/time; all other components are zero
struct Gradient {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0;
};

// edges (lx,0,0), (xy,ly,0), (0,0,lz) of the cell
struct Cell {
  double lx, ly, lz, xy;
};

// relative change of the cell in one step, over dt; exp() keeps the volume of a volume-conserving
// flow
inline double per_step(double rate, double dt)
{
  return std::expm1(rate * dt) / dt;
}

// rate: of shear dvx/dy, or of extension dvx/dx; dilation: d ln V/dt, which a shear flow takes from
// y alone and an extension equally from all directions
inline Gradient gradient(Flow flow, int dimension, double rate, double dilation, double dt)
{
  const double all = dilation / dimension;
  const double z = dimension == 3 ? 1.0 : 0.0;
  switch (flow) {
    case PLANAR:
      return {per_step(rate + all, dt), per_step(all - rate, dt), z * per_step(all, dt), 0.0};
    case UNIAXIAL:
      return {per_step(rate + all, dt), per_step(all - 0.5 * rate, dt),
              per_step(all - 0.5 * rate, dt), 0.0};
    default:
      return {0.0, per_step(dilation, dt), 0.0, rate};
  }
}

inline Gradient minus(const Gradient &p, const Gradient &q)
{
  return {p.xx - q.xx, p.yy - q.yy, p.zz - q.zz, p.xy - q.xy};
}

// what the flow g of a step looks like at its end: G (1 + dt G)^-1
inline Gradient at_end(const Gradient &g, double dt)
{
  const double xx = 1.0 + dt * g.xx, yy = 1.0 + dt * g.yy;
  return {g.xx / xx, g.yy / yy, g.zz / (1.0 + dt * g.zz), g.xy / (xx * yy)};
}

// K above
inline Gradient change(const Gradient &before, const Gradient &after, double dt)
{
  return minus(after, at_end(before, dt));
}

// dh/dt = G h
inline Cell cell_rate(const Gradient &g, const Cell &h)
{
  return {g.xx * h.lx, g.yy * h.ly, g.zz * h.lz, g.xx * h.xy + g.xy * h.ly};
}

inline Cell advance(const Cell &h, const Cell &rate, double dt)
{
  return {h.lx + dt * rate.lx, h.ly + dt * rate.ly, h.lz + dt * rate.lz, h.xy + dt * rate.xy};
}

// What a cell does, numbers only: restart files hold it as it is.
struct CellMotion {
  double strain = 0.0, path = 0.0;    // sums of the rate and of its amount over time
  double time = 0.0;                  // since an oscillation began
  double rate = 0.0, dilation = 0.0;
  Gradient gradient;                           // when the flow was last adjusted
  Cell rate_of_cell = {0.0, 0.0, 0.0, 0.0};    // and the change of the cell per time since then
  double moved = 0.0;                          // time since then
};

inline void pass(CellMotion &m, double dt)
{
  m.strain += m.rate * dt;
  m.path += std::fabs(m.rate) * dt;
  m.time += dt;
  m.moved += dt;
}

// how many edges (lx,0,0) to add to the second edge so that its tilt is at most half an edge
inline int flips(const Cell &h)
{
  if (h.xy > 0.5 * h.lx) return -1;
  if (h.xy < -0.5 * h.lx) return 1;
  return 0;
}

// stress in 3 normal and 1 shear components, tension positive
struct Stress {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0;
};

// pressure that the dilation of the flow works against; compression positive
inline double pressure(Flow flow, int dimension, const Stress &s)
{
  if (flow == SHEAR) return -s.yy;
  return -(s.xx + s.yy + (dimension == 3 ? s.zz : 0.0)) / dimension;
}

// stress that drives the flow: shear stress, or difference of the normal stresses
inline double driving_stress(Flow flow, const Stress &s)
{
  switch (flow) {
    case PLANAR:
      return s.xx - s.yy;
    case UNIAXIAL:
      return s.xx - 0.5 * (s.yy + s.zz);
    default:
      return s.xy;
  }
}

// driving stress of a Newtonian fluid over viscosity*rate: 1, and Trouton's 4 and 3
inline double trouton_ratio(Flow flow)
{
  return flow == PLANAR ? 4.0 : flow == UNIAXIAL ? 3.0 : 1.0;
}

// mean rate of g0 + g1 cos(w t) from t to t + dt: its strain is exact
inline double oscillation_rate(double g0, double g1, double w, double t, double dt)
{
  const double half = 0.5 * w * dt;
  const double sinc = half == 0.0 ? 1.0 : std::sin(half) / half;
  return g0 + g1 * std::cos(w * (t + 0.5 * dt)) * sinc;
}

}    // namespace LAMMPS_NS::Rheometer_NS

#endif
