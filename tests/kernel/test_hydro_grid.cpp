// Gaussians on the points of a deformed cell.

#include "hydro_case.h"

using namespace hydro_case;
using testing_tools::expect_near;

namespace {

Lattice tilted_lattice()
{
  Lattice l;
  l.cell = {{0.3, -1.0, 2.0}, 7.0, 6.0, 8.0, 2.5, -1.5, 2.0};
  l.nx = 16;
  l.ny = 14;
  l.nz = 18;
  l.width = 0.8;
  l.reach = 8.0 * l.width;
  return l;
}

Vec3 point(const Lattice &l, int i, int j, int k)
{
  const Cell &c = l.cell;
  const double x = static_cast<double>(i) / l.nx, y = static_cast<double>(j) / l.ny,
               z = static_cast<double>(k) / l.nz;
  return c.origin + Vec3{x * c.xprd + y * c.xy + z * c.xz, y * c.yprd + z * c.yz, z * c.zprd};
}

template <class F> void for_each_point(const Brick &b, F &&f)
{
  for (int k = b.low[2]; k < b.low[2] + b.size[2]; k++)
    for (int j = b.low[1]; j < b.low[1] + b.size[1]; j++)
      for (int i = b.low[0]; i < b.low[0] + b.size[0]; i++) f(i, j, k);
}

Load some_load(Random &rnd)
{
  double n[NUMBERS];
  for (double &value : n) value = rnd.uniform(-1.0, 1.0);
  return get_load(n);
}

Stencils stencil(const Lattice &l, const Brick &b, const Vec3 &center)
{
  Stencils s;
  s.start(l, b);
  s.add(center);
  return s;
}

// each point within reach once, with its own exponential; beyond it the same or nothing
TEST(HydroGrid, StencilIsTheGaussianAtAllPointsWithinReach)
{
  Random rnd(11);
  for (int trial = 0; trial < 8; trial++) {
    Lattice l = tilted_lattice();
    if (trial % 2) l.cell.xz = l.cell.yz = 0.0;
    if (trial > 5) l.reach = 3.0 * l.width;
    const Vec3 center = rnd.vector(9.0), g = lattice_place(l, center);
    const Brick b = brick_for(l, g, g);
    const Stencils s = stencil(l, b, center);
    std::vector<double> found(b.points() + Stencils::PADDING);
    for_each_eight(s, 0, {{}, 0.0, 0.0},
                   [&](int n, double, double, const Lanes &of_force, const Lanes &, const Lanes &) {
                     for (int lane = 0; lane < LANES; lane++) found[n + lane] += of_force[lane];
                   });
    int beyond = 0;
    for_each_point(b, [&](int i, int j, int k) {
      const Vec3 y = point(l, i, j, k) - center;
      const double expected = std::exp(-0.5 * dot(y, y) / (l.width * l.width)) /
          std::pow(2.0 * PI_ * l.width * l.width, 1.5);
      const double value = found[b.index(i, j, k)];
      if (norm(y) < l.reach || value != 0.0) {
        EXPECT_NEAR(value, expected, 1e-14);
      }
      beyond += norm(y) > l.reach && value != 0.0;
    });
    EXPECT_LT(beyond, b.points() / 4);
    for (int n = 0; n < Stencils::PADDING; n++) EXPECT_EQ(found[b.points() + n], 0.0);
  }
}

// the whole force, and the first moment: no more
TEST(HydroGrid, SpreadHasForceAndFirstMoment)
{
  const Lattice l = tilted_lattice();
  Random rnd(12);
  for (const double radius : {0.3, 1.0, 1.3}) {
    const Vec3 center = rnd.vector(4.0), g = lattice_place(l, center);
    const Brick b = brick_for(l, g, g);
    const Load load = some_load(rnd);
    std::vector<double> f(3 * b.points() + Stencils::PADDING);
    spread(stencil(l, b, center), 0, make_body(radius, l.width), load, f.data());
    Vec3 force;
    Tensor moment;
    for_each_point(b, [&](int i, int j, int k) {
      const std::size_t n = b.index(i, j, k);
      const Vec3 here = l.point_volume() * Vec3{f[n], f[n + b.points()], f[n + 2 * b.points()]};
      force = force + here;
      moment = moment + outer(here, point(l, i, j, k) - center);
    });
    expect_near(force, load.force, 1e-9);
    expect_near(moment.x, load.dipole.x, 1e-9);
    expect_near(moment.y, load.dipole.y, 1e-9);
    expect_near(moment.z, load.dipole.z, 1e-9);
  }
}

TEST(HydroGrid, LinearFlowsAreInterpolatedAsTheyAre)
{
  const Lattice l = tilted_lattice();
  Random rnd(13);
  for (const double radius : {0.3, 1.0, 1.3}) {
    const Vec3 center = rnd.vector(4.0), g = lattice_place(l, center), u0 = rnd.vector(1.0);
    const Tensor gradient{rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)};
    const Brick b = brick_for(l, g, g);
    std::vector<double> u(3 * b.points() + Stencils::PADDING);
    for_each_point(b, [&](int i, int j, int k) {
      const Vec3 here = u0 + gradient * (point(l, i, j, k) - center);
      const std::size_t n = b.index(i, j, k);
      u[n] = here.x;
      u[n + b.points()] = here.y;
      u[n + 2 * b.points()] = here.z;
    });
    const Motion m = interpolate(stencil(l, b, center), 0, make_body(radius, l.width), u.data());
    expect_near(m.velocity, u0, 1e-9);
    expect_near(m.gradient.x, gradient.x, 1e-9);
    expect_near(m.gradient.y, gradient.y, 1e-9);
    expect_near(m.gradient.z, gradient.z, 1e-9);
  }
}

