#include "scene_laws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace LAMMPS_NS::Lubcontact_NS;
namespace scene = LAMMPS_NS::Scene_NS;

namespace {

// types 1 and 2, the unlike pair not given; type 1 rubs, type 2 does not
Law two_types()
{
  Law law(Settings{}, 2);
  law.of(1, 1).g = law.of(1, 1).asperity = 300.0;
  law.of(1, 1).kt = 100.0;
  law.of(1, 1).roughness_a = 0.02;
  law.of(1, 1).law = FrictionLaw::COULOMB;
  law.of(1, 1).friction = 0.5;
  law.of(2, 2).g = law.of(2, 2).asperity = 600.0;
  law.of(2, 2).kt = 200.0;
  law.of(2, 2).roughness_a = 0.01;
  return law;
}

}    // namespace

TEST(SceneLaws, EveryEffectOfThePairHasItsVerdict)
{
  unsigned mask = 0;
  for (const auto &one : scene::OF_PAIR) mask |= one.bit;
  EXPECT_EQ(mask, all_effects() & ~RESTITUTION);    // a property of the grains: not judged
  std::vector<scene::Verdict> verdicts;
  for (int e = 0; e <= scene::FLUID_INERTIA_EFFECT; e++)
    verdicts.push_back({static_cast<scene::Effect>(e), scene::NOT_NEEDED, ""});
  verdicts[scene::ROLLING_FILM].answer = verdicts[scene::REPULSION].answer = scene::NEEDED;
  verdicts[scene::CRITICAL_LOAD].answer = scene::CANNOT_TELL;
  EXPECT_EQ(scene::with_answer(verdicts, scene::NEEDED), unsigned{ROLL | REPULSION});
  EXPECT_EQ(scene::with_answer(verdicts, scene::NOT_NEEDED),
            all_effects() & ~(ROLL | REPULSION | THRESHOLD | RESTITUTION));
}

TEST(SceneLaws, NamesAreInTheOrderOfTheEffects)
{
  EXPECT_EQ(scene::effect_names(0, ", "), "");
  EXPECT_EQ(scene::effect_names(REPULSION | SQUEEZE | THRESHOLD, ", "),
            "squeeze, critical load, repulsion");
}

TEST(SceneLaws, WithoutNumbersOnlyFilmsAreSwitchedOn)
{
  Law law = two_types();
  law.settings.films = SHEAR;
  const Law on = scene::switched_on(law, {}, 1.0);
  EXPECT_EQ(on.settings.films, all_films());
  law.settings.films = all_films();
  EXPECT_TRUE(scene::same_law(on, law));
}

TEST(SceneLaws, NumbersSwitchOnLawsOfTheSurfaces)
{
  const Law law = two_types();
  scene::SurfaceLaws laws;
  laws.friction = 0.3;
  laws.critical = 2.0;
  laws.pull_off = 12.0;
  laws.repulsion = 5.0;
  laws.screening = 0.1;
  const Law on = scene::switched_on(law, laws, 2.0);
  for (int i = 1; i <= 2; i++) {
    const TypeCoeffs &c = on.of(i, i);
    EXPECT_EQ(c.law, FrictionLaw::STEP);
    EXPECT_EQ(c.friction, 0.3);
    EXPECT_EQ(c.critical, 2.0);
    EXPECT_DOUBLE_EQ(c.adhesion_a, 12.0 / (law.of(i, i).asperity * 2.0));    // k delta a = F
    EXPECT_EQ(c.repulsion, 5.0);
    EXPECT_EQ(c.screening, 0.1);
  }
  EXPECT_EQ(on.of(1, 2).g, 0.0);    // not given, still to be mixed
  EXPECT_EQ(scene::used_effects(on), all_effects() & ~RESTITUTION);
  EXPECT_EQ(scene::used_effects(law), all_films() | FRICTION);
  const auto forces = scene::surface_forces(on.of(1, 1), 2.0);
  EXPECT_EQ(forces.critical, 2.0);
  EXPECT_DOUBLE_EQ(forces.pull_off, 12.0);
  EXPECT_EQ(forces.repulsion, 5.0);
}

TEST(SceneLaws, ACriticalLoadNeedsFrictionAndKeepsItsLaw)
{
  Law law = two_types();
  law.of(1, 1).law = FrictionLaw::RAMP;
  scene::SurfaceLaws laws;
  laws.critical = 2.0;
  const Law on = scene::switched_on(law, laws, 1.0);
  EXPECT_EQ(on.of(1, 1).law, FrictionLaw::RAMP);
  EXPECT_EQ(on.of(1, 1).critical, 2.0);
  EXPECT_EQ(on.of(2, 2).law, FrictionLaw::NONE);
  EXPECT_EQ(on.of(2, 2).critical, 0.0);
}

