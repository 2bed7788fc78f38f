// The plates of a plane Couette cell: signs of the stresses, exact motion with a damper.

#include "rheometer_plate.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace LAMMPS_NS::Rheometer_NS;

namespace {

// what a Newtonian fluid sheared at a positive rate under pressure does to the plates: it presses
// on both and drags the lower one along +x, the upper one along -x
constexpr double AREA = 4.0;
constexpr double ON_LOWER[3] = {6.0, -10.0, 2.0};
constexpr double ON_UPPER[3] = {-6.0, 10.0, -2.0};

TEST(WallStress, IsTheSameOnBothPlatesAndPositiveInASteadyFlow)
{
  const WallStress low = wall_stress(LOWER, ON_LOWER, AREA),
                   up = wall_stress(UPPER, ON_UPPER, AREA);
  EXPECT_DOUBLE_EQ(low.pressure, 2.5);
  EXPECT_DOUBLE_EQ(low.xy, 1.5);
  EXPECT_DOUBLE_EQ(low.zy, 0.5);
  EXPECT_DOUBLE_EQ(up.pressure, low.pressure);
  EXPECT_DOUBLE_EQ(up.xy, low.xy);
  EXPECT_DOUBLE_EQ(up.zy, low.zy);
}

TEST(WallStress, DiffersByTheMomentumThatTheSuspensionGains)
{
  const double up[3] = {-6.0, 7.0, 0.0}, low[3] = {5.0, -4.0, 0.0};
  // force on the suspension along x: 6 - 5, along y: -7 + 4
  EXPECT_DOUBLE_EQ(AREA * (wall_stress(UPPER, up, AREA).xy - wall_stress(LOWER, low, AREA).xy),
                   1.0);
  EXPECT_DOUBLE_EQ(
      AREA * (wall_stress(LOWER, low, AREA).pressure - wall_stress(UPPER, up, AREA).pressure),
      -3.0);
}

TEST(DampedVelocity, FollowsTheClosedForm)
{
  // m = 2, c = 0.5, F = 3: v = 6 - (6 - v0) exp(-t/4)
  const double t = 1.7, v0 = -1.2;
  EXPECT_NEAR(damped_velocity(v0, 3.0, 2.0, 0.5, t), 6.0 - (6.0 - v0) * std::exp(-t / 4.0), 1e-15);
}

TEST(DampedVelocity, OfTwoHalvesIsThatOfTheWhole)
{
  const double half = damped_velocity(0.3, 2.0, 5.0, 7.0, 0.4);
  EXPECT_NEAR(damped_velocity(half, 2.0, 5.0, 7.0, 0.4), damped_velocity(0.3, 2.0, 5.0, 7.0, 0.8),
              1e-15);
}

TEST(DampedVelocity, HasBothLimitsOfTheDamper)
{
  EXPECT_DOUBLE_EQ(damped_velocity(0.3, 2.0, 5.0, 0.0, 0.5), 0.3 + 2.0 / 5.0 * 0.5);
  // overdamped, a step of a million relaxation times: at the terminal velocity, not beyond
  EXPECT_DOUBLE_EQ(damped_velocity(0.3, 2.0, 1e-6, 4.0, 0.25), 0.5);
}

TEST(DilationVelocity, TakesTheGapExactlyToItsExponential)
{
  double gap = 12.0;
  for (int n = 0; n < 1000; n++) gap += 1e-3 * dilation_velocity(gap, -0.8, 1e-3);
  EXPECT_NEAR(gap, 12.0 * std::exp(-0.8), 1e-12);
}

TEST(PlateStepLimit, IsThatOfTwoEqualMassesOnASpring)
{
  // masses m, spring k: omega^2 = 2 k/m, stable below 2/omega
  const double m = 3.0, k = 50.0;
  EXPECT_NEAR(plate_step_limit(m, k), 2.0 / std::sqrt(2.0 * k / m), 1e-15);
  double x = 1.0, v = 0.0;    // relative motion, velocity Verlet
  const double dt = 0.999 * plate_step_limit(m, k);
  for (int n = 0; n < 10000; n++) {
    v -= 0.5 * dt * 2.0 * k / m * x;
    x += dt * v;
    v -= 0.5 * dt * 2.0 * k / m * x;
  }
  EXPECT_LT(std::fabs(x), 100.0);
}

}    // namespace
