#include "scene_verdict.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace LAMMPS_NS::Scene_NS;

// dense, viscous, rough, hard and slow: everything known, all numbers away from their thresholds
static Scene paste()
{
  Scene s;
  s.particles = 1000;
  s.phi = 0.55;
  s.viscosity = 1.0;
  s.rate = 1.0;
  s.pressure = 20.0;    // Iv 0.05
  s.density = 0.05;
  s.g = 1e6;
  s.roughness = 0.01;
  s.friction = 0.5;
  s.repulsion = s.adhesion = s.critical = 0.0;
  s.thermal = 0.0;
  s.fluid_density = 0.05;
  s.dt = 0.1;
  s.dt_limit = 1.0;
  s.box = 40.0;
  return s;
}

static Verdict verdict(const Scene &s, Effect e)
{
  return judge(s, numbers(s))[e];
}

static Answer answer(const Scene &s, Effect e)
{
  return verdict(s, e).answer;
}

// one number a hair below and above its threshold
static void expect_flip(Effect e, double Scene::*what, double at, Answer below, Answer above,
                        Scene s = paste())
{
  s.*what = 0.999 * at;
  EXPECT_EQ(answer(s, e), below) << EFFECT_NAME[e] << ": " << verdict(s, e).why;
  s.*what = 1.001 * at;
  EXPECT_EQ(answer(s, e), above) << EFFECT_NAME[e] << ": " << verdict(s, e).why;
}

static bool warns(const Scene &s, const std::string &word)
{
  for (const auto &warning : warnings(s, numbers(s)))
    if (warning.find(word) != std::string::npos) return true;
  return false;
}

TEST(SceneVerdict, OnePerEffectInTheirOrder)
{
  const Scene s = paste();
  const auto verdicts = judge(s, numbers(s));
  ASSERT_EQ(verdicts.size(), static_cast<std::size_t>(NUM_EFFECTS));
  for (int e = 0; e < NUM_EFFECTS; e++) {
    EXPECT_EQ(verdicts[e].effect, e);
    EXPECT_FALSE(verdicts[e].why.empty());
    EXPECT_NE(verdicts[e].answer, CANNOT_TELL) << EFFECT_NAME[e];
  }
}

TEST(SceneVerdict, OfAPaste)
{
  const Scene s = paste();
  for (Effect e : {SQUEEZE_FILM, SHEAR_FILM, ROLLING_FILM, FRICTION_LAW, ROUGHNESS})
    EXPECT_EQ(answer(s, e), NEEDED) << EFFECT_NAME[e];
  for (Effect e : {TWISTING_FILM, CRITICAL_LOAD, ADHESION, REPULSION, DRAG, INERTIA, COMPLIANCE,
                   BROWNIAN_MOTION, FAR_HYDRODYNAMICS, FLUID_INERTIA_EFFECT})
    EXPECT_EQ(answer(s, e), NOT_NEEDED) << EFFECT_NAME[e];
  EXPECT_TRUE(warnings(s, numbers(s)).empty());
}

TEST(SceneVerdict, OfDryGrains)
{
  Scene s = paste();
  s.viscosity = 0.0;
  for (Effect e : {SQUEEZE_FILM, SHEAR_FILM, ROLLING_FILM, TWISTING_FILM, ROUGHNESS, DRAG,
                   FAR_HYDRODYNAMICS, BROWNIAN_MOTION, FLUID_INERTIA_EFFECT})
    EXPECT_EQ(answer(s, e), NOT_NEEDED) << EFFECT_NAME[e];
  for (Effect e : {FRICTION_LAW, INERTIA}) EXPECT_EQ(answer(s, e), NEEDED) << EFFECT_NAME[e];
  s.roughness = 1e-9;
  EXPECT_FALSE(warns(s, "crushed"));    // nothing to crush
}

TEST(SceneVerdict, OfAnUnknownFluid)
{
  Scene s = paste();
  s.viscosity = UNKNOWN;
  for (Effect e : {SQUEEZE_FILM, SHEAR_FILM, ROLLING_FILM, TWISTING_FILM, DRAG, INERTIA, ROUGHNESS,
                   FAR_HYDRODYNAMICS, FLUID_INERTIA_EFFECT})
    EXPECT_EQ(answer(s, e), CANNOT_TELL) << EFFECT_NAME[e];
}

