// Both sides of every border of the gap integrator where it changes its formula, against quadrature
// in long double, and the series behind them term by term.

#include "lubcontact_gap.h"
#include "quadrature.h"
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

// A step by its definition: x and D are the mean and half of the change of r h, I the integral of
// exp(-(x + D) s + D s^2).
struct Step {
  double y0, x, D, A, h;

  double r0() const { return (x - D) / h; }
  double r1() const { return (x + D) / h; }
  bool is_usual() const
  {
    bool usual = true;
    gap_exponential_usual(gap_of(y0), r0(), r1(), A, h, usual);
    return usual;
  }
  double any() const { return gap_exponential_any(y0, r0(), r1(), A, h); }
  double taken() const { return gap_exponential(gap_of(y0), r0(), r1(), A, h).ln_u; }
  double with(Real ln_I) const
  {
    const Real a = -Real(x) - Real(y0), b = std::log(Real(A) * h) + ln_I, top = std::fmax(a, b);
    return static_cast<double>(-top - std::log(std::exp(a - top) + std::exp(b - top)));
  }
  double exact() const { return with(weighted(Real(x) + D, D).ln); }
  // exp of the mean exponent instead of the mean of exp, as the step is defined for small D
  double by_mean() const
  {
    const Weighted w = weighted(Real(x) + D, 0.0L);
    return with(w.ln + D * w.mean_s2);
  }
};

double product_up_to(int n)
{
  return n < 2 ? 1.0 : n * product_up_to(n - 1);
}

constexpr double SIGNS[] = {1.0, -1.0};

}    // namespace

TEST(GapSeries, CoefficientsAreThoseOfTheIntegrals)
{
  for (int n = 0; n < 12; n++) EXPECT_DOUBLE_EQ(PhiSeries::at(n) * product_up_to(n + 1), 1.0) << n;
  for (int n = 0; n < 9; n++)
    EXPECT_DOUBLE_EQ(PsiSeries::at(n) * product_up_to(n) * (n + 3), 1.0) << n;
  for (int n = 0; n < 6; n++) EXPECT_DOUBLE_EQ(ExpSeries<6>::at(n) * product_up_to(n), 1.0) << n;
  double odd = 1.0;    // (2n-1)!!
  for (int n = 0; n < 7; n++) {
    EXPECT_EQ(ErfcxSeries::at(n), (n % 2 ? -1.0 : 1.0) * odd) << n;
    odd *= 2 * n + 1;
  }
}

TEST(ExponentialMean, SeriesAndClosedFormMeetWithinRounding)
{
  // the series leave z^12/13! and, in the mean, 3 z^9/(9! 12); the closed form loses 3/|z|^3 digits
  for (const double sign : SIGNS)
    for (const double size :
         {0.0305, 0.05, 0.1, 0.2, 0.29, 0.2999, 0.3001, 0.35, 0.5, 1.0, 2.9, 20.0}) {
      const double z = sign * size;
      const ExponentialMean m = exponential_mean(z);
      const Weighted w = weighted(z, 0.0L);
      const double left = size < 0.3 ? 1.3 * 3.0 * std::pow(size, 9) / (product_up_to(9) * 12.0)
                                     : 0.0;
      EXPECT_NEAR(m.phi / static_cast<double>(std::exp(w.ln)), 1.0, 2e-15) << z;
      EXPECT_NEAR(m.mean_s2 / static_cast<double>(w.mean_s2), 1.0,
                  left + (size < 0.3 ? 1e-15 : 1e-13))
          << z;
      EXPECT_NEAR(m.exp_minus_z / static_cast<double>(std::exp(-Real(z))), 1.0, 1e-15) << z;
    }
}

TEST(ExponentialMean, ReachesAsFarAsItSays)
{
  for (const double z : {-299.0, -31.0, 31.0, 299.0}) {
    const Weighted w = weighted(z, 0.0L);
    EXPECT_NEAR(exponential_mean(z).phi / static_cast<double>(std::exp(w.ln)), 1.0, 1e-14) << z;
    EXPECT_NEAR(exponential_mean(z).mean_s2 / static_cast<double>(w.mean_s2), 1.0, 1e-13) << z;
  }
}

