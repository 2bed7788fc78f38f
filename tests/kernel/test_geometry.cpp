// Shows the signs of a pair, and that its relative motion does not see rigid motions.

#include "lubcontact_geometry.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

struct Spheres {
  Body i, j;
  double dt, r_old;
  PairGeometry g;

  PairMotion motion() const { return pair_motion(g, i, j, r_old, dt); }
};

Spheres step(const Vec3 &xi, const Vec3 &xj, const Vec3 &vi, const Vec3 &vj, const Vec3 &wi,
             const Vec3 &wj, double ri, double rj, double dt)
{
  Spheres s{{xi, vi, wi, ri}, {xj, vj, wj, rj}, dt, 0.0, {}};
  s.g = pair_geometry(xi, xj, ri, rj, 0.5 * (ri + rj));
  s.r_old = norm(xi - xj - dt * (vi - vj));
  return s;
}

// Two spheres fixed to a solid that turned by `angle` about the line `axis` through `centre`.
Spheres rigid_rotation(const Vec3 &xi, const Vec3 &xj, const Vec3 &centre, const Vec3 &axis,
                       double angle, double ri, double rj, double dt)
{
  const Vec3 yi = centre + rotated(xi - centre, axis, angle);
  const Vec3 yj = centre + rotated(xj - centre, axis, angle);
  const Vec3 omega = (angle / dt) * axis;
  return step(yi, yj, (1.0 / dt) * (yi - xi), (1.0 / dt) * (yj - xj), omega, omega, ri, rj, dt);
}

}    // namespace

TEST(EffectiveRadius, OfEqualSpheresIsTheirRadius)
{
  EXPECT_EQ(effective_radius(Radius::MEAN, 1.5, 1.5), 1.5);
  EXPECT_EQ(effective_radius(Radius::HARMONIC, 1.5, 1.5), 1.5);
}

TEST(EffectiveRadius, OfOneAndThreeIsTwoOrOneAndAHalf)
{
  EXPECT_EQ(effective_radius(Radius::MEAN, 1.0, 3.0), 2.0);
  EXPECT_EQ(effective_radius(Radius::HARMONIC, 1.0, 3.0), 1.5);
}

TEST(EffectiveRadius, AgainstAPlaneIsTwiceTheRadius)
{
  EXPECT_NEAR(effective_radius(Radius::HARMONIC, 0.7, 1e12), 1.4, 1e-11);
}

TEST(PairGeometry, AgreesWithHandComputedValues)
{
  const PairGeometry g = pair_geometry({3.0, 4.0, 1.0}, {0.0, 0.0, 1.0}, 1.0, 3.5, 2.0);
  expect_near(g.n, {0.6, 0.8, 0.0}, 1e-15);    // from j to i
  EXPECT_NEAR(g.r, 5.0, 1e-15);
  EXPECT_NEAR(g.un, 0.5, 1e-15);
  EXPECT_NEAR(g.un_a, 0.25, 1e-15);
  EXPECT_EQ(g.a, 2.0);
  EXPECT_NEAR(g.arm_i, 1.25, 1e-15);
  EXPECT_NEAR(g.arm_j, 3.75, 1e-15);
}

TEST(PairGeometry, ArmsAddUpToTheDistanceAlsoInOverlap)
{
  Random rnd(1);
  for (int trial = 0; trial < 1000; trial++) {
    const PairGeometry g = pair_geometry(rnd.vector(2.0), rnd.vector(2.0), rnd.uniform(0.1, 3.0),
                                         rnd.uniform(0.1, 3.0), 1.0);
    EXPECT_NEAR(g.arm_i + g.arm_j, g.r, 1e-14);
    EXPECT_NEAR(norm(g.n), 1.0, 1e-15);
  }
}

TEST(PairMotion, SlidingOfIPastJIsThePositiveSlip)
{
  const double dt = 1e-5;
  const Spheres s = step({2.1, 0, 0}, {0, 0, 0}, {0, 3.0, 0}, {0, 1.0, 0}, {}, {}, 1.0, 1.0, dt);
  expect_near((1.0 / dt) * s.motion().slip, {0.0, 2.0, 0.0}, 1e-4);
}

