/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Flow between the pores of a network, and what it does to the particles:
//   K p = -D v,   F = D^T p
// (K p)_i is the sum of conductance * (p_i - p_j) over the throats of pore i, (D v)_i the rate at
// which the motion of its corners changes its volume. Each row of the volume's gradient adds up to
// zero, so that F does; F.v = -p K p. A motion that is linear in the position and keeps the volume
// of the cell changes the volume of no pore.
// A step is that of pore_step.h with P = A = K + dt D M^-1 D^T + S V/dt: backward Euler, whose
// result depends on the pressure before only by what is stored.
// Rows are summed in one order whoever does it.

#ifndef LMP_PORE_NETWORK_FLOW_H
#define LMP_PORE_NETWORK_FLOW_H

#include "pore_network.h"

namespace LAMMPS_NS::Pore_NS {

struct CellEdges {
  Vec3 edge[3];
};

inline Vec3 shift(const CellEdges &cell, const Image &n)
{
  return n[0] * cell.edge[0] + n[1] * cell.edge[1] + n[2] * cell.edge[2];
}

// Its corners; with the last two exchanged, the volume changes its sign.
inline Tetrahedron corners_of(const Pore &pore, const std::vector<Vec3> &x, const CellEdges &cell)
{
  Tetrahedron t;
  for (int n = 0; n < 4; n++) t[n] = x[pore[n].particle] + shift(cell, pore[n].image);
  return t;
}

struct PoreShape {
  double volume = 0.0;
  std::array<Vec3, 4> gradient;    // of the volume, by corners
};

// positive: +1 or -1, the sign of its volume when it was made
inline PoreShape shape_of(const Pore &pore, double positive, const std::vector<Vec3> &x,
                          const CellEdges &cell)
{
  const Tetrahedron t = corners_of(pore, x, cell);
  PoreShape s;
  s.volume = positive * tetrahedron_volume(t);
  s.gradient = volume_gradient(t);
  for (Vec3 &g : s.gradient) g = positive * g;
  return s;
}

inline Vec3 center_of(const Pore &pore, const std::vector<Vec3> &x,
                      const std::vector<double> &radius, const CellEdges &cell)
{
  std::array<double, 4> r;
  for (int n = 0; n < 4; n++) r[n] = radius[pore[n].particle];
  return power_center(corners_of(pore, x, cell), r);
}

// of the power center over the facet opposite to a corner, positive if it is on the corner's side.
// All pores have a positive volume.
inline double height_of(const Tetrahedron &t, int corner, const Vec3 &center)
{
  const Vec3 &a = t[(corner + 1) % 4], &b = t[(corner + 2) % 4], &c = t[(corner + 3) % 4];
  const Vec3 normal = cross(b - a, c - a);
  const double side = dot(normal, t[corner] - a);
  return std::copysign(dot(normal, center - a) / norm(normal), side * dot(normal, center - a));
}

// On a hull: from the power center to the facet; as if it were on the inner side.
inline Throat hull_throat(const Pore &pore, int corner, const std::vector<Vec3> &x,
                          const std::vector<double> &radius, const CellEdges &cell,
                          const Vec3 &center)
{
  Facet f;
  const auto corners = facet_opposite(pore, corner);
  for (int n = 0; n < 3; n++) {
    f.corner[n] = x[corners[n].particle] + shift(cell, corners[n].image);
    f.radius[n] = radius[corners[n].particle];
  }
  const Vec3 normal = cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]);
  const double out = dot(normal, center - f.corner[0]) / dot(normal, normal);
  f.center[0] = center;
  f.center[1] = center - out * normal;
  f.height[0] = std::fabs(out) * norm(normal);
  f.height[1] = 0.0;
  return make_throat(f);
}

