// How long a neighbor list lives: against random vectors and brute force.

#include "rheometer_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace LAMMPS_NS::Rheometer_NS;

std::mt19937 &generator()
{
  static std::mt19937 engine(4711);
  return engine;
}

double uniform(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(generator());
}

Deformation random_deformation()
{
  return {uniform(0.7, 1.4), uniform(0.7, 1.4), uniform(0.7, 1.4), uniform(-1.0, 1.0)};
}

double mapped(const Deformation &f, double x, double y, double z)
{
  return std::sqrt(std::pow(f.xx * x + f.xy * y, 2) + std::pow(f.yy * y, 2) +
                   std::pow(f.zz * z, 2));
}

// the shortest image of a unit vector, over all directions of a plane or of space
double shortest_image(const Deformation &f, int dimension)
{
  double least = mapped(f, 1.0, 0.0, 0.0);
  if (dimension == 3) least = std::min(least, mapped(f, 0.0, 0.0, 1.0));
  for (int n = 0; n < 200000; n++) {
    const double angle = M_PI * n / 200000.0;
    least = std::min(least, mapped(f, std::cos(angle), std::sin(angle), 0.0));
  }
  return least;
}

TEST(SmallestStretch, IsTheShortestImageOfAUnitVector)
{
  for (int n = 0; n < 40; n++)
    for (int dimension : {2, 3}) {
      const Deformation f = random_deformation();
      EXPECT_NEAR(smallest_stretch(f, dimension), shortest_image(f, dimension), 1e-9);
    }
}

// Simple shear by g: singular values sqrt(1 + g^2/4) -+ g/2 (their product is 1, their difference
// g).
TEST(SmallestStretch, OfSimpleShear)
{
  for (double g : {0.0, 1e-12, 1e-3, 0.05, -0.3, 2.0}) {
    const double exact = std::sqrt(1.0 + 0.25 * g * g) - 0.5 * std::fabs(g);
    EXPECT_NEAR(smallest_stretch({1.0, 1.0, 1.0, g}, 3), exact, 1e-15);
  }
}

TEST(SmallestStretch, IsZeroWhereADirectionIsTurnedOver)
{
  EXPECT_EQ(smallest_stretch({-1.0, 1.0, 1.0, 0.0}, 3), 0.0);
  EXPECT_EQ(smallest_stretch({1.0, 0.0, 1.0, 0.3}, 3), 0.0);
  EXPECT_EQ(smallest_stretch({1.0, 1.0, -0.5, 0.0}, 3), 0.0);
  EXPECT_EQ(smallest_stretch({1.0, 1.0, -0.5, 0.0}, 2), 1.0);    // a flat system has no z
}

TEST(Deformation, MapsOneCellToTheOther)
{
  for (int n = 0; n < 20; n++) {
    const Cell h0 = {uniform(5, 9), uniform(5, 9), uniform(5, 9), uniform(-4, 4)};
    const Cell h = {uniform(5, 9), uniform(5, 9), uniform(5, 9), uniform(-4, 4)};
    const Deformation f = deformation(h0, h);
    EXPECT_NEAR(f.xx * h0.lx, h.lx, 1e-12);
    EXPECT_NEAR(f.xx * h0.xy + f.xy * h0.ly, h.xy, 1e-12);
    EXPECT_NEAR(f.yy * h0.ly, h.ly, 1e-12);
    EXPECT_NEAR(f.zz * h0.lz, h.lz, 1e-12);
  }
}

TEST(Scatter, BoundsEveryDifferenceAndIsBlindToADrift)
{
  for (int n = 0; n < 50; n++) {
    const Deformation f = random_deformation();
    const double drift[3] = {uniform(-5, 5), uniform(-5, 5), uniform(-5, 5)};
    std::vector<std::array<double, 3>> d(20);
    Scatter still, drifting;
    for (auto &one : d) {
      const double x0[3] = {uniform(0, 9), uniform(0, 9), uniform(0, 9)};
      for (double &component : one) component = uniform(-0.1, 0.1);
      const double x[3] = {f.xx * x0[0] + f.xy * x0[1] + one[0], f.yy * x0[1] + one[1],
                           f.zz * x0[2] + one[2]};
      const double far[3] = {x[0] + drift[0], x[1] + drift[1], x[2] + drift[2]};
      still.add(f, x0, x);
      drifting.add(f, x0, far);
    }
    double most = 0.0;
    for (const auto &p : d)
      for (const auto &q : d)
        most = std::max(most, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    EXPECT_GE(largest_difference(still), most - 1e-12);
    EXPECT_GE(largest_difference(drifting), most - 1e-12);
    EXPECT_LE(largest_difference(still), 2.0 * 0.1 * std::sqrt(3.0) + 1e-12);
    EXPECT_LE(largest_difference(drifting), 2.0 * 0.1 * std::sqrt(3.0) + 1e-12);
  }
}

TEST(Scatter, OfNoParticleIsNothing)
{
  EXPECT_EQ(largest_difference(Scatter()), 0.0);
}

// Pairs that were just not in the list, moved by F and by the worst that d allows.
TEST(ListHolds, WhileNoPairCanHaveComeInRange)
{
  const double cut = 2.5, skin = 0.3;
  int held = 0, given_up = 0;
  for (int n = 0; n < 20000; n++) {
    const double g = uniform(-0.25, 0.25), d = uniform(0.0, 0.1);
    const Deformation f = {uniform(0.97, 1.03), uniform(0.97, 1.03), uniform(0.97, 1.03), g};
    const double angle = uniform(0.0, 2.0 * M_PI), z = uniform(-1.0, 1.0), s = std::sqrt(1 - z * z);
    const double r = cut + skin;
    const double now = mapped(f, r * s * std::cos(angle), r * s * std::sin(angle), r * z) - 2.0 * d;
    const bool holds = list_holds(f, 3, 2.0 * d, cut + skin, skin);
    (holds ? held : given_up)++;
    if (holds) { EXPECT_GT(now, cut); }
  }
  EXPECT_GT(held, 1000);
  EXPECT_GT(given_up, 1000);
}

// It is given up where the first pair may come in range, not earlier.
TEST(ListHolds, UntilTheVeryLimit)
{
  const double cut = 2.5, skin = 0.3, d = 0.02;
  auto sheared = [](double g) {
    return Deformation{1.0, 1.0, 1.0, g};
  };
  // s (cut + skin) = cut + 2 d, with s = sqrt(1 + g^2/4) - g/2: g = 1/s - s
  const double s = (cut + 2.0 * d) / (cut + skin), g = 1.0 / s - s;
  EXPECT_TRUE(list_holds(sheared(g * (1.0 - 1e-9)), 3, 2.0 * d, cut + skin, skin));
  EXPECT_FALSE(list_holds(sheared(g * (1.0 + 1e-9)), 3, 2.0 * d, cut + skin, skin));
}

}    // namespace