TEST(PairMotion, OpeningIsNoSlip)
{
  const Spheres s = step({2.1, 0, 0}, {0, 0, 0}, {5.0, 0, 0}, {-1.0, 0, 0}, {}, {}, 1.0, 1.0, 0.01);
  expect_near(s.motion().slip, {}, 1e-17);
  expect_near(s.motion().turn, {}, 1e-17);
}

TEST(PairMotion, SpinsMoveTheSurfacesByTheirArms)
{
  // the contact is at -arm_i n of i and at +arm_j n of j: slip = -(arm_i w_i + arm_j w_j) x n
  const double dt = 1e-6;
  const Spheres i = step({3.2, 0, 0}, {0, 0, 0}, {}, {}, {0, 0, 1.0}, {}, 1.0, 2.0, dt);
  expect_near((1.0 / dt) * i.motion().slip, {0.0, -1.1, 0.0}, 1e-5);
  const Spheres j = step({3.2, 0, 0}, {0, 0, 0}, {}, {}, {}, {0, 0, 1.0}, 1.0, 2.0, dt);
  expect_near((1.0 / dt) * j.motion().slip, {0.0, -2.1, 0.0}, 1e-5);
}

TEST(PairMotion, SplitsTheRelativeRotationIntoRollAndTwist)
{
  const double dt = 1e-6;
  const Spheres s =
      step({2.1, 0, 0}, {0, 0, 0}, {}, {}, {3.0, 2.0, -4.0}, {1.0, 0.5, 1.0}, 1.0, 1.0, dt);
  EXPECT_NEAR(s.motion().twist / dt, 2.0, 1e-9);
  expect_near((1.0 / dt) * s.motion().roll, {0.0, 1.5, -5.0}, 1e-5);
}

TEST(PairMotion, RollingWithoutSlidingHasRollButNoSlip)
{
  // opposite spins of equal spheres, like gears
  const Spheres s = step({2.1, 0, 0}, {0, 0, 0}, {}, {}, {0, 0, 1.0}, {0, 0, -1.0}, 1.0, 1.0, 0.01);
  expect_near(s.motion().slip, {}, 1e-17);
  expect_near(s.motion().roll, {0.0, 0.0, 0.02}, 1e-17);
}

TEST(PairMotion, TranslationTogetherIsNothing)
{
  Random rnd(2);
  const Vec3 v = rnd.vector(10.0);
  const PairMotion m = step({1, 2, 3}, {0, 1, 2}, v, v, {}, {}, 1.0, 0.5, 0.1).motion();
  expect_same(m.slip, {});
  expect_same(m.roll, {});
  expect_same(m.turn, {});
  EXPECT_EQ(m.twist, 0.0);
}

TEST(PairMotion, RigidRotationIsNeitherSlipNorRollNorTwist)
{
  Random rnd(3);
  for (int trial = 0; trial < 5000; trial++) {
    const double ri = rnd.uniform(0.3, 3.0), rj = rnd.uniform(0.3, 3.0);
    const Vec3 xj = rnd.vector(3.0), xi = xj + (ri + rj + rnd.uniform(-0.05, 0.3)) * rnd.unit();
    const Vec3 centre = rnd.vector(3.0), axis = rnd.unit();
    // small enough for the third order of the angle to vanish, velocities of order one
    const Spheres s = rigid_rotation(xi, xj, centre, axis, 1e-6, ri, rj, 1e-6);
    EXPECT_NEAR(norm(s.motion().slip) / s.dt, 0.0, 1e-8);
    EXPECT_EQ(norm(s.motion().roll), 0.0);
    EXPECT_EQ(s.motion().twist, 0.0);
  }
}

TEST(PairMotion, SlipOfAFiniteRotationIsOfThirdOrderInTheAngle)
{
  Random rnd(4);
  for (int trial = 0; trial < 1000; trial++) {
    const double ri = 1.0, rj = rnd.uniform(0.3, 3.0);
    const Vec3 xj = rnd.vector(3.0), xi = xj + (ri + rj + 0.1) * rnd.unit();
    const Vec3 centre = rnd.vector(3.0), axis = rnd.unit();
    for (const double angle : {0.1, 0.05, 0.025}) {
      const Spheres s = rigid_rotation(xi, xj, centre, axis, angle, ri, rj, 1.0);
      EXPECT_LE(norm(s.motion().slip), s.g.r * angle * angle * angle / 6.0);
    }
  }
}

