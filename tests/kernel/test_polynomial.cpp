// Even and odd powers side by side give what Horner's rule gives; exponential and logarithm are
// exact to rounding.

#include "lubcontact_polynomial.h"

#include "tools.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

struct Four {
  static constexpr int SIZE = 4;
  static constexpr double at(int n)
  {
    constexpr double c[] = {2.0, -3.0, 5.0, 7.0};
    return c[n];
  }
};

struct Five {
  static constexpr int SIZE = 5;
  static constexpr double at(int n)
  {
    constexpr double c[] = {1.0, 0.0, -2.0, 0.5, 4.0};
    return c[n];
  }
};

}    // namespace

TEST(Polynomial, IsTheSumOfItsTermsForEvenAndOddLength)
{
  EXPECT_DOUBLE_EQ(polynomial<Four>(0.0), 2.0);
  EXPECT_DOUBLE_EQ(polynomial<Four>(2.0), 72.0);
  EXPECT_DOUBLE_EQ(polynomial<Five>(-2.0), 53.0);
  EXPECT_DOUBLE_EQ(polynomial<Five>(1.0), 3.5);
}

TEST(Polynomial, SeriesOfTheInverseHyperbolicTangent)
{
  for (double s : {-0.17, -0.02, 0.0, 1e-3, 0.05, 0.17})
    EXPECT_NEAR(s * polynomial<ArtanhSeries>(s * s), std::atanh(s), 3e-17 + 1e-15 * std::fabs(s));
}

TEST(Polynomial, ExponentialAgreesWithLongDouble)
{
  Random rnd(1);
  EXPECT_EQ(exponential(0.0), 1.0);
  for (int trial = 0; trial < 200000; trial++) {
    const double x = trial % 2 ? rnd.uniform(-1.0, 1.0) : rnd.uniform(-700.0, 700.0);
    const double exact = static_cast<double>(std::exp(static_cast<long double>(x)));
    EXPECT_NEAR(exponential(x) / exact, 1.0, 4e-16) << "x = " << x;
  }
}

TEST(Polynomial, LogarithmAgreesWithLongDouble)
{
  Random rnd(2);
  EXPECT_EQ(logarithm(1.0), 0.0);
  for (int trial = 0; trial < 200000; trial++) {
    const double x = trial % 2 ? 1.0 + rnd.log_uniform(1e-15, 0.9) * (trial % 4 == 1 ? 1.0 : -1.0)
                               : rnd.log_uniform(1e-300, 1e300);
    const double exact = static_cast<double>(std::log(static_cast<long double>(x)));
    EXPECT_NEAR(logarithm(x), exact, 8e-16 * std::fabs(exact)) << "x = " << x;
  }
  const double root = std::sqrt(0.5);    // on both sides of the border between two exponents
  for (const double x : {std::nextafter(root, 0.0), root, std::nextafter(root, 1.0)})
    EXPECT_NEAR(logarithm(x), std::log(x), 1e-16);
}

TEST(Polynomial, CoefficientsAreThoseOfTheSeries)
{
  for (int n = 0; n < 11; n++) EXPECT_DOUBLE_EQ(ArtanhSeries::at(n) * (2 * n + 1), 1.0) << n;
  double factorial = 1.0;
  for (int n = 0; n < 14; n++) {
    if (n > 0) factorial *= n;
    EXPECT_DOUBLE_EQ(ExpSeries<14>::at(n) * factorial, 1.0) << n;
  }
  // high + low is ln 2 to twice the digits, and the high part has room for the exponent
  EXPECT_NEAR(static_cast<double>(LN2_HIGH - std::log(2.0L) + LN2_LOW), 0.0, 1e-19);
  EXPECT_EQ(bits_of(LN2_HIGH) & 0x7FF, 0u);
}

TEST(Polynomial, ErrorsNextToTheBordersAreRoundingAndCancelInTheMean)
{
  // what a term of the series adds there has one sign: left out, it would show in the mean
  double exp_error[2] = {}, log_error[2] = {};
  const int N = 100000;
  Random rnd(3);
  for (int n = 0; n < N; n++)
    for (const int side : {0, 1}) {
      // exp: remainders near -ln 2/2 and ln 2/2; ln: mantissas near the roots of 1/2 and 2
      const double r = (side ? 0.5 : -0.5) * std::log(2.0) * rnd.uniform(0.98, 0.999999);
      const long double exact = std::exp(static_cast<long double>(r));
      exp_error[side] += static_cast<double>(exponential(r) / exact - 1.0L) / N;
      const double m =
          std::sqrt(side ? 2.0 : 0.5) * (1.0 + (side ? -1.0 : 1.0) * rnd.uniform(1e-6, 0.02));
      const long double ln = std::log(static_cast<long double>(m));
      log_error[side] += static_cast<double>(logarithm(m) / ln - 1.0L) / N;
    }
  for (const int side : {0, 1}) {
    EXPECT_NEAR(exp_error[side], 0.0, 1e-17) << side;
    EXPECT_NEAR(log_error[side], 0.0, 3e-17) << side;
  }
}

TEST(Polynomial, ExponentialAndLogarithmReachAsFarAsTheySay)
{
  for (const double x : {-699.99, -690.0, 690.0, 699.99})
    EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 5e-16) << x;
  for (const double x : {2.3e-308, 1e-300, 1e300, 1.7e308})
    EXPECT_NEAR(logarithm(x), std::log(x), 3e-16 * std::fabs(std::log(x))) << x;
}
