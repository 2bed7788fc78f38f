// The table of coefficients: mixing, limits, and its own order.

#include "lubcontact_coeffs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

using namespace LAMMPS_NS::Lubcontact_NS;

namespace {

TypeCoeffs rough()
{
  TypeCoeffs c;
  c.g = 4.0;
  c.kt = 2.0;
  c.asperity = 1.0;
  c.roughness_a = 0.01;
  c.friction = 0.4;
  c.law = FrictionLaw::COULOMB;
  return c;
}

TEST(Coeffs, EachMemberHasOneColumnAndOneName)
{
  // all doubles of the struct, so that none is forgotten; the law fills the rest
  EXPECT_EQ(NUM_COLUMNS, (sizeof(TypeCoeffs) - sizeof(double)) / sizeof(double));
  std::set<std::string> names;
  for (std::size_t m = 0; m < NUM_COLUMNS; m++) {
    names.insert(COLUMNS[m].name);
    EXPECT_EQ(column_of(COLUMNS[m].value), m);
  }
  EXPECT_EQ(names.size(), NUM_COLUMNS);
}

TEST(Coeffs, ColumnsThatAKeywordFillsFollowEachOther)
{
  for (std::size_t m = 0; m < NUM_COLUMNS; m++) {
    if (!COLUMNS[m].keyword) continue;
    const std::string values = COLUMNS[m].keyword;
    const bool two = values.find(' ') != std::string::npos;
    EXPECT_EQ(two, m + 1 < NUM_COLUMNS && COLUMNS[m + 1].mixing == Mixing::WITH_LAST);
  }
}

TEST(Coeffs, SpringsInSeriesMeanAndGeometricMean)
{
  // two springs k1 and k2 of half the compliance each: 2 k1 k2/(k1 + k2)
  EXPECT_DOUBLE_EQ(mixed(Mixing::SERIES, 2.0, 6.0), 3.0);
  EXPECT_DOUBLE_EQ(mixed(Mixing::MEAN, 2.0, 6.0), 4.0);
  EXPECT_DOUBLE_EQ(mixed(Mixing::GEOMETRIC, 2.0, 8.0), 4.0);
}

TEST(Coeffs, MixingWithItselfChangesNothing)
{
  TypeCoeffs c = rough();
  c.critical = 3.0;
  c.law = FrictionLaw::STEP;
  c.adhesion_a = 0.02;
  c.repulsion = 5.0;
  c.screening = 0.1;
  const TypeCoeffs both = mixed(c, c);
  for (const Column &column : COLUMNS)
    EXPECT_NEAR(both.*column.value, c.*column.value, 1e-15 * c.*column.value) << column.name;
  EXPECT_EQ(both.law, c.law);
}

TEST(Coeffs, SurfacesWithoutFrictionHaveNoneWithOthers)
{
  TypeCoeffs smooth = rough();
  smooth.law = FrictionLaw::NONE;
  smooth.friction = 0.0;
  for (const TypeCoeffs &both : {mixed(rough(), smooth), mixed(smooth, rough())}) {
    EXPECT_EQ(both.law, FrictionLaw::NONE);
    EXPECT_EQ(both.friction, 0.0);
  }
  EXPECT_TRUE(laws_agree(rough(), smooth));
  TypeCoeffs step = rough();
  step.law = FrictionLaw::STEP;
  EXPECT_FALSE(laws_agree(rough(), step));
}

TEST(Coeffs, RepulsionOfOneTypeOnlyHasNoLength)
{
  TypeCoeffs charged = rough();
  charged.repulsion = 5.0;
  charged.screening = 0.1;
  const TypeCoeffs both = mixed(charged, rough());
  EXPECT_EQ(both.repulsion, 0.0);
  EXPECT_EQ(both.screening, 0.0);
}

TEST(Coeffs, ComplaintsNameTheCure)
{
  EXPECT_EQ(complaint(rough()), "");
  TypeCoeffs c = rough();
  c.law = FrictionLaw::NONE;
  EXPECT_NE(complaint(c).find("friction coulomb 0 first"), std::string::npos);
  c = rough();
  c.critical = 1.0;
  EXPECT_NE(complaint(c).find("friction clm first"), std::string::npos);
  c = rough();
  c.law = FrictionLaw::BRIZMER;
  c.critical = 1.0;
  EXPECT_EQ(complaint(c), "");
  c.friction = 0.0;
  EXPECT_NE(complaint(c).find("give pair_coeff friction none"), std::string::npos);
  c = rough();
  c.repulsion = 1.0;
  EXPECT_NE(complaint(c).find("screening length first"), std::string::npos);
  c = rough();
  c.roughness_a = 0.0;
  c.adhesion_a = 0.1;
  EXPECT_NE(complaint(c).find("give them one > 0"), std::string::npos);
}

TEST(Coeffs, StiffnessMustBePositiveAndNumbersFinite)
{
  const Column &g = COLUMNS[column_of(&TypeCoeffs::g)];
  const Column &friction = COLUMNS[column_of(&TypeCoeffs::friction)];
  EXPECT_FALSE(is_allowed(g, 0.0));
  EXPECT_TRUE(is_allowed(friction, 0.0));
  EXPECT_FALSE(is_allowed(friction, -0.1));
  EXPECT_FALSE(is_allowed(friction, NAN));
  EXPECT_FALSE(is_allowed(g, HUGE_VAL));
}

}    // namespace
