// Shows that rolling is a Maxwell element in the tangent plane, with the film's steady torque.

#include "lubcontact_film.h"
#include "lubcontact_roll.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Roll, WithRigidFilmIsASpring)
{
  expect_near(next_roll({0.1, -0.2, 0.3}, {0.01, 0.02, -0.03}, 1.0, 1e-30), {0.11, -0.18, 0.27},
              1e-16);
}

TEST(Roll, WithoutFilmForgetsEverything)
{
  expect_same(next_roll({0.1, -0.2, 0.3}, {0.01, 0.02, -0.03}, 0.0, 1.0), {});
}

TEST(Roll, TwoRelaxationTimesAgreeWithTheClosedForm)
{
  // x = 2: 1/(1 + x + x^2/2) = 0.2 of the old, 0.4 of the new
  expect_near(next_roll({2.0, 0.0, 0.0}, {0.0, 3.0, 0.0}, 0.5, 1.0), {0.4, 1.2, 0.0}, 1e-15);
}

TEST(Roll, StaysInThePlaneOfItsInputs)
{
  Random rnd(1);
  for (int trial = 0; trial < 1000; trial++) {
    const Vec3 n = rnd.unit();
    const Vec3 q0 = tangential(rnd.vector(1.0), n), roll = tangential(rnd.vector(1.0), n);
    EXPECT_NEAR(dot(next_roll(q0, roll, 1.0, rnd.log_uniform(1e-8, 1e8)), n), 0.0, 1e-15);
  }
}

TEST(Roll, SteadyTorqueIsTheFilmsForAnyStep)
{
  const Film f = make_film(0.8, 2.0, Range::CUT, 0.6);
  const double a = 1.3, kr = 50.0, rate = 0.2;
  const double u = 1e-3, resistance = roll_resistance(f, a, u, std::log(u));
  for (const double dt : {1e-3, 0.1, 10.0}) {
    Vec3 q{};
    for (int n = 0; n < 30 || n * dt * kr < 60.0 * resistance; n++)
      q = next_roll(q, {rate * dt, 0.0, 0.0}, resistance, kr * dt);
    EXPECT_NEAR(kr * q.x, resistance * rate, 1e-10 * resistance * rate) << "dt = " << dt;
  }
}

TEST(Roll, IsOddAndNeverLongerThanItsInputs)
{
  Random rnd(2);
  for (int trial = 0; trial < 2000; trial++) {
    const Vec3 q0 = rnd.vector(1.0), roll = rnd.vector(1.0);
    const double x = rnd.log_uniform(1e-10, 1e10);
    const Vec3 q1 = next_roll(q0, roll, 1.0, x);
    expect_same(next_roll(-1.0 * q0, -1.0 * roll, 1.0, x), -1.0 * q1);
    EXPECT_LE(norm(q1), norm(q0) + norm(roll));
  }
}
