// Shows the three tangential regimes: Maxwell film, sticking contact, slipping contact with film.

#include "lubcontact_shear.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

// x = kt dt/nu_t; infinity: no film, zero: a rigid one
Vec3 next(const Vec3 &q0, const Vec3 &slip, double cone, double x)
{
  if (x == HUGE_VAL) return next_shear(q0, slip, cone, cone, 0.0, 1.0);
  return next_shear(q0, slip, cone, cone, 0.7, 0.7 * std::fmax(x, 1e-30));
}

// dq/dt = v - (q - cone q/|q|) x outside the cone, v inside it, over unit time, by small steps of
// second order.
Vec3 integrated(Vec3 q, const Vec3 &slip, double cone, double x, int steps)
{
  auto rate = [&](const Vec3 &p) {
    const double size = norm(p);
    return size > cone ? slip - (x * (1.0 - cone / size)) * p : slip;
  };
  const double h = 1.0 / steps;
  for (int n = 0; n < steps; n++) {
    const Vec3 middle = q + (0.5 * h) * rate(q);
    q = q + h * rate(middle);
  }
  return q;
}

}    // namespace

TEST(Shear, WithoutContactIsTheMaxwellElement)
{
  // x = 2: 1/(1 + x + x^2/2) = 0.2 of the old, 0.4 of the new
  expect_near(next({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.0, 2.0), {0.2, 0.4, 0.0}, 1e-15);
}

TEST(Shear, WithoutContactAndFilmThereIsNoForce)
{
  expect_same(next({1.0, 2.0, 0.0}, {0.3, 0.0, 0.0}, 0.0, HUGE_VAL), {});
}

TEST(Shear, StickingContactIsASpringHoweverThinTheFilm)
{
  for (const double x : {0.0, 1.0, 1e8, HUGE_VAL}) {
    expect_near(next({0.3, 0.1, 0.0}, {0.2, -0.1, 0.0}, 0.6, x), {0.5, 0.0, 0.0}, 1e-16);
  }
}

TEST(Shear, SlipWithoutFilmReturnsToTheCone)
{
  expect_near(next({0.0, 0.9, 0.0}, {0.0, 0.3, 0.0}, 1.0, HUGE_VAL), {0.0, 1.0, 0.0}, 1e-15);
  expect_near(next({0.0, 5.0, 0.0}, {0.0, 0.3, 0.0}, 1.0, HUGE_VAL), {0.0, 1.0, 0.0}, 1e-15);
}

TEST(Shear, SlipInARigidFilmIsASpring)
{
  expect_near(next({0.0, 0.9, 0.0}, {0.0, 0.3, 0.0}, 1.0, 0.0), {0.0, 1.2, 0.0}, 1e-15);
  expect_near(next({0.0, 1.5, 0.0}, {0.0, 0.3, 0.0}, 1.0, 0.0), {0.0, 1.8, 0.0}, 1e-15);
}

TEST(Shear, SlipAlongALineAgreesWithTheClosedForm)
{
  // outside the cone q - cone relaxes: 1 + 0.2*0.5 + 0.4*0.25 at x = 2
  expect_near(next({1.5, 0.0, 0.0}, {0.25, 0.0, 0.0}, 1.0, 2.0), {1.2, 0.0, 0.0}, 1e-15);
}

TEST(Shear, StickTurnsIntoSlipInsideTheStep)
{
  // from 0.8 the cone 1.0 is reached after 0.4 of a step of 0.5; then 0.6 of it with the film
  // 1 + 0.3 gain(0.6 x), gain(2) = 0.4
  expect_near(next({0.8, 0.0, 0.0}, {0.5, 0.0, 0.0}, 1.0, 2.0 / 0.6), {1.12, 0.0, 0.0}, 1e-15);
}

TEST(Shear, SlipUnderAChangingLoadConvergesToSecondOrder)
{
  // cone a + b t, unit speed, slipping from the start or from where q = t meets the cone: what is
  // beyond it follows e' = 1 - b - x e
  for (const double start : {0.0, 0.2})
    for (const double b : {-0.15, 0.3, 0.8}) {
      const double a = 0.2, x = 6.0, begin = start == a ? 0.0 : (a - start) / (1.0 - b);
      const double exact = a + b - (1.0 - b) * std::expm1(-x * (1.0 - begin)) / x;
      double error[2];
      for (int fine = 0; fine < 2; fine++) {
        const int steps = fine ? 2000 : 1000;
        double q = start;
        for (int n = 0; n < steps; n++) {
          const double cone0 = a + b * n / steps, cone = a + b * (n + 1) / steps;
          q = next_shear({q, 0.0, 0.0}, {1.0 / steps, 0.0, 0.0}, cone0, cone, 0.7, 0.7 * x / steps)
                  .x;
        }
        error[fine] = std::fabs(q - exact);
      }
      EXPECT_LT(error[1], 1e-6) << start << " " << b;
      if (error[1] > 1e-9) { EXPECT_NEAR(error[0] / error[1], 4.0, 0.5) << start << " " << b; }
    }
}

TEST(Shear, ContactThatIsLostLeavesAFilm)
{
  const Vec3 left = next_shear({0.5, 0.0, 0.0}, {0.0, 0.1, 0.0}, 1.0, 0.0, 1.0, 2.0);
  expect_near(left, {0.2 * 0.5, 0.4 * 0.1, 0.0}, 1e-15);
}

TEST(Shear, StickThenSlipAlongALineConvergesToSecondOrder)
{
  // the closed form from 0 at unit speed: the cone is left at t = cone, the film then relaxes
  Random rnd(2);
  for (int trial = 0; trial < 40; trial++) {
    const double cone = rnd.uniform(0.1, 0.6), x = rnd.log_uniform(0.5, 20.0);
    const Vec3 e = rnd.unit();
    const double exact = cone - std::expm1(-x * (1.0 - cone)) / x;
    double error[2];
    for (int fine = 0; fine < 2; fine++) {
      const int steps = fine ? 2000 : 1000;
      Vec3 q{};
      for (int n = 0; n < steps; n++) q = next(q, (1.0 / steps) * e, cone, x / steps);
      error[fine] = norm(q - exact * e);
    }
    EXPECT_LT(error[1], 1e-5);
    if (error[1] > 1e-9) {    // where the corner falls in its step moves the error a little
      EXPECT_NEAR(error[0] / error[1], 4.0, 0.5);
    }
  }
}

TEST(Shear, FastFilmStickThenSlipIsAboutRightInOneStep)
{
  // share of the step spent slipping counts, not the whole step
  for (const double x : {1e-3, 0.1, 1.0, 10.0, 1e3}) {
    const double exact = 1.0 - std::expm1(-0.6 * x) / x * 0.5;
    const Vec3 q = next({0.8, 0.0, 0.0}, {0.5, 0.0, 0.0}, 1.0, x);
    EXPECT_NEAR(q.x, exact, 0.06 * (exact - 1.0)) << "x = " << x;
  }
}

TEST(Shear, SlipThatTurnsConvergesToTheRateEquation)
{
  Random rnd(3);
  for (int trial = 0; trial < 20; trial++) {
    const double cone = rnd.uniform(0.2, 1.0), x = rnd.uniform(0.1, 5.0);
    // outside the cone all the time: the corner of the stick regime is tested above
    const Vec3 q0 = 1.3 * cone * rnd.unit();
    Vec3 slip = 2.0 * rnd.unit();
    if (dot(slip, q0) < 0.0) slip = -1.0 * slip;
    const Vec3 exact = integrated(q0, slip, cone, x, 20000);
    double error[2];
    for (int fine = 0; fine < 2; fine++) {
      const int steps = fine ? 800 : 400;
      Vec3 q = q0;
      for (int n = 0; n < steps; n++) q = next(q, (1.0 / steps) * slip, cone, x / steps);
      error[fine] = norm(q - exact);
    }
    EXPECT_LT(error[1], 5e-3);
    EXPECT_NEAR(error[0] / error[1], 2.0, 0.3);    // the trial direction is of first order
  }
}

TEST(Shear, FrictionIsNeverBeyondTheCone)
{
  Random rnd(4);
  for (int trial = 0; trial < 100000; trial++) {
    const double cone = rnd.log_uniform(1e-6, 10.0);
    const double x = trial % 5 ? rnd.log_uniform(1e-12, 1e12) : HUGE_VAL;
    const Vec3 q0 = rnd.log_uniform(1e-6, 10.0) * rnd.unit();
    const Vec3 slip = rnd.log_uniform(1e-6, 10.0) * rnd.unit();
    const Vec3 q1 = next(q0, slip, cone, x);
    const ShearSplit s = shear_split(q1, cone, true);
    EXPECT_LE(s.contact * norm(q1), cone * (1.0 + 1e-12));
    EXPECT_GE(s.contact, 0.0);
    EXPECT_LE(s.contact, 1.0);
    // nor does the film pull inwards, against the motion of the contact
    if (norm(q0 + slip) > cone) { EXPECT_GE(norm(q1), cone * (1.0 - 1e-12)); }
    if (x == HUGE_VAL) { EXPECT_LE(norm(q1), cone * (1.0 + 1e-12)); }
  }
}

TEST(Shear, IsOddInItsVectors)
{
  Random rnd(5);
  for (int trial = 0; trial < 5000; trial++) {
    const Vec3 q0 = rnd.vector(1.0), slip = rnd.vector(1.0);
    const double cone = rnd.coin() ? rnd.uniform(0.0, 2.0) : 0.0, x = rnd.log_uniform(1e-9, 1e9);
    expect_same(next(-1.0 * q0, -1.0 * slip, cone, x), -1.0 * next(q0, slip, cone, x));
  }
}

TEST(Shear, SteadySlipAddsFilmAndFriction)
{
  // F = mu N + nu_t v: q = cone + slip/x in steps of any length
  for (const double x : {1e-3, 0.1, 10.0}) {
    Vec3 q{};
    for (int n = 0; n < 40000; n++) q = next(q, {0.3 * x, 0.0, 0.0}, 0.5, x);
    EXPECT_NEAR(q.x, 0.8, 1e-11);
  }
}

TEST(Shear, ContinuousWhereTheContactBeginsToSlipAndWhereItIsLost)
{
  const Vec3 slip{0.2, 0.0, 0.0};
  const Vec3 inside = next({0.8 - 1e-12, 0.0, 0.0}, slip, 1.0, 3.0);
  const Vec3 outside = next({0.8 + 1e-12, 0.0, 0.0}, slip, 1.0, 3.0);
  expect_near(inside, outside, 1e-11);
  expect_near(next({0.8, 0.1, 0.0}, slip, 1e-14, 3.0), next({0.8, 0.1, 0.0}, slip, 0.0, 3.0), 0.02);
  const Vec3 line{0.8, 0.0, 0.0};
  expect_near(next(line, slip, 1e-14, 3.0), next(line, slip, 0.0, 3.0), 1e-13);
}

TEST(ShearSplit, NamesTheStateAndTheShareOfFriction)
{
  EXPECT_EQ(shear_split({1.0, 0.0, 0.0}, 0.0, false).state, ContactState::NONE);
  EXPECT_EQ(shear_split({1.0, 0.0, 0.0}, 0.0, false).contact, 0.0);
  EXPECT_EQ(shear_split({0.0, 0.5, 0.0}, 1.0, true).state, ContactState::STICK);
  EXPECT_EQ(shear_split({0.0, 0.5, 0.0}, 1.0, true).contact, 1.0);
  EXPECT_EQ(shear_split({0.0, 4.0, 0.0}, 1.0, true).state, ContactState::SLIP);
  EXPECT_NEAR(shear_split({0.0, 4.0, 0.0}, 1.0, true).contact, 0.25, 1e-15);
  EXPECT_EQ(shear_split({}, 0.0, true).contact, 1.0);    // frictionless contact, no force
}

TEST(ShearSplit, SlipWithoutFilmIsCalledSlipDespiteRounding)
{
  Random rnd(6);
  for (int trial = 0; trial < 5000; trial++) {
    const double cone = rnd.log_uniform(1e-9, 1e3);
    const Vec3 q =
        next(rnd.uniform(0.0, 1.0) * cone * rnd.unit(), 3.0 * cone * rnd.unit(), cone, HUGE_VAL);
    EXPECT_EQ(shear_split(q, cone, true).state, ContactState::SLIP);
  }
}

TEST(ShearSplit, AMillionthOfAMillionthInsideTheConeIsSlip)
{
  for (const double cone : {1e-6, 1.0, 1e6}) {
    EXPECT_EQ(shear_split({0.0, cone * (1.0 - 2e-12), 0.0}, cone, true).state, ContactState::STICK);
    EXPECT_EQ(shear_split({0.0, cone * (1.0 - 5e-13), 0.0}, cone, true).state, ContactState::SLIP);
  }
}

TEST(Shear, AContactAtRestInsideOrOnItsConeKeepsItsDisplacement)
{
  // also without any displacement, and where no film takes part
  for (const double x : {0.0, 1.0, HUGE_VAL})
    for (const double size : {0.0, 1e-310, 0.5, 1.0})
      expect_same(next({size, 0.0, 0.0}, {}, 1.0, x), {size, 0.0, 0.0});
  expect_same(next_shear({}, {}, 0.0, 0.0, 1.0, 2.0), {});
}
