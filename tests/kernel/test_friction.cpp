// Shows each law of friction against its formula, its limits, and that none exceeds Coulomb's.

#include "lubcontact_friction.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Friction, NamesStandInTheOrderOfTheLaws)
{
  auto name = [](FrictionLaw law) {
    return std::string(FRICTION_NAME[static_cast<int>(law)]);
  };
  EXPECT_EQ(name(FrictionLaw::NONE), "none");
  EXPECT_EQ(name(FrictionLaw::COULOMB), "coulomb");
  EXPECT_EQ(name(FrictionLaw::STEP), "clm step");
  EXPECT_EQ(name(FrictionLaw::SHIFT), "clm shift");
  EXPECT_EQ(name(FrictionLaw::RAMP), "clm ramp");
  EXPECT_EQ(name(FrictionLaw::BRIZMER), "brizmer");
  EXPECT_EQ(std::size(FRICTION_NAME), static_cast<std::size_t>(FrictionLaw::NUM_LAWS));
}

TEST(Friction, EveryLawIsItsFormula)
{
  Random rnd(1);
  for (int trial = 0; trial < 10000; trial++) {
    const double F = rnd.log_uniform(1e-6, 1e6), N = F * rnd.log_uniform(1e-3, 1e3);
    EXPECT_EQ(rubbing_load(make_threshold(FrictionLaw::COULOMB, F), N), N);
    EXPECT_EQ(rubbing_load(make_threshold(FrictionLaw::STEP, F), N), N < F ? 0.0 : N);
    EXPECT_NEAR(rubbing_load(make_threshold(FrictionLaw::SHIFT, F), N), std::fmax(0.0, N - F),
                1e-15 * N);
    EXPECT_NEAR(rubbing_load(make_threshold(FrictionLaw::RAMP, F), N), N < F ? N * N / F : N,
                1e-14 * N);
  }
}

TEST(Friction, TheStepRubsFromTheCriticalLoadOn)
{
  const Threshold t = make_threshold(FrictionLaw::STEP, 3.0);
  EXPECT_EQ(rubbing_load(t, std::nextafter(3.0, 0.0)), 0.0);
  EXPECT_EQ(rubbing_load(t, 3.0), 3.0);
}

TEST(Friction, ShiftAndRampAreContinuousAtTheCriticalLoad)
{
  for (const double N : {3.0 - 1e-9, 3.0, 3.0 + 1e-9}) {
    EXPECT_NEAR(rubbing_load(make_threshold(FrictionLaw::SHIFT, 3.0), N), 0.0, 2e-9);
    EXPECT_NEAR(rubbing_load(make_threshold(FrictionLaw::RAMP, 3.0), N), 3.0, 3e-9);
  }
}

TEST(Friction, NeverBeyondCoulombNeverNegativeAndGrowsWithTheLoad)
{
  Random rnd(2);
  for (int trial = 0; trial < 10000; trial++) {
    const double F = rnd.coin() ? rnd.log_uniform(1e-300, 1e300) : 0.0;
    const double N = rnd.log_uniform(1e-300, 1e300);
    for (const FrictionLaw law : {FrictionLaw::STEP, FrictionLaw::SHIFT, FrictionLaw::RAMP}) {
      const Threshold t = make_threshold(law, F);
      const double load = rubbing_load(t, N);
      EXPECT_GE(load, 0.0);
      EXPECT_LE(load, N);
      EXPECT_LE(load, rubbing_load(t, 2.0 * N));
      EXPECT_EQ(rubbing_load(t, 0.0), 0.0);
    }
  }
}

TEST(Friction, WithoutCriticalLoadEveryLawIsCoulombBitForBit)
{
  Random rnd(3);
  for (int trial = 0; trial < 10000; trial++) {
    const double N = rnd.log_uniform(1e-200, 1e200);
    EXPECT_EQ(rubbing_load(Threshold{}, N), N);
    for (const FrictionLaw law : {FrictionLaw::STEP, FrictionLaw::SHIFT, FrictionLaw::RAMP})
      EXPECT_EQ(rubbing_load(make_threshold(law, 0.0), N), N);
  }
  for (const double N : {0.0, 5e-324, 1.7e308}) EXPECT_EQ(rubbing_load(Threshold{}, N), N);
}
