#include "scene_bounds.h"

#include <gtest/gtest.h>

using namespace LAMMPS_NS::Scene_NS;

// Seto's mixture, 1:1.4 in equal volumes, with a critical load; a = rate = eta = 1
static Scene mixture()
{
  Scene s;
  s.particles = 1000;
  s.phi = 0.54;
  s.viscosity = 1.0;
  s.rate = 1.0;
  s.density = 0.05;
  s.g = 1e8;
  s.roughness = 0.01;
  s.friction = 1.0;
  s.critical = 100.0;
  s.repulsion = s.adhesion = 0.0;
  s.spread = 0.163;
  s.skew = 1.0;
  return s;
}

static Verdict verdict(const Scene &s, Effect e)
{
  return judge_at_bounds(s)[e];
}

// by hand: frictional (0.5574/0.54 - 1)^-2 = 964, frictionless (0.6301/0.54 - 1)^-2 = 35.9
TEST(SceneBounds, OfASuspensionThatMayRubOrSlip)
{
  Scene s = mixture();
  s.spread = s.skew = 0.0;
  const Bounds b = steady_pressure(s);
  EXPECT_NEAR(b.low, 35.9, 0.1);
  EXPECT_NEAR(b.high, 1 / std::pow(jamming_fraction(1.0) / 0.54 - 1.0, 2), 1e-9);
  EXPECT_NEAR(b.high, 960.0, 30.0);
  EXPECT_FALSE(b.one());
}

TEST(SceneBounds, AreOneWithoutCriticalLoadAndSpread)
{
  Scene s = mixture();
  s.spread = 0.1;
  s.critical = 0.0;
  EXPECT_TRUE(steady_pressure(s).one());
  s.critical = 100.0;
  s.rubs_always = true;    // some pairs of types
  EXPECT_TRUE(steady_pressure(s).one());
  s.spread = 0.3;
  EXPECT_FALSE(steady_pressure(s).one());
  EXPECT_EQ(numbers_at_bounds(s).size(), 2u);
  s.pressure = 30.0;    // known
  EXPECT_EQ(numbers_at_bounds(s).size(), 1u);
}

// a run of this mixture with a critical load that nothing reaches had 28
TEST(SceneBounds, SizesPackDenser)
{
  EXPECT_EQ(packing_gain(0.05, 3.0), 1.0);
  EXPECT_EQ(packing_gain(0.1, 0.0), 1.0);
  // Desmond and Weeks: 0.634 + 0.0658 d + 0.0857 S d^2; here less the part of the first 0.1
  EXPECT_NEAR(0.634 * packing_gain(0.4, 0.0), 0.634 + 0.0658 * 0.3, 1e-12);
  EXPECT_NEAR(0.634 * packing_gain(0.4, 2.0), 0.634 + 0.0658 * 0.3 + 0.0857 * 2.0 * 0.16, 1e-12);
  EXPECT_LT(steady_pressure(mixture()).low, 33.0);
  EXPECT_GT(steady_pressure(mixture()).low, 24.0);
}

TEST(SceneBounds, JammedWhereContactsRub)
{
  Scene s = mixture();
  s.phi = 0.58;
  const Bounds b = steady_pressure(s);
  EXPECT_TRUE(std::isinf(b.high));
  EXPECT_TRUE(std::isfinite(b.low));
  s.phi = 0.66;
  EXPECT_FALSE(known(steady_pressure(s).low));
  s = mixture();
  s.dimension = 2.0;
  EXPECT_FALSE(known(steady_pressure(s).low));
}

TEST(SceneBounds, WarnOfJammingAtEither)
{
  Scene s = mixture();
  s.pressure = 30.0;
  for (double phi : {0.55, 0.6, 0.66}) {
    s.phi = phi;
    const auto all = warnings_at_bounds(s);
    ASSERT_EQ(all.size(), phi < 0.56 ? 0u : 1u) << phi;
    if (phi > 0.65) { EXPECT_NE(all[0].find("only soft particles flow"), std::string::npos); }
    if (phi == 0.6) { EXPECT_NE(all[0].find("only if contacts slip"), std::string::npos); }
  }
}

