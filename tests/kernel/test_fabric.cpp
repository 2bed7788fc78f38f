// Fabric tensors of directions whose mean is known: isotropic, and tilted by a normal distribution.

#include "lubcontact_fabric.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Fabric, OfIsotropicDirectionsIsAThirdOfTheIdentity)
{
  Random rnd(11);
  Fabric f;
  const int N = 400000;
  for (int m = 0; m < N; m++) f.add(1.0, rnd.unit());
  // standard deviations: of n_x^2 sqrt(4/45), of n_x n_y sqrt(1/15)
  const double error = 5.0 / std::sqrt(static_cast<double>(N));
  for (int m = 0; m < 3; m++) EXPECT_NEAR(f.mean(m), 1.0 / 3.0, 0.2981 * error);
  for (int m = 3; m < 6; m++) EXPECT_NEAR(f.mean(m), 0.0, 0.2582 * error);
}

// n = (cos t, sin t, 0) with t normal about b, deviation s: the mean of exp(2 i t) is
// exp(2 i b - 2 s^2).
TEST(Fabric, OfDirectionsTiltedByANormalDistributionIsKnown)
{
  Random rnd(12);
  const double b = 2.2, s = 0.4;
  Fabric f;
  const int N = 400000;
  for (int m = 0; m < N; m++) {
    const double size = std::sqrt(-2.0 * std::log(1.0 - rnd.uniform(0.0, 1.0)));
    const double t = b + s * size * std::cos(rnd.uniform(-PI_, PI_));
    f.add(0.7, {std::cos(t), std::sin(t), 0.0});
  }
  const double shrink = std::exp(-2.0 * s * s), error = 4.0 / std::sqrt(static_cast<double>(N));
  EXPECT_NEAR(f.mean(0), 0.5 * (1.0 + shrink * std::cos(2.0 * b)), error);
  EXPECT_NEAR(f.mean(1), 0.5 * (1.0 - shrink * std::cos(2.0 * b)), error);
  EXPECT_NEAR(f.mean(3), 0.5 * shrink * std::sin(2.0 * b), error);
  EXPECT_EQ(f.mean(2), 0.0);
  EXPECT_EQ(f.mean(4), 0.0);
  EXPECT_EQ(f.mean(5), 0.0);
}

TEST(Fabric, WeighsEachDirection)
{
  Fabric f;
  f.add(3.0, {1.0, 0.0, 0.0});
  f.add(1.0, {0.0, 0.0, -1.0});
  EXPECT_DOUBLE_EQ(f.mean(0), 0.75);
  EXPECT_DOUBLE_EQ(f.mean(2), 0.25);
}

TEST(Fabric, OfTwoVectorsIsTheSymmetricPartOverTheNorm)
{
  Fabric f;
  f.add(2.0, {0.0, 0.6, 0.8}, {5.0, 0.0, 0.0}, 4.0);
  EXPECT_DOUBLE_EQ(f.mean(3), 0.75);    // 2 (5 0.6)/2/4
  EXPECT_DOUBLE_EQ(f.mean(4), 1.0);
  EXPECT_DOUBLE_EQ(f.mean(0) + f.mean(1) + f.mean(2), 0.0);
  EXPECT_DOUBLE_EQ(f.mean(5), 0.0);
}

TEST(Fabric, OfNothingIsZero)
{
  for (int m = 0; m < FABRIC_SIZE; m++) EXPECT_EQ(Fabric().mean(m), 0.0);
}

TEST(Fabric, IsTheSymmetricProductOfBothDirections)
{
  Fabric f;
  f.add(2.0, {1.0, 2.0, 3.0}, {5.0, 7.0, 11.0}, 4.0);
  const double expected[FABRIC_SIZE] = {2.5, 7.0, 16.5, 4.25, 6.5, 10.75};
  for (int m = 0; m < FABRIC_SIZE; m++) EXPECT_EQ(f.mean(m), expected[m]) << m;
}
