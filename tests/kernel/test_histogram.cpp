// The histogram loses nothing, and its density is that of the samples.

#include "lubcontact_histogram.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Histogram, CountsEachBinBelowAndAbove)
{
  Histogram h(1.0, 3.0, 4);
  for (const double x : {0.9, 1.0, 1.49, 1.5, 2.999, 3.0, 100.0, -5.0}) h.add(1.0, x);
  h.add(0.5, 2.2);
  const std::vector<double> expected = {2.0, 1.0, 0.5, 1.0, 2.0, 2.0};
  EXPECT_EQ(h.weight, expected);
  EXPECT_EQ(h.below(), 2.0);
  EXPECT_EQ(h.above(), 2.0);
  EXPECT_DOUBLE_EQ(h.center(0), 1.25);
  EXPECT_DOUBLE_EQ(h.center(3), 2.75);
}

TEST(Histogram, DensityAndSharesOutsideAddUpToOne)
{
  Random rnd(21);
  Histogram h(0.0, 2.0, 7);
  for (int m = 0; m < 1000; m++) h.add(rnd.coin() ? 1.0 : 0.5, rnd.uniform(-1.0, 4.0));
  double sum = (h.below() + h.above()) / h.total();
  for (int bin = 0; bin < h.bins(); bin++) sum += h.density(bin) * h.width();
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(Histogram, FindsTheDensityOfAnExponentialDistribution)
{
  Random rnd(22);
  Histogram h(0.0, 6.0, 12);
  const int N = 400000;
  for (int m = 0; m < N; m++) h.add(1.0, -std::log(1.0 - rnd.uniform(0.0, 1.0)));
  for (int bin = 0; bin < h.bins(); bin++) {
    const double left = 0.5 * bin, share = std::exp(-left) - std::exp(-left - 0.5);
    EXPECT_NEAR(h.density(bin), share / 0.5, 5.0 * std::sqrt(share / N) / 0.5);
  }
  EXPECT_NEAR(h.above() / N, std::exp(-6.0), 5.0 * std::exp(-3.0) / std::sqrt(N));
}

TEST(Histogram, OfNothingIsZero)
{
  EXPECT_EQ(Histogram(0.0, 1.0, 3).density(1), 0.0);
}

TEST(Histogram, TakesValuesNextToItsEndsAndNoNumbers)
{
  Histogram h(0.0, 1.5, 9);    // here (x - lo)/width is rounded up to 9
  h.add(1.0, std::nextafter(1.5, 0.0));
  EXPECT_EQ(h.weight[8], 1.0);
  h.add(1.0, std::nan(""));
  EXPECT_EQ(h.above(), 1.0);
}