TEST(SceneLaws, AnyDifferenceIsSeen)
{
  const Law law = two_types();
  EXPECT_TRUE(scene::same_law(law, law));
  EXPECT_FALSE(scene::same_law(law, Law(law.settings, 1)));
  for (const Column &column : COLUMNS) {
    Law other = law;
    other.of(2, 2).*column.value += 0.5;
    EXPECT_FALSE(scene::same_law(law, other)) << column.name;
  }
  Law other = law;
  other.of(1, 1).law = FrictionLaw::STEP;
  EXPECT_FALSE(scene::same_law(law, other));
  for (const EffectRow &row : EFFECTS)
    if (uses(law, row.bit)) {
      EXPECT_FALSE(scene::same_law(law, without(law, row.bit))) << row.name;
    }
}

// series of 300 and 600, mean roughness; a pair that is given stays as it is
TEST(SceneLaws, UnlikePairsFollowFromTheLikeOnes)
{
  Law law = two_types();
  EXPECT_DOUBLE_EQ(scene::coeffs_between(law, 1, 2).g, 400.0);
  EXPECT_DOUBLE_EQ(scene::coeffs_between(law, 2, 1).roughness_a, 0.015);
  law.of(1, 2) = law.of(1, 1);
  EXPECT_EQ(scene::coeffs_between(law, 1, 2).g, 300.0);
}

TEST(SceneLaws, ASceneHasTheSoftestTheSmoothestAndTheRoughest)
{
  Law law = two_types();
  law.of(2, 2).law = FrictionLaw::SHIFT;
  law.of(2, 2).friction = 0.2;
  law.of(2, 2).critical = 3.0;
  law.of(2, 2).adhesion_a = 0.001;
  scene::Scene s;
  s.radius = 2.0;
  scene::describe_law(law, s);
  EXPECT_EQ(s.g, 300.0);
  EXPECT_EQ(s.roughness, 0.01);
  EXPECT_EQ(s.friction, 0.5);
  EXPECT_TRUE(s.rubs_always);    // type 1 has no critical load
  EXPECT_EQ(s.critical, 3.0);
  EXPECT_EQ(s.critical_max, 3.0);
  EXPECT_EQ(s.critical_law, scene::SHIFT_LAW);
  EXPECT_DOUBLE_EQ(s.adhesion, 600.0 * 0.001 * 2.0);
  EXPECT_FALSE(scene::known(s.repulsion));

  law.of(1, 1).law = FrictionLaw::RAMP;
  law.of(1, 1).critical = 8.0;
  scene::Scene t;
  scene::describe_law(law, t);
  EXPECT_FALSE(t.rubs_always);
  EXPECT_EQ(t.critical, 3.0);
  EXPECT_EQ(t.critical_max, 8.0);
  EXPECT_EQ(t.critical_law, scene::RAMP_LAW);

  law.of(1, 1).law = FrictionLaw::BRIZMER;    // of which no load makes a contact frictionless
  scene::Scene plastic;
  plastic.radius = 1.0;
  scene::describe_law(law, plastic);
  EXPECT_EQ(plastic.critical_law, scene::PLASTIC_LAW);
  EXPECT_TRUE(plastic.rubs_always);
  EXPECT_EQ(scene::largest_friction(plastic), HUGE_VAL);
  EXPECT_EQ(scene::largest_friction(t), t.friction);
}

TEST(SceneLaws, NoCoefficientsLeaveASceneUnknown)
{
  scene::Scene s;
  scene::describe_law(Law(), s);
  EXPECT_FALSE(scene::known(s.g));
  EXPECT_FALSE(scene::known(s.friction));
  EXPECT_FALSE(s.rubs_always);
}

TEST(SceneLaws, StifferMeansAllSprings)
{
  const TypeCoeffs c = scene::stiffer(two_types().of(1, 1), 4.0);
  EXPECT_EQ(c.g, 1200.0);
  EXPECT_EQ(c.kt, 400.0);
  EXPECT_EQ(c.asperity, 1200.0);
  EXPECT_EQ(c.roughness_a, 0.02);
}

TEST(SceneLaws, ProposedNumbersHaveFourDigits)
{
  EXPECT_EQ(scene::rounded(12345678.0), 12350000.0);
  EXPECT_EQ(scene::rounded(0.00123456), 0.001235);
  EXPECT_EQ(scene::rounded(999.96), 1000.0);
  EXPECT_EQ(scene::rounded(-0.33333), -0.3333);
  EXPECT_EQ(scene::rounded(0.0), 0.0);
}
