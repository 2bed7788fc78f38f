// Shows squeeze film, asperities and bulk in series: forces, rest, shifted range, dry limit.

#include "lubcontact_normal.h"
#include "reference/gap_reference.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

NormalCoeffs make_coeffs(double g, double k, double eps, bool euler = false)
{
  return {g, k, {k / g, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, euler}};
}

Gap gap_of(double ln_u)
{
  return {std::exp(ln_u), ln_u};
}

double motion(const GapCase &c, double t)
{
  return c.c0 + c.c1 * std::cos(c.w * t + c.p);
}

// Largest error of ln u at the 16 reference times: radius 0.7, stiffness 30, so that dt = tau/30.
double error_of(const GapCase &c, int steps, bool euler)
{
  const double a = 0.7, g = 30.0, viscosity = 2.0;
  const double tau = 1.5 * PI_ * viscosity * a / g;
  const NormalCoeffs coeffs = make_coeffs(g, c.alpha * g, c.eps, euler);
  const Film film = c.shift > 0.0 ? make_film(viscosity, 1.0 / c.shift, Range::SHIFTED, 0.6)
                                  : make_film(viscosity, 2.0, Range::CUT, 0.6);
  const double h = c.end / steps;
  Gap gap{c.u0, std::log(c.u0)};
  double worst = 0.0;
  for (int n = 0; n < steps; n++) {
    gap = next_gap(coeffs, film, a, gap, motion(c, n * h), motion(c, (n + 1) * h), h * tau);
    if ((n + 1) % (steps / 16) == 0) {
      worst = std::fmax(worst, std::fabs(gap.ln_u - c.y[(n + 1) / (steps / 16) - 1]));
    }
  }
  return worst;
}

}    // namespace

TEST(ElasticGap, FollowsTheSurfacesUntilTheAsperitiesTouch)
{
  const GapLaw law = make_coeffs(1.0, 3.0, 0.02).gap;
  EXPECT_NEAR(elastic_gap_a(law, 0.5), 0.5, 1e-15);
  EXPECT_NEAR(elastic_gap_a(law, 0.02), 0.02, 1e-15);
  EXPECT_NEAR(elastic_gap_a(law, 0.0), 0.015, 1e-15);     // (0 + 3*0.02)/4
  EXPECT_NEAR(elastic_gap_a(law, -0.02), 0.01, 1e-15);    // (-0.02 + 0.06)/4
}

TEST(ElasticGap, CrushedOrSmoothAndOverlappingIsThinButPositive)
{
  EXPECT_EQ(elastic_gap_a(make_coeffs(1.0, 3.0, 0.02).gap, -0.1), 1e-8);
  EXPECT_EQ(elastic_gap_a(make_coeffs(1.0, 1.0, 0.0).gap, -0.1), 1e-8);
  EXPECT_EQ(elastic_gap_a(make_coeffs(1.0, 1.0, 0.0).gap, 0.0), 1e-8);
}

TEST(ElasticGap, IsARestOfTheStepAndTheFilmCarriesNothing)
{
  Random rnd(1);
  for (int trial = 0; trial < 5000; trial++) {
    const double a = rnd.uniform(0.3, 3.0), eps = rnd.log_uniform(1e-5, 0.1);
    const NormalCoeffs c = make_coeffs(1e3, 1e3 * rnd.log_uniform(1e-3, 1e3), eps);
    const Film f = make_film(rnd.log_uniform(1e-3, 1e3), 2.0, Range::CUT, 0.6);
    const double un = rnd.uniform(-0.9 * c.gap.alpha, 5.0) * eps;
    const double u = elastic_gap_a(c.gap, un);
    const Gap next = next_gap(c, f, a, {u, std::log(u)}, un, un, rnd.log_uniform(1e-6, 1.0));
    EXPECT_NEAR(next.ln_u, std::log(u), 1e-9);
    const NormalForce force = normal_force(c, a, a * un, a * u, true);
    EXPECT_NEAR(force.film, 0.0, 1e-12 * (c.g * a * std::fabs(un) + force.contact));
  }
}