inline Throat throat_of(const Network &net, const Link &link, const std::vector<Vec3> &x,
                        const std::vector<double> &radius, const CellEdges &cell,
                        const std::vector<Vec3> &centers)
{
  const Pore &a = net.pores[link.pore[0]], &b = net.pores[link.pore[1]];
  Facet f;
  const auto corners = facet_opposite(a, link.opposite[0]);
  for (int n = 0; n < 3; n++) {
    f.corner[n] = x[corners[n].particle] + shift(cell, corners[n].image);
    f.radius[n] = radius[corners[n].particle];
  }
  const Vec3 away = shift(cell, link.image);
  f.center[0] = centers[link.pore[0]];
  f.center[1] = centers[link.pore[1]] + away;
  f.height[0] = height_of(corners_of(a, x, cell), link.opposite[0], f.center[0]);
  f.height[1] = height_of(corners_of(b, x, cell), link.opposite[1], centers[link.pore[1]]);
  return make_throat(f);
}

// length^3, over the viscosity: of a throat through the facet opposite to a corner
inline double conductance_of(const Throat &throat, const Pore &pore, int corner,
                             const std::vector<double> &radius)
{
  double sum = 0.0;
  for (const Corner &c : facet_opposite(pore, corner)) sum += radius[c.particle];
  return conductance(throat, sum / 3.0);
}

inline double conductance_of(const Network &net, const Link &link, const Throat &throat,
                             const std::vector<double> &radius)
{
  return conductance_of(throat, net.pores[link.pore[0]], link.opposite[0], radius);
}

// ---- the matrices, row by row

struct Flow {
  std::vector<PoreShape> shape;    // of each pore
  std::vector<double> g;           // conductance of each link: volume/time over pressure
  std::vector<double> drain;       // of each pore to the fluid outside; empty: there is none
};

// pressure at the other end of a link, seen from a pore
inline int beyond(const Link &link, int pore)
{
  return link.pore[0] == pore ? link.pore[1] : link.pore[0];
}

// (K p)_i
inline double outflow(const Network &net, const Flow &flow, const std::vector<double> &p, int i)
{
  double sum = 0.0;
  for (const int n : net.link_of[i])
    if (n >= 0) sum += flow.g[n] * (p[i] - p[beyond(net.links[n], i)]);
  return sum + (flow.drain.empty() ? 0.0 : flow.drain[i] * p[i]);
}

// (D v)_i
inline double growth(const Network &net, const Flow &flow, const std::vector<Vec3> &v, int i)
{
  double sum = 0.0;
  for (int n = 0; n < 4; n++) sum += dot(flow.shape[i].gradient[n], v[net.pores[i][n].particle]);
  return sum;
}

// (D^T p)_k
inline Vec3 pore_force(const Network &net, const Flow &flow, const std::vector<double> &p, int k)
{
  Vec3 sum;
  for (int n = net.first[k]; n < net.first[k + 1]; n++)
    sum = sum + p[net.at[n].pore] * flow.shape[net.at[n].pore].gradient[net.at[n].corner];
  return sum;
}

// The same in the order in which the iterations read it: A by rows, storage S/dt included.
struct ImplicitMatrix {
  struct Row {
    std::array<int, 4> neighbor, particle;
    std::array<double, 4> g;
    std::array<Vec3, 4> gradient;
    double stored, diagonal;    // the former with what leaves to the outside
  };
  struct Entry {
    int pore;
    Vec3 gradient;    // over the mass
  };
  double dt = 0.0;    // 0: A = K and what is stored
  std::vector<Row> rows;
  std::vector<int> first;
  std::vector<Entry> entries;    // of D^T: by particles
};

inline ImplicitMatrix implicit_matrix(const Network &net, const Flow &flow, double dt,
                                      double storage, const std::vector<double> &inverse_mass)
{
  ImplicitMatrix a;
  a.dt = dt;
  a.rows.resize(net.pores.size());
  for (int i = 0; i < static_cast<int>(net.pores.size()); i++) {
    ImplicitMatrix::Row &row = a.rows[i];
    row.stored = storage * flow.shape[i].volume + (flow.drain.empty() ? 0.0 : flow.drain[i]);
    row.diagonal = row.stored;
    row.gradient = flow.shape[i].gradient;
    for (int n = 0; n < 4; n++) {
      const int link = net.link_of[i][n];
      row.neighbor[n] = link < 0 ? i : beyond(net.links[link], i);
      row.g[n] = link < 0 ? 0.0 : flow.g[link];
      row.particle[n] = net.pores[i][n].particle;
      row.diagonal +=
          row.g[n] + dt * inverse_mass[row.particle[n]] * dot(row.gradient[n], row.gradient[n]);
    }
  }
  a.first = net.first;
  for (int k = 0; k + 1 < static_cast<int>(net.first.size()); k++)
    for (int n = net.first[k]; n < net.first[k + 1]; n++)
      a.entries.push_back(
          {net.at[n].pore,
           inverse_mass[k] * flow.shape[net.at[n].pore].gradient[net.at[n].corner]});
  return a;
}

