// Shared by the tests of the network of pores: a body-centered lattice of spheres with known pores.

#ifndef KERNEL_NETWORK_CASE_H
#define KERNEL_NETWORK_CASE_H

#include "pore_network_flow.h"
#include "tools.h"

namespace network_case {

using namespace LAMMPS_NS::Pore_NS;
using testing_tools::Random;

struct Lattice {
  CellEdges cell;
  std::vector<Vec3> x;
  std::vector<double> radius, inverse_mass;
  std::vector<Pore> pores;
  double volume;
  Network net;
  std::vector<double> positive;    // as their volumes
  std::vector<Vec3> centers;
  Flow flow;

  // the network of these positions
  void shape()
  {
    flow.shape.clear();
    centers.clear();
    for (std::size_t i = 0; i < net.pores.size(); i++) {
      flow.shape.push_back(shape_of(net.pores[i], positive[i], x, cell));
      centers.push_back(center_of(net.pores[i], x, radius, cell));
    }
  }
  double edge_volume() const { return dot(cell.edge[0], cross(cell.edge[1], cell.edge[2])); }
};

// m^3 cubes of edge 1 with touching spheres at their corners and centers; each pore has two of both
// kinds. Positions and radii are off by up to jitter, the cell is tilted. m > 1
inline Lattice make_lattice(int m, Random &rnd, double jitter = 0.0, double tilt = 0.0)
{
  Lattice s;
  const double edge = m;
  s.cell = {{{edge, 0.0, 0.0}, {tilt * edge, edge, 0.0}, {0.0, 0.5 * tilt * edge, edge}}};
  auto particle = [m](int kind, int i, int j, int k) {
    Corner c;
    const int at[3] = {i, j, k};
    int index = 0;
    for (int d = 0; d < 3; d++) {
      c.image[d] = (at[d] + m) / m - 1;
      index = index * m + at[d] - m * c.image[d];
    }
    c.particle = 2 * index + kind;
    return c;
  };
  s.x.resize(2 * m * m * m);
  for (int i = 0; i < m; i++)
    for (int j = 0; j < m; j++)
      for (int k = 0; k < m; k++)
        for (int kind = 0; kind < 2; kind++) {
          const double a = (i + 0.5 * kind) / m, b = (j + 0.5 * kind) / m, c = (k + 0.5 * kind) / m;
          s.x[particle(kind, i, j, k).particle] =
              a * s.cell.edge[0] + b * s.cell.edge[1] + c * s.cell.edge[2] + rnd.vector(jitter);
        }
  for (std::size_t k = 0; k < s.x.size(); k++) {
    s.radius.push_back(0.25 * std::sqrt(3.0) * (1.0 - jitter * rnd.uniform(0.0, 1.0)));
    s.inverse_mass.push_back(rnd.uniform(0.5, 1.5));
  }
  // around each edge of the cubes are four centers, of which two neighbors make a pore
  static const int around[5][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
  for (int i = 0; i < m; i++)
    for (int j = 0; j < m; j++)
      for (int k = 0; k < m; k++)
        for (int d = 0; d < 3; d++)
          for (int n = 0; n < 4; n++) {
            Corner c[4];
            int at[3] = {i, j, k};
            c[0] = particle(0, i, j, k);
            at[d]++;
            c[1] = particle(0, at[0], at[1], at[2]);
            for (int end = 0; end < 2; end++) {
              int center[3] = {i, j, k};
              center[(d + 1) % 3] += around[n + end][0];
              center[(d + 2) % 3] += around[n + end][1];
              c[2 + end] = particle(1, center[0], center[1], center[2]);
            }
            s.pores.push_back(canonical(Pore{c[0], c[1], c[2], c[3]}));
          }
  connect(s.pores, static_cast<int>(s.x.size()), s.net);
  for (const Pore &pore : s.net.pores)
    s.positive.push_back(std::copysign(1.0, tetrahedron_volume(corners_of(pore, s.x, s.cell))));
  s.shape();
  for (const Link &link : s.net.links)
    s.flow.g.push_back(conductance_of(
        s.net, link, throat_of(s.net, link, s.x, s.radius, s.cell, s.centers), s.radius));
  return s;
}

inline std::vector<double> random_pressure(Random &rnd, const Lattice &s)
{
  std::vector<double> p(s.net.pores.size());
  for (double &value : p) value = rnd.uniform(-1.0, 1.0);
  return p;
}

inline std::vector<Vec3> forces(const Lattice &s, const std::vector<double> &p)
{
  std::vector<Vec3> f;
  for (std::size_t k = 0; k < s.x.size(); k++)
    f.push_back(pore_force(s.net, s.flow, p, static_cast<int>(k)));
  return f;
}

}    // namespace network_case

#endif
