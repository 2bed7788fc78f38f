// Geometry of a pore and its throats.

#include "pore_tetrahedron.h"
#include "tools.h"

using namespace LAMMPS_NS::Pore_NS;
using testing_tools::PI_;
using testing_tools::Random;

namespace {

// edge 1, one facet in the plane z = 0, the tip above
const Tetrahedron REGULAR = {{{0.0, 0.0, 0.0},
                              {1.0, 0.0, 0.0},
                              {0.5, std::sqrt(0.75), 0.0},
                              {0.5, std::sqrt(1.0 / 12.0), std::sqrt(2.0 / 3.0)}}};

Tetrahedron random_tetrahedron(Random &rnd)
{
  Tetrahedron t{};
  do
    for (Vec3 &x : t) x = rnd.vector(1.0);
  while (tetrahedron_volume(t) < 0.02);
  return t;
}

// facet opposite to corner n of a tetrahedron, with its power center on both sides
Facet facet_of(const Tetrahedron &t, const std::array<double, 4> &radius, int n)
{
  Facet f;
  for (int m = 0, at = 0; m < 4; m++)
    if (m != n) {
      f.corner[at] = t[m];
      f.radius[at++] = radius[m];
    }
  const Vec3 normal = cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]);
  const double side = std::copysign(1.0 / norm(normal), dot(normal, t[n] - f.corner[0]));
  f.center[0] = f.center[1] = power_center(t, radius);
  f.height[0] = side * dot(normal, f.center[0] - f.corner[0]);
  f.center[1] = f.center[0] - (f.height[0] * side) * normal;
  f.height[1] = 0.0;
  return f;
}

TEST(PoreTetrahedron, RegularOneHasTheVolumeOfTheTextbook)
{
  EXPECT_NEAR(tetrahedron_volume(REGULAR), std::sqrt(2.0) / 12.0, 1e-15);
  const Vec3 c = power_center(REGULAR, {0.3, 0.3, 0.3, 0.3});
  for (const Vec3 &x : REGULAR) EXPECT_NEAR(norm(c - x), std::sqrt(6.0) / 4.0, 1e-15);
}

TEST(PoreTetrahedron, GradientOfTheVolumeIsThatOfFiniteDifferences)
{
  Random rnd(301);
  for (int trial = 0; trial < 100; trial++) {
    Tetrahedron t = random_tetrahedron(rnd);
    const auto gradient = volume_gradient(t);
    for (int n = 0; n < 4; n++) {
      const Vec3 e = rnd.unit();
      const Vec3 x = t[n];
      t[n] = x + 1e-4 * e;
      const double more = tetrahedron_volume(t);
      t[n] = x - 1e-4 * e;
      EXPECT_NEAR(dot(gradient[n], e), (more - tetrahedron_volume(t)) / 2e-4, 1e-11);
      t[n] = x;
    }
  }
}

TEST(PoreTetrahedron, MotionThatIsLinearChangesTheVolumeByItsDivergence)
{
  Random rnd(302);
  for (int trial = 0; trial < 100; trial++) {
    const Tetrahedron t = random_tetrahedron(rnd);
    const auto gradient = volume_gradient(t);
    const Vec3 rows[3] = {rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)}, at = rnd.vector(5.0);
    double growth = 0.0;
    Vec3 sum;
    for (int n = 0; n < 4; n++) {
      growth +=
          dot(gradient[n], at + Vec3{dot(rows[0], t[n]), dot(rows[1], t[n]), dot(rows[2], t[n])});
      sum = sum + gradient[n];
    }
    EXPECT_NEAR(growth, (rows[0].x + rows[1].y + rows[2].z) * tetrahedron_volume(t), 1e-13);
    EXPECT_NEAR(norm(sum), 0.0, 1e-15);
  }
}

TEST(PoreTetrahedron, PowerCenterHasEqualTangents)
{
  Random rnd(303);
  for (int trial = 0; trial < 100; trial++) {
    const Tetrahedron t = random_tetrahedron(rnd);
    const std::array<double, 4> r = {0.1, 0.4, 0.2, 0.3};
    const Vec3 c = power_center(t, r);
    const double first = dot(c - t[0], c - t[0]) - r[0] * r[0];
    for (int n = 1; n < 4; n++)
      EXPECT_NEAR(dot(c - t[n], c - t[n]) - r[n] * r[n], first, 1e-10 * (1.0 + std::fabs(first)));
  }
}

TEST(PoreTetrahedron, SolidAngleOfAnOctantAndOfHalfASphere)
{
  EXPECT_NEAR(solid_angle({2.0, 0.0, 0.0}, {0.0, 3.0, 0.0}, {0.0, 0.0, 0.5}), PI_ / 2.0, 1e-15);
  const double angle = std::acos(23.0 / 27.0);
  EXPECT_NEAR(
      solid_angle(REGULAR[1] - REGULAR[0], REGULAR[2] - REGULAR[0], REGULAR[3] - REGULAR[0]), angle,
      1e-15);
  EXPECT_NEAR(solid_angle({1.0, 0.0, 1e-12}, {-0.5, 0.8, 1e-12}, {-0.5, -0.8, 1e-12}), 2.0 * PI_,
              1e-10);
}