TEST(LogExponentialMean, AgreesWithQuadratureOnBothSidesOfItsBorder)
{
  for (const double sign : SIGNS)
    for (const double size : {3.1, 10.0, 29.9, 30.1, 35.0, 290.0, 310.0, 1e3, 1e4}) {
      const LogExponentialMean m = log_exponential_mean(sign * size);
      const Weighted w = weighted(sign * size, 0.0L);
      EXPECT_NEAR(m.ln_phi, static_cast<double>(w.ln), 2e-13 + 2e-16 * size) << sign * size;
      EXPECT_NEAR(m.mean_s2, static_cast<double>(w.mean_s2), 1e-13) << sign * size;
    }
}

TEST(LogErfcx, AgreesWithItsContinuedFraction)
{
  // Legendre's: sqrt(pi) exp(x^2) erfc(x) = 1/(x + (1/2)/(x + 1/(x + (3/2)/(x + ...))))
  for (const double x : {2.1, 5.0, 19.0, 19.999, 20.0, 20.001, 25.0, 30.0, 60.0, 199.0, 1e3, 1e8}) {
    Real tail = x;
    for (int n = 400; n > 0; n--) tail = x + 0.5L * n / tail;
    const Real exact = -std::log(tail) - 0.5L * std::log(3.14159265358979323846264L);
    EXPECT_NEAR(log_erfcx(x), static_cast<double>(exact),
                x < 20.0 ? 2e-13 : 2e-15 + 2e-16 * std::log(x))
        << x;
  }
  EXPECT_EQ(log_erfcx(0.0), 0.0);
}

TEST(LogGaussianIntegral, IsExactWhereverTheGaussianIsCut)
{
  // a = z/(2 sqrt(-D)) > 0, b = a + sqrt(-D) < 0, and between
  for (const double D : {-0.501, -0.7, -2.0, -7.0, -100.0, -399.0, -401.0, -3e4, -1e8})
    for (const double a :
         {-1e3, -40.0, -20.1, -19.9, -5.0, -1.0, -1e-3, 0.0, 1e-3, 1.0, 5.0, 19.9, 20.1, 40.0, 1e3})
      for (const double from : {0.0, 1.0}) {    // a, or b = a
        const double root = std::sqrt(-D), z = 2.0 * root * (a - from * root);
        const double exact = static_cast<double>(weighted(z, D).ln);
        const double size = 1.0 + std::fabs(exact) + std::fabs(D - z) + 0.25 * z * z / -D;
        EXPECT_NEAR(log_gaussian_integral(z, D), exact, 1e-15 * size + 3e-13) << z << " " << D;
      }
}

TEST(ExponentialScheme, UsualStepsEndAtTheirBounds)
{
  EXPECT_TRUE((Step{-3.0, -29.9, 0.0, 1.5, 2.0}.is_usual()));
  EXPECT_FALSE((Step{-3.0, -30.1, 0.0, 1.5, 2.0}.is_usual()));
  EXPECT_TRUE((Step{-19.9, 30.1, 0.0, 1.5, 2.0}.is_usual()));
  EXPECT_FALSE((Step{-20.1, 30.1, 0.0, 1.5, 2.0}.is_usual()));
  EXPECT_TRUE((Step{-3.0, 0.99e8, 0.0, 1.5, 2.0}.is_usual()));
  EXPECT_FALSE((Step{-3.0, 1.01e8, 0.0, 1.5, 2.0}.is_usual()));
  for (const double sign : SIGNS) {
    EXPECT_TRUE((Step{-3.0, 40.0, sign * 0.159, 1.5, 2.0}.is_usual()));
    EXPECT_FALSE((Step{-3.0, 40.0, sign * 0.161, 1.5, 2.0}.is_usual()));
    EXPECT_TRUE((Step{-3.0, 100.0, sign * 0.499, 1.5, 2.0}.is_usual()));
    EXPECT_FALSE((Step{-3.0, 100.0, sign * 0.501, 1.5, 2.0}.is_usual()));
    EXPECT_TRUE((Step{-3.0, 0.1, sign * 0.00999, 1.5, 2.0}.is_usual()));
    EXPECT_FALSE((Step{-3.0, 0.1, sign * 0.01001, 1.5, 2.0}.is_usual()));
    EXPECT_TRUE((Step{sign * 299.0, 0.1, 0.0, 1.5, 2.0}.is_usual()));
    EXPECT_FALSE((Step{sign * 301.0, 0.1, 0.0, 1.5, 2.0}.is_usual()));
  }
}