TEST(HydroGrid, SpreadAndInterpolateAreAdjoint)
{
  const Lattice l = tilted_lattice();
  Random rnd(14);
  const Vec3 center = rnd.vector(3.0), g = lattice_place(l, center);
  const Brick b = brick_for(l, g, g);
  const Body body = make_body(0.7, l.width);
  const Load load = some_load(rnd);
  std::vector<double> f(3 * b.points() + Stencils::PADDING), u(f.size());
  for (double &value : u) value = rnd.uniform(-1.0, 1.0);
  const Stencils s = stencil(l, b, center);
  spread(s, 0, body, load, f.data());
  const Motion m = interpolate(s, 0, body, u.data());
  double sum = 0.0;
  for (std::size_t n = 0; n < f.size(); n++) sum += f[n] * u[n] * l.point_volume();
  EXPECT_NEAR(dot(load.force, m.velocity) + contraction(load.dipole, m.gradient), sum, 1e-13);
}

TEST(HydroGrid, BrickHoldsWhatItsCentersReach)
{
  const Lattice l = tilted_lattice();
  Random rnd(15);
  const Vec3 low{-3.0, 2.0, 5.0}, high{4.0, 6.0, 9.0};
  const Brick b = brick_for(l, low, high);
  for (int trial = 0; trial < 30; trial++) {
    const double x = rnd.uniform(low.x, high.x) / l.nx, y = rnd.uniform(low.y, high.y) / l.ny,
                 z = rnd.uniform(low.z, high.z) / l.nz;
    const Cell &c = l.cell;
    const Vec3 center =
        c.origin + Vec3{x * c.xprd + y * c.xy + z * c.xz, y * c.yprd + z * c.yz, z * c.zprd};
    const Vec3 g = lattice_place(l, center);
    const Brick own = brick_for(l, g, g);
    for (int d = 0; d < 3; d++) {
      EXPECT_GE(own.low[d], b.low[d]);
      EXPECT_LE(own.low[d] + own.size[d], b.low[d] + b.size[d]);
    }
    // all of it, in a brick that holds it as in one that is too large
    Brick large = own;
    for (int d = 0; d < 3; d++) {
      large.low[d] -= 9;
      large.size[d] += 18;
    }
    std::vector<double> f(3 * own.points() + Stencils::PADDING);
    std::vector<double> more(3 * large.points() + Stencils::PADDING);
    const Load load = some_load(rnd);
    spread(stencil(l, own, center), 0, make_body(1.0, l.width), load, f.data());
    spread(stencil(l, large, center), 0, make_body(1.0, l.width), load, more.data());
    double of_f = 0.0, of_more = 0.0;
    for (const double value : f) of_f += std::fabs(value);
    for (const double value : more) of_more += std::fabs(value);
    for_each_point(own, [&](int i, int j, int k) {
      EXPECT_EQ(f[own.index(i, j, k)], more[large.index(i, j, k)]);
    });
    EXPECT_NEAR(of_f, of_more, 1e-12 * of_f);
  }
}

TEST(HydroGrid, NumbersOfPointsHaveSmallFactors)
{
  EXPECT_EQ(good_number(9.7), 10);
  EXPECT_EQ(good_number(12.0), 12);
  EXPECT_EQ(good_number(21.5), 24);
  EXPECT_EQ(good_number(24.8), 25);
  EXPECT_EQ(good_number(0.1), 2);
  EXPECT_EQ(span(0.5, 2.0).first, -1);    // whole numbers between two
  EXPECT_EQ(span(0.5, 2.0).last, 2);
  EXPECT_EQ(span(-2.5, 1.5).first, -4);
  EXPECT_EQ(span(-2.5, 1.4).last, -2);
  EXPECT_EQ(span(-2.5, 1.5).last, -1);
}

}    // namespace
