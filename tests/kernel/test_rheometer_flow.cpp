// Shows that cell and particles follow one affine flow whatever the history of the rates, that
// flips keep the lattice, and that stresses and rates are conjugate.

#include "rheometer_flow.h"
#include "tools.h"

#include <algorithm>

using namespace LAMMPS_NS::Rheometer_NS;
using namespace testing_tools;

static Cell moved(const Cell &h, const Gradient &g, double dt)
{
  return advance(h, cell_rate(g, h), dt);
}

namespace {

struct Case {
  Flow flow;
  int dimension;
  const char *name;
};

const Case CASES[] = {{SHEAR, 3, "shear"},
                      {SHEAR, 2, "shear 2d"},
                      {PLANAR, 3, "planar"},
                      {PLANAR, 2, "planar 2d"},
                      {UNIAXIAL, 3, "uniaxial"}};

using Matrix = long double[3][3];

void set(Matrix &m, const Gradient &g)
{
  const long double from[3][3] = {{g.xx, g.xy, 0.0L}, {0.0L, g.yy, 0.0L}, {0.0L, 0.0L, g.zz}};
  std::copy(&from[0][0], &from[0][0] + 9, &m[0][0]);
}

double volume(const Cell &h)
{
  return h.lx * h.ly * h.lz;
}

// place of the particle at (x, y, z) of the cell
Vec3 at(const Cell &h, const Vec3 &place)
{
  return {h.lx * place.x + h.xy * place.y, h.ly * place.y, h.lz * place.z};
}

// wanders between -1 and 1, with jumps, reversals and rests
class Wander {
 public:
  double next(Random &rnd)
  {
    const double kind = rnd.uniform(0.0, 1.0);
    if (kind < 0.002)
      now = -now;
    else if (kind < 0.004)
      now = 0.0;
    else if (kind < 0.01)
      now = rnd.uniform(-1.0, 1.0);
    else
      now = std::clamp(now + rnd.uniform(-0.05, 0.05), -1.0, 1.0);
    return now;
  }

 private:
  double now = 0.0;
};

// a step in the order of a run: positions and cell, flip, then the flow of the next step
struct Motion {
  Cell h;
  Gradient g;
  Vec3 place, x, v;    // of one particle; place counts edges of the present cell
  double dt;
  int flipped = 0;

  Motion(const Cell &cell, const Vec3 &where, double step) :
      h(cell), place(where), x(at(cell, where)), v{0.0, 0.0, 0.0}, dt(step)
  {
  }

  void change_flow(const Gradient &next, double dt_before)
  {
    const Gradient k = change(g, next, dt_before);
    v = v + Vec3{k.xx * x.x + k.xy * x.y, k.yy * x.y, k.zz * x.z};
    g = next;
  }

  void step(const Gradient &next)
  {
    x = x + dt * v;
    h = moved(h, g, dt);
    const int n = flips(h);
    flipped += std::abs(n);
    h.xy += n * h.lx;
    place.x -= n * place.y;
    change_flow(next, dt);
  }

  void expect_affine(double tolerance) const
  {
    const double size = std::max({h.lx, h.ly, h.lz});
    const Cell rate = cell_rate(g, h);
    expect_near(x, at(h, place), tolerance * size * (1.0 + std::fabs(place.x)));
    expect_near(v, at(rate, place), tolerance * size * (1.0 + std::fabs(place.x)));
  }
};

// forth and back: the strain is 0, its path is not
TEST(CellMotion, CountsStrainAndItsPath)
{
  CellMotion m;
  for (double rate : {2.0, -2.0}) {
    m.rate = rate;
    pass(m, 0.25);
  }
  EXPECT_EQ(m.strain, 0.0);
  EXPECT_EQ(m.path, 1.0);
  EXPECT_EQ(m.time, 0.5);
  EXPECT_EQ(m.moved, 0.5);
}

}    // namespace

