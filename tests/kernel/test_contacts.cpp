// What the statistics see of a pair, forces by origin, and averages of a few pairs done by hand.

#include "lubcontact_contacts.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

// Spheres of radius 1 along x at the separation un, i on the right.
PairGeometry at(double un)
{
  return pair_geometry({2.0 + un, 0.0, 0.0}, {}, 1.0, 1.0, 1.0);
}

Load load(double contact, double film, double shear, double u, double cone)
{
  Load l{};
  l.contact = contact;
  l.film = film;
  l.normal = contact + film;
  l.touch = contact > 0.0;
  l.shear = {0.0, shear, 0.0};
  l.u = u;
  l.cone = cone;
  return l;
}

}    // namespace

TEST(PairView, OfAFilmHasNoContact)
{
  const PairView p = view(at(0.1), load(0.0, -2.0, 3.0, 0.1, 0.0));
  EXPECT_FALSE(p.contact || p.frictional || p.sliding);
  EXPECT_EQ(p.normal, 0.0);
  EXPECT_EQ(p.friction, 0.0);
  EXPECT_EQ(p.u, 0.1);
  EXPECT_NEAR(p.un, 0.1, 1e-15);
  EXPECT_EQ(p.n.x, 1.0);
}

TEST(PairView, SticksInsideTheConeAndSlidesOutside)
{
  const PairView sticks = view(at(0.0), load(4.0, 1.0, -1.5, 0.005, 2.0));
  EXPECT_TRUE(sticks.contact && sticks.frictional);
  EXPECT_FALSE(sticks.sliding);
  EXPECT_DOUBLE_EQ(sticks.friction, 1.5);
  const PairView slides =
      view(at(0.0), load(4.0, 1.0, -3.0, 0.005, 2.0));    // a third is the film's
  EXPECT_TRUE(slides.sliding);
  EXPECT_DOUBLE_EQ(slides.friction, 2.0);
}

TEST(PairView, OfAContactWithoutConeHasNoFrictionAndDoesNotSlide)
{
  const PairView p = view(at(0.0), load(4.0, 1.0, 3.0, 0.005, 0.0));
  EXPECT_TRUE(p.contact);
  EXPECT_FALSE(p.frictional || p.sliding);
  EXPECT_EQ(p.friction, 0.0);
}

TEST(ForceByChannel, AddsUpToTheForceOfThePair)
{
  Random rnd(41);
  for (int m = 0; m < 1000; m++) {
    const Vec3 n = rnd.unit();
    const PairGeometry g = pair_geometry(2.01 * n, {}, 1.0, 1.0, 1.0);
    Load l = load(rnd.coin() ? rnd.uniform(0.0, 5.0) : 0.0, rnd.uniform(-3.0, 3.0), 0.0, 0.01, 0.0);
    l.shear = tangential(rnd.vector(3.0), n);
    l.cone = 0.5 * l.contact;
    const auto force = force_by_channel(g, l);
    Vec3 sum;
    for (const Vec3 &f : force.of) sum = sum + f;
    expect_near(sum, force_on_i(l, g), 1e-14);
    EXPECT_LE(norm(force.of[CONTACT_TANGENTIAL]), l.cone * (1.0 + 1e-12));
    EXPECT_NEAR(norm(cross(force.of[CONTACT_NORMAL], n)), 0.0, 1e-14);
  }
}

// Four spheres in a row touch one after another, the third pair is a film: contacts 1, 2, 1, 0 of
// each; the first contact sticks at half its cone, the second one slides.
TEST(Averages, OfARowOfFourSpheres)
{
  PairSums s;
  s.add(1.0, view(at(-0.02), load(4.0, 0.0, 1.0, 0.004, 2.0)));
  s.add(0.5, view(at(0.0), load(2.0, 0.0, 5.0, 0.008, 1.0)));
  s.add(0.5, view(at(0.0), load(2.0, 0.0, 5.0, 0.008, 1.0)));    // seen twice
  s.add(1.0, view(at(0.3), load(0.0, 1.0, 0.2, 0.3, 0.0)));
  const Averages a = averages(s, 4.0, 3.0, 2.0);
  const double expected[Averages::SIZE] = {1.0,   2.0, 0.75, 1.0, 1.0,  0.5,   0.5, 0.3,
                                           0.004, 3.0, 4.0,  1.0, 0.75, 0.024, 0.02};
  for (int m = 0; m < Averages::SIZE; m++) EXPECT_NEAR(a.value[m], expected[m], 1e-14) << m;
}

TEST(Averages, CountContactsWithAndWithoutFriction)
{
  PairSums s;
  s.add(1.0, view(at(0.0), load(4.0, 0.0, 0.0, 0.005, 2.0)));
  for (int m = 0; m < 3; m++) s.add(1.0, view(at(0.0), load(1.0, 0.0, 0.0, 0.005, 0.0)));
  const Averages a = averages(s, 8.0, 8.0, 8.0);
  EXPECT_DOUBLE_EQ(a.value[Averages::Z], 1.0);
  EXPECT_DOUBLE_EQ(a.value[Averages::Z_FRICTIONAL], 0.25);
  EXPECT_DOUBLE_EQ(a.value[Averages::CHI_F], 0.25);
  EXPECT_DOUBLE_EQ(a.value[Averages::RATTLERS], 1.0);
  EXPECT_DOUBLE_EQ(a.value[Averages::Z_CARRYING], 0.0);
}

TEST(Averages, OfNothingAreZero)
{
  const Averages a = averages(PairSums(), 0.0, 0.0, 0.0);
  for (const double v : a.value) EXPECT_EQ(v, 0.0);
}
