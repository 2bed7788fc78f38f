// The rows of the effects: complete, distinct, and consistent with what they do to coefficients.

#include "lubcontact_law.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

using namespace LAMMPS_NS::Lubcontact_NS;

namespace {

// With every effect.
TypeCoeffs everything()
{
  TypeCoeffs c;
  c.g = c.kt = c.asperity = 1.0;
  c.roughness_a = 0.01;
  c.friction = 0.5;
  c.critical = 2.0;
  c.law = FrictionLaw::STEP;
  c.adhesion_a = 0.01;
  c.repulsion = 3.0;
  c.screening = 0.1;
  c.restitution = 0.5;
  return c;
}

TEST(Registry, NamesAndBitsAreDistinct)
{
  std::set<std::string> names;
  std::set<unsigned> bits;
  for (const EffectRow &row : EFFECTS) {
    names.insert(row.name);
    bits.insert(row.bit);
    EXPECT_EQ(row.bit & (row.bit - 1), 0u) << row.name;
    EXPECT_EQ(&effect_row(row.bit), &row);
  }
  EXPECT_EQ(names.size(), std::size(EFFECTS));
  EXPECT_EQ(bits.size(), std::size(EFFECTS));
}

TEST(Registry, FilmsAreSwitchesAndTheOthersHaveCoefficients)
{
  EXPECT_EQ(all_films(), SQUEEZE | SHEAR | ROLL | TWIST);
  for (const EffectRow &row : EFFECTS) {
    EXPECT_EQ(row.is_film(), row.acts == nullptr) << row.name;
    EXPECT_EQ(row.is_film(), row.remove == nullptr) << row.name;
  }
}

TEST(Registry, WhatIsRemovedIsGoneAndTheRestStays)
{
  for (const EffectRow &row : EFFECTS) {
    if (row.is_film()) continue;
    TypeCoeffs c = everything();
    EXPECT_TRUE(row.is_present(c)) << row.name;
    EXPECT_TRUE(row.acts(c)) << row.name;
    row.remove(c);
    EXPECT_FALSE(row.is_present(c)) << row.name;
    EXPECT_FALSE(row.acts(c)) << row.name;
    EXPECT_EQ(complaint(c), "") << row.name;
    for (const EffectRow &other : EFFECTS) {
      if (other.is_film() || other.bit == row.bit) continue;
      const bool with_it = row.bit == FRICTION && other.bit == THRESHOLD;    // it acts on friction
      EXPECT_EQ(other.acts(c), !with_it) << other.name << " without " << row.name;
    }
  }
}

TEST(Registry, AnEffectOfStrengthZeroIsPresentButDoesNotAct)
{
  TypeCoeffs c = everything();
  c.friction = c.critical = c.repulsion = 0.0;
  for (const unsigned bit : {FRICTION, THRESHOLD, REPULSION}) {
    EXPECT_TRUE(effect_row(bit).is_present(c)) << bit;
    EXPECT_FALSE(effect_row(bit).acts(c)) << bit;
  }
}

}    // namespace