TEST(Advance, MultipliesTheCellByOnePlusTheGradient)
{
  Random rnd(1);
  for (int trial = 0; trial < 1000; trial++) {
    const Gradient g{rnd.uniform(-2.0, 2.0), rnd.uniform(-2.0, 2.0), rnd.uniform(-2.0, 2.0),
                     rnd.uniform(-2.0, 2.0)};
    const Cell h{rnd.uniform(1.0, 9.0), rnd.uniform(1.0, 9.0), rnd.uniform(1.0, 9.0),
                 rnd.uniform(-4.0, 4.0)};
    const double dt = rnd.uniform(0.0, 0.3);
    Matrix m;
    set(m, g);
    // columns: the three edges
    const long double edges[3][3] = {{h.lx, h.xy, 0.0L}, {0.0L, h.ly, 0.0L}, {0.0L, 0.0L, h.lz}};
    Matrix to;
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) {
        to[i][j] = edges[i][j];
        for (int k = 0; k < 3; k++) to[i][j] += dt * m[i][k] * edges[k][j];
      }
    const Cell next = moved(h, g, dt);
    EXPECT_NEAR(next.lx, static_cast<double>(to[0][0]), 1e-14);
    EXPECT_NEAR(next.ly, static_cast<double>(to[1][1]), 1e-14);
    EXPECT_NEAR(next.lz, static_cast<double>(to[2][2]), 1e-14);
    EXPECT_NEAR(next.xy, static_cast<double>(to[0][1]), 1e-14);
    EXPECT_EQ(to[1][0] + to[2][0] + to[0][2] + to[1][2] + to[2][1], 0.0L);
  }
}

TEST(Change, IsTheDifferenceToTheFlowSeenFromTheEndOfTheStep)
{
  // (change - after)(1 + dt before) = -before, as matrices: no inverse in the oracle
  Random rnd(2);
  for (int trial = 0; trial < 1000; trial++) {
    auto random = [&rnd]() {
      return Gradient{rnd.uniform(-2.0, 2.0), rnd.uniform(-2.0, 2.0), rnd.uniform(-2.0, 2.0),
                      rnd.uniform(-2.0, 2.0)};
    };
    const Gradient before = random(), after = random();
    const double dt = rnd.uniform(0.0, 0.3);
    Matrix b, d;
    set(b, before);
    set(d, minus(change(before, after, dt), after));
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) {
        long double sum = d[i][j] + b[i][j];
        for (int k = 0; k < 3; k++) sum += dt * d[i][k] * b[k][j];
        EXPECT_NEAR(static_cast<double>(sum), 0.0, 3e-14);
      }
  }
}

TEST(Change, VanishesInSteadyShearAndIsTheAccelerationOfSteadyExtension)
{
  const Gradient shear = gradient(SHEAR, 3, 0.7, 0.0, 0.1);
  const Gradient still = change(shear, shear, 0.1);
  EXPECT_EQ(still.xx, 0.0);
  EXPECT_EQ(still.yy, 0.0);
  EXPECT_EQ(still.zz, 0.0);
  EXPECT_NEAR(still.xy, 0.0, 1e-16);
  // in a flow u = G x a particle accelerates by G^2 x
  const double dt = 1e-6;
  const Gradient planar = gradient(PLANAR, 3, 0.7, 0.0, dt);
  const Gradient k = change(planar, planar, dt);
  EXPECT_NEAR(k.xx / dt, 0.49, 1e-5);
  EXPECT_NEAR(k.yy / dt, 0.49, 1e-5);
  EXPECT_EQ(k.zz, 0.0);
}

