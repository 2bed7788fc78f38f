// One step of each servo against its equation with the printed constants, on both sides of every
// border; the watch at the ends of its patience.

#include "rheometer_flow.h"
#include "rheometer_plate.h"
#include "tools.h"

#include <algorithm>

using namespace LAMMPS_NS::Rheometer_NS;
using namespace testing_tools;

namespace {

using Real = long double;

// I dx/dt + C x = force, for a step at constant force
Real relaxed(Real x, Real inertia, Real damping, Real force, Real dt)
{
  const Real k = damping / inertia * dt;
  const Real mean = k == 0.0L ? 1.0L : -std::expm1(-k) / k;
  return x * std::exp(-k) + force * dt / inertia * mean;
}

Real per_time(const Material &m, Real stress)    // 1/t, t = eta/P + d sqrt(rho/P)
{
  return 1.0L / (m.eta / stress + m.diameter * std::sqrt(m.density / stress));
}

struct Draw {
  Material m;
  double stress, per_t, rate, dt;
  explicit Draw(Random &rnd, double floor)
  {
    m = {rnd.coin() ? rnd.log_uniform(1e-3, 1e3) : 0.0, rnd.log_uniform(1e-3, 1e3),
         rnd.log_uniform(0.1, 10.0), rnd.log_uniform(1e-6, 1.0)};
    stress = rnd.log_uniform(1e-2, 1e2);
    per_t = static_cast<double>(per_time(m, stress));
    // at rest, near the floor, near the rate of a jammed packing, and flowing
    const double rates[] = {0.0, floor, 0.01 * floor, 1.0};
    rate = rates[rnd.engine() % 4] * per_t * rnd.log_uniform(0.1, 10.0) * (rnd.coin() ? 1.0 : -1.0);
    dt = rnd.log_uniform(1e-6, 1e-1) / per_t;
  }
};

}    // namespace

TEST(PressureServo, AStepSolvesItsEquationWithThePrintedConstants)
{
  Random rnd(1);
  int limited = 0;
  for (int trial = 0; trial < 20000; trial++) {
    const Draw d(rnd, 1e-4);
    const double gain = rnd.log_uniform(0.3, 3.0), P = d.stress;
    const Real still = 1e-4L * d.per_t, w2 = Real(d.rate) * d.rate + still * still;
    const Real C = std::sqrt(Real(P) * P / (gain * gain * w2) + 8.0L * d.m.inertia * P);
    const Real quick = 100.0L * still * (still * still / w2) * (still * still / w2);
    const Real I = 0.02L * P / (gain * (w2 + quick * quick)) + d.m.inertia;
    const double most = static_cast<double>(P / C), e = most * rnd.uniform(-1.0, 1.0);
    const double p = P * rnd.uniform(-1.0, 3.0);
    // with a dashpot more, that of a layer that drains
    for (const double drainage : {0.0, static_cast<double>(C) * std::pow(10.0, trial % 13 - 6)}) {
      const double exact = static_cast<double>(relaxed(e, I, C + drainage, Real(p) - P, d.dt));
      limited += std::fabs(exact) > most;
      EXPECT_NEAR(next_dilation(d.m, e, p, P, d.rate, gain, d.dt, drainage),
                  std::clamp(exact, -most, most), 1e-11 * most);
    }
    EXPECT_NEAR(dilation_limit(d.m, P, d.rate, gain), most, 1e-13 * most);
  }
  EXPECT_GT(limited, 100);
}

TEST(StressServo, AStepSolvesItsEquationWithThePrintedConstants)
{
  Random rnd(2);
  for (int trial = 0; trial < 20000; trial++) {
    Draw d(rnd, 1e-2);
    const double trouton = rnd.coin() ? 1.0 : 3.0;
    const double target = rnd.uniform(-1.0, 1.0) * d.stress;
    // by the size of the total stress, the fluid with it: below and above twice the target
    const double total =
        2.0 * target * (rnd.coin() ? rnd.uniform(0.0, 0.999) : rnd.uniform(1.001, 3.0));
    const double stress = total - trouton * d.m.eta * d.rate;
    const Real s = std::fmax(std::fabs(Real(target)),
                             0.5L * std::fabs(Real(stress) + Real(trouton) * d.m.eta * d.rate));
    const Real per_t = per_time(d.m, s), floor = 0.01L * per_t, g = d.rate;
    const Real I = 0.02L * s / (g * g + std::fabs(g) * per_t + floor * floor) + d.m.inertia;
    const Real slow = 0.01L * floor, D = 2e-3L * s * slow / (g * g + slow * slow);
    const Real exact = relaxed(g, I, Real(trouton) * d.m.eta + D, Real(target) - stress, d.dt);
    const double size = static_cast<double>(std::fabs(g) + s * d.dt / I) *
        (1.0 + trouton * d.m.eta * std::fabs(d.rate) / d.stress);
    EXPECT_NEAR(next_rate(d.m, d.rate, stress, target, trouton, d.dt), static_cast<double>(exact),
                1e-12 * size);
  }
}

TEST(DecayMean, IsExactOnBothSidesOfTheBorderOfItsSeries)
{
  for (const double x : {0.0, 1e-12, 9e-9, 9.99e-9, 1.001e-8, 2e-8, 9e-8, 1e-6, 1e-4}) {
    const Real y = x;
    const double exact = static_cast<double>(1.0L - y / 2.0L + y * y / 6.0L - y * y * y / 24.0L);
    EXPECT_NEAR(decay_mean(x), exact, 2.3e-16) << x;
  }
}

TEST(Watch, RemembersFiveUnitsOfStrainAndCountsADeviationOfOneAtMost)
{
  // the share of a step: of the age while it is below 5, of 5 from then on
  for (const double age : {0.0, 0.5, 4.8, 4.95, 50.0})
    for (const double deviation : {-7.0, -1.001, -0.999, 0.3, 0.999, 1.001, 80.0}) {
      const Watch next = watch({0.25, age}, deviation, 2.0, 0.05);
      EXPECT_NEAR(next.age, age + 0.1, 1e-15);
      const double share = 0.1 / std::fmin(age + 0.1, 5.0);
      EXPECT_NEAR(next.deviation, 0.25 + share * (std::clamp(deviation, -1.0, 1.0) - 0.25), 1e-15);
    }
}

TEST(Watch, JudgesAfterTenUnitsOfStrainByAHalfAndByAHundredth)
{
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(unreachable({0.501 * sign, 10.01}));
    EXPECT_FALSE(unreachable({0.499 * sign, 10.01}));
    EXPECT_FALSE(unreachable({0.501 * sign, 9.99}));
  }
  EXPECT_TRUE(jammed({0.00999, 10.01}));
  EXPECT_FALSE(jammed({0.01001, 10.01}));
  EXPECT_FALSE(jammed({0.00999, 9.99}));
}

TEST(Flips, BeginBeyondHalfAnEdge)
{
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(flips({4.0, 1.0, 1.0, sign * 2.0}), 0);
    EXPECT_EQ(flips({4.0, 1.0, 1.0, sign * 1.9999999}), 0);
    EXPECT_EQ(flips({4.0, 1.0, 1.0, sign * 2.0000001}), sign > 0.0 ? -1 : 1);
  }
}
