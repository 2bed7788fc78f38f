#include "scene_accuracy.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

using namespace LAMMPS_NS::Scene_NS;

// the base of benchmarks/accuracy_cost: phi 0.5, all known
static Scene base()
{
  Scene s;
  s.particles = 500;
  s.phi = 0.5;
  s.viscosity = 1.0;
  s.rate = 1.0;
  s.pressure = 45.0;
  s.density = 0.5;
  s.g = 1e6;
  s.roughness = 0.01;
  s.friction = 0.5;
  s.dt_limit = 3.2e-4;
  return s;
}

static Plan plan_of(double tolerance, const Scene &s = base())
{
  return plan(tolerance, s, numbers(s), s.dt_limit);
}

static const double TOLERANCES[] = {0.5, 0.3, 0.2, 0.15, 0.1, 0.07, 0.05};

TEST(SceneAccuracy, PromisesNoMoreThanTheTolerance)
{
  for (const double tolerance : TOLERANCES) {
    const Plan p = plan_of(tolerance);
    ASSERT_TRUE(p.possible) << tolerance;
    double sum = 0.0;
    for (const double c : p.change) sum += std::fabs(c);
    EXPECT_LE(sum + 2.0 * std::sqrt(p.scatter * p.scatter + p.doubt * p.doubt),
              tolerance * (1 + 1e-12));
  }
}

TEST(SceneAccuracy, CostsMoreForLess)
{
  double before = 0.0;
  for (const double tolerance : TOLERANCES) {
    const double cost = plan_of(tolerance).cost;
    EXPECT_GE(cost, before) << tolerance;
    before = cost;
  }
}

// scatter of the mean of N strain/C^2 independent values
TEST(SceneAccuracy, AveragesLongEnough)
{
  for (const double tolerance : TOLERANCES) {
    const Plan p = plan_of(tolerance);
    EXPECT_NEAR(p.scatter * p.scatter * p.particles * p.strain / std::pow(scatter(0.5), 2), 1.0,
                1e-12);
    EXPECT_GE(p.strain, SHORTEST);
  }
}

TEST(SceneAccuracy, ScatterIsThatOfTheTableAndBetween)
{
  for (const Scatter &s : SCATTER) EXPECT_DOUBLE_EQ(scatter(s.phi), s.value);
  EXPECT_DOUBLE_EQ(scatter(0.475), 0.5 * (scatter(0.45) + scatter(0.5)));
  EXPECT_DOUBLE_EQ(scatter(0.1), SCATTER[0].value);
  EXPECT_DOUBLE_EQ(scatter(0.6), std::rbegin(SCATTER)->value);
}

// dt = step limit sqrt(m/m' g/g'): four times the mass, twice the step
TEST(SceneAccuracy, StepsGoAsTheRootOfStiffnessOverMass)
{
  const Scene s = base();
  const Numbers n = numbers(s);
  Plan p;
  p.step = 0.5;
  p.St = n.St;
  p.softness = 1.0 / n.crushing;
  EXPECT_NEAR(steps_per_strain(p, s, n, s.dt_limit), 1.0 / (0.5 * 3.2e-4), 1e-6);
  p.St = 4.0 * n.St;
  EXPECT_NEAR(steps_per_strain(p, s, n, s.dt_limit), 0.5 / (0.5 * 3.2e-4), 1e-6);
  p.softness = 9.0 / n.crushing;
  EXPECT_NEAR(steps_per_strain(p, s, n, s.dt_limit), 0.5 / 3.0 / (0.5 * 3.2e-4), 1e-6);
}

// the plan is about the flow, not about the numbers that the deck has now
TEST(SceneAccuracy, ForgetsStiffnessAndDensityOfNow)
{
  Scene s = base();
  const Plan p = plan_of(0.1);
  s.g *= 25.0;
  s.density *= 4.0;
  s.dt_limit *= std::sqrt(4.0 / 25.0);
  const Plan q = plan_of(0.1, s);
  EXPECT_EQ(p.softness, q.softness);
  EXPECT_EQ(p.St, q.St);
  EXPECT_NEAR(p.cost, q.cost, 1e-9 * p.cost);
}

TEST(SceneAccuracy, AllOptionsWereMeasured)
{
  for (const double x : SOFTNESSES) EXPECT_LE(x, LAW[SOFTNESS].high);
  for (const double x : INERTIAS) EXPECT_LE(x, LAW[PARTICLE_INERTIA].high);
  for (const double x : SIZES) EXPECT_LE(1.0 / x, LAW[FEW_PARTICLES].high);
}