TEST(Volume, StaysExactlyInAHundredThousandStepsOfAnyFlow)
{
  for (const Case &c : CASES) {
    SCOPED_TRACE(c.name);
    Cell h{3.0, 4.0, 5.0, 0.0};
    const double dt = 1e-3;
    Random rnd(3);
    Wander walk;
    double strain = 0.0;
    for (int n = 0; n < 100000; n++) {
      const double rate = walk.next(rnd) - 0.1 * strain;    // the cell stays of its size
      strain += rate * dt;
      h = moved(h, gradient(c.flow, c.dimension, rate, 0.0, dt), dt);
    }
    EXPECT_NEAR(volume(h) / 60.0, 1.0, 1e-11);
    // and each edge follows its own exponential
    const double half = c.flow == UNIAXIAL ? 0.5 : 1.0;
    const double ex = c.flow == SHEAR ? 1.0 : std::exp(strain);
    const double ey = c.flow == SHEAR ? 1.0 : std::exp(-half * strain);
    EXPECT_NEAR(h.lx / (3.0 * ex), 1.0, 1e-11);
    EXPECT_NEAR(h.ly / (4.0 * ey), 1.0, 1e-11);
    EXPECT_NEAR(h.xy, c.flow == SHEAR ? 4.0 * strain : 0.0, 1e-10);
  }
}

TEST(Volume, FollowsTheExponentialOfTheDilation)
{
  for (const Case &c : CASES) {
    SCOPED_TRACE(c.name);
    for (const double dilation : {1e-3, -0.02, 0.05}) {
      Cell h{3.0, 4.0, 5.0, 0.0};
      const double dt = 1e-3;
      const Gradient g = gradient(c.flow, c.dimension, 0.03, dilation, dt);
      for (int n = 0; n < 100000; n++) h = moved(h, g, dt);
      EXPECT_NEAR(volume(h) / (60.0 * std::exp(100.0 * dilation)), 1.0, 1e-10);
    }
  }
}

TEST(Gradient, DilationActsAlongTheGradientInShearAndEvenlyInExtension)
{
  const double dt = 1e-9;
  const Gradient shear = gradient(SHEAR, 3, 0.0, 0.6, dt);
  EXPECT_EQ(shear.xx, 0.0);
  EXPECT_NEAR(shear.yy, 0.6, 1e-6);
  EXPECT_EQ(shear.zz, 0.0);
  for (const Flow flow : {PLANAR, UNIAXIAL}) {
    const Gradient g = gradient(flow, 3, 0.0, 0.6, dt);
    EXPECT_NEAR(g.xx, 0.2, 1e-6);
    EXPECT_NEAR(g.yy, 0.2, 1e-6);
    EXPECT_NEAR(g.zz, 0.2, 1e-6);
  }
  const Gradient flat = gradient(PLANAR, 2, 0.0, 0.6, dt);
  EXPECT_NEAR(flat.xx, 0.3, 1e-6);
  EXPECT_NEAR(flat.yy, 0.3, 1e-6);
}

TEST(Gradient, LeavesTheThirdDirectionOfTwoDimensionsAlone)
{
  Random rnd(4);
  for (const Flow flow : {SHEAR, PLANAR}) {
    Cell h{3.0, 4.0, 0.37, 0.0};
    for (int n = 0; n < 1000; n++) {
      const Gradient g = gradient(flow, 2, rnd.uniform(-1.0, 1.0), rnd.uniform(-1.0, 1.0), 1e-2);
      EXPECT_EQ(g.zz, 0.0);
      h = moved(h, g, 1e-2);
    }
    EXPECT_EQ(h.lz, 0.37);
  }
}

