// Background flows: profiles, continuity at walls, spin = half of the curl of the velocity.

#include "fluid_flow.h"

#include <gtest/gtest.h>

#include <functional>

using namespace LAMMPS_NS::Fluid_NS;

namespace {

using Profile = std::function<Flow(const Vec3 &)>;

// by central differences
Vec3 half_curl(const Profile &flow, const Vec3 &x)
{
  const double h = 1e-3;
  const auto slope = [&](const Vec3 &e) {
    return (0.5 / h) * (flow(x + h * e).velocity - flow(x - h * e).velocity);
  };
  const Vec3 dx = slope({1, 0, 0}), dy = slope({0, 1, 0}), dz = slope({0, 0, 1});
  return 0.5 * Vec3{dy.z - dz.y, dz.x - dx.z, dx.y - dy.x};
}

void expect_near(const Vec3 &a, const Vec3 &b, double tolerance)
{
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

// a cell in general motion
constexpr double CELL[6] = {4.0, 3.0, 2.0, 0.3, -0.2, 0.7};    // xx yy zz yz xz xy
constexpr double RATE[6] = {0.5, -0.4, 0.1, 0.2, 0.6, 1.5};
constexpr Vec3 LOW{-1.0, 2.0, 0.5}, LOW_RATE{0.3, -0.2, 0.1};

struct Inverse {
  double of[6];
  explicit Inverse(const double *h)
  {
    of[0] = 1.0 / h[0];
    of[1] = 1.0 / h[1];
    of[2] = 1.0 / h[2];
    of[3] = -h[3] / (h[1] * h[2]);
    of[4] = (h[3] * h[5] - h[1] * h[4]) / (h[0] * h[1] * h[2]);
    of[5] = -h[5] / (h[0] * h[1]);
  }
};

Flow in_cell(const Vec3 &x)
{
  return cell_flow(RATE, Inverse(CELL).of, x, LOW, LOW_RATE);
}

Vec3 place(const double *h, const Vec3 &l)
{
  return {h[0] * l.x + h[5] * l.y + h[4] * l.z, h[1] * l.y + h[3] * l.z, h[2] * l.z};
}

TEST(Background, Shear)
{
  const Flow f = shear_flow(2.0, 1.5);
  expect_near(f.velocity, {3.0, 0.0, 0.0}, 0.0);
  expect_near(f.spin, {0.0, 0.0, -1.0}, 0.0);
}

TEST(Background, CouetteIsLinearBetweenThePlatesAndMovesWithThemBeyond)
{
  const Couette c{1.0, -2.0, 5.0, 6.0};
  EXPECT_DOUBLE_EQ(couette_flow(c, 1.0 + 1e-14).velocity.x, -2.0 + 2e-14);
  EXPECT_DOUBLE_EQ(couette_flow(c, 2.0).velocity.x, 0.0);
  EXPECT_DOUBLE_EQ(couette_flow(c, 2.0).spin.z, -1.0);
  EXPECT_DOUBLE_EQ(couette_flow(c, 0.0).velocity.x, -2.0);
  EXPECT_DOUBLE_EQ(couette_flow(c, 9.0).velocity.x, 6.0);
  EXPECT_DOUBLE_EQ(couette_flow(c, 9.0).spin.z, 0.0);
}

TEST(Background, PoiseuilleRestsAtTheWallsAndIsFastestInTheMiddle)
{
  const Poiseuille p{-1.0, 3.0, 5.0};
  EXPECT_DOUBLE_EQ(poiseuille_flow(p, 1.0).velocity.x, 5.0);
  EXPECT_DOUBLE_EQ(poiseuille_flow(p, 1.0).spin.z, 0.0);
  EXPECT_DOUBLE_EQ(poiseuille_flow(p, 2.0).velocity.x, 3.75);
  EXPECT_NEAR(poiseuille_flow(p, 3.0 - 1e-12).velocity.x, 0.0, 1e-10);
  EXPECT_DOUBLE_EQ(poiseuille_flow(p, 3.5).velocity.x, 0.0);
  EXPECT_DOUBLE_EQ(poiseuille_flow(p, -1.5).spin.z, 0.0);
}

TEST(Background, SpinIsHalfTheVorticity)
{
  const Profile profiles[] = {[](const Vec3 &x) {
                                return shear_flow(-1.3, x.y);
                              },
                              [](const Vec3 &x) {
                                return couette_flow({-1.0, 2.0, 3.0, -1.0}, x.y);
                              },
                              [](const Vec3 &x) {
                                return poiseuille_flow({-1.0, 3.0, 5.0}, x.y);
                              },
                              in_cell};
  for (const auto &profile : profiles)
    for (const Vec3 &x : {Vec3{0.1, 0.2, 0.3}, Vec3{-2.0, 1.7, 4.0}})
      expect_near(profile(x).spin, half_curl(profile, x), 1e-10);
}

TEST(Background, CellMovesItsImagesAsItsEdges)
{
  const Vec3 x{0.4, 2.6, 1.1};
  const Vec3 images[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-2, 3, 1}};
  for (const Vec3 &n : images)
    expect_near(in_cell(x + place(CELL, n)).velocity - in_cell(x).velocity, place(RATE, n), 1e-13);
}

TEST(Background, CellCarriesItsPointsAtAConstantVelocity)
{
  const Vec3 lambda{0.3, 0.8, 0.6};
  const Vec3 v = in_cell(LOW + place(CELL, lambda)).velocity;
  const double dt = 0.2;
  double later[6];
  for (int n = 0; n < 6; n++) later[n] = CELL[n] + dt * RATE[n];
  const Vec3 low = LOW + dt * LOW_RATE;
  const Vec3 x = LOW + place(CELL, lambda) + dt * v;
  expect_near(x, low + place(later, lambda), 1e-14);
  expect_near(cell_flow(RATE, Inverse(later).of, x, low, LOW_RATE).velocity, v, 1e-13);
}

TEST(Background, ProfilesHaveOneComponentAndEndAtTheirWalls)
{
  const double eps = 1e-9;
  const Couette c{-1.0, 2.0, 3.0, 6.0};
  const Poiseuille p{-1.0, 3.0, 5.0};
  for (const double y : {-2.0, -1.0 - eps, -1.0, -1.0 + eps, 1.0, 3.0 - eps, 3.0, 3.0 + eps, 4.0}) {
    const bool inside = y > -1.0 && y < 3.0;
    for (const Flow &f : {couette_flow(c, y), poiseuille_flow(p, y), shear_flow(1.5, y)}) {
      EXPECT_EQ(f.velocity.y, 0.0);
      EXPECT_EQ(f.velocity.z, 0.0);
      EXPECT_EQ(f.spin.x, 0.0);
      EXPECT_EQ(f.spin.y, 0.0);
    }
    EXPECT_EQ(couette_flow(c, y).spin.z, inside ? -0.5 : 0.0) << y;
    EXPECT_EQ(poiseuille_flow(p, y).spin.z != 0.0, inside && y != 1.0) << y;
    EXPECT_NEAR(couette_flow(c, y).velocity.x, y < -1.0 ? 2.0 : y > 3.0 ? 6.0 : 3.0 + y, 1e-15);
  }
}

}    // namespace
