// Bins of directions: head and tail are the same, all bins of the sphere are equally large, and the
// density of isotropic pairs is 1/(4 pi) everywhere.

#include "lubcontact_orientation.h"
#include "tools.h"

#include <vector>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Orientation, AzimuthGoesFromTheFirstAxisOfThePlaneToTheSecond)
{
  const Vec3 n = {0.36, 0.48, 0.8};
  EXPECT_NEAR(direction(Plane::XY, n).azimuth, std::atan(0.48 / 0.36), 1e-15);
  EXPECT_NEAR(direction(Plane::XZ, n).azimuth, std::atan(0.8 / 0.36), 1e-15);
  EXPECT_NEAR(direction(Plane::YZ, n).azimuth, std::atan(0.8 / 0.48), 1e-15);
  EXPECT_EQ(direction(Plane::XY, n).height, 0.8);
  EXPECT_EQ(direction(Plane::XZ, n).height, 0.48);
  EXPECT_EQ(direction(Plane::YZ, n).height, 0.36);
  // the axis of compression of a flow along x that increases with y
  EXPECT_NEAR(direction(Plane::XY, {-0.6, 0.6, 0.1}).azimuth, 0.75 * PI_, 1e-15);
}

TEST(Orientation, HeadAndTailAreTheSame)
{
  Random rnd(31);
  for (const Plane plane : {Plane::XY, Plane::XZ, Plane::YZ})
    for (int m = 0; m < 1000; m++) {
      const Vec3 n = rnd.unit();
      const Direction a = direction(plane, n), b = direction(plane, -1.0 * n);
      EXPECT_NEAR(a.azimuth, b.azimuth, 1e-15);
      EXPECT_EQ(a.height, b.height);
      EXPECT_GE(a.azimuth, 0.0);
      EXPECT_LT(a.azimuth, PI_);
    }
}

TEST(Orientation, TheFirstAxisAndThePolesHaveARow)
{
  const DirectionBins bins = {Plane::XY, 4, 6, 1.0};
  EXPECT_EQ(bins.find({1.0, 0.0, 0.0}), bins.find({-1.0, -0.0, 0.0}));
  EXPECT_EQ(direction(Plane::XY, {-1.0, -1e-300, 0.5}).azimuth, 0.0);
  for (const double y : {0.0, -0.0, -1e-300}) {
    EXPECT_EQ(direction(Plane::XY, {-0.8, y, 0.6}).azimuth, 0.0);
    EXPECT_EQ(direction(Plane::XY, {-0.8, y, 0.6}).height, -0.6);
  }
  for (const Vec3 &n : {Vec3{0.0, 0.0, 1.0}, Vec3{0.0, 0.0, -1.0}, Vec3{-1.0, 1e-300, 0.0}}) {
    EXPECT_GE(bins.find(n), 0);
    EXPECT_LT(bins.find(n), bins.size());
  }
}

TEST(Orientation, TheCenterOfARowIsInIt)
{
  const DirectionBins bins = {Plane::XY, 5, 7, 1.0};
  for (int row = 0; row < bins.size(); row++) {
    const double t = bins.polar_angle(row), p = bins.azimuth(row);
    EXPECT_EQ(bins.find({std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)}), row);
  }
  EXPECT_DOUBLE_EQ(bins.measure_sphere() * bins.size(), 4.0 * PI_);
  EXPECT_DOUBLE_EQ(bins.measure_circle() * bins.size(), 2.0 * PI_);
}

TEST(Orientation, DensityOfIsotropicPairsIsOneOverFourPi)
{
  Random rnd(32);
  const int N = 200000;
  for (const Plane plane : {Plane::XY, Plane::XZ, Plane::YZ}) {
    const DirectionBins bins = {plane, 6, 9, 1.0};
    std::vector<double> count(static_cast<std::size_t>(bins.size()), 0.0);
    for (int m = 0; m < N; m++) count[static_cast<std::size_t>(bins.find(rnd.unit()))] += 1.0;
    const double share = 1.0 / bins.size();    // of each bin
    for (const double c : count)
      EXPECT_NEAR(c / (N * bins.measure_sphere()), 1.0 / (4.0 * PI_),
                  5.0 * std::sqrt(share / N) / bins.measure_sphere());
  }
}

TEST(Orientation, ABandKeepsTheDirectionsNearThePlane)
{
  Random rnd(33);
  const DirectionBins bins = {Plane::XY, 1, 4, 0.3};
  const int N = 100000;
  int inside = 0;
  for (int m = 0; m < N; m++) {
    const Vec3 n = rnd.unit();
    EXPECT_EQ(bins.find(n) >= 0, std::fabs(n.z) <= 0.3);
    inside += bins.find(n) >= 0;
  }
  EXPECT_NEAR(inside / static_cast<double>(N), 0.3, 5.0 * std::sqrt(0.21 / N));    // equal zones
}

TEST(Orientation, BinsHaveTheirCentersAndBordersWhereTheySay)
{
  const DirectionBins bins = {Plane::XY, 5, 8, 1.0};
  EXPECT_DOUBLE_EQ(bins.azimuth(0), PI_ / 16.0);
  EXPECT_DOUBLE_EQ(bins.azimuth(11), 7.0 * PI_ / 16.0);
  EXPECT_DOUBLE_EQ(std::cos(bins.polar_angle(0)), -0.8);
  EXPECT_NEAR(std::cos(bins.polar_angle(20)), 0.0, 1e-15);
  for (int border = 1; border < 5; border++)
    for (const int side : {0, 1}) {
      const double z = -1.0 + 0.4 * border + (side ? 1e-9 : -1e-9);
      EXPECT_EQ(bins.find({std::sqrt(1.0 - z * z), 0.0, z}) / 8, border - 1 + side);
    }
  for (int border = 1; border < 8; border++)
    for (const int side : {0, 1}) {
      const double angle = PI_ * border / 8.0 + (side ? 1e-9 : -1e-9);
      EXPECT_EQ(bins.find({std::cos(angle), std::sin(angle), 0.0}), 16 + border - 1 + side);
    }
}
