#include "scene_settling.h"

#include <gtest/gtest.h>

using namespace LAMMPS_NS::Scene_NS;

// a glass bead in water, SI: a = 50 um; Stokes by hand
static Scene bead()
{
  Scene s;
  s.radius = 5e-5;
  s.density = 2500.0;
  s.viscosity = 1e-3;
  s.gravity = 9.81;
  s.fluid_density = 1000.0;
  s.thermal = 1.380649e-23 * 300.0;
  s.g = 50.0;
  s.roughness = 0.01;
  s.friction = 0.5;
  s.adhesion = s.repulsion = s.critical = 0.0;
  s.bottom = 10.0;
  s.dt = 1e-7;
  s.dt_limit = 1e-6;
  return s;
}

static Verdict verdict(const Scene &s, Effect e)
{
  return judge_settling(s, settling(s))[e];
}

TEST(SceneSettling, OfABeadInWater)
{
  const Settling n = settling(bead());
  const double v = 2.0 / 9.0 * 2500.0 * 9.81 * 25e-10 / 1e-3;
  EXPECT_NEAR(n.velocity, v, 1e-9 * v);
  EXPECT_NEAR(n.velocity * n.buoyant, 2.0 / 9.0 * 1500.0 * 9.81 * 25e-10 / 1e-3, 1e-9 * v);
  EXPECT_NEAR(n.time, 2.0 / 9.0 * 2500.0 * 25e-10 / 1e-3, 1e-12);
  EXPECT_NEAR(n.St, 2500.0 * 5e-5 * v / 1e-3, 1e-9);
  EXPECT_NEAR(n.Re, 1000.0 * 5e-5 * v / 1e-3, 1e-9);
  EXPECT_NEAR(n.weight, 4.0 / 3.0 * 3.14159265 * 1.25e-13 * 2500.0 * 9.81, 1e-16);
  EXPECT_NEAR(n.Pe, n.weight * 5e-5 / 4.141947e-21, 1e3);
  EXPECT_NEAR(n.stiffness, 50.0 / 5e-5 / 10.0, 1e-6);
}

TEST(SceneSettling, UnknownInputGivesUnknownNumbers)
{
  Scene s = bead();
  s.viscosity = s.gravity = s.bottom = UNKNOWN;
  const Settling n = settling(s);
  EXPECT_FALSE(known(n.velocity) || known(n.St) || known(n.weight) || known(n.stiffness));
  s = bead();
  s.dimension = 2.0;
  EXPECT_FALSE(known(settling(s).velocity));
  s = bead();
  s.viscosity = 0.0;
  EXPECT_FALSE(known(settling(s).velocity));
}

TEST(SceneSettling, OnePerEffectInTheirOrder)
{
  const auto verdicts = judge_settling(bead(), settling(bead()));
  ASSERT_EQ(verdicts.size(), static_cast<std::size_t>(NUM_EFFECTS));
  for (int e = 0; e < NUM_EFFECTS; e++) {
    EXPECT_EQ(verdicts[e].effect, e);
    EXPECT_FALSE(verdicts[e].why.empty());
  }
}

// nothing that was measured in shear is said of a scene without
TEST(SceneSettling, JudgesWhatItKnowsOnly)
{
  const Scene s = bead();
  for (Effect e : {SHEAR_FILM, ROLLING_FILM, TWISTING_FILM, FRICTION_LAW, INERTIA})
    EXPECT_EQ(verdict(s, e).answer, CANNOT_TELL) << EFFECT_NAME[e];
  for (Effect e : {SQUEEZE_FILM, DRAG, ROUGHNESS}) EXPECT_EQ(verdict(s, e).answer, NEEDED);
  EXPECT_EQ(verdict(s, FAR_HYDRODYNAMICS).answer, LIMITED);
  EXPECT_EQ(verdict(s, BROWNIAN_MOTION).answer, NOT_NEEDED);
  EXPECT_EQ(verdict(s, FLUID_INERTIA_EFFECT).answer, BEYOND);    // Re 0.68
  for (Effect e : {CRITICAL_LOAD, ADHESION, REPULSION}) EXPECT_EQ(verdict(s, e).answer, NOT_NEEDED);
}

TEST(SceneSettling, OfDryGrains)
{
  Scene s = bead();
  s.viscosity = 0.0;
  for (Effect e : {SQUEEZE_FILM, SHEAR_FILM, ROLLING_FILM, TWISTING_FILM, DRAG, FAR_HYDRODYNAMICS,
                   FLUID_INERTIA_EFFECT, ROUGHNESS})
    EXPECT_EQ(verdict(s, e).answer, NOT_NEEDED) << EFFECT_NAME[e];
}

TEST(SceneSettling, AsksForWhatItDoesNotKnow)
{
  Scene s = bead();
  s.viscosity = s.friction = s.critical = s.adhesion = s.repulsion = s.thermal = UNKNOWN;
  s.fluid_density = s.bottom = UNKNOWN;
  for (int e = 0; e < NUM_EFFECTS; e++)
    EXPECT_EQ(verdict(s, static_cast<Effect>(e)).answer, CANNOT_TELL) << EFFECT_NAME[e];
}

TEST(SceneSettling, ShowsForcesOverTheWeight)
{
  Scene s = bead();
  s.adhesion = 3.0 * settling(s).weight;
  EXPECT_NE(verdict(s, ADHESION).why.find("force over weight = 3"), std::string::npos);
}

TEST(SceneSettling, FilmsDampImpactsUpToAStokesNumber)
{
  Scene s = bead();
  s.viscosity = 1e-6;    // dry as impacts go
  EXPECT_EQ(verdict(s, SQUEEZE_FILM).answer, NOT_NEEDED);
}

TEST(SceneSettling, Warns)
{
  Scene s = bead();
  EXPECT_TRUE(settling_warnings(s, settling(s)).empty());
  s.bottom = 1e4;
  s.dt = 2e-6;
  const auto all = settling_warnings(s, settling(s));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NE(all[0].find("crushed flat under the whole weight"), std::string::npos);
  EXPECT_NE(all[1].find("exceeds the stability limit"), std::string::npos);
}
