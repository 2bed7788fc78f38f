// Even and odd powers side by side give what Horner's rule gives; exponential and logarithm are exact
// to rounding.

#include "lubcontact_polynomial.h"

#include "tools.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace lubcontact;
using namespace testing_tools;

TEST(Polynomial, IsTheSumOfItsTermsForEvenAndOddLength)
{
  constexpr double FOUR[4] = {2.0, -3.0, 5.0, 7.0}, FIVE[5] = {1.0, 0.0, -2.0, 0.5, 4.0};
  EXPECT_DOUBLE_EQ(polynomial(FOUR, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(polynomial(FOUR, 2.0), 72.0);
  EXPECT_DOUBLE_EQ(polynomial(FIVE, -2.0), 53.0);
  EXPECT_DOUBLE_EQ(polynomial(FIVE, 1.0), 3.5);
}

TEST(Polynomial, SeriesOfTheInverseHyperbolicTangent)
{
  for (double s : {-0.17, -0.02, 0.0, 1e-3, 0.05, 0.17})
    EXPECT_NEAR(s * polynomial(ARTANH_SERIES, s * s), std::atanh(s), 3e-17 + 1e-15 * std::fabs(s));
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
