// Shows the friction of an elastic-plastic asperity against its formula, written in another way,
// its two limits, and that friction grows and its coefficient falls with the load.

#include "lubcontact_brizmer.h"
#include "lubcontact_friction.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

double friction(double mu, double F, double N)
{
  const Threshold t = make_threshold(FrictionLaw::BRIZMER, F, mu);
  return mu * rubbing_load_any(t, N);
}

}    // namespace

TEST(Brizmer, IsItsFormula)
{
  Random rnd(1);
  for (int trial = 0; trial < 100000; trial++) {
    const double mu = rnd.log_uniform(1e-2, 2.0), F = rnd.log_uniform(1e-9, 1e9);
    const double N = F * rnd.log_uniform(1e-20, 1e12);
    const double y = mu * std::exp(0.35 * (std::log(N) - std::log(F)));
    const double expected = mu * N * (1.0 + 2.0 / std::expm1(2.0 * y));    // coth
    EXPECT_NEAR(friction(mu, F, N), expected, 1e-13 * expected) << mu << " " << N / F;
  }
}

// the values of a coefficient of 0.27, by hand
TEST(Brizmer, FitsWhatWasCalculatedForASphere)
{
  EXPECT_NEAR(friction(0.27, 1.0, 1.0), 1.02418, 1e-5);              // 0.27 coth 0.27
  EXPECT_NEAR(friction(0.27, 2.0, 200.0) / 200.0, 0.30864, 1e-5);    // 0.27 coth(0.27 100^0.35)
}

TEST(Brizmer, IsAPowerOfSmallLoadsWithoutTheCoefficient)
{
  for (const double mu : {0.1, 0.27, 1.0})
    for (const double x : {1e-30, 1e-20, 1e-12})
      EXPECT_NEAR(friction(mu, 5.0, 5.0 * x) / (5.0 * std::pow(x, 0.65)), 1.0,
                  0.4 * std::pow(mu * std::pow(x, 0.35), 2.0) + 1e-13);
}

TEST(Brizmer, IsCoulombsLawUnderLargeLoads)
{
  for (const double mu : {0.1, 0.27, 1.0}) EXPECT_EQ(friction(mu, 1e-9, 1e6), mu * 1e6);
}

TEST(Brizmer, VanishesWithTheLoad)
{
  EXPECT_EQ(friction(0.27, 1.0, 0.0), 0.0);
  EXPECT_GT(friction(0.27, 1.0, 1e-300), 0.0);
  EXPECT_LT(friction(0.27, 1.0, 1e-300), 1e-270);
}

TEST(Brizmer, GrowsWithTheLoadAndItsCoefficientFalls)
{
  Random rnd(2);
  for (int trial = 0; trial < 10000; trial++) {
    const double mu = rnd.log_uniform(1e-2, 2.0), N = rnd.log_uniform(1e-12, 1e12);
    const double more = N * rnd.uniform(1.001, 2.0);
    EXPECT_LT(friction(mu, 1.0, N), friction(mu, 1.0, more));
    EXPECT_GE(friction(mu, 1.0, N) / N * (1.0 + 1e-14), friction(mu, 1.0, more) / more);
    EXPECT_GE(friction(mu, 1.0, N), mu * N);
  }
}

TEST(Brizmer, LeavesTheOtherLawsAsTheyAre)
{
  for (const FrictionLaw law : {FrictionLaw::STEP, FrictionLaw::SHIFT, FrictionLaw::RAMP}) {
    const Threshold other = make_threshold(law, 3.0, 0.27);
    for (const double N : {0.0, 1.0, 3.0, 5.0})
      EXPECT_EQ(rubbing_load_any(other, N), rubbing_load(other, N));
  }
}

// a critical load of 0 is Coulomb's law, as for the laws clm
TEST(Brizmer, WithoutLoadIsCoulombBitForBit)
{
  Random rnd(3);
  for (int trial = 0; trial < 1000; trial++) {
    const double mu = rnd.log_uniform(1e-2, 2.0), N = rnd.log_uniform(1e-200, 1e200);
    EXPECT_EQ(friction(mu, 0.0, N), mu * N);
  }
}
