// Even and odd powers side by side give what Horner's rule gives.

#include "lubcontact_polynomial.h"

#include "tools.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace lubcontact;

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
  for (double s : {-0.11, -0.02, 0.0, 1e-3, 0.05, 0.11})
    EXPECT_NEAR(s * polynomial(ARTANH_SERIES, s * s), std::atanh(s), 3e-17 + 1e-15 * std::fabs(s));
}
