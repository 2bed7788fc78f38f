// Shows that the vector algebra is right-handed and that turned() is a proper rotation.

#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Vec3, SumDifferenceAndMultipleActOnEachComponent)
{
  const Vec3 a{1.0, -2.0, 3.0}, b{4.0, 0.5, -6.0};
  expect_same(a + b, {5.0, -1.5, -3.0});
  expect_same(a - b, {-3.0, -2.5, 9.0});
  expect_same(-2.0 * a, {-2.0, 4.0, -6.0});
}

TEST(Vec3, DotNormAndCrossAgreeWithHandComputedValues)
{
  EXPECT_EQ(dot({1.0, -2.0, 3.0}, {4.0, 5.0, 6.0}), 12.0);
  EXPECT_EQ(norm({2.0, -3.0, 6.0}), 7.0);
  expect_same(cross({1.0, 2.0, 3.0}, {4.0, 5.0, 7.0}), {-1.0, 5.0, -3.0});
}

TEST(Vec3, CrossIsRightHanded)
{
  const Vec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
  expect_same(cross(x, y), z);
  expect_same(cross(y, z), x);
  expect_same(cross(z, x), y);
}

TEST(Vec3, TangentialRemovesTheNormalPartAndNothingElse)
{
  expect_same(tangential({1.0, 2.0, 3.0}, {0.0, 0.0, 1.0}), {1.0, 2.0, 0.0});
  Random rnd(1);
  for (int trial = 0; trial < 1000; trial++) {
    const Vec3 a = rnd.vector(2.0), n = rnd.unit();
    const Vec3 t = tangential(a, n);
    EXPECT_NEAR(dot(t, n), 0.0, 1e-15);
    EXPECT_NEAR(norm(cross(n, t) - cross(n, a)), 0.0, 2e-15);
  }
}

TEST(Larger, TakesTheLargerAndPassesOnWhatIsNotANumber)
{
  EXPECT_EQ(larger(1.0, 2.0), 2.0);
  EXPECT_EQ(larger(-1.0, -2.0), -1.0);
  EXPECT_TRUE(std::isnan(larger(0.0, std::nan(""))));
}

TEST(Turned, QuarterTurnAboutZTakesXToY)
{
  // 2 tan(45 degrees) = 2
  expect_near(turned({1.0, 0.0, 0.0}, {0.0, 0.0, 2.0}), {0.0, 1.0, 0.0}, 1e-15);
  expect_near(turned({0.0, 3.0, 0.0}, {0.0, 0.0, 2.0}), {-3.0, 0.0, 0.0}, 1e-15);
}

TEST(Turned, AgreesWithRodriguesForAnyAxisAndAngle)
{
  Random rnd(2);
  for (int trial = 0; trial < 2000; trial++) {
    const Vec3 a = rnd.vector(1.0), axis = rnd.unit();
    const double angle = rnd.uniform(-3.1, 3.1);
    expect_near(turned(a, 2.0 * std::tan(0.5 * angle) * axis), rotated(a, axis, angle), 1e-14);
  }
}

TEST(Turned, KeepsLengthsForAnyVectorHoweverLong)
{
  Random rnd(3);
  for (int trial = 0; trial < 2000; trial++) {
    const Vec3 a = rnd.vector(1.0);
    const Vec3 c = rnd.log_uniform(1e-12, 1e12) * rnd.unit();
    EXPECT_NEAR(norm(turned(a, c)), norm(a), 1e-14);
  }
}

TEST(Turned, IsUndoneByTheOppositeVector)
{
  Random rnd(4);
  for (int trial = 0; trial < 1000; trial++) {
    const Vec3 a = rnd.vector(1.0), c = rnd.vector(5.0);
    expect_near(turned(turned(a, c), -1.0 * c), a, 1e-14);
  }
}

TEST(Turned, ZeroVectorChangesNothing)
{
  expect_same(turned({1.0, 2.0, 3.0}, {}), {1.0, 2.0, 3.0});
}