// a small cell of soft particles breaks down, a large one does not, nor a hard one
TEST(SceneAccuracy, KeepsSmallCellsHard)
{
  EXPECT_TRUE(breaks_down(0.045, 200));
  EXPECT_FALSE(breaks_down(0.045, 500));
  EXPECT_FALSE(breaks_down(0.0045, 200));
  for (const double tolerance : TOLERANCES) {
    const Plan p = plan_of(tolerance);
    EXPECT_FALSE(breaks_down(p.softness, p.particles));
  }
}

TEST(SceneAccuracy, StaysWithinWhatWasRun)
{
  Plan p = plan_of(0.2);
  ASSERT_TRUE(judge_plan(p, 0.2, 0.5).possible);
  p.steps = 0.5 / LAW[TIME_STEP].high;
  p.possible = false;
  EXPECT_FALSE(judge_plan(p, 0.2, 0.5).possible);
}

TEST(SceneAccuracy, SaysWhereItEnds)
{
  EXPECT_FALSE(plan_of(1e-4).possible);
  const double best = finest(base(), numbers(base()), base().dt_limit);
  EXPECT_TRUE(plan_of(1.01 * best).possible);
  EXPECT_FALSE(plan_of(0.99 * best).possible);
  EXPECT_TRUE(remarks(0.3, base()).empty());
  EXPECT_EQ(remarks(0.5 * MODEL_DOUBT, base()).size(), 1u);
  EXPECT_EQ(remarks(0.5 * SMALLEST_MEASURED, base()).size(), 2u);
  Scene s = base();
  for (const Scatter &measured : SCATTER) {
    s.phi = measured.phi * 1.0001;
    EXPECT_TRUE(remarks(0.3, s).empty()) << s.phi;
  }
  s.phi = 0.3;
  s.friction = 0.0;
  EXPECT_EQ(remarks(0.3, s).size(), 2u);
}

TEST(SceneAccuracy, RemarksBeginAtTheirBorders)
{
  auto said = [](double tolerance, double phi, double friction) {
    Scene s = base();
    s.phi = phi;
    s.friction = friction;
    return remarks(tolerance, s).size();
  };
  EXPECT_EQ(said(0.1501, 0.5, 0.5), 0u);
  EXPECT_EQ(said(0.1499, 0.5, 0.5), 1u);
  EXPECT_EQ(said(0.0301, 0.5, 0.5), 1u);
  EXPECT_EQ(said(0.0299, 0.5, 0.5), 2u);
  for (const double phi : {0.3951, 0.5449}) EXPECT_EQ(said(0.3, phi, 0.5), 0u) << phi;
  for (const double phi : {0.3949, 0.5451}) EXPECT_EQ(said(0.3, phi, 0.5), 1u) << phi;
  for (const double friction : {0.301, 0.699}) EXPECT_EQ(said(0.3, 0.5, friction), 0u) << friction;
  for (const double friction : {0.299, 0.701}) EXPECT_EQ(said(0.3, 0.5, friction), 1u) << friction;
  Scene s = base();
  EXPECT_NE(remarks(0.1, s)[0].find("within 15 %"), std::string::npos);
  EXPECT_NE(remarks(0.01, s)[1].find("below 3 %"), std::string::npos);
  EXPECT_TRUE(breaks_down(0.00461, 499.0));
  EXPECT_FALSE(breaks_down(0.00459, 499.0));
  EXPECT_FALSE(breaks_down(0.00461, 501.0));
}

// all numbers by hand: 1 %, room of half the rest for twice the scatter and the doubt
TEST(SceneAccuracy, PromiseIsTheSumOfItsParts)
{
  Plan p;
  p.change[0] = -0.01;
  p.change[1] = 0.02;
  p.doubt = 0.03;
  p.scatter = 0.04;
  EXPECT_DOUBLE_EQ(p.promised(), 0.03 + 2.0 * 0.05);
  for (const double tolerance : TOLERANCES) {
    const Plan q = plan_of(tolerance);
    if (q.strain > SHORTEST) { EXPECT_NEAR(q.promised(), tolerance, 1e-12); }
    const double x[NUM_CAUSES] = {1.0 / q.steps, q.softness, q.St, 1.0 / q.particles,
                                  q.twist ? 0.0 : 1.0};
    for (int c = 0; c < NUM_CAUSES; c++)
      EXPECT_DOUBLE_EQ(q.change[c], LAW[c].coefficient * std::pow(x[c], LAW[c].exponent));
  }
}
