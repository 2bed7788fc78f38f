// Shows that both gap integrators solve du/dt = u (r - A u): order, limits, bounds, transitions.

#include "lubcontact_gap.h"
#include "reference/gap_reference.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

GapLaw make_law(double alpha, double eps, bool euler = false)
{
  return {alpha, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, euler};
}

Gap gap_of(double ln_u)
{
  return {std::exp(ln_u), ln_u};
}

// ln u after time h at constant r, as long double: the closed form of the logistic equation.
double closed_form(double y0, double r, double A, double h)
{
  const long double x = static_cast<long double>(r) * h;
  const long double mean = x == 0.0L ? 1.0L : -std::expm1(-x) / x;
  return static_cast<double>(-std::log(std::exp(-x - static_cast<long double>(y0)) +
                                       static_cast<long double>(A) * h * mean));
}

// Simpson's rule for f on (0, 1).
template <class F> long double integral(F f)
{
  const int n = 1000;
  long double sum = f(0.0L) + f(1.0L);
  for (int m = 1; m < n; m++) sum += (m % 2 ? 4.0L : 2.0L) * f(m / static_cast<long double>(n));
  return sum / (3.0L * n);
}

double motion(const GapCase &c, double t)
{
  return c.c0 + c.c1 * std::cos(c.w * t + c.p);
}

// Largest error of ln u at the 16 reference times, in `steps` steps.
double error_of(const GapCase &c, int steps, bool euler)
{
  const GapLaw law = make_law(c.alpha, c.eps, euler);
  const double h = c.end / steps;
  Gap gap{c.u0, std::log(c.u0)};
  double worst = 0.0;
  for (int n = 0; n < steps; n++) {
    gap = gap_step(law, gap, motion(c, n * h), motion(c, (n + 1) * h), h);
    if ((n + 1) % (steps / 16) == 0)
      worst = std::fmax(worst, std::fabs(gap.ln_u - c.y[(n + 1) / (steps / 16) - 1]));
  }
  return worst;
}

struct Draw {    // any step a run could ask for, and many it could not
  GapLaw law;
  double y0, un0, un1, h;
  explicit Draw(Random &rnd, bool euler = false)
  {
    const double eps = rnd.coin() ? rnd.log_uniform(1e-8, 0.3) : 0.0;
    law = make_law(rnd.log_uniform(1e-6, 1e6), eps, euler);
    y0 = rnd.coin() ? rnd.uniform(-20.0, 2.0) : -rnd.log_uniform(1e-3, 1e5);
    un0 = rnd.log_uniform(1e-8, 1.0) * (rnd.coin() ? 1.0 : -1.0);
    un1 = rnd.coin() ? un0 * rnd.uniform(-1.0, 2.0)
                     : rnd.log_uniform(1e-8, 1.0) * (rnd.coin() ? 1.0 : -1.0);
    h = rnd.log_uniform(1e-12, 1e11);
  }
  double step() const { return gap_step(law, gap_of(y0), un0, un1, h).ln_u; }
};

std::ostream &operator<<(std::ostream &out, const Draw &d)
{
  out.precision(17);
  return out << "alpha " << d.law.alpha << " eps " << d.law.eps_a << " y0 " << d.y0 << " un0 "
             << d.un0 << " un1 " << d.un1 << " h " << d.h;
}

// u stays the same length when the radii, and with them a, grow.
TEST(RescaledGap, KeepsTheLength)
{
  for (double u : {0.3, 1e-2, 1e-9, 1e-250}) {
    const double a = 1.3, grown = 1.7;
    double gap[2] = {u / a, std::log(u / a)};
    rescale_gap(a / grown, gap);
    EXPECT_NEAR(gap[0] * grown / u, 1.0, 1e-15);
    EXPECT_NEAR(gap[1], std::log(u) - std::log(grown), 1e-12);
  }
}

}    // namespace