TEST(PairMotion, IsOddOrEvenUnderExchangeBitForBit)
{
  Random rnd(5);
  for (int trial = 0; trial < 5000; trial++) {
    const double ri = rnd.uniform(0.3, 3.0), rj = rnd.uniform(0.3, 3.0), dt = 0.01;
    const Vec3 xj = rnd.vector(3.0), xi = xj + (ri + rj + rnd.uniform(-0.05, 0.3)) * rnd.unit();
    const Vec3 vi = rnd.vector(5.0), vj = rnd.vector(5.0);
    const Vec3 wi = rnd.vector(5.0), wj = rnd.vector(5.0);
    const Spheres ij = step(xi, xj, vi, vj, wi, wj, ri, rj, dt);
    const Spheres ji = step(xj, xi, vj, vi, wj, wi, rj, ri, dt);
    EXPECT_EQ(ij.g.r, ji.g.r);
    EXPECT_EQ(ij.g.un, ji.g.un);
    expect_same(ij.g.n, -1.0 * ji.g.n);
    EXPECT_EQ(ij.g.arm_i, ji.g.arm_j);
    const PairMotion a = ij.motion(), b = ji.motion();
    expect_same(a.slip, -1.0 * b.slip);
    expect_same(a.roll, -1.0 * b.roll);
    EXPECT_EQ(a.twist, b.twist);
    expect_same(a.turn, b.turn);
  }
}

TEST(PairMotion, SlipAndRollLieInTheTangentPlane)
{
  Random rnd(6);
  for (int trial = 0; trial < 2000; trial++) {
    const Vec3 xj = rnd.vector(3.0), xi = xj + 2.1 * rnd.unit();
    const Spheres s = step(xi, xj, rnd.vector(5.0), rnd.vector(5.0), rnd.vector(5.0),
                           rnd.vector(5.0), 1.2, 0.8, 0.02);
    EXPECT_NEAR(dot(s.motion().slip, s.g.n), 0.0, 1e-15);
    EXPECT_NEAR(dot(s.motion().roll, s.g.n), 0.0, 1e-15);
  }
}

TEST(Turn, CarriesTheOldTangentPlaneIntoTheNewOne)
{
  Random rnd(7);
  for (int trial = 0; trial < 2000; trial++) {
    const Vec3 xj = rnd.vector(3.0), xi = xj + 2.1 * rnd.unit();
    const Spheres s = step(xi, xj, rnd.vector(5.0), rnd.vector(5.0), rnd.vector(5.0),
                           rnd.vector(5.0), 1.2, 0.8, 0.05);
    const Vec3 d0 = xi - xj - s.dt * (s.i.v - s.j.v);
    expect_near(turned((1.0 / norm(d0)) * d0, s.motion().turn), s.g.n, 1e-14);
  }
}

TEST(Turn, TumblingPairCarriesItsHistoryExactly)
{
  // axis perpendicular to n: no spin about n, steps of any size
  Random rnd(8);
  for (const double angle : {0.01, 0.3, 1.5}) {
    const Vec3 n = rnd.unit();
    Vec3 axis = tangential(rnd.unit(), n);
    axis = (1.0 / norm(axis)) * axis;
    const Vec3 q0 = tangential(rnd.vector(1.0), n), centre = rnd.vector(1.0);
    Vec3 xi = 1.3 * n, xj = -0.8 * n, q = q0;
    for (int m = 1; m <= 1000; m++) {
      const Spheres s = rigid_rotation(xi, xj, centre, axis, angle, 1.2, 0.8, 0.1);
      q = turned(q, s.motion().turn);
      xi = s.i.x;
      xj = s.j.x;
      if (m % 100 == 0) expect_near(q, rotated(q0, axis, m * angle), 1e-11);
    }
  }
}

TEST(Turn, AnyRigidRotationCarriesTheHistoryToSecondOrder)
{
  Random rnd(9);
  for (int trial = 0; trial < 20; trial++) {
    const Vec3 n = rnd.unit(), axis = rnd.unit(), centre = rnd.vector(1.0);
    const Vec3 q0 = tangential(rnd.unit(), n);
    double error[2];
    for (int fine = 0; fine < 2; fine++) {
      const int steps = fine ? 400 : 200;
      const double angle = 6.0 / steps;    // nearly a full turn
      Vec3 xi = 1.3 * n, xj = -0.8 * n, q = q0;
      for (int m = 0; m < steps; m++) {
        const Spheres s = rigid_rotation(xi, xj, centre, axis, angle, 1.2, 0.8, 0.1);
        q = turned(q, s.motion().turn);
        xi = s.i.x;
        xj = s.j.x;
      }
      error[fine] = norm(q - rotated(q0, axis, 6.0));
    }
    EXPECT_LT(error[1], 6.0 * (6.0 / 400) * (6.0 / 400) / 8.0 * norm(q0));
    if (error[0] > 1e-10) { EXPECT_NEAR(error[0] / error[1], 4.0, 0.1); }
  }
}

