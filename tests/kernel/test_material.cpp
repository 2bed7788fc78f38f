// Shows that springs of two spheres have the stiffness of the contact laws that they stand for.

#include "lubcontact_material.h"

#include <gtest/gtest.h>

using namespace LAMMPS_NS::Lubcontact_NS;

static constexpr Elastic GLASS{70e9, 0.25, 1e-4}, PLASTIC{3e9, 0.4, 3e-4};

TEST(Material, EqualSpheresHaveModulusTimesRadius)
{
  EXPECT_DOUBLE_EQ(springs(GLASS, GLASS, 0.0).g, 7e6);
}

TEST(Material, UnlikeSpheresAreSpringsInSeries)
{
  // 2 E R of each: 1.4e7 and 1.8e6; in series 1/(1/1.4e7 + 1/1.8e6)
  EXPECT_NEAR(springs(GLASS, PLASTIC, 0.0).g, 1.4e7 * 1.8e6 / (1.4e7 + 1.8e6), 1e-8);
  EXPECT_DOUBLE_EQ(springs(GLASS, PLASTIC, 0.0).g, springs(PLASTIC, GLASS, 0.0).g);
}

TEST(Material, RatioOfStiffnessesIsMindlins)
{
  // 2 (1 - nu)/(2 - nu): 6/7 for nu = 1/4, 3/4 for 0.4, 1 for 0, 2/3 for 1/2
  EXPECT_NEAR(mindlin_ratio(GLASS, GLASS), 6.0 / 7.0, 1e-15);
  EXPECT_NEAR(mindlin_ratio(PLASTIC, PLASTIC), 0.75, 1e-15);
  EXPECT_NEAR(mindlin_ratio({1, 0, 1}, {1, 0, 1}), 1.0, 1e-15);
  EXPECT_NEAR(mindlin_ratio({5, 0.5, 1}, {5, 0.5, 2}), 2.0 / 3.0, 1e-15);
}

TEST(Material, RatioOfUnlikeSolidsIsThatOfTheSofterOne)
{
  const Elastic rigid{70e18, 0.1, 1e-4};
  EXPECT_NEAR(mindlin_ratio(rigid, PLASTIC), 0.75, 1e-8);
  // 4 G*/E* by hand: G* = 1/(3.5*1.25/70 + 3.2*1.4/3) GPa, E* = 1/(0.9375/70 + 0.84/3) GPa
  EXPECT_NEAR(mindlin_ratio(GLASS, PLASTIC),
              4.0 * (0.9375 / 70 + 0.84 / 3) / (3.5 * 1.25 / 70 + 3.2 * 1.4 / 3), 1e-14);
}

TEST(Material, SecantIsThatOfHertz)
{
  // overlap from the law itself: F = (4/3) E* sqrt(R*) d^1.5 with E* = 70e9/(2*0.9375), R* = 5e-5
  const double overlap = 2e-9, star = 70e9 / 1.875;
  const double load = 4.0 / 3.0 * star * std::sqrt(5e-5) * std::pow(overlap, 1.5);
  EXPECT_NEAR(springs(GLASS, GLASS, load).g, load / overlap, 1e-9 * load / overlap);
  EXPECT_NEAR(springs(GLASS, GLASS, load).kt, 6.0 / 7.0 * load / overlap, 1e-9 * load / overlap);
}

TEST(Material, HertzIsAsStiffAsModulusTimesRadiusOnlyAtAbsurdOverlap)
{
  // overlap/R = 4.5 (1 - nu^2)^2: g = E a is stiffer than Hertz at any load that a solid bears
  const double overlap = 4.5 * 0.9375 * 0.9375 * GLASS.radius;
  EXPECT_NEAR(springs(GLASS, GLASS, 7e6 * overlap).g, 7e6, 1e-2);
}

TEST(Material, HertzUnderPressureIsThatOfTheManual)
{
  // F = 4 a^2 P: g/(E a) = (8/9 P/E/(1 - nu^2)^2)^(1/3)
  const double P = 7e4, a = GLASS.radius;
  EXPECT_NEAR(springs(GLASS, GLASS, 4.0 * a * a * P).g / 7e6,
              std::cbrt(8.0 / 9.0 * 1e-6 / (0.9375 * 0.9375)), 1e-12);
}

TEST(Material, UnitsOfForcePressureAndDensity)
{
  const UnitScale micro{1e-15, 1e-6, 1e-6}, cgs{1e-3, 1e-2, 1.0};
  EXPECT_NEAR(micro.force(), 1e-9, 1e-23);
  EXPECT_NEAR(micro.pressure(), 1e3, 1e-11);
  EXPECT_NEAR(micro.density(), 1e3, 1e-11);
  EXPECT_NEAR(cgs.force(), 1e-5, 1e-19);
  EXPECT_NEAR(cgs.pressure(), 0.1, 1e-15);
}