TEST(SceneVerdict, AsksForWhatItDoesNotKnow)
{
  Scene s = paste();
  s.friction = s.critical = s.adhesion = s.repulsion = s.thermal = s.fluid_density = UNKNOWN;
  s.g = UNKNOWN;
  for (Effect e : {FRICTION_LAW, CRITICAL_LOAD, ADHESION, REPULSION, BROWNIAN_MOTION, COMPLIANCE,
                   FLUID_INERTIA_EFFECT}) {
    EXPECT_EQ(answer(s, e), CANNOT_TELL) << EFFECT_NAME[e];
    EXPECT_NE(verdict(s, e).why.find("give"), std::string::npos) << verdict(s, e).why;
  }
  s = paste();
  s.rate = s.pressure = UNKNOWN;
  s.thermal = s.adhesion = s.repulsion = s.critical = 1.0;
  for (Effect e : {SQUEEZE_FILM, CRITICAL_LOAD, ADHESION, REPULSION, INERTIA, COMPLIANCE,
                   BROWNIAN_MOTION, FLUID_INERTIA_EFFECT})
    EXPECT_EQ(answer(s, e), CANNOT_TELL) << EFFECT_NAME[e];
}

// --- both sides of every threshold; a = rate = eta = 1, so that St = density, Iv = 1/pressure

TEST(SceneVerdict, FilmsAreIdleAtLargeStokesNumbers)    // impact St = 4 St/9, dry above 500
{
  for (Effect e : {SQUEEZE_FILM, SHEAR_FILM, ROLLING_FILM})
    expect_flip(e, &Scene::density, 1125.0, NEEDED, NOT_NEEDED);
}

// left out only where films carry little, nothing collides, and it was measured: friction 0.5, phi
// 0.54
TEST(SceneVerdict, SqueezeFilmIsLeftOutWhereThatWasMeasured)
{
  Scene s = paste();
  s.phi = 0.52;
  s.density = 0.049;
  expect_flip(SQUEEZE_FILM, &Scene::pressure, 100.0, NEEDED, NOT_NEEDED, s);    // Iv 0.01
  const double root = 1.0 / 0.94 - 1.0;
  expect_flip(SQUEEZE_FILM, &Scene::pressure, 1.0 / (root * root), NOT_NEEDED, NEEDED, s);
  s.pressure = 120.0;
  expect_flip(SQUEEZE_FILM, &Scene::density, 0.05, NOT_NEEDED, NEEDED, s);    // St
  expect_flip(SQUEEZE_FILM, &Scene::phi, 0.94 * jamming_fraction(0.5), NOT_NEEDED, NEEDED, s);
  s.friction = 0.0;
  EXPECT_EQ(answer(s, SQUEEZE_FILM), NEEDED);
  s.friction = 0.1;
  EXPECT_EQ(answer(s, SQUEEZE_FILM), NEEDED);
  s.friction = 0.5;
  s.density = 0.049;
  s.phi = 0.52;
  EXPECT_EQ(answer(s, SQUEEZE_FILM), NOT_NEEDED);
  s.dimension = 2.0;
  EXPECT_EQ(answer(s, SQUEEZE_FILM), NEEDED);
  s = paste();
  s.phi = 0.52;
  s.density = 0.049;
  s.pressure = 120.0;
  s.critical = 1e6;    // nothing rubs
  EXPECT_EQ(answer(s, SQUEEZE_FILM), NEEDED);
}

// phi 0.54, St 0.5: without it the viscosity is half
TEST(SceneVerdict, SqueezeFilmStaysWhereParticlesCollide)
{
  Scene s = paste();
  s.phi = 0.54;
  s.density = 0.5;
  s.pressure = 250.0;
  EXPECT_EQ(answer(s, SQUEEZE_FILM), NEEDED);
}

TEST(SceneVerdict, FrictionNeedsCrowding)
{
  // (1 - phi/0.6301)^2 = 1.1 (1 - phi/0.5737)^2 at phi = 0.19117 for friction 0.5
  const double jam = jamming_fraction(0.5), r = std::sqrt(1.1);
  expect_flip(FRICTION_LAW, &Scene::phi, (r - 1.0) / (r / jam - 1.0 / 0.6301), NOT_NEEDED, NEEDED);
  Scene s = paste();
  s.friction = 0.0;
  EXPECT_EQ(answer(s, FRICTION_LAW), NOT_NEEDED);
  s = paste();
  s.roughness = 0.0;    // smooth
  EXPECT_EQ(answer(s, FRICTION_LAW), NOT_NEEDED);
  s = paste();
  s.dimension = 2.0;
  EXPECT_EQ(answer(s, FRICTION_LAW), NEEDED);
}

