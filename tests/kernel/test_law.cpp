// All that a user gives: effects, ranges, and what the loop over the pairs gets.

#include "lubcontact_law.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace LAMMPS_NS::Lubcontact_NS;

namespace {

TypeCoeffs hard()
{
  TypeCoeffs c;
  c.g = 1e4;
  c.kt = 5e3;
  c.asperity = 2e4;
  c.roughness_a = 0.01;
  return c;
}

// Two types, their unlike pair has friction.
Law two_types()
{
  Law law(Settings(), 2);
  law.settings.viscosity = 1.0;
  for (int i = 1; i <= 2; i++)
    for (int j = 1; j <= 2; j++) law.of(i, j) = hard();
  for (TypeCoeffs *c : {&law.of(1, 2), &law.of(2, 1)}) {
    c->law = FrictionLaw::COULOMB;
    c->friction = 0.5;
  }
  return law;
}

TEST(Law, AnEffectOfOnePairOfTypesIsPresent)
{
  const Law law = two_types();
  EXPECT_EQ(present_effects(law), all_films() | FRICTION);
  EXPECT_TRUE(uses(law, FRICTION));
  EXPECT_TRUE(uses(law, ROLL));
  EXPECT_FALSE(uses(law, ADHESION));
}

TEST(Law, WithoutLeavesOutAndKeepsTheRest)
{
  const Law law = without(two_types(), FRICTION | TWIST);
  EXPECT_EQ(present_effects(law), SQUEEZE | SHEAR | ROLL);
  EXPECT_EQ(law.of(1, 2).g, 1e4);
  EXPECT_EQ(present_effects(without(law, 0)), present_effects(law));
}

TEST(Law, TheRangeIsThatOfTheFilmsOrOfAContact)
{
  Settings s;
  s.reach_a = 0.3;
  EXPECT_EQ(reach_a_of(s, hard()), 0.3);
  s.films = 0;
  EXPECT_EQ(reach_a_of(s, hard()), 0.01);    // asperities
  TypeCoeffs sticky = hard();
  sticky.adhesion_a = 0.02;
  // asperities stretched by 0.02 pull with k 0.02, which stretches the bulk by k/g 0.02 = 0.04
  EXPECT_NEAR(reach_a_of(s, sticky), 0.01 + 0.02 + 0.04, 1e-15);
  TypeCoeffs charged = hard();
  charged.repulsion = 1.0;
  charged.screening = 0.1;
  EXPECT_EQ(reach_a_of(s, charged), 0.3);
}

TEST(Law, TheLoopGetsLogarithmsAndRatios)
{
  TypeCoeffs c = hard();
  c.adhesion_a = 0.02;
  c.repulsion = 3.0;
  c.screening = 0.25;
  const PairCoeffs p = pair_coeffs(Settings(), c);
  EXPECT_EQ(p.normal.gap.alpha, 2.0);
  EXPECT_EQ(p.normal.gap.ln_eps, std::log(0.01));
  EXPECT_NEAR(p.normal.gap.release_a, 0.03, 1e-17);
  EXPECT_NEAR(p.normal.gap.ln_release, std::log(0.03), 1e-15);
  EXPECT_EQ(p.normal.repulsion.force, 3.0);
  EXPECT_EQ(p.normal.repulsion.per_length, 4.0);
  TypeCoeffs smooth = hard();
  smooth.roughness_a = 0.0;
  EXPECT_EQ(pair_coeffs(Settings(), smooth).normal.gap.ln_eps, -HUGE_VAL);
}

TEST(Law, FilmsThatAreOffEndAtInfinity)
{
  Settings s;
  s.viscosity = 2.0;
  s.films = SQUEEZE | ROLL;
  const Film film = film_of(s);
  EXPECT_EQ(film.viscosity, 2.0);
  EXPECT_EQ(shear_resistance(film, 1.0, 0.01, std::log(0.01)), 0.0);
  EXPECT_EQ(twist_resistance(film, 1.0, 0.01, std::log(0.01)), 0.0);
  EXPECT_GT(roll_resistance(film, 1.0, 0.01, std::log(0.01)), 0.0);
}

TEST(Law, SmoothSurfacesTouchOnlyWithoutASqueezeFilm)
{
  Settings s;
  s.viscosity = 1.0;
  TypeCoeffs smooth = hard();
  smooth.roughness_a = 0.0;
  EXPECT_FALSE(can_touch(s, smooth));
  EXPECT_TRUE(can_touch(s, hard()));
  s.viscosity = 0.0;
  EXPECT_TRUE(can_touch(s, smooth));
  s.viscosity = 1.0;
  s.films &= ~SQUEEZE;
  EXPECT_TRUE(can_touch(s, smooth));
}

}    // namespace