TEST(NormalForce, AgreesWithHandComputedValues)
{
  // g = 100, k = 50, eps a = 0.04; un = -0.01, u = 0.03: total 4, asperities 0.5, film 3.5
  const NormalForce f = normal_force(make_coeffs(100.0, 50.0, 0.02), 2.0, -0.01, 0.03, true);
  EXPECT_NEAR(f.contact, 0.5, 1e-14);
  EXPECT_NEAR(f.film, 3.5, 1e-14);
  // suction: u < un
  const NormalForce s = normal_force(make_coeffs(100.0, 50.0, 0.02), 2.0, 0.09, 0.07, true);
  EXPECT_EQ(s.contact, 0.0);
  EXPECT_NEAR(s.film, -2.0, 1e-14);
}

TEST(NormalForce, WithoutFilmTheAsperitiesCarryAll)
{
  const NormalCoeffs c = make_coeffs(100.0, 50.0, 0.02);
  EXPECT_NEAR(normal_force(c, 2.0, -0.5, 2e-8, false).contact, 50.000002, 1e-9);
  EXPECT_EQ(normal_force(c, 2.0, -0.5, 2e-8, false).film, 0.0);
}

TEST(NormalForce, DryPairNeverAttracts)
{
  Random rnd(2);
  for (int trial = 0; trial < 20000; trial++) {
    const double eps = rnd.coin() ? rnd.log_uniform(1e-8, 0.1) : 0.0, a = rnd.uniform(0.1, 5.0);
    const NormalCoeffs c = make_coeffs(1e3, rnd.log_uniform(1e-3, 1e9), eps);
    const double un = rnd.log_uniform(1e-10, 1.0) * (rnd.coin() ? 1.0 : -1.0);
    const NormalForce f = normal_force(c, a, a * un, a * elastic_gap_a(c.gap, un), false);
    EXPECT_GE(f.contact, 0.0);
    EXPECT_EQ(f.film, 0.0);
    if (un > eps) { EXPECT_EQ(f.contact, 0.0); }
  }
}

TEST(NormalForce, DryForceIsThatOfTwoSpringsInSeries)
{
  // asperities k from eps a on, in series with g, until they are crushed at un = -alpha eps
  const NormalCoeffs c = make_coeffs(100.0, 300.0, 0.02);
  const double a = 2.0;
  for (const double un : {0.01, 0.0, -0.03, -0.059}) {
    const double f = normal_force(c, a, a * un, a * elastic_gap_a(c.gap, un), false).contact;
    EXPECT_NEAR(f, 75.0 * a * (0.02 - un), 1e-12) << "un = " << un;
  }
  // crushed: the bulk alone
  const double f = normal_force(c, a, a * -0.1, a * elastic_gap_a(c.gap, -0.1), false).contact;
  EXPECT_NEAR(f, 100.0 * a * (0.1 + 1e-8), 1e-12);
}

TEST(NormalEnergy, IsTheWorkOfTheForces)
{
  // -dE/d(un) at fixed u is the total force; dE/du at fixed un is what the film takes
  Random rnd(3);
  for (int trial = 0; trial < 2000; trial++) {
    const NormalCoeffs c = make_coeffs(rnd.uniform(1.0, 10.0), rnd.uniform(1.0, 10.0), 0.3);
    const double a = rnd.uniform(0.5, 2.0), un = rnd.uniform(-0.5, 0.5), u = rnd.uniform(0.0, 0.5);
    const double e = 1e-5;
    if (std::fabs(u - 0.3 * a) < 2.0 * e) continue;
    const NormalForce f = normal_force(c, a, un, u, true);
    const double by_un = normal_energy(c, a, un + e, u) - normal_energy(c, a, un - e, u);
    const double by_u = normal_energy(c, a, un, u + e) - normal_energy(c, a, un, u - e);
    EXPECT_NEAR(-by_un / (2.0 * e), f.contact + f.film, 1e-8);
    EXPECT_NEAR(by_u / (2.0 * e), f.film, 1e-8);
  }
}

TEST(NextGap, FilmForceIsTheSqueezeResistanceTimesTheRateOfTheGap)
{
  // F = -nu a^2 u'/u with nu = (3/2) pi eta, from the change of u over a short step
  const double a = 1.4, eta = 0.6, g = 200.0, dt = 1e-7;
  for (const double range : {0.0, 0.5}) {    // 0: cut
    const Film f = range > 0.0 ? make_film(eta, range, Range::SHIFTED, 0.6)
                               : make_film(eta, 2.0, Range::CUT, 0.6);
    for (const double k : {200.0, 1000.0}) {
      const NormalCoeffs c = make_coeffs(g, k, 0.05);
      for (const double u0 : {0.02, 0.1, 0.3}) {
        const double un = u0 - 0.04;
        const Gap u1 = next_gap(c, f, a, {u0, std::log(u0)}, un, un, dt);
        const double rate = (u1.ln_u - std::log(u0)) / dt;
        const double weight = range > 0.0 ? 1.0 - u0 / range : 1.0;
        const double force = -1.5 * PI_ * eta * a * a * weight * rate;
        EXPECT_NEAR(normal_force(c, a, a * un, a * u0, true).film, force, 2e-5 * std::fabs(force));
      }
    }
  }
}