TEST(SceneVerdict, CriticalLoadNeedsForcesOfItsSize)
{
  expect_flip(CRITICAL_LOAD, &Scene::critical, 20.0 / 0.03, NEEDED, NOT_NEEDED);    // P a^2/F
  expect_flip(CRITICAL_LOAD, &Scene::critical, 20.0 / 3.0, NOT_NEEDED, NEEDED);
  Scene s = paste();
  s.critical = 20.0;
  EXPECT_EQ(answer(s, CRITICAL_LOAD), NEEDED);
  s.friction = 0.0;
  EXPECT_EQ(answer(s, CRITICAL_LOAD), NOT_NEEDED);
}

// the input lines follow: no verdict leaves out friction and keeps its critical load, or vice versa
TEST(SceneVerdict, FrictionAndItsCriticalLoadAgree)
{
  for (double phi : {0.1, 0.3, 0.5, 0.55, 0.6})
    for (CriticalLaw law : {STEP_LAW, SHIFT_LAW, RAMP_LAW})
      for (bool rubs_always : {false, true})
        for (double critical = 1e-2; critical < 1e5; critical *= 1.7) {
          Scene s = paste();
          s.phi = phi;
          s.critical_law = law;
          s.rubs_always = rubs_always;
          s.critical = critical;
          const Verdict load = verdict(s, CRITICAL_LOAD), friction = verdict(s, FRICTION_LAW);
          const bool slips = load.why.find("no contact is frictional") != std::string::npos;
          EXPECT_TRUE(!slips || friction.answer == NOT_NEEDED) << friction.why;
          EXPECT_TRUE(friction.answer != NOT_NEEDED || load.answer == NOT_NEEDED) << load.why;
          EXPECT_FALSE(slips && (rubs_always || law == RAMP_LAW));
          EXPECT_TRUE(law == STEP_LAW || friction.answer != NEEDED || load.answer == NEEDED);
        }
}

// a critical load that nothing reaches: friction none, not Coulomb's
TEST(SceneVerdict, FrictionIsNotNeededBelowTheCriticalLoad)
{
  expect_flip(FRICTION_LAW, &Scene::critical, 20.0 / 0.03, NEEDED, NOT_NEEDED);
  Scene s = paste();
  s.critical = 1e4;
  s.rubs_always = true;
  EXPECT_EQ(answer(s, FRICTION_LAW), NEEDED);
  s.rubs_always = false;
  s.pressure = UNKNOWN;    // and no estimate
  s.rate = UNKNOWN;
  EXPECT_EQ(answer(s, FRICTION_LAW), NEEDED);
}

// several pairs of types: the smallest load decides whether any contact rubs, the largest whether
// all do
TEST(SceneVerdict, CriticalLoadsOfSeveralTypes)
{
  Scene s = paste();
  s.critical = 1.0;    // P a^2/F 20 and 0.002
  s.critical_max = 1e4;
  EXPECT_EQ(answer(s, CRITICAL_LOAD), NEEDED);
  s.critical_max = 6.0;
  EXPECT_EQ(answer(s, CRITICAL_LOAD), NOT_NEEDED);
  s.critical = 700.0;
  s.critical_max = 1e4;
  EXPECT_EQ(answer(s, CRITICAL_LOAD), NOT_NEEDED);
  EXPECT_EQ(answer(s, FRICTION_LAW), NOT_NEEDED);
}

TEST(SceneVerdict, SurfaceForcesNeedAPartOfTheConfinement)
{
  expect_flip(ADHESION, &Scene::adhesion, 24.0, NOT_NEEDED, NEEDED);    // P d^2 = 80
  expect_flip(REPULSION, &Scene::repulsion, 8.0, NOT_NEEDED, NEEDED);
}

TEST(SceneVerdict, FarFieldNeedsRoom)
{
  expect_flip(DRAG, &Scene::phi, 0.45, NEEDED, NOT_NEEDED);
  expect_flip(FAR_HYDRODYNAMICS, &Scene::phi, 0.45, NEEDED, NOT_NEEDED);
  Scene s = paste();
  s.phi = 0.149;
  EXPECT_NE(verdict(s, FAR_HYDRODYNAMICS).why.find("level mean: phi = 0.149"), std::string::npos);
  s.phi = 0.151;
  EXPECT_NE(verdict(s, FAR_HYDRODYNAMICS).why.find("level mean or grid: phi = 0.151"),
            std::string::npos);
  s.dimension = 2.0;
  EXPECT_EQ(answer(s, FAR_HYDRODYNAMICS), CANNOT_TELL);
}

