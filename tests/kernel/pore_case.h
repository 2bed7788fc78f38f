// Shared by the tests of the pore pressure: random spheres, and a grid with them on one rank.

#ifndef KERNEL_PORE_CASE_H
#define KERNEL_PORE_CASE_H

#include "pore_step.h"
#include "tools.h"

#include <vector>

namespace pore_case {

using namespace LAMMPS_NS::Pore_NS;
using testing_tools::Random;

struct Bed {
  std::vector<Vec3> x;
  std::vector<double> radius;

  std::size_t size() const { return x.size(); }
  double volume(std::size_t i) const
  {
    return 4.0 / 3.0 * testing_tools::PI_ * radius[i] * radius[i] * radius[i];
  }
};

// difference of two points: to the nearest image, along y only if it is periodic
inline Vec3 difference(const Cell &c, bool plates, const Vec3 &a, const Vec3 &b)
{
  Vec3 d = a - b;
  d = d - std::round(d.z / c.zprd) * Vec3{c.xz, c.yz, c.zprd};
  if (!plates) d = d - std::round(d.y / c.yprd) * Vec3{c.xy, c.yprd, 0.0};
  return d - std::round(d.x / c.xprd) * Vec3{c.xprd, 0.0, 0.0};
}

// n spheres with radii of 0.5 (1 +- spread) at random, pushed apart from each other and from the
// plates
inline Bed random_bed(Random &rnd, int n, double spread, const Cell &c, bool plates,
                      int sweeps = 200)
{
  Bed bed;
  for (int i = 0; i < n; i++) {
    const double x = rnd.uniform(0.0, 1.0), y = rnd.uniform(0.0, 1.0), z = rnd.uniform(0.0, 1.0);
    bed.x.push_back(c.origin +
                    Vec3{x * c.xprd + y * c.xy + z * c.xz, y * c.yprd + z * c.yz, z * c.zprd});
    bed.radius.push_back(0.5 * (1.0 + spread * rnd.uniform(-1.0, 1.0)));
  }
  for (int sweep = 0; sweep < sweeps; sweep++) {
    for (std::size_t i = 0; i < bed.size(); i++)
      for (std::size_t j = 0; j < i; j++) {
        const Vec3 d = difference(c, plates, bed.x[i], bed.x[j]);
        const double reach = bed.radius[i] + bed.radius[j], square = dot(d, d);
        if (square >= reach * reach) continue;
        const double r = std::sqrt(square);
        const Vec3 push = (0.5 * (reach - r) / r) * d;
        bed.x[i] = bed.x[i] + push;
        bed.x[j] = bed.x[j] - push;
      }
    if (!plates) continue;
    for (std::size_t i = 0; i < bed.size(); i++) {
      const double from = bed.x[i].y - c.origin.y, a = bed.radius[i];
      if (from < a) bed.x[i].y += a - from;
      if (from > c.yprd - a) bed.x[i].y -= from - (c.yprd - a);
    }
  }
  return bed;
}

// a cell that n spheres of radius 0.5 fill to phi, with these edges over one another
inline Cell filled_cell(int n, double phi, const Vec3 &edges, double xy, double xz, double yz)
{
  const double unit = std::cbrt(n * testing_tools::PI_ / (6.0 * phi * edges.x * edges.y * edges.z));
  Cell c;
  c.origin = {-1.3, 0.7, 2.1};
  c.xprd = unit * edges.x;
  c.yprd = unit * edges.y;
  c.zprd = unit * edges.z;
  c.xy = xy * c.yprd;
  c.xz = xz * c.zprd;
  c.yz = yz * c.zprd;
  return c;
}

// elements of about this size
inline Grid grid_of(const Cell &c, double h, Wall lower, Wall upper)
{
  const auto count = [h](double length) {
    return std::max(1, static_cast<int>(std::round(length / h)));
  };
  Grid g;
  g.nx = count(c.xprd);
  g.ny = count(c.yprd);
  g.nz = count(c.zprd);
  g.lower = lower;
  g.upper = upper;
  g.cell = c;
  return g;
}

// f(element, row, column, offset from its center) for all that a particle reaches
template <class F> void for_each_reached(const Grid &g, const Vec3 &x, const F &f)
{
  const Reached at = reached(g, metric(g), x);
  for (int r = 0; r < 9; r++)
    for (int a = 0; a < 3; a++)
      f(at.element(r, a), r, a, Vec3{at.x.offset[a], at.y.offset[r / 3], at.z.offset[r % 3]});
}

// phases 1 and 2 of a step
struct Pores {
  Grid grid;
  Permeability law;
  double viscosity;
  std::vector<Moments> moments;
  std::vector<Element> elements;
  std::vector<Stencil> stencils;
  std::vector<double> mobility;
  ElementMatrix matrix;

  Pores(const Grid &g, const Permeability &permeability_law, double eta, const Bed &bed) :
      grid(g), law(permeability_law), viscosity(eta), moments(g.elements())
  {
    const Metric m = metric(grid);
    for (std::size_t i = 0; i < bed.size(); i++)
      add_moments(grid, m, bed.x[i], inside(bed, i) * bed.volume(i),
                  inside(bed, i) * bed.radius[i] * bed.radius[i], moments.data());
    elements = make_elements(grid, law, moments);
    for (std::size_t i = 0; i < bed.size(); i++)
      stencils.push_back(make_stencil(grid, m, elements, bed.x[i], inside(bed, i) * bed.volume(i)));
    mobility = mobilities(elements, viscosity);
    matrix = element_matrix(grid);
  }

  double inside(const Bed &bed, std::size_t i) const
  {
    return part_inside(grid, bed.x[i].y, bed.radius[i]);
  }
  std::vector<Motion> motion(const std::vector<Vec3> &v) const
  {
    std::vector<Motion> sums(grid.elements());
    for (std::size_t i = 0; i < v.size(); i++) add_motion(stencils[i], {v[i]}, sums.data());
    return sums;
  }
  std::vector<double> bounds(const std::vector<double> &inverse_mass) const
  {
    std::vector<double> sums(grid.elements());
    for (std::size_t i = 0; i < inverse_mass.size(); i++)
      add_bound(stencils[i], inverse_mass[i], grid.element_volume(), sums.data());
    return sums;
  }
  std::vector<Vec3> forces(const Field &p, const Vec3 &mean = {}) const
  {
    const std::vector<Lanes> g = gradients(grid, p, mean);
    std::vector<Vec3> f;
    for (const Stencil &s : stencils) f.push_back(pore_force(s, grid.element_volume(), g));
    return f;
  }
  Field darcy(const Field &p) const
  {
    Field y;
    apply_darcy(grid, matrix, mobility, p, y);
    return y;
  }
};

inline Field random_field(Random &rnd, const Grid &g)
{
  Field p(g.nodes());
  for (double &value : p) value = rnd.uniform(-1.0, 1.0);
  return p;
}

inline double largest_size(const Field &p)
{
  double most = 0.0;
  for (double value : p)
    if (!(std::fabs(value) <= most)) most = std::fabs(value);    // what is not a number stays, too
  return most;
}

// the five pairs of boundaries
struct Sides {
  Wall lower, upper;
};
static constexpr Sides SIDES[] = {{Wall::PERIODIC, Wall::PERIODIC},
                                  {Wall::IMPERMEABLE, Wall::DRAINED},
                                  {Wall::DRAINED, Wall::IMPERMEABLE},
                                  {Wall::DRAINED, Wall::DRAINED},
                                  {Wall::IMPERMEABLE, Wall::IMPERMEABLE}};

}    // namespace pore_case

#endif
