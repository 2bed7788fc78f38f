// Momentum of fluctuations: the definition in two passes, no effect of a common drift, parts that
// add up.

#include "lubcontact_inertia.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

using namespace LAMMPS_NS::Lubcontact_NS;

namespace {

using Particles = std::vector<std::pair<double, Vec3>>;

Particles random_particles(const Vec3 &drift)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> mass(0.5, 3.0), v(-1.0, 1.0);
  Particles particles(40);
  for (auto &p : particles) {
    p.first = mass(random);
    const double x = v(random), y = v(random), z = v(random);
    p.second = Vec3{x, y + 0.5 * x, z} + drift;
  }
  return particles;
}

Inertia sum_of(const Particles &particles)
{
  Inertia sum;
  for (const auto &p : particles) sum.add(p.first, p.second);
  return sum;
}

void expect_near(const Fluctuation &a, const Fluctuation &b, double tolerance)
{
  EXPECT_NEAR(a.xx, b.xx, tolerance);
  EXPECT_NEAR(a.yy, b.yy, tolerance);
  EXPECT_NEAR(a.zz, b.zz, tolerance);
  EXPECT_NEAR(a.xy, b.xy, tolerance);
  EXPECT_NEAR(a.xz, b.xz, tolerance);
  EXPECT_NEAR(a.yz, b.yz, tolerance);
}

}    // namespace

TEST(Inertia, TwoPasses)
{
  const Particles particles = random_particles({0.7, -2.0, 0.3});
  double mass = 0.0;
  Vec3 momentum;
  for (const auto &p : particles) {
    mass += p.first;
    momentum = momentum + p.first * p.second;
  }
  const Vec3 w = (1.0 / mass) * momentum;
  Fluctuation expected{};
  for (const auto &p : particles) {
    const Vec3 d = p.second - w;
    expected.xx += p.first * d.x * d.x;
    expected.yy += p.first * d.y * d.y;
    expected.zz += p.first * d.z * d.z;
    expected.xy += p.first * d.x * d.y;
    expected.xz += p.first * d.x * d.z;
    expected.yz += p.first * d.y * d.z;
  }
  const Inertia sum = sum_of(particles);
  expect_near(fluctuation(sum), expected, 1e-12);
  EXPECT_NEAR(sum.drift().y, w.y, 1e-15);
}

TEST(Inertia, DriftDoesNotCount)
{
  const Fluctuation still = fluctuation(sum_of(random_particles({})));
  for (const double w : {1.0, 1e3})
    expect_near(fluctuation(sum_of(random_particles({-3.0 * w, w, 0.5 * w}))), still,
                1e-12 * (1.0 + w * w));
}

TEST(Inertia, OneParticleAndNone)
{
  expect_near(fluctuation(sum_of({{2.0, {1.0, -3.0, 0.25}}})), Fluctuation{}, 1e-15);
  expect_near(fluctuation(Inertia()), Fluctuation{}, 0.0);
}