TEST(ExponentialMean, AgreesWithQuadratureOnBothSidesOfTheSeries)
{
  for (const double z : {-29.0, -5.0, -0.31, -0.29, -1e-3, 0.0, 1e-9, 0.2999, 0.3001, 2.0, 29.0}) {
    const long double phi = integral([z](long double s) {
      return std::exp(-z * s);
    });
    const long double psi = integral([z](long double s) {
      return s * s * std::exp(-z * s);
    });
    const ExponentialMean m = exponential_mean(z);
    EXPECT_NEAR(m.phi / static_cast<double>(phi), 1.0, 1e-8) << "z = " << z;
    EXPECT_NEAR(m.mean_s2 * static_cast<double>(phi / psi), 1.0, 1e-8) << "z = " << z;
    if (std::fabs(z) < 1.0) {    // where Simpson's rule is exact to rounding
      EXPECT_NEAR(m.phi / static_cast<double>(phi), 1.0, 1e-13) << "z = " << z;
      EXPECT_NEAR(m.mean_s2 * static_cast<double>(phi / psi), 1.0, 3e-11) << "z = " << z;
    }
    const LogExponentialMean ln = log_exponential_mean(z);
    EXPECT_NEAR(ln.ln_phi, static_cast<double>(std::log(phi)), 1e-8);
    EXPECT_EQ(ln.mean_s2, m.mean_s2);
  }
}

TEST(ExponentialMean, LogarithmIsContinuousWhereTheAsymptoticFormBegins)
{
  for (const double z : {-30.0, 30.0}) {
    const LogExponentialMean in = log_exponential_mean(z * (1.0 - 1e-15));
    const LogExponentialMean out = log_exponential_mean(z * (1.0 + 1e-15));
    EXPECT_NEAR(in.ln_phi, out.ln_phi, 1e-12);
    EXPECT_NEAR(in.mean_s2, out.mean_s2, 1e-12);
  }
  // phi -> 1/z and exp(-z)/(-z)
  EXPECT_NEAR(log_exponential_mean(1e10).ln_phi, -std::log(1e10), 1e-12);
  EXPECT_NEAR(log_exponential_mean(-1e6).ln_phi, 1e6 - std::log(1e6), 1e-9);
}

TEST(LogAddExp, AgreesWithTheDefinitionAndDoesNotOverflow)
{
  EXPECT_NEAR(log_add_exp(std::log(2.0), std::log(3.0)), 1.6094379124341003, 1e-15);
  EXPECT_NEAR(log_add_exp(1e5, 1e5), 1e5 + 0.6931471805599453, 1e-10);
  EXPECT_EQ(log_add_exp(-1e5, 1e5), 1e5);
  EXPECT_EQ(log_add_exp(3.0, -HUGE_VAL), 3.0);
}

TEST(ExponentialScheme, IsExactForConstantSurfaces)
{
  Random rnd(1);
  for (int trial = 0; trial < 20000; trial++) {
    const double y0 = rnd.uniform(-300.0, 2.0), A = 1.0 + rnd.log_uniform(1e-6, 1e6);
    const double h = rnd.log_uniform(1e-10, 1e5);
    const double r = rnd.uniform(-1.0, 1.0) * std::fmin(1.0, 5000.0 / h);
    const double exact = closed_form(y0, r, A, h);
    const double tolerance = 1e-12 * (1.0 + std::fabs(y0) + std::fabs(r * h));
    EXPECT_NEAR(gap_exponential(gap_of(y0), r, r, A, h).ln_u, exact, tolerance)
        << y0 << " " << r << " " << h;
    EXPECT_NEAR(gap_exponential_any(y0, r, r, A, h), exact, tolerance);
  }
}

TEST(ExponentialScheme, ErrorForMovingSurfacesIsTheVarianceOfTheMean)
{
  // exp of a mean instead of the mean of exp: half the variance of D s^2, at most 0.045 D^2
  Random rnd(2);
  for (int trial = 0; trial < 300; trial++) {
    const double z = rnd.uniform(-20.0, 20.0), D = rnd.uniform(-0.5, 0.5), h = 3.0;
    const double r1 = z / h, r0 = r1 - 2.0 * D / h, y0 = rnd.uniform(-5.0, 3.0), A = 1.7;
    const long double I = integral([=](long double s) {
      return std::exp(-z * s + D * s * s);
    });
    const double exact =
        static_cast<double>(-std::log(std::exp(static_cast<long double>(D - z - y0)) + A * h * I));
    EXPECT_NEAR(gap_exponential(gap_of(y0), r0, r1, A, h).ln_u, exact, 0.05 * D * D + 1e-8);
    EXPECT_NEAR(gap_exponential_any(y0, r0, r1, A, h), exact, 0.05 * D * D + 1e-8);
  }
}

