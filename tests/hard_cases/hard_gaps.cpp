// Gaps where they are hardest to follow: closed, pressed for long, released, born overlapping, at
// the border of contact, torn open. Oracles: closed forms of du/dt = u (r - A u) and of Newton's
// law, and stored SciPy solutions.

#include "../kernel/reference/gap_reference.h"
#include "falling.h"

using namespace hard_cases;
using namespace testing_tools;

namespace {

GapLaw gap_law(double alpha, double eps)
{
  return {alpha, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, false};
}

// ln u of an opening pair, un linear from un0 to un1 over h, A = 1: quadrature of
// w1 = w0 exp(-X(h)) + integral exp(X(t) - X(h)) dt, X the integral of un.
double opened(double u0, double un0, double un1, double h)
{
  auto X = [=](long double t) {
    return un0 * t + (un1 - un0) * t * t / (2.0L * h);
  };
  const long double begin = std::max(0.0L, static_cast<long double>(h) - 60.0L / un1);
  const int n = 100000;
  long double sum = 0.0;
  for (int m = 0; m <= n; m++) {
    const long double t = begin + (h - begin) * m / n;
    sum += (m == 0 || m == n ? 1.0L : m % 2 ? 4.0L : 2.0L) * std::exp(X(t) - X(h));
  }
  sum *= (h - begin) / (3.0L * n);
  return static_cast<double>(-std::log(std::exp(-X(h)) / u0 + sum));
}

}    // namespace