TEST(Particle, KeepsItsPlaceInTheCellUnderAnyHistoryOfRatesDilationsAndFlips)
{
  Random rnd(5);
  int flipped = 0;
  for (const Case &c : CASES) {
    for (const double dt : {1e-2, 3e-4}) {
      SCOPED_TRACE(c.name);
      Motion run({8.0, 9.0, 7.0, 0.0}, {0.3, 0.9, 0.7}, dt);
      Wander rates, dilations;
      double strain = 0.0, expansion = 0.0;
      for (int n = 0; n < 5000; n++) {
        const double rate =
            (c.flow == SHEAR ? 10.0 : 1.0) * rates.next(rnd) - (c.flow == SHEAR ? 0.0 : strain);
        const double dilation = 2.0 * dilations.next(rnd) - 2.0 * expansion;
        strain += rate * dt;
        expansion += dilation * dt;
        const Gradient g = gradient(c.flow, c.dimension, rate, dilation, dt);
        if (n == 0)
          run.change_flow(g, 0.0);
        else
          run.step(g);
        if (n % 50 == 0) run.expect_affine(1e-10);
      }
      run.expect_affine(1e-10);
      flipped += run.flipped;
    }
  }
  EXPECT_GT(flipped, 20);    // the draws do flip
}

TEST(Particle, FollowsSumsAndExponentialsOfTheHistoryInShear)
{
  // the other oracle: y of the particle is y0 exp(sum of dilation dt), x grows by rate*y*dt
  Random rnd(6);
  Motion run({8.0, 9.0, 7.0, 0.0}, {0.2, 0.4, 0.6}, 1e-3);
  Wander rates, dilations;
  long double x = 1.6L, y = 3.6L, expansion = 0.0L;
  for (int n = 0; n < 20000; n++) {
    const double rate = 5.0 * rates.next(rnd), dilation = dilations.next(rnd);
    const Gradient g = gradient(SHEAR, 3, rate, dilation, run.dt);
    if (n == 0)
      run.change_flow(g, 0.0);
    else
      run.step(g);
    if (n == 19999) break;
    y = 3.6L * std::exp(expansion);
    x += rate * y * 1e-3L;
    expansion += dilation * 1e-3L;
  }
  y = 3.6L * std::exp(expansion);
  EXPECT_NEAR(run.x.x, static_cast<double>(x), 1e-10);
  EXPECT_NEAR(run.x.y, static_cast<double>(y), 1e-10);
  EXPECT_EQ(run.x.z, 0.6 * 7.0);
}

TEST(Particle, KeepsItsOwnVelocityThroughSteadyShear)
{
  // a particle that does not take part is not touched either
  const Gradient g = gradient(SHEAR, 3, 0.7, 0.0, 1e-2);
  Motion run({8.0, 9.0, 7.0, 0.0}, {0.2, 0.4, 0.6}, 1e-2);
  run.change_flow(g, 0.0);
  run.v = run.v + Vec3{0.1, -0.2, 0.3};
  const Vec3 v = run.v;
  for (int n = 0; n < 100; n++) run.step(g);
  expect_near(run.v, v, 1e-14);
}

TEST(Flips, KeepTheLatticeAndTheTiltWithinHalfAnEdge)
{
  Random rnd(7);
  Cell h{4.0, 6.0, 5.0, 0.0};
  double tilt = 0.0;    // never flipped
  int flipped = 0;
  for (int n = 0; n < 100000; n++) {
    const double more = rnd.uniform(-0.3, 0.31);
    h.xy += more;
    tilt += more;
    const int number = flips(h);
    EXPECT_EQ(number == 0, std::fabs(h.xy) <= 2.0);
    h.xy += number * h.lx;
    EXPECT_LE(std::fabs(h.xy), 2.0);
    flipped += number;
    // the second edge differs from the unflipped one by whole first edges
    ASSERT_NEAR(h.xy - flipped * h.lx, tilt, 1e-8);
  }
  EXPECT_LT(flipped, -10);    // the walk drifts to the right
}

TEST(Stress, OfAFluidAtRestIsThePressureAndDrivesNothing)
{
  for (const Case &c : CASES) {
    SCOPED_TRACE(c.name);
    const Stress s{-2.5, -2.5, c.dimension == 3 ? -2.5 : 77.0, 0.0};
    EXPECT_EQ(pressure(c.flow, c.dimension, s), 2.5);
    EXPECT_EQ(driving_stress(c.flow, s), 0.0);
  }
}