TEST(ExponentialScheme, FastPathEqualsTheGeneralOne)
{
  Random rnd(3);
  for (int trial = 0; trial < 50000; trial++) {
    const double h = rnd.log_uniform(1e-8, 1e4), y0 = rnd.uniform(-300.0, 5.0);
    const double x = rnd.uniform(-30.0, 30.0), D = rnd.uniform(-0.01, 0.01);
    const double r0 = (x - D) / h, r1 = (x + D) / h, A = 1.0 + rnd.log_uniform(1e-3, 1e3);
    const double fast = gap_exponential(gap_of(y0), r0, r1, A, h).ln_u;
    const double any = gap_exponential_any(y0, r0, r1, A, h);
    // the cubic exp_q leaves q^4/24, where |q| < D/3 if z > 0 and |q| < D if not
    const double q = std::fabs(D) * (x + D > 0.0 ? 1.0 / 3.0 : 1.0);
    EXPECT_NEAR(fast, any, q * q * q * q / 20.0 + 1e-13 * (1.0 + std::fabs(any)));
  }
}

TEST(ExponentialScheme, LongStepReachesTheElasticGapOrClosesExponentially)
{
  for (const double h : {1e6, 1e9, 1e11}) {
    EXPECT_NEAR(gap_exponential(gap_of(-3.0), 0.02, 0.02, 2.0, h).ln_u, std::log(0.01), 1e-12);
    EXPECT_NEAR(gap_exponential(gap_of(-3.0), -0.02, -0.02, 2.0, h).ln_u / (-0.02 * h), 1.0, 1e-3);
  }
}

TEST(ExponentialScheme, ShortStepFollowsTheRate)
{
  // u (r - A u) at u = 0.1, r = 0.3, A = 2
  const double h = 1e-9, y0 = std::log(0.1);
  EXPECT_NEAR((gap_exponential(gap_of(y0), 0.3, 0.3, 2.0, h).ln_u - y0) / h, 0.1, 1e-6);
  EXPECT_NEAR((gap_euler(gap_of(y0), 0.3, 2.0, h).ln_u - y0) / h, 0.1, 1e-6);
}