TEST(HardGaps, SmoothSpheresUnderAWeightForAMillionSteps)
{
  // u passes 1e-280 and the smallest number
  const double g = 5e3, weight = 100.0, mass = 1e-3, eta = 1.0, u0 = 0.1;
  const double c = film_coefficient(eta, 1.0);
  Scene s = above(make_coeffs(g, g, 0.0, g, 0.5), eta, u0, mass, weight, 0.1 * std::sqrt(mass / g));
  double worst = 0.0;
  for (int n = 1; n <= 1000000; n++) {
    s.step();
    if (n % 1000) continue;
    const double exact = std::log(u0) - weight / c * n * s.dt - mass * speed(s) / c;
    worst = std::fmax(worst, std::fabs(ln_gap(s) - exact));
    ASSERT_EQ(s.pairs[0].load.contact, 0.0) << "smooth spheres do not touch";
    ASSERT_EQ(s.pairs[0].load.cone, 0.0) << "nor rub";
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(ln_gap(s), -745.0);    // exp() of it is 0
}

TEST(HardGaps, SuctionLastsAsLongAsThePressure)
{
  // pressed by the weight for t1, then pulled by it: m v + c ln u says when the gap is back
  const double g = 5e3, weight = 100.0, mass = 1e-3, eta = 1.0, u0 = 0.1;
  const double c = film_coefficient(eta, 1.0);
  for (const int pressed : {1000, 10000, 100000}) {
    Scene s =
        above(make_coeffs(g, g, 0.0, g, 0.5), eta, u0, mass, weight, 0.1 * std::sqrt(mass / g));
    for (int n = 0; n < pressed; n++) s.step();
    s.gravity = -1.0 * s.gravity;
    const double deepest = ln_gap(s);
    int pulled = 0;
    while (ln_gap(s) < std::log(u0) && pulled < 3 * pressed) {
      s.step();
      pulled++;
    }
    EXPECT_LT(deepest, std::log(u0) - 0.8 * weight / c * pressed * s.dt);
    // the impulse m v of the sphere, which already leaves, is the rest
    const double late = (pulled - pressed) * s.dt * weight;
    EXPECT_NEAR(late, mass * speed(s), 2.0 * weight * s.dt) << pressed;
  }
}

TEST(HardGaps, SmoothSpheresBornDeepInsideEachOtherKeepTheirImpulse)
{
  // a film of the least thickness holds them: they swing on the bulk and stay
  const double g = 1e3, mass = 2.0, eta = 1.0;
  for (const double un : {-1e-9, -0.01, -0.3, -0.4, -0.95}) {
    Scene s =
        above(make_coeffs(g, g, 0.0, g, 0.5), eta, un, mass, 1e-300, 0.02 * std::sqrt(mass / g));
    EXPECT_NEAR(s.pairs[0].load.normal, -g * un, 2.0 * THINNEST_A * g) << "repels at once";
    const double c = film_coefficient(eta, 1.0), energy = s.stored() + s.kinetic();
    const double most = mass * std::fabs(un) * std::sqrt(g / mass) / c;
    for (int n = 1; n <= 20000 && s.pairs[0].known; n++) {
      s.step();
      if (!s.pairs[0].known) break;
      const double impulse = ln_gap(s) + mass * speed(s) / c;
      ASSERT_NEAR(impulse, std::log(THINNEST_A), 1e-3 * most + 1e-9)
          << "un " << un << " step " << n;
      ASSERT_LE(s.stored() + s.kinetic(), energy * (1.0 + 1e-3));
      ASSERT_LT(s.spheres[1].x.z - 2.0, std::fabs(un) * 1.001 + 2.0 * THINNEST_A);
    }
  }
}

TEST(HardGaps, DrySpheresBornDeepInsideEachOtherLeaveWithTheEnergyOfTheirSprings)
{
  const double g = 1e3, k = 500.0, eps = 0.02, mass = 2.0;
  for (const double un : {-1e-6, -0.005, -0.3, -0.95}) {
    const double dt = 2e-3 * std::sqrt(mass / g);
    Scene s = above(make_coeffs(g, k, eps, g, 0.5), 0.0, un, mass, 1e-300, dt);
    for (int n = 0; n < 1000000 && s.spheres[1].x.z < 2.1; n++) {
      s.step();
      ASSERT_GE(s.pairs[0].load.normal, 0.0) << "never attracts";
      ASSERT_EQ(s.pairs[0].load.film, 0.0);
    }
    // asperities and bulk in series until the former are flat, at un = -(k/g) eps; then the bulk
    const double series = g * k / (g + k), flat = -k / g * eps, soft = std::fmax(un, flat);
    double energy = 0.5 * series * (eps - soft) * (eps - soft);
    if (un < flat) energy += 0.5 * g * (un * un - flat * flat);
    EXPECT_NEAR(0.5 * mass * speed(s) * speed(s) / energy, 1.0, 1e-4) << "un " << un;
  }
}

TEST(HardGaps, TransitionsOfContactAtAnyAlignmentWithTheStep)
{
  for (const GapCase &c : GAP_CASES) {
    if (c.shift != 0.0 || c.transitions == 0) continue;
    SCOPED_TRACE(c.name);
    auto error = [&c](int steps, double first) {
      const GapLaw law = gap_law(c.alpha, c.eps);
      const double h = c.end / steps;
      Gap gap{c.u0, std::log(c.u0)};
      double from = 0.0;
      for (double to = first * h; from < c.end; to += h) {
        to = c.end - to < 1e-9 * h ? c.end : to;
        gap = gap_step(law, gap, c.c0 + c.c1 * std::cos(c.w * from + c.p),
                       c.c0 + c.c1 * std::cos(c.w * to + c.p), to - from);
        from = to;
      }
      return std::fabs(gap.ln_u - c.y[15]);
    };
    const double coarse = error(256, 1.0), fine = error(1024, 1.0);
    EXPECT_GT(coarse / fine, 14.0);    // second order
    for (int m = 1; m < 64; m++) {
      EXPECT_LT(error(256, m / 64.0), 1.1 * coarse) << m;
      EXPECT_LT(error(1024, m / 64.0), 1.1 * fine) << m;
    }
  }
}

TEST(HardGaps, NoChatterAtTheBorderOfContact)
{
  // surfaces that pass eps (1 +- d) in turn: u may not leave these bounds, however stiff the film
  const double eps = 0.01;
  for (const double alpha : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    for (const double h : {1e-2, 1.0, 1e2, 1e4, 1e6, 1e9})
      for (const double d : {1e-12, 1e-6, 1e-3}) {
        const GapLaw law = gap_law(alpha, eps);
        Gap gap{eps, law.ln_eps};
        for (int n = 0; n < 2000; n++) {
          const double way = n % 2 ? d : -d;
          gap = gap_step(law, gap, eps * (1.0 - way), eps * (1.0 + way), h);
          ASSERT_LE(std::fabs(gap.ln_u - law.ln_eps), 1.001 * d + 1e-14)
              << alpha << " " << h << " " << d;
        }
      }
}

TEST(HardGaps, AnAdhesiveContactFormsAndBreaksOnceHoweverTheSurfacesTremble)
{
  GapLaw law = gap_law(2.0, 0.01);
  law.release_a = 0.012;
  law.ln_release = std::log(0.012);
  const double broken = 0.012 + 2.0 * 0.002;    // un at which it breaks, film at rest
  Gap gap{0.02, std::log(0.02)};
  int changes = 0;
  const double h = 1e5;
  double un = 0.02;
  // down to the border of contact, up to that of release; at each tremble for 1000 steps
  for (const double stay : {0.01, broken, 0.02}) {
    for (int n = 0; n < 1000; n++) {
      const double next = stay * (1.0 + (n % 2 ? 1e-4 : -1e-4));
      const Gap after = gap_step<ADHESION>(law, gap, un, next, h);
      changes += after.bond != gap.bond;
      gap = after;
      un = next;
    }
  }
  EXPECT_EQ(changes, 2);
  EXPECT_EQ(gap.bond, 0.0);
}

TEST(HardGaps, APairAtOneHundredMillionthPulledOpenInAFewSteps)
{
  const GapLaw smooth = gap_law(1.0, 0.0);
  const double u0 = 1e-8, un1 = 0.3;
  for (const int steps : {1, 3, 10})
    for (const double h : {1e-2, 1.0, 1e2, 1e3, 1e4, 1e6, 1e8}) {    // from slow films to fast ones
      const double exact = opened(u0, u0, un1, h);
      Gap gap{u0, std::log(u0)};
      for (int n = 0; n < steps; n++) {
        gap = gap_step(smooth, gap, u0 + (un1 - u0) * n / steps, u0 + (un1 - u0) * (n + 1) / steps,
                       h / steps);
        // suction: never more than the bulk holds, never repulsion
        ASSERT_LT(gap.u_a, u0 + (un1 - u0) * (n + 1) / steps);
        ASSERT_GT(gap.u_a, 0.0);
      }
      // sixteen pieces of a step: an exponential of a mean instead of a mean of exponentials
      EXPECT_NEAR(gap.ln_u, exact, h > 1.0 ? 3e-4 : 1e-9) << steps << " steps, h " << h;
    }
}