TEST(Stress, PressureOfShearIsTheNormalStressAlongTheGradient)
{
  EXPECT_EQ(pressure(SHEAR, 3, {1.0, -2.0, 3.0, 4.0}), 2.0);
  EXPECT_EQ(pressure(PLANAR, 3, {1.0, -2.0, -5.0, 4.0}), 2.0);
  EXPECT_EQ(pressure(PLANAR, 2, {1.0, -2.0, -5.0, 4.0}), 0.5);
  EXPECT_EQ(pressure(UNIAXIAL, 3, {1.0, -2.0, -5.0, 4.0}), 2.0);
  EXPECT_EQ(driving_stress(SHEAR, {1.0, -2.0, -5.0, 4.0}), 4.0);
  EXPECT_EQ(driving_stress(PLANAR, {1.0, -2.0, -5.0, 4.0}), 3.0);
  EXPECT_EQ(driving_stress(UNIAXIAL, {1.0, -2.0, -5.0, 4.0}), 4.5);
}

TEST(Stress, TimesTheRatesIsThePowerOfTheFlow)
{
  Random rnd(8);
  for (const Case &c : CASES) {
    SCOPED_TRACE(c.name);
    for (int trial = 0; trial < 100; trial++) {
      const Stress s{rnd.uniform(-3.0, 3.0), rnd.uniform(-3.0, 3.0),
                     c.dimension == 3 ? rnd.uniform(-3.0, 3.0) : 0.0, rnd.uniform(-3.0, 3.0)};
      const double rate = rnd.uniform(-1.0, 1.0), dilation = rnd.uniform(-1.0, 1.0);
      const Gradient g = gradient(c.flow, c.dimension, rate, dilation, 1e-10);
      EXPECT_NEAR(s.xx * g.xx + s.yy * g.yy + s.zz * g.zz + s.xy * g.xy,
                  driving_stress(c.flow, s) * rate - pressure(c.flow, c.dimension, s) * dilation,
                  1e-8);
    }
  }
}

TEST(TroutonRatio, IsThatOfTheStressOfANewtonianFluid)
{
  const double eta = 1.7, rate = 0.3;
  for (const Case &c : CASES) {
    SCOPED_TRACE(c.name);
    const Gradient g = gradient(c.flow, c.dimension, rate, 0.0, 1e-10);
    // eta (G + G^T), and any pressure
    const double p = 5.0;
    const Stress s{2.0 * eta * g.xx - p, 2.0 * eta * g.yy - p, 2.0 * eta * g.zz - p, eta * g.xy};
    EXPECT_NEAR(driving_stress(c.flow, s) / (eta * rate), trouton_ratio(c.flow), 1e-8);
  }
}

TEST(OscillationRate, SumsToTheStrainWhateverTheSteps)
{
  Random rnd(9);
  for (const double w : {0.0, 1e-9, 0.3, 7.0, 200.0}) {
    const double g0 = 0.4, g1 = -1.3;
    double t = 0.0, strain = 0.0;
    for (int n = 0; n < 10000; n++) {
      const double dt = rnd.log_uniform(1e-5, 0.1);    // longer than a period of the fastest
      strain += oscillation_rate(g0, g1, w, t, dt) * dt;
      t += dt;
    }
    const double swing = w == 0.0 ? t : std::sin(w * t) / w;
    EXPECT_NEAR(strain, g0 * t + g1 * swing, 1e-10) << "w " << w;
  }
}

TEST(OscillationRate, IsTheCosineForShortSteps)
{
  EXPECT_NEAR(oscillation_rate(0.4, 1.3, 2.0, 0.7, 1e-7), 0.4 + 1.3 * std::cos(1.4), 1e-6);
  EXPECT_DOUBLE_EQ(oscillation_rate(0.4, 1.3, 0.0, 0.7, 0.1), 1.7);
}