TEST(PairMotion, SumsToTheRateEquationsToSecondOrder)
{
  // oracle: dq/dt = W x q + slip rate, W = n x n' + (w_i + w_j).n/2 n, by Runge-Kutta
  Random rnd(10);
  const double ri = 1.3, rj = 0.7;
  const WaveVector direction(rnd, 0.8), wi(rnd, 2.0), wj(rnd, 2.0), drift(rnd, 1.0);
  const Wave gap(rnd, 0.1);
  auto centre = [&](double t) {
    return drift(t);
  };
  auto arm = [&](double t) {
    const Vec3 d = Vec3{1.0, 0.3, -0.2} + direction(t);
    return ((ri + rj + 0.1 + gap(t)) / norm(d)) * d;
  };

  struct Sum {
    Vec3 shear, roll;
    double twist;
  };
  auto rate = [&](double t, const Sum &q) {
    const double e = 1e-5;    // fourth-order difference for the velocity
    const Vec3 d = arm(t);
    const Vec3 v = (1.0 / (12.0 * e)) *
        (arm(t - 2.0 * e) - arm(t + 2.0 * e) + 8.0 * (arm(t + e) - arm(t - e)));
    const double r = norm(d);
    const Vec3 n = (1.0 / r) * d;
    const double un = r - ri - rj;
    const Vec3 vt = v - dot(v, n) * n, w = wi(t) - wj(t);
    const Vec3 slip = vt - cross((ri + un / 2) * wi(t) + (rj + un / 2) * wj(t), n);
    const Vec3 W = (1.0 / r) * cross(n, vt) + (0.5 * dot(wi(t) + wj(t), n)) * n;
    return Sum{cross(W, q.shear) + slip, cross(W, q.roll) + (w - dot(w, n) * n), dot(w, n)};
  };
  auto plus = [](const Sum &q, double h, const Sum &f) {
    return Sum{q.shear + h * f.shear, q.roll + h * f.roll, q.twist + h * f.twist};
  };
  const double end = 3.0;
  Sum exact{};
  const int fine = 2000;
  for (int m = 0; m < fine; m++) {
    const double h = end / fine, t = m * h;
    const Sum a = rate(t, exact), b = rate(t + h / 2, plus(exact, h / 2, a));
    const Sum c = rate(t + h / 2, plus(exact, h / 2, b)), d = rate(t + h, plus(exact, h, c));
    exact = plus(plus(plus(plus(exact, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  }

  double old_error[3] = {0.0, 0.0, 0.0};
  for (const int steps : {200, 400, 800}) {
    const double dt = end / steps;
    Sum q{};
    for (int m = 0; m < steps; m++) {
      const double t0 = m * dt, t1 = t0 + dt, tm = t0 + dt / 2;
      const Vec3 vj = (1.0 / dt) * (centre(t1) - centre(t0));
      const Vec3 v = (1.0 / dt) * (arm(t1) - arm(t0));
      const PairMotion p =
          step(centre(t1) + arm(t1), centre(t1), vj + v, vj, wi(tm), wj(tm), ri, rj, dt).motion();
      q = {turned(q.shear, p.turn) + p.slip, turned(q.roll, p.turn) + p.roll, q.twist + p.twist};
    }
    const double error[3] = {norm(q.shear - exact.shear), norm(q.roll - exact.roll),
                             std::fabs(q.twist - exact.twist)};
    for (int m = 0; m < 3; m++) {
      if (steps > 200) { EXPECT_NEAR(std::log2(old_error[m] / error[m]), 2.0, 0.3) << m; }
      old_error[m] = error[m];
    }
  }
  EXPECT_LT(old_error[0], 1e-4);
  EXPECT_LT(old_error[1], 1e-4);
  EXPECT_LT(old_error[2], 1e-4);
}