// Two regular tetrahedra with a common facet, of spheres that touch: each corner of the facet has
// a third of the solid angle of a tetrahedron on either side.
TEST(PoreTetrahedron, ThroatBetweenRegularOnesHasItsClosedForm)
{
  const double r = 0.5, height = std::sqrt(6.0) / 12.0, facet = std::sqrt(3.0) / 4.0;
  Facet f;
  for (int n = 0; n < 3; n++) f.corner[n] = REGULAR[n];
  f.radius = {r, r, r};
  f.center[0] = power_center(REGULAR, {r, r, r, r});
  f.center[1] = f.center[0] - Vec3{0.0, 0.0, 2.0 * height};
  f.height[0] = f.height[1] = height;
  const Throat t = make_throat(f);
  const double angle = 2.0 * std::acos(23.0 / 27.0);    // of three corners, two sides
  const double radius = (facet * 2.0 * height / 3.0 - angle * r * r * r / 3.0) / (angle * r * r);
  const double area = facet - PI_ / 2.0 * r * r;
  EXPECT_NEAR(t.facet, facet, 1e-15);
  EXPECT_NEAR(t.area, area, 1e-15);
  EXPECT_NEAR(t.length, 2.0 * height, 1e-15);
  EXPECT_NEAR(t.radius, radius, 1e-15);
  EXPECT_NEAR(conductance(t, r), area * radius * radius / (4.0 * height), 1e-16);
  EXPECT_NEAR(throat_permeability(t), area * radius * radius / (2.0 * facet), 1e-16);
}

// also where the power center is outside of the tetrahedron
TEST(PoreTetrahedron, PiecesOfTheFourFacetsAddUpToTheWhole)
{
  Random rnd(304);
  int outside = 0;
  for (int trial = 0; trial < 300; trial++) {
    const Tetrahedron t = random_tetrahedron(rnd);
    double wetted = 0.0, solid = 0.0, volume = 0.0;
    std::array<double, 4> r;
    for (double &radius : r) radius = 0.05;
    for (int n = 0; n < 4; n++) {
      const Facet f = facet_of(t, r, n);
      outside += f.height[0] < 0.0;
      const Throat piece = make_throat(f);
      // fluid + solid = facet * height/3; all radii are the same
      const double whole = piece.facet * f.height[0] / 3.0;
      const double surface = whole / (piece.radius + r[0] / 3.0);
      if (f.height[0] > 0.0) {
        volume += whole;
        wetted += surface;
      } else {
        Facet mirrored = f;    // what it takes away
        mirrored.height[0] = -f.height[0];
        const Throat other = make_throat(mirrored);
        volume += whole;
        wetted += whole / (other.radius + r[0] / 3.0);
      }
    }
    solid = 0.0;
    for (int n = 0; n < 4; n++)
      solid += r[n] * r[n] *
          solid_angle(t[(n + 1) % 4] - t[n], t[(n + 2) % 4] - t[n], t[(n + 3) % 4] - t[n]);
    EXPECT_NEAR(volume, tetrahedron_volume(t), 1e-12);
    EXPECT_NEAR(wetted, solid, 1e-9);
  }
  EXPECT_GT(outside, 50);
}

// of an obtuse tetrahedron, whose neighbor has its center on the same side of the facet
TEST(PoreTetrahedron, CenterOnTheOtherSideTakesAwayWhatTheOtherHasTooMuch)
{
  const double r = 0.3;
  auto wetted = [r](double above, double below) {
    Facet f;
    for (int n = 0; n < 3; n++) f.corner[n] = REGULAR[n];
    f.radius = {r, r, r};
    const Vec3 foot = {0.5, std::sqrt(1.0 / 12.0), 0.0};
    f.center[0] = foot + Vec3{0.0, 0.0, above};
    f.center[1] = foot - Vec3{0.0, 0.0, below};
    f.height[0] = above;
    f.height[1] = below;
    const Throat t = make_throat(f);
    return t.facet * t.length / 3.0 / (t.radius + r / 3.0);
  };
  const double tall = 0.5 * wetted(0.3, 0.3), low = 0.5 * wetted(0.1, 0.1);
  EXPECT_NEAR(wetted(0.3, -0.1), tall - low, 1e-13);
  EXPECT_NEAR(wetted(-0.1, 0.3), tall - low, 1e-13);
  EXPECT_NEAR(wetted(0.1, 0.3), tall + low, 1e-13);
}

// so that no matrix is singular, and none badly conditioned
TEST(PoreTetrahedron, ConductanceHasBounds)
{
  const Throat closed{1.0, -0.1, 0.2, 0.3}, full{1.0, 0.1, -0.2, 0.3}, open{4.0, 3.0, 0.2, 0.5},
      flat{4.0, 3.0, 0.2, 0.0}, folded{4.0, 3.0, 0.2, -0.1};
  EXPECT_NEAR(conductance(open, 2.0), 3.0 * 0.04 / 2.0 / 0.5, 1e-15);
  EXPECT_NEAR(conductance(flat, 2.0), 3.0 * 0.04 / 2.0 / 0.2, 1e-14);
  EXPECT_EQ(conductance(folded, 2.0), conductance(flat, 2.0));
  for (const Throat &t : {closed, full}) {
    EXPECT_NEAR(conductance(t, 2.0), 8e-5, 1e-19);
    EXPECT_EQ(throat_permeability(t), 0.0);
  }
}

}    // namespace
