#include "rheometer_mean.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <vector>

using namespace LAMMPS_NS::Rheometer_NS;

static double value(const StrainMeans &means, int n)
{
  return mean_output(means, n, -1.0, -2.0);
}

// pressure p(gamma), stress s(gamma) at a constant rate, up to this strain
template <typename P, typename S>
static StrainMeans sheared(double strain, P p, S s, double rate = 1.0, double dt = 1e-3)
{
  StrainMeans means;
  const int steps = static_cast<int>(std::lround(strain / std::fabs(rate) / dt));
  for (int n = 1; n <= steps; n++) {
    const double gamma = std::fabs(rate) * dt * n;
    add(means, p(gamma), s(gamma), rate * dt, dt);
  }
  return means;
}

TEST(RheometerMean, BeforeAnythingWasAdded)
{
  const StrainMeans means;
  const double expected[] = {-1.0, -2.0, 0.0, 0.0, 0.0};
  for (int n = 0; n < MEAN_OUTPUTS; n++) EXPECT_EQ(value(means, n), expected[n]);
}

TEST(RheometerMean, OfConstants)
{
  const auto means = sheared(
      3.0,
      [](double) {
        return 5.0;
      },
      [](double) {
        return -7.0;
      },
      -2.0);
  EXPECT_NEAR(value(means, 0), 5.0, 1e-12);
  EXPECT_NEAR(value(means, 1), -7.0, 1e-12);
  EXPECT_NEAR(value(means, 2), 0.0, 1e-6);
  EXPECT_NEAR(value(means, 3), 0.0, 1e-6);
}

// the mean of gamma over the last unit is gamma - 1/2, its deviation 1/sqrt(12)
TEST(RheometerMean, OfTheLastUnitOfStrain)
{
  for (double gamma : {1.0, 2.5, 7.0}) {
    const auto means = sheared(
        gamma,
        [](double x) {
          return x;
        },
        [](double x) {
          return std::sin(20.0 * x);
        });
    const double span = value(means, 4);
    EXPECT_GE(span, 1.0 - 1e-9);
    EXPECT_LE(span, 1.1 + 2e-3);
    EXPECT_NEAR(value(means, 0), gamma - 0.5 * span, 1e-3);
    EXPECT_NEAR(value(means, 2), span / std::sqrt(12.0), 1e-3);
    EXPECT_NEAR(value(means, 3), std::sqrt(0.5), 0.03);
  }
}

TEST(RheometerMean, OfLessStrainIsOfAllOfIt)
{
  const auto means = sheared(
      0.35,
      [](double x) {
        return x;
      },
      [](double) {
        return 1.0;
      });
  EXPECT_NEAR(value(means, 4), 0.35, 1e-12);
  EXPECT_NEAR(value(means, 0), 0.5 * 0.351, 1e-12);
}

// a start at ten times the value is forgotten after a unit of strain, not after several
TEST(RheometerMean, ForgetsTheStart)
{
  auto start = [](double x) {
    return x < 0.5 ? 100.0 : 10.0;
  };
  EXPECT_NEAR(value(sheared(1.7, start, start), 0), 10.0, 1e-12);
}

TEST(RheometerMean, WeightsByTime)
{
  StrainMeans means;
  add(means, 1.0, 0.0, 0.01, 3.0);
  add(means, 5.0, 0.0, 0.01, 1.0);
  EXPECT_DOUBLE_EQ(value(means, 0), 2.0);
  EXPECT_DOUBLE_EQ(value(means, 2), std::sqrt(3.0));
}

TEST(RheometerMean, AtRestIsOfAllTheTime)
{
  StrainMeans means;
  for (int n = 1; n <= 1000; n++) add(means, n, 0.0, 0.0, 0.1);
  EXPECT_NEAR(value(means, 0), 500.5, 1e-9);
  EXPECT_EQ(value(means, 4), 0.0);
}

TEST(RheometerMean, OfStepsLongerThanABlock)
{
  StrainMeans means;
  for (int n = 1; n <= 30; n++) add(means, n, 0.0, 0.25, 1.0);
  EXPECT_DOUBLE_EQ(value(means, 4), 11 * 0.25);
  EXPECT_DOUBLE_EQ(value(means, 0), 25.0);
}

TEST(RheometerMean, PartsOfTheSpan)
{
  const auto means = sheared(
      1.0,
      [](double x) {
        return x;
      },
      [](double) {
        return 0.0;
      });
  EXPECT_NEAR(mean(total(means, 0, 5), PRESSURE_MEAN, 0.0), 0.75, 2e-2);
  EXPECT_NEAR(mean(total(means, 5), PRESSURE_MEAN, 0.0), 0.25, 2e-2);
}

// restart files: a copy of its bytes goes on alike
TEST(RheometerMean, GoesOnFromItsBytes)
{
  auto wave = [](double x) {
    return std::sin(3.0 * x);
  };
  StrainMeans means = sheared(0.777, wave, wave), copy;
  std::memcpy(&copy, &means, sizeof(means));
  for (int n = 0; n < 1000; n++) {
    add(means, 0.1 * n, 0.3 * n, 1e-3, 1e-3);
    add(copy, 0.1 * n, 0.3 * n, 1e-3, 1e-3);
  }
  for (int n = 0; n < MEAN_OUTPUTS; n++) EXPECT_EQ(value(means, n), value(copy, n));
}