TEST(NextGap, IsSecondOrderOnSmoothMotionsAlsoWithAShiftedRange)
{
  for (const GapCase &c : GAP_CASES) {
    SCOPED_TRACE(c.name);
    double error = error_of(c, 512, false);
    for (int steps = 1024; steps <= 8192; steps *= 2) {
      const double finer = error_of(c, steps, false);
      EXPECT_NEAR(std::log2(error / finer), 2.0, 0.15) << steps << " steps, error " << finer;
      error = finer;
    }
    EXPECT_LT(error, 3e-6);
  }
}

TEST(NextGap, BackwardEulerIsFirstOrderAlsoWithAShiftedRange)
{
  for (const GapCase &c : GAP_CASES) {
    SCOPED_TRACE(c.name);
    const double error = error_of(c, 8192, true), finer = error_of(c, 16384, true);
    EXPECT_NEAR(std::log2(error / finer), 1.0, 0.1);
    EXPECT_LT(finer, 0.05);
  }
}

TEST(NextGap, TinyViscosityTendsToTheDryPair)
{
  // a rough pair pressed and released, not crushed: the force differs by the film's, which falls
  // with the viscosity
  const double a = 1.0, g = 1e3;
  const NormalCoeffs c = make_coeffs(g, g, 0.02);
  double old_worst = HUGE_VAL;
  for (const double eta : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const Film f = make_film(eta, 2.0, Range::CUT, 0.6);
    const int steps = 1000;
    const double dt = 1e-2;
    double un0 = 0.03, worst = 0.0;
    Gap gap{un0, std::log(un0)};
    for (int n = 1; n <= steps; n++) {
      const double un1 = 0.01 + 0.02 * std::cos(2.0 * PI_ * n / steps);
      gap = next_gap(c, f, a, gap, un0, un1, dt);
      un0 = un1;
      const NormalForce wet = normal_force(c, a, a * un1, a * gap.u_a, true);
      const NormalForce dry = normal_force(c, a, a * un1, a * elastic_gap_a(c.gap, un1), false);
      worst = std::fmax(worst, std::fabs(wet.contact + wet.film - dry.contact));
      worst = std::fmax(worst, std::fabs(wet.contact - dry.contact));
    }
    EXPECT_LT(worst, 0.05 * old_worst + 1e-9) << "eta = " << eta;
    old_worst = worst;
  }
  EXPECT_LT(old_worst, 1e-6);
}

TEST(NextGap, ThinFilmBetweenSmoothSurfacesNeverPushesHarderThanTheSurfacesAllow)
{
  // approach from 0.01 to contact in one step: u stays below 0.01, hence F <= g (0.01 - un) a
  const double a = 1.0, g = 1e3, dt = 1e-3;
  const NormalCoeffs c = make_coeffs(g, g, 0.0);
  for (double eta = 1e-3; eta > 1e-12; eta *= 0.5) {
    const Film f = make_film(eta, 2.0, Range::CUT, 0.6);
    for (const double un1 : {1e-5, 1e-7, 0.0, -1e-7}) {
      const Gap gap = next_gap(c, f, a, {0.01, std::log(0.01)}, 0.01, un1, dt);
      const NormalForce force = normal_force(c, a, a * un1, a * gap.u_a, true);
      ASSERT_LE(force.film, g * a * (0.01 - un1)) << "eta " << eta << " un " << un1;
      ASSERT_GE(force.film, -g * a * 0.01) << "eta " << eta << " un " << un1;
    }
  }
}