TEST(ExponentialScheme, BothPathsAreTheMeanToRoundingOnBothSidesOfTheirBorders)
{
  // where D is largest the short series of the usual step leave q^4/24 of exp(q), q = D mean(s^2)
  for (const double y0 : {-250.0, -3.0, 1.0})
    for (const double x :
         {-30.1, -29.9, -5.0, -0.3, -0.2, 0.0, 0.2, 0.3, 5.0, 29.9, 30.1, 75.0, 299.0})
      for (const double D :
           {-0.49, -0.1, -0.0101, -0.0099, -0.002, 0.0, 0.002, 0.0099, 0.0101, 0.1, 0.49})
        for (const double h : {1e-3, 1.0, 1e4}) {
          const Step s{y0, x, D, 1.7, h};
          const double exact = s.by_mean(),
                       q = D * static_cast<double>(weighted(x + D, 0.0L).mean_s2);
          const double rounding = 4e-15 * (1.0 + std::fabs(exact) + std::fabs(x) + std::fabs(y0));
          const double left = (s.is_usual() ? 1.02 * q * q * q * q / 24.0 : 0.0) +
              (std::fabs(x + D) < 0.3 ? 5e-12 * std::fabs(D)
                                      : 0.0);    // of the mean by its series;
          EXPECT_NEAR(s.any(), exact, rounding + 2e-13 + left)
              << y0 << " " << x << " " << D << " " << h;
          EXPECT_NEAR(s.taken(), exact, rounding + 1e-13 + left)
              << y0 << " " << x << " " << D << " " << h;
        }
  // which is 4.2e-10 at most
  EXPECT_NEAR((Step{-3.0, -29.0, 0.0099, 1.7, 1.0}.taken()),
              (Step{-3.0, -29.0, 0.0099, 1.7, 1.0}.by_mean()), 4.2e-10);
}

// 10 D^2/z^4 is what the mean exponent leaves
TEST(ExponentialScheme, AFilmThatRelaxesWithinTheStepSeesItsEnd)
{
  for (const double y0 : {-19.9, -3.0, 1.0})
    for (const double x : {30.1, 60.0, 150.0, 299.0})
      for (const double sign : SIGNS) {
        const Step s{y0, x, sign * 0.999 * largest_change(x), 1.7, 3.0};
        EXPECT_TRUE(s.is_usual());
        EXPECT_NEAR(s.taken(), s.exact(), 1.1e-7) << y0 << " " << x;
      }
  // u = r/A at the end of the step, and what is left of the motion during it
  for (const double x : {1e3, 1e5, 0.9e8}) {
    const Step s{0.5, x, 0.4, 1.7, 3.0};
    const double z = x + s.D;
    EXPECT_NEAR(s.taken(), std::log(s.r1() / s.A) - 2.0 * s.D / (z * z), 1e-11) << x;
  }
}