TEST(ExponentialScheme, IsSecondOrderOnSmoothMotions)
{
  for (const GapCase &c : GAP_CASES) {
    if (c.shift != 0.0) continue;    // needs next_gap, see test_normal.cpp
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

TEST(ExponentialScheme, ExtrapolatesToTheReference)
{
  // both halves of Richardson's rule must be right for nine digits to appear
  for (const GapCase &c : GAP_CASES) {
    if (c.shift != 0.0) continue;
    SCOPED_TRACE(c.name);
    const GapLaw law = make_law(c.alpha, c.eps);
    double end[2];
    for (int fine = 0; fine < 2; fine++) {
      const int steps = fine ? 16384 : 8192;
      const double h = c.end / steps;
      Gap gap{c.u0, std::log(c.u0)};
      for (int n = 0; n < steps; n++)
        gap = gap_step(law, gap, motion(c, n * h), motion(c, (n + 1) * h), h);
      end[fine] = gap.ln_u;
    }
    EXPECT_NEAR((4.0 * end[1] - end[0]) / 3.0, c.y[15], 1e-9);
  }
}

TEST(BackwardEuler, IsFirstOrderOnSmoothMotions)
{
  for (const GapCase &c : GAP_CASES) {
    if (c.shift != 0.0) continue;
    SCOPED_TRACE(c.name);
    double error = error_of(c, 2048, true);
    for (int steps = 4096; steps <= 16384; steps *= 2) {
      const double finer = error_of(c, steps, true);
      EXPECT_NEAR(std::log2(error / finer), 1.0, 0.1) << steps << " steps, error " << finer;
      error = finer;
    }
    EXPECT_LT(error, 0.05);
  }
}

TEST(BackwardEuler, SolvesItsQuadraticToRounding)
{
  Random rnd(4);
  for (int trial = 0; trial < 20000; trial++) {
    const double y0 = rnd.uniform(-300.0, 2.0), r = rnd.uniform(-1.0, 1.0);
    const double A = 1.0 + rnd.log_uniform(1e-6, 1e6), h = rnd.log_uniform(1e-8, 1e8);
    const long double u0 = std::exp(static_cast<long double>(y0));
    const long double u1 = std::exp(static_cast<long double>(gap_euler(gap_of(y0), r, A, h).ln_u));
    // u1 - u0 = h u1 (r - A u1), every term beside the largest
    const long double b = u1 * (1.0L - static_cast<long double>(h) * r);
    const long double quadratic = static_cast<long double>(A) * h * u1 * u1;
    const double size = static_cast<double>(std::fmax(u0, std::fmax(std::fabs(b), quadratic)));
    EXPECT_NEAR(static_cast<double>(b + quadratic - u0) / size, 0.0, 1e-12) << Draw(rnd);
  }
}

TEST(BackwardEuler, IsFiniteWhereBothTermsOfItsRootVanish)
{
  // r h = 1 and exp(y0) = 0 in double precision: u1 = sqrt(u0/(A h))
  for (const double y0 : {-700.0, -1000.0}) {
    const double exact = 0.5 * (y0 - std::log(2.0));
    EXPECT_NEAR(gap_euler(gap_of(y0), 0.5, 1.0, 2.0).ln_u, exact, 1e-9) << "y0 = " << y0;
  }
}

TEST(GapStep, IsFiniteForAnything)
{
  Random rnd(5);
  for (int trial = 0; trial < 100000; trial++) {
    const Draw d(rnd, trial % 4 == 0);
    ASSERT_TRUE(std::isfinite(d.step())) << d;
  }
}

TEST(GapStep, StaysBetweenItsStartAndItsElasticLimits)
{
  // du/dt = u (un - u + alpha max(0, eps - u)) has the sign of elastic gap - u
  Random rnd(6);
  const double slack = 0.05;    // of ln u: error of a step
  for (int trial = 0; trial < 100000; trial++) {
    const Draw d(rnd, trial % 4 == 0);
    auto rest = [&d](double un) {
      const double u = un < d.law.eps_a ? (un + d.law.alpha * d.law.eps_a) / (1.0 + d.law.alpha)
                                        : un;
      return u > 0.0 ? std::log(u) : -HUGE_VAL;
    };
    const double y1 = d.step();
    ASSERT_LE(y1, std::fmax(d.y0, rest(std::fmax(d.un0, d.un1))) + slack) << d;
    ASSERT_GE(y1, std::fmin(d.y0, rest(std::fmin(d.un0, d.un1))) - slack) << d;
  }
}

TEST(GapStep, QuasiStaticFilmClosesOnTheSurfacesWhenTheyTouch)
{
  // a thin film while smooth surfaces close onto un = 0: u stays below the gap at the start
  const GapLaw smooth = make_law(1.0, 0.0);
  for (const double h : {1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11})
    for (const double un1 : {1e-5, 1e-7, 1e-9, 0.0, -1e-9, -1e-7}) {
      const double y1 = gap_step(smooth, gap_of(std::log(0.01)), 0.01, un1, h).ln_u;
      EXPECT_LT(y1, std::log(0.01)) << "h " << h << " un1 " << un1;
    }
}

TEST(GapStep, KeepsTheGapAndItsLogarithmTogether)
{
  Random rnd(10);
  for (int trial = 0; trial < 100000; trial++) {
    const Draw d(rnd, trial % 4 == 0);
    const Gap end = gap_step(d.law, gap_of(d.y0), d.un0, d.un1, d.h);
    if (end.ln_u > -700.0 && end.ln_u < 700.0)
      ASSERT_NEAR(std::log(end.u_a), end.ln_u, 1e-12 * (1.0 + std::fabs(end.ln_u))) << d;
    else
      ASSERT_TRUE(end.u_a < 1e-300 || end.u_a > 1e300) << d;
  }
}

TEST(GapStep, ThinFilmThatOpensFastKeepsTheDigitsOfItsLogarithm)
{
  // exp(-x) is small beside 1: ln(1 + q) of q = exp(-x) - 1 has lost it
  for (const double x : {5.0, 15.0, 25.0, 29.9}) {
    const Gap end = gap_step(make_law(1.0, 0.0), gap_of(-250.0), x / 10.0, x / 10.0, 10.0);
    EXPECT_NEAR(end.ln_u, -250.0 + x, 1e-12) << "x = " << x;
    EXPECT_NEAR(end.u_a / std::exp(-250.0 + x), 1.0, 1e-12) << "x = " << x;
  }
}

TEST(GapStep, GapAndLogarithmDoNotDriftApartInAMillionSteps)
{
  const GapLaw law = make_law(1.0, 0.01);
  for (const double amplitude : {0.0, 0.03}) {
    Gap gap = gap_of(std::log(0.02));
    double un0 = 0.02 + amplitude;
    for (int n = 1; n <= 1000000; n++) {
      const double un1 = 0.02 + amplitude * (n % 2000 < 1000 ? 1.0 : -1.0);
      gap = gap_step(law, gap, un0, un1, 0.5);
      un0 = un1;
    }
    EXPECT_NEAR(std::log(gap.u_a), gap.ln_u, 1e-10);
  }
}

TEST(GapStep, GrowsWithTheGapBefore)
{
  Random rnd(7);
  for (int trial = 0; trial < 50000; trial++) {
    Draw d(rnd, trial % 4 == 0);
    const double y1 = d.step();
    d.y0 += rnd.log_uniform(1e-6, 10.0);
    ASSERT_GE(d.step(), y1 - 1e-9 * (1.0 + std::fabs(y1))) << d;
  }
}

TEST(GapStep, GrowsWithTheSurfaceAfter)
{
  Random rnd(8);
  for (int trial = 0; trial < 50000; trial++) {
    Draw d(rnd, trial % 4 == 0);
    // what the cut into pieces cannot resolve is bounded, not ordered
    if (d.h * std::fabs(d.un1 - d.un0) > 1.0 && !d.law.euler) continue;
    const double y1 = d.step();
    d.un1 += std::fmin(rnd.log_uniform(1e-6, 1.0), 1.0 / d.h);
    if (d.h * std::fabs(d.un1 - d.un0) > 1.0 && !d.law.euler) continue;
    ASSERT_GE(d.step(), y1 - 1e-9 * (1.0 + std::fabs(y1))) << d;
  }
}

TEST(GapStep, DoesNotDependOnWhereTheStepIsCut)
{
  Random rnd(9);
  int crossed = 0;
  for (int trial = 0; trial < 20000; trial++) {
    const double eps = rnd.log_uniform(1e-4, 0.1);
    const GapLaw law = make_law(rnd.log_uniform(1e-3, 1e3), eps);
    const double y0 = law.ln_eps + rnd.uniform(-3.0, 3.0);
    const double un = rnd.uniform(-1.0, 3.0) * eps;
    const double h = rnd.log_uniform(0.01, 100.0) / eps / (1.0 + law.alpha);
    const double cut = rnd.uniform(0.0, 1.0);
    const double whole = gap_step(law, gap_of(y0), un, un, h).ln_u;
    const Gap first = gap_step(law, gap_of(y0), un, un, cut * h);
    const double parts = gap_step(law, first, un, un, (1.0 - cut) * h).ln_u;
    EXPECT_NEAR(parts, whole, 1e-10 * (1.0 + std::fabs(whole)));
    crossed += (y0 < law.ln_eps) != (whole < law.ln_eps);
  }
  EXPECT_GT(crossed, 2000);    // the draws do test transitions
}

TEST(GapStep, MeetsTheTransitionAtTheTimeOfTheClosedForm)
{
  // from u = 0.2 at un = -0.1 to the border eps = 0.05, then in contact: both by the closed form
  const double eps = 0.05, alpha = 3.0, un = -0.1, h = 20.0;
  // w(t) = (w0 + 1/|un|) exp(|un| t) - 1/|un| reaches 20 from 5
  const double t = 10.0 * std::log((20.0 + 10.0) / (5.0 + 10.0));
  const double exact = closed_form(std::log(eps), un + alpha * eps, 1.0 + alpha, h - t);
  const GapLaw law = make_law(alpha, eps);
  EXPECT_NEAR(gap_step(law, gap_of(std::log(0.2)), un, un, h).ln_u, exact, 1e-11);

  // and out of contact: u = 0.01 at un = 0.2
  const double r = 0.2 + alpha * eps, w0 = 100.0, w1 = 20.0, A = 1.0 + alpha;
  const double out = std::log((w0 - A / r) / (w1 - A / r)) / r;
  EXPECT_NEAR(gap_step(law, gap_of(std::log(0.01)), 0.2, 0.2, h).ln_u,
              closed_form(std::log(eps), 0.2, 1.0, h - out), 1e-11);
}

TEST(GapStep, OnTheBorderTheSurfacesDecide)
{
  const GapLaw law = make_law(9.0, 0.02);
  const Gap border = gap_of(law.ln_eps);
  const double h = 5.0;
  auto end = [&](double un) {
    return gap_step(law, border, un, un, h).ln_u;
  };
  EXPECT_NEAR(end(0.1), closed_form(law.ln_eps, 0.1, 1.0, h), 1e-13);
  EXPECT_NEAR(end(-0.1), closed_form(law.ln_eps, -0.1 + 0.18, 10.0, h), 1e-13);
  EXPECT_NEAR(end(0.02), law.ln_eps, 1e-13);
}

TEST(GapStep, FromTheBorderIsTheLimitOfStepsFromTheSideOfTheMeanDrive)
{
  // surfaces that open on average and yet end closer than the border, and the other way
  for (const bool euler : {false, true}) {
    const GapLaw law = make_law(2.0, 0.05, euler);
    for (const double way : {0.03, -0.03}) {
      for (const double h : {10.0, 100.0, 1000.0}) {
        auto end = [&](double y0) {
          return gap_step(law, gap_of(y0), 0.05 + way, 0.05 - 0.9 * way, h).ln_u;
        };
        const double side = way > 0.0 ? 1e-9 : -1e-9;
        EXPECT_NEAR(end(law.ln_eps), end(law.ln_eps + side), 1e-6) << way << " " << h;
      }
    }
  }
}

TEST(GapStep, ComesBackFromTheDeepestCompression)
{
  // un = -1 for 1e5, then +1 as long: the area is repaid and the film opens where it closed
  const GapLaw smooth = make_law(1.0, 0.0);
  Gap gap = gap_of(std::log(0.1));
  for (int n = 0; n < 100; n++) gap = gap_step(smooth, gap, -1.0, -1.0, 1e3);
  // u = u0/(1 + u0) exp(-t)
  EXPECT_NEAR(gap.ln_u, -1e5 + std::log(0.1 / 1.1), 1e-8);
  for (int n = 0; n < 100; n++) gap = gap_step(smooth, gap, 1.0, 1.0, 1e3);
  // 1/u = exp(-x)/u + (1 - exp(-x)) with everything repaid: 11 + 1
  EXPECT_NEAR(gap.ln_u, -std::log(12.0), 1e-8);
}

TEST(GapStep, SustainedCompressionFollowsTheClosedFormForAHundredThousandSteps)
{
  const GapLaw smooth = make_law(1.0, 0.0);
  const double un = -0.03, h = 0.7;
  Gap gap{0.05, std::log(0.05)};
  for (int n = 1; n <= 100000; n++) {
    gap = gap_step(smooth, gap, un, un, h);
    if (n % 1000) continue;
    // 1/u = (1/u0 + 1/|un|) exp(|un| t) - 1/|un|
    const double x = 0.03 * 0.7 * n;
    const double exact = -x - std::log(1.0 / 0.05 + 1.0 / 0.03 * (1.0 - std::exp(-x)));
    ASSERT_NEAR(gap.ln_u, exact, 1e-12 * n) << "step " << n;
  }
}

TEST(GapStep, RemembersCompressionWhereBackwardEulerForgets)
{
  // the suction of a smooth pair lasts as long as it was pressed: un = -0.1 for 300, +0.1 for 200
  const GapLaw smooth = make_law(1.0, 0.0), euler = make_law(1.0, 0.0, true);
  Gap gap = gap_of(std::log(0.1)), gap_e = gap;
  const double h = 20.0;
  for (int n = 0; n < 25; n++) {
    const double un = n < 15 ? -0.1 : 0.1;
    gap = gap_step(smooth, gap, un, un, h);
    gap_e = gap_step(euler, gap_e, un, un, h);
  }
  // u = u0/(1 + u0/0.1) exp(-0.1 t), then exp(+0.1 t)
  EXPECT_NEAR(gap.ln_u, std::log(0.05) - 30.0 + 20.0, 1e-4);
  EXPECT_GT(gap_e.ln_u, std::log(0.05));
}