TEST(NextGap, ZeroAndNegligibleViscosityAreDry)
{
  const NormalCoeffs c = make_coeffs(1e3, 2e3, 0.02);
  for (const double eta : {0.0, 1e-13}) {
    const Film f = make_film(eta, 2.0, Range::CUT, 0.6);
    EXPECT_TRUE(is_dry(c, f, 1.0, 1e-3));
    for (const double un : {0.1, 0.01, -0.01, -0.5}) {
      const Gap gap = next_gap(c, f, 1.0, gap_of(-50.0), 0.3, un, 1e-3);
      EXPECT_EQ(gap.u_a, elastic_gap_a(c.gap, un));
      EXPECT_NEAR(gap.ln_u, std::log(gap.u_a), 1e-15);
    }
  }
  EXPECT_FALSE(is_dry(c, make_film(1e-9, 2.0, Range::CUT, 0.6), 1.0, 1e-3));
}

TEST(ShiftedRange, SqueezeForceVanishesAtItsEnd)
{
  // surfaces that leave at a constant speed: F = -nu a^2 (1 - un/range) un'/un, soft corrections
  const double a = 1.3, eta = 0.5, range = 0.4, g = 1e6, speed = 0.1, dt = 1e-4;
  const NormalCoeffs c = make_coeffs(g, g, 0.0);
  const Film f = make_film(eta, range, Range::SHIFTED, 0.6);
  double un = 0.1;
  Gap gap{un, std::log(un)};
  double last = 0.0;
  while (un < range - 1e-9) {
    const double un1 = std::fmin(un + speed * dt, range);
    gap = next_gap(c, f, a, gap, un, un1, dt * (un1 - un) / (speed * dt));
    un = un1;
    if (un < 0.11) continue;    // the deflection sets in
    last = normal_force(c, a, a * un, a * gap.u_a, true).film;
    const double exact = -1.5 * PI_ * eta * a * a * (1.0 - un / range) * speed / un;
    ASSERT_NEAR(last, exact, 2e-3 * std::fabs(exact) + 2e-4) << "un = " << un;
  }
  EXPECT_NEAR(last, 0.0, 2e-4);
}

TEST(FilmSteps, CutRangeIsTheStepOverTau)
{
  // tau = (3/2) pi eta a/g
  const NormalCoeffs c = make_coeffs(50.0, 50.0, 0.01);
  const Film f = make_film(2.0, 2.0, Range::CUT, 0.6);
  EXPECT_NEAR(film_steps(c, f, 3.0, gap_of(-4.0), 0.1, 0.2, 0.01), 0.01 * 50.0 / (PI_ * 9.0),
              1e-15);
}

TEST(FilmSteps, ShiftedRangeDividesByTheRemainingResistance)
{
  const NormalCoeffs c = make_coeffs(50.0, 50.0, 0.0);
  const Film f = make_film(2.0, 0.5, Range::SHIFTED, 0.6);
  // at rest, u = un = 0.3: 1 - 0.3/0.5
  const Gap gap{0.3, std::log(0.3)};
  EXPECT_NEAR(film_steps(c, f, 3.0, gap, 0.3, 0.3, 0.01), 0.01 * 50.0 / (PI_ * 9.0) / 0.4, 1e-14);
}

TEST(FilmSteps, IsPositiveAndFiniteForAnything)
{
  Random rnd(4);
  for (int trial = 0; trial < 100000; trial++) {
    const double eps = rnd.coin() ? rnd.log_uniform(1e-8, 0.3) : 0.0;
    const NormalCoeffs c = make_coeffs(1.0, rnd.log_uniform(1e-6, 1e6), eps);
    const double eta = rnd.log_uniform(1e-11, 1e12), range = rnd.log_uniform(1e-3, 10.0);
    const Film f =
        make_film(eta, range, rnd.coin() ? Range::CUT : Range::SHIFTED, rnd.uniform(0.0, 1.5));
    const double ln_u = rnd.coin() ? rnd.uniform(-20.0, 5.0) : -rnd.log_uniform(1.0, 1e5);
    const double un0 = rnd.uniform(-1.0, range), un1 = rnd.uniform(-1.0, range);
    const double h = film_steps(c, f, 1.0, gap_of(ln_u), un0, un1, 1.0);
    ASSERT_TRUE(h > 0.0 && std::isfinite(h)) << ln_u << " " << un0 << " " << un1 << " " << eta;
    // the resistance is never more than the whole
    ASSERT_GE(h, 1.0 / (1.5 * PI_ * eta) * (1.0 - 1e-12));
    const Gap next = next_gap(c, f, 1.0, gap_of(ln_u), un0, un1, 1.0);
    ASSERT_TRUE(std::isfinite(next.ln_u) && next.u_a >= 0.0);
  }
}