TEST(SceneBounds, DoNotTellWhatTheyDoNotAgreeOn)
{
  const Scene s = mixture();    // P a^2/F 0.28 to 9.6
  const Verdict v = verdict(s, CRITICAL_LOAD);
  EXPECT_EQ(v.answer, CANNOT_TELL);
  EXPECT_NE(
      v.why.find(
          "run first, or give pressure P. At the least pressure of steady flow: needed, P a^2/F"),
      std::string::npos)
      << v.why;
  EXPECT_NE(v.why.find("; at the largest: not needed, P a^2/F"), std::string::npos) << v.why;
  EXPECT_EQ(v.why.find('['), std::string::npos) << v.why;
  EXPECT_EQ(verdict(s, FRICTION_LAW).answer, NEEDED);
  EXPECT_EQ(verdict(s, SHEAR_FILM).answer, NEEDED);
}

TEST(SceneBounds, TellWhatTheyAgreeOn)
{
  Scene s = mixture();
  s.critical = 1e6;    // nothing reaches it even if all rubbed
  EXPECT_EQ(verdict(s, CRITICAL_LOAD).answer, NOT_NEEDED);
  EXPECT_EQ(verdict(s, FRICTION_LAW).answer, NOT_NEEDED);
  s.critical = 1.0;    // everything reaches it even if nothing rubbed
  EXPECT_EQ(verdict(s, CRITICAL_LOAD).answer, NOT_NEEDED);
  EXPECT_EQ(verdict(s, FRICTION_LAW).answer, NEEDED);
}

TEST(SceneBounds, WarnOfWhatTheLargestPressureSpoils)
{
  Scene s = mixture();
  s.g = 1e6;    // E eps/P 10 to 300
  const auto all = warnings_at_bounds(s);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NE(all[0].find("asperities are crushed flat"), std::string::npos);
  EXPECT_NE(all[0].find("(at the largest pressure)"), std::string::npos);
  s.pressure = 30.0;
  EXPECT_TRUE(warnings_at_bounds(s).empty());
}

TEST(SceneBounds, AreShownTogether)
{
  Scene s = mixture();
  s.spread = s.skew = 0.0;
  EXPECT_EQ(show(numbers_at_bounds(s), &Numbers::St), "0.05");
  EXPECT_EQ(show(numbers_at_bounds(s), &Numbers::pressure),
            show(steady_pressure(s).low) + " to " + show(steady_pressure(s).high));
  EXPECT_EQ(show(numbers_at_bounds(s), &Numbers::Re), "?");
}

// --- measured pressures

TEST(SceneBounds, DoubtPressuresFarFromBothBounds)
{
  Scene s = mixture();
  const Bounds b = steady_pressure(s);
  for (double p : {b.low, b.high, 28.0, b.low / 4.9, b.high * 4.9})
    EXPECT_FALSE(doubt_pressure(s, p).any) << p;
  for (double p : {b.low / 5.1, b.high * 5.2, 1e-7}) EXPECT_TRUE(doubt_pressure(s, p).any) << p;
  s.density = 20.0;    // inertia adds to it
  EXPECT_FALSE(doubt_pressure(s, b.high * 40.0).any);
}

TEST(SceneBounds, DoNotDoubtWithoutALaw)
{
  for (auto change : {+[](Scene &s) {
                        s.phi = 0.3;
                      },
                      +[](Scene &s) {
                        s.dimension = 2.0;
                      },
                      +[](Scene &s) {
                        s.adhesion = 1.0;
                      },
                      +[](Scene &s) {
                        s.repulsion = 1.0;
                      },
                      +[](Scene &s) {
                        s.viscosity = 0.0;
                      },
                      +[](Scene &s) {
                        s.phi = 0.65;
                      }}) {
    Scene s = mixture();
    change(s);
    EXPECT_FALSE(doubt_pressure(s, 1e-7).any);
  }
}

TEST(SceneBounds, TellAChangingPressureFromChance)
{
  Scene s = mixture();
  s.particles = 4000;    // chance: sqrt(2) 3.8/sqrt(4000/2) = 0.12
  EXPECT_FALSE(still_changing(s, 100.0, 140.0, 1.0));
  EXPECT_TRUE(still_changing(s, 100.0, 180.0, 1.0));
  EXPECT_TRUE(still_changing(s, 180.0, 100.0, 1.0));
  s.particles = 100;    // 0.76
  EXPECT_FALSE(still_changing(s, 100.0, 400.0, 1.0));
}