// D^T p/m of particle k
inline Vec3 acceleration_of(const ImplicitMatrix &a, const std::vector<double> &p, int k)
{
  Vec3 sum;
  for (int n = a.first[k]; n < a.first[k + 1]; n++)
    sum = sum + p[a.entries[n].pore] * a.entries[n].gradient;
  return sum;
}

// (A p)_i, with the accelerations of the particles
inline double implicit_row(const ImplicitMatrix &a, const std::vector<double> &p,
                           const std::vector<Vec3> &acceleration, int i)
{
  const ImplicitMatrix::Row &row = a.rows[i];
  double flux = 0.0, change = 0.0;
  for (int n = 0; n < 4; n++) flux += row.g[n] * (p[i] - p[row.neighbor[n]]);
  if (a.dt > 0.0)
    for (int n = 0; n < 4; n++) change += dot(row.gradient[n], acceleration[row.particle[n]]);
  return flux + row.stored * p[i] + a.dt * change;
}

// What of the integral of a pressure particle k stands for: a quarter of each of its pores, as a
// linear function of the corners has it. Their sum is the integral, their first moment that of it.
inline double share_of(const Network &net, const Flow &flow, const std::vector<double> &p, int k)
{
  double sum = 0.0;
  for (int n = net.first[k]; n < net.first[k + 1]; n++)
    sum += 0.25 * flow.shape[net.at[n].pore].volume * p[net.at[n].pore];
  return sum;
}

// ---- a mean gradient of the pressure, beside that of p

// what it adds from the first pore of a link to the second
inline double rise_of(const Link &link, const std::vector<Vec3> &centers, const CellEdges &cell,
                      const Vec3 &gradient)
{
  return dot(gradient, centers[link.pore[1]] + shift(cell, link.image) - centers[link.pore[0]]);
}

// area of the facet opposite to a corner, out of the pore
inline Vec3 area_of(const PoreShape &shape, int corner)
{
  return -3.0 * shape.gradient[corner];
}

// of the facet of a link, from its first pore into its second
inline Vec3 area_of(const Flow &flow, const Link &link)
{
  return area_of(flow.shape[link.pore[0]], link.opposite[0]);
}

// ---- what there is to know

// power that turns into heat; rises: rise_of() each link
inline double network_dissipation(const Network &net, const Flow &flow,
                                  const std::vector<double> &p, const std::vector<double> &rises)
{
  double power = 0.0;
  for (std::size_t n = 0; n < net.links.size(); n++) {
    const Link &link = net.links[n];
    const double rise = p[link.pore[1]] - p[link.pore[0]] + rises[n];
    power += flow.g[n] * rise * rise;
  }
  return power;
}

// Step up to which explicit coupling is stable for sure. |F_k|^2 is at most the sum of g (p_i -
// p_j)^2 over the facets of k, times that of area^2/(9 g).
inline double network_explicit_step(const Network &net, const Flow &flow,
                                    const std::vector<double> &inverse_mass)
{
  std::vector<double> of_particle(inverse_mass.size(), 0.0);
  auto each_corner = [&net](const Link &link, const auto &visit) {
    for (const Corner &c : facet_opposite(net.pores[link.pore[0]], link.opposite[0]))
      visit(c.particle);
  };
  for (std::size_t n = 0; n < net.links.size(); n++) {
    const Vec3 area = area_of(flow, net.links[n]);
    each_corner(net.links[n], [&](int k) {
      of_particle[k] += inverse_mass[k] * dot(area, area) / (9.0 * flow.g[n]);
    });
  }
  double rate = 0.0;
  for (const Link &link : net.links) {
    double sum = 0.0;
    each_corner(link, [&](int k) {
      sum += of_particle[k];
    });
    rate = std::fmax(rate, sum);
  }
  return 2.0 / rate;
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
