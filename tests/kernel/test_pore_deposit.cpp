// Spreading of particles over elements, and the weights of their velocities.

#include "pore_case.h"

using namespace pore_case;

namespace {

const Permeability LAW;

// a bed at phi .5 in a tilted cell, or between plates
Pores random_pores(Random &rnd, const Sides &sides, double h, Bed &bed)
{
  const bool plates = sides.lower != Wall::PERIODIC;
  const Cell c =
      filled_cell(90, 0.5, {1.0, 1.2, 0.9}, plates ? 0.0 : 0.3, 0.2, plates ? 0.0 : -0.4);
  bed = random_bed(rnd, 90, 0.2, c, plates, 100);
  return Pores(grid_of(c, h, sides.lower, sides.upper), LAW, 1.0, bed);
}

TEST(PoreDeposit, SplineIsTheQuadraticOne)
{
  // at a center: 1/8, 3/4, 1/8; at a corner: 1/2 of both sides
  Spline s = spline(2.5, 7, false);
  EXPECT_EQ(s.index[0], 1);
  EXPECT_EQ(s.index[2], 3);
  EXPECT_DOUBLE_EQ(s.weight[0], 0.125);
  EXPECT_DOUBLE_EQ(s.weight[1], 0.75);
  EXPECT_DOUBLE_EQ(s.weight[2], 0.125);
  s = spline(3.0, 7, false);
  EXPECT_DOUBLE_EQ(s.weight[0], 0.5);
  EXPECT_DOUBLE_EQ(s.weight[1], 0.5);
  EXPECT_DOUBLE_EQ(s.weight[2], 0.0);
}

TEST(PoreDeposit, SplineHasTotalOneAndTheRightCenter)
{
  for (int n : {1, 2, 3, 8})
    for (bool reflected : {false, true})
      for (double xi = 0.003; xi < n; xi += 0.0617) {
        const Spline s = spline(xi, n, reflected);
        double sum = 0.0, mean = 0.0;
        for (int m = 0; m < 3; m++) {
          EXPECT_GE(s.index[m], 0);
          EXPECT_LT(s.index[m], n);
          sum += s.weight[m];
          mean += s.weight[m] * s.offset[m];
          EXPECT_NEAR(std::remainder(s.index[m] + 0.5 + s.offset[m] - xi, n), 0.0, 1e-12);
        }
        EXPECT_NEAR(sum, 1.0, 1e-14);
        EXPECT_NEAR(reflected ? 0.0 : mean, 0.0, 1e-14);
      }
}

TEST(PoreDeposit, SplineBeyondAPlateIsThatOfTheMirrorImage)
{
  const Spline in = spline(0.3, 6, true), out = spline(-0.3, 6, true);
  double a[6] = {}, b[6] = {};
  for (int m = 0; m < 3; m++) {
    a[in.index[m]] += in.weight[m];
    b[out.index[m]] += out.weight[m];
  }
  for (int e = 0; e < 6; e++) EXPECT_NEAR(a[e], b[e], 1e-15);
}

TEST(PoreDeposit, PeriodicSplineDoesNotDependOnTheImage)
{
  for (double xi : {-12.3, -5.3, 1.7, 8.7, 701.7}) {
    const Spline s = spline(xi, 7, false);
    EXPECT_EQ(s.index[1], 1);
    EXPECT_NEAR(s.offset[1], 0.2, 1e-12);
  }
}

TEST(PoreDeposit, PartAboveAPlaneIsThatOfTheSphericalCap)
{
  EXPECT_EQ(part_above(1.2, 1.0), 1.0);
  EXPECT_EQ(part_above(-1.2, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(part_above(0.0, 2.0), 0.5);
  // cap of height a/2: pi h^2 (3 a - h)/3 = 5/24 pi a^3 of 4/3 pi a^3
  EXPECT_NEAR(part_above(-1.0, 2.0), 5.0 / 32.0, 1e-15);
}

TEST(PoreDeposit, VolumeIsConserved)
{
  Random rnd(11);
  for (const Sides &sides : SIDES) {
    Bed bed;
    const Pores pores = random_pores(rnd, sides, 1.4, bed);
    double filled = 0.0, all = 0.0;
    for (const Element &e : pores.elements) filled += e.phi * pores.grid.element_volume();
    for (std::size_t i = 0; i < bed.size(); i++) all += pores.inside(bed, i) * bed.volume(i);
    EXPECT_NEAR(filled, all, 1e-12 * all);
  }
}

TEST(PoreDeposit, WeightsReproduceOneAndThePosition)
{
  Random rnd(12);
  for (const Sides &sides : SIDES)
    for (double h : {1.0, 1.5, 2.5}) {
      Bed bed;
      const Pores pores = random_pores(rnd, sides, h, bed);
      const Grid &g = pores.grid;
      std::vector<double> one(g.elements());
      std::vector<Vec3> position(g.elements());    // from the center
      for (std::size_t i = 0; i < bed.size(); i++) {
        for_each_reached(g, bed.x[i], [&](int e, int r, int a, const Vec3 &d) {
          ASSERT_EQ(pores.stencils[i].element(r, a), e);
          const double w = pores.stencils[i].weight[r][a];
          one[e] += w;
          position[e] = position[e] + w * d;
        });
      }
      for (std::size_t e = 0; e < g.elements(); e++) {
        ASSERT_GT(pores.elements[e].phi, LAW.phi_min);
        EXPECT_NEAR(one[e], 1.0, 1e-13);
        testing_tools::expect_near(position[e], {0.0, 0.0, 0.0}, 1e-12);
      }
    }
}

// The offset of the elements from the images of a particle, in space: what the cell's tilt does to
// it.
TEST(PoreDeposit, VelocityThatIsLinearInPositionIsExactAtTheCenters)
{
  Random rnd(13);
  for (const Sides &sides : {SIDES[1], SIDES[4]}) {
    Bed bed;
    const Pores pores = random_pores(rnd, sides, 1.5, bed);
    const Grid &g = pores.grid;
    std::vector<Vec3> v;
    for (const Vec3 &x : bed.x) v.push_back({2.0 * x.y - 1.0, 0.3 * x.y, 0.7 - x.y});
    const std::vector<Motion> motion = pores.motion(v);
    for (int j = 0; j < g.ny; j++) {
      const double y = center(g, 0, j, 0).y;
      for (int n = 0; n < g.layer_size(); n++)
        testing_tools::expect_near(motion[j * g.layer_size() + n].velocity,
                                   {2.0 * y - 1.0, 0.3 * y, 0.7 - y}, 1e-12);
    }
  }
}

TEST(PoreDeposit, ImagesAndTiltsThatAreTheSameLatticeGiveTheSame)
{
  // xy + xprd is the same periodic system; nodes fall on nodes if nx is a multiple of ny
  Random rnd(14);
  Grid g;
  g.nx = 6;
  g.ny = 3;
  g.nz = 4;
  g.cell = filled_cell(60, 0.5, {1.0, 1.0, 1.0}, 0.5, 0.0, 0.0);
  g.cell.xy = 0.5 * g.cell.xprd;
  const Bed bed = random_bed(rnd, 60, 0.0, g.cell, false);
  Bed moved = bed;
  for (Vec3 &x : moved.x) x = x + Vec3{g.cell.xprd, 0.0, 0.0} - Vec3{g.cell.xy, g.cell.yprd, 0.0};
  Grid flipped = g;
  flipped.cell.xy -= g.cell.xprd;
  const Pores one(g, LAW, 1.0, bed), two(g, LAW, 1.0, moved), three(flipped, LAW, 1.0, bed);
  for (std::size_t e = 0; e < g.elements(); e++)
    EXPECT_NEAR(one.elements[e].phi, two.elements[e].phi, 1e-12);
  double sum = 0.0, flipped_sum = 0.0;
  for (std::size_t e = 0; e < g.elements(); e++) {
    sum += one.elements[e].phi;
    flipped_sum += three.elements[e].phi;
  }
  EXPECT_NEAR(sum, flipped_sum, 1e-11);
}

TEST(PoreDeposit, NegativeWeightsOccurAtPlatesOnly)
{
  Random rnd(15);
  for (const Sides &sides : SIDES) {
    Bed bed;
    const Pores pores = random_pores(rnd, sides, 1.7, bed);
    ASSERT_GT(spacing(pores.grid), 1.2);
    double negative = 0.0, all = 0.0;
    for (const Stencil &s : pores.stencils)
      for (const auto &row : s.weight)
        for (double w : row) {
          all += std::fabs(w);
          if (w < 0.0) negative -= w;
        }
    EXPECT_LE(negative, pores.grid.has_plates() ? 0.01 * all : 0.0);
  }
}

TEST(PoreDeposit, DiluteElementsHaveWeightsThatFadeAway)
{
  Grid g;
  g.nx = g.ny = g.nz = 5;
  g.cell.xprd = g.cell.yprd = g.cell.zprd = 7.5;
  Bed bed;
  bed.x.push_back({3.1, 3.3, 4.2});
  bed.radius.push_back(0.5);
  const Pores pores(g, LAW, 1.0, bed);
  const std::vector<Motion> motion = pores.motion({{1.0, 0.0, 0.0}});
  double filled = 0.0;
  for (std::size_t e = 0; e < g.elements(); e++) {
    EXPECT_NEAR(motion[e].velocity.x, pores.elements[e].phi / LAW.phi_min, 1e-14);
    EXPECT_DOUBLE_EQ(pores.elements[e].radius, 0.5);    // of the mean where there is nobody
    filled += pores.elements[e].phi;
  }
  EXPECT_NEAR(filled * g.element_volume(), bed.volume(0), 1e-14);
}

TEST(PoreDeposit, NobodyIsNoError)
{
  Grid g;
  g.nx = g.ny = g.nz = 3;
  const Pores pores(g, LAW, 1.0, Bed());
  for (const Element &e : pores.elements) {
    EXPECT_EQ(e.phi, 0.0);
    EXPECT_EQ(e.permeability, 0.0);
    EXPECT_TRUE(std::isfinite(e.constant));
  }
}

TEST(PoreDeposit, RadiusOfAnElementFillsUpWithTheMean)
{
  Grid g;
  g.nx = g.nz = 1;
  g.ny = 20;
  g.cell = {{}, 1.5, 30.0, 1.5, 0.0, 0.0, 0.0};
  Bed bed;
  for (double y : {2.0, 14.0}) {
    bed.x.push_back({0.5, y, 0.5});
    bed.radius.push_back(y < 3.0 ? 0.7 : 0.4);
  }
  const Permeability dense{Closure::KOZENY, 0.0, 1.0, 1e-6};
  const Pores pores(g, dense, 1.0, bed);
  EXPECT_NEAR(pores.elements[1].radius, 0.7, 1e-6);
  EXPECT_NEAR(pores.elements[9].radius, 0.4, 1e-6);
  EXPECT_NEAR(pores.elements[15].radius, (0.343 + 0.064) / (0.49 + 0.16), 1e-14);
}

TEST(PoreDeposit, PseudoInverseIsTheInverseWithoutFlatDirections)
{
  Random rnd(16);
  for (int trial = 0; trial < 300; trial++) {
    // axes and eigenvalues known
    const Vec3 u = rnd.unit(), t = rnd.unit();
    const Vec3 w = (1.0 / norm(cross(u, t))) * cross(u, t), v = cross(w, u);
    const double lu = rnd.uniform(0.02, 1.0), lv = rnd.uniform(0.02, 1.0);
    const double lw = trial % 2 ? rnd.uniform(0.0, 0.009) : rnd.uniform(0.02, 1.0);
    const auto entry = [&](double Vec3::*a, double Vec3::*b) {
      return lu * (u.*a) * (u.*b) + lv * (v.*a) * (v.*b) + lw * (w.*a) * (w.*b);
    };
    const Symmetric m{entry(&Vec3::x, &Vec3::x), entry(&Vec3::y, &Vec3::y),
                      entry(&Vec3::z, &Vec3::z), entry(&Vec3::x, &Vec3::y),
                      entry(&Vec3::x, &Vec3::z), entry(&Vec3::y, &Vec3::z)};
    const Vec3 a = rnd.vector(1.0);
    const Vec3 expected =
        (dot(u, a) / lu) * u + (dot(v, a) / lv) * v + (lw < FLAT ? 0.0 : dot(w, a) / lw) * w;
    testing_tools::expect_near(bounded_solve(m, a, FLAT), expected, 1e-11);
    testing_tools::expect_near(pseudo_solve(m, a, FLAT), expected, 1e-11);
  }
  testing_tools::expect_near(bounded_solve({}, {1.0, 1.0, 1.0}, FLAT), {}, 0.0);
}

TEST(PoreDeposit, BoundOfEqualSpheresIsAboutOneOverTheirDensity)
{
  Random rnd(17);
  const Cell c = filled_cell(200, 0.5, {1.0, 1.0, 1.0}, 0.0, 0.0, 0.0);
  const Bed bed = random_bed(rnd, 200, 0.0, c, false, 60);
  const Pores pores(grid_of(c, 1.5, Wall::PERIODIC, Wall::PERIODIC), LAW, 1.0, bed);
  const double mass = 1.7, density = mass / bed.volume(0);
  for (double bound : pores.bounds(std::vector<double>(bed.size(), 1.0 / mass)))
    EXPECT_NEAR(bound * density * 0.5, 1.0, 0.35);
}

TEST(PoreDeposit, FlatSystemsHaveOneLayer)
{
  // discs in a plane, volumes per length of the axis
  Random rnd(18);
  Grid g;
  g.nx = 7;
  g.ny = 6;
  g.cell = {{0.0, 0.0, -0.5}, 10.5, 9.0, 1.0, 2.0, 0.0, 0.0};
  const Metric m = metric(g);
  std::vector<Moments> sums(g.elements());
  std::vector<Vec3> x;
  for (int n = 0; n < 90; n++) {
    x.push_back({rnd.uniform(0.0, 10.5), rnd.uniform(0.0, 9.0), 0.0});
    add_moments(g, m, x.back(), 0.7, 0.2, sums.data());
  }
  const std::vector<Element> elements = make_elements(g, LAW, sums);
  std::vector<Motion> motion(g.elements());
  for (const Vec3 &at : x)
    add_motion(make_stencil(g, m, elements, at, 0.7), {{1.0, 2.0, 0.0}}, motion.data());
  for (const Motion &one : motion) testing_tools::expect_near(one.velocity, {1.0, 2.0, 0.0}, 1e-12);
}

}    // namespace