TEST(ExponentialScheme, IsExactForLargeFallsAndTheMeanForSmallOnes)
{
  for (const double x : {-40.0, -3.0, -0.5, 0.0, 0.5, 3.0, 40.0}) {
    for (const double D : {-0.501, -0.6, -4.9, -50.0}) {
      const Step s{-2.0, x, D, 1.7, 3.0};
      EXPECT_NEAR(s.any(), s.exact(), 1e-12) << x << " " << D;
    }
    for (const double D : {-0.499, -0.06}) {
      const Step s{-2.0, x, D, 1.7, 3.0};
      EXPECT_NEAR(s.any(), s.by_mean(), 1e-12) << x << " " << D;
      EXPECT_NEAR(s.any(), s.exact(), 0.05 * D * D) << x << " " << D;
    }
  }
}

TEST(GapStep, IsCutInPiecesOfAUnitChangeAndSixteenAtMost)
{
  const GapLaw law = make_law(1.0, 0.0);
  const Gap start = gap_of(-2.0);
  const double h = 4.0, un0 = 0.02;
  const struct {
    double D;
    int pieces;
  } cases[] = {{0.02, 1}, {0.499, 1},  {0.501, 2},  {1.99, 2},
               {2.01, 3}, {112.0, 15}, {113.0, 16}, {200.0, 16}};
  for (const double way : SIGNS)
    for (const auto &c : cases) {
      const double change = way * 2.0 * c.D / h;
      auto in_pieces = [&](int pieces) {
        Gap gap = start;
        for (int n = 0; n < pieces; n++)
          gap = gap_piece(law, gap, un0 + change * n / pieces, un0 + change * (n + 1) / pieces,
                          h / pieces);
        return gap.ln_u;
      };
      const double whole = gap_step(law, start, un0, un0 + change, h).ln_u;
      const double exact = in_pieces(c.pieces), tolerance = 1e-12 * (1.0 + std::fabs(exact));
      EXPECT_NEAR(whole, exact, tolerance) << c.D;
      if (way > 0.0) {    // closing, each piece is exact
        EXPECT_GT(std::fabs(whole - in_pieces(c.pieces + 1)), 2.0 * tolerance) << c.D;
      }
    }
}

TEST(GapCrossing, IsFoundToTenDigitsHoweverFlat)
{
  // from rest at r0 the pair closes faster and faster: y(t) at a time that the border is put to
  for (const double t : {1e-6, 0.01, 0.3, 0.7, 0.99, 1.0 - 1e-6}) {
    for (const double un1 : {-1e-6, -0.01, -3.0}) {
      const double y0 = -2.0, un0 = std::exp(-2.0), h = 0.1;
      const Step part{y0, 0.5 * t * h * (un0 + un0 + t * (un1 - un0)),
                      0.5 * t * h * t * (un1 - un0), 1.0, t * h};
      GapLaw law = make_law(2.0, 0.1);
      law.ln_eps = part.any();
      law.eps_a = std::exp(law.ln_eps);
      const Gap old = gap_of(y0), end = gap_branch(law, false, old, un0, un1, h);
      ASSERT_LT(end.ln_u, law.ln_eps);
      const double slope =
          std::fabs(un0 + t * (un1 - un0) - law.eps_a) * h;    // of y over the step
      EXPECT_NEAR(gap_crossing(law, false, old, end, un0, un1, h), t, 1e-11 + 2e-13 / slope)
          << t << " " << un1;
    }
  }
}

TEST(GapBranch, SaysWhetherTheAsperitiesHold)
{
  const GapLaw law = make_law(2.0, 0.05);
  EXPECT_EQ(gap_branch(law, true, gap_of(-4.0), 0.01, 0.01, 0.1).bond, 1.0);
  EXPECT_EQ(gap_branch(law, false, gap_of(-2.0), 0.1, 0.1, 0.1).bond, 0.0);
  // across the border and back again, as it is crossed
  EXPECT_EQ(gap_step(law, gap_of(-2.9), -0.1, -0.1, 20.0).bond, 1.0);
  EXPECT_EQ(gap_step(law, gap_of(-3.1), 0.3, 0.3, 20.0).bond, 0.0);
}