// The numbers themselves: tests/tools/test_accuracy.py
TEST(SceneVerdict, SaysHowMuchFarHydrodynamicsIsMissing)
{
  EXPECT_DOUBLE_EQ(missing_viscosity(0.0), 0.0);
  EXPECT_NEAR(missing_viscosity(0.01), 0.025, 0.003);    // a dilute suspension: 2.5 phi
  EXPECT_DOUBLE_EQ(missing_viscosity(0.375),
                   0.5 * (missing_viscosity(0.35) + missing_viscosity(0.4)));
  EXPECT_DOUBLE_EQ(missing_viscosity(0.5), missing_viscosity(0.45));

  Scene s = paste();
  s.phi = 0.35;
  const std::string why = verdict(s, FAR_HYDRODYNAMICS).why;
  EXPECT_NE(why.find("viscosity about 33 % low with films alone: phi = 0.35"), std::string::npos);
}

TEST(SceneVerdict, InertiaNeedsAStokesNumberOfTheOrderOfOne)
{
  expect_flip(INERTIA, &Scene::density, 0.5, NOT_NEEDED, NEEDED);
}

TEST(SceneVerdict, ComplianceShowsInSoftParticles)
{
  expect_flip(COMPLIANCE, &Scene::g, 2e5, NEEDED, NOT_NEEDED);    // E/P = 1e4
}

TEST(SceneVerdict, BrownianMotionNeedsSmallPecletNumbers)
{
  const double thermal = 6.0 * 3.14159265358979 / 1e3;
  expect_flip(BROWNIAN_MOTION, &Scene::thermal, thermal, NOT_NEEDED, BEYOND);
}

TEST(SceneVerdict, FluidInertiaNeedsAReynoldsNumber)
{
  expect_flip(FLUID_INERTIA_EFFECT, &Scene::fluid_density, 0.1, NOT_NEEDED, BEYOND);
}

// --- warnings

TEST(SceneVerdict, WarnsAtBothSidesOfTheThresholds)
{
  struct {
    double Scene::*what;
    double at;
    bool above;
    const char *word;
  } const table[] = {{&Scene::g, 1e5, false, "crushed"},    // E eps/P = 50
                     {&Scene::roughness, 0.02, true, "larger"},
                     {&Scene::dt, 0.5, true, "near the stability limit"},
                     {&Scene::dt, 1.0, true, "exceeds the stability limit"},
                     {&Scene::box, 16.0, false, "box is small"},
                     {&Scene::phi, 0.57369, true, "above jamming"}};
  for (const auto &row : table) {
    Scene s = paste();
    s.*row.what = 0.999 * row.at;
    EXPECT_EQ(warns(s, row.word), !row.above) << row.word;
    s.*row.what = 1.001 * row.at;
    EXPECT_EQ(warns(s, row.word), row.above) << row.word;
  }
}

// --- the table

TEST(SceneVerdict, ReasonsNameNumberThresholdAndSource)
{
  const std::string why = verdict(paste(), SQUEEZE_FILM).why;
  EXPECT_NE(why.find("Iv = 0.05 > 0.01 [tests/validation/mu_of_iv"), std::string::npos) << why;
}

TEST(SceneVerdict, ManualQuotesEveryThreshold)
{
  std::ifstream file(SUSPENSION_MANUAL "/scene_thresholds.csv");
  std::stringstream all;
  all << file.rdbuf();
  const std::string page = all.str();
  for (const Threshold &t : THRESHOLD) {
    const std::string row = std::string(t.number) + "; " + show(t.value) + "; " + t.source;
    EXPECT_NE(page.find(row), std::string::npos) << row;
    EXPECT_EQ(std::string(t.source).find(';'), std::string::npos) << "separates columns: " << row;
  }
}

TEST(SceneVerdict, TheReasonOfDryFilmsIsTheNumberThatDecides)
{
  Scene s = paste();
  s.density = 1200.0;    // St 1200
  for (const Effect e : {SQUEEZE_FILM, SHEAR_FILM, ROLLING_FILM, TWISTING_FILM})
    EXPECT_NE(verdict(s, e).why.find("4 St/9 = 533 > 500"), std::string::npos) << verdict(s, e).why;
}

TEST(SceneVerdict, RoughnessSetsTheGapAlsoWithoutFriction)
{
  Scene s = paste();
  EXPECT_NE(verdict(s, ROUGHNESS).why.find("never touch and have no friction"), std::string::npos);
  s.friction = 0.0;
  EXPECT_NE(verdict(s, ROUGHNESS).why.find("without friction"), std::string::npos);
}
