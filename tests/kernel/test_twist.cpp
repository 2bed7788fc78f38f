// Shows that twisting is a scalar Maxwell element with the film's steady torque.

#include "lubcontact_film.h"
#include "lubcontact_twist.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Twist, WithRigidFilmIsASpring)
{
  EXPECT_NEAR(next_twist(0.25, -0.75, 1.0, 1e-30), -0.5, 1e-16);
}

TEST(Twist, WithoutFilmForgetsEverything)
{
  EXPECT_EQ(next_twist(0.25, -0.75, 0.0, 1.0), 0.0);
}

TEST(Twist, TwoRelaxationTimesAgreeWithTheClosedForm)
{
  // x = 2: 1/(1 + x + x^2/2) = 0.2 of the old, 0.4 of the new
  EXPECT_NEAR(next_twist(3.0, 4.0, 0.5, 1.0), 2.2, 1e-15);
}

TEST(Twist, SteadyTorqueIsTheFilmsForAnyStep)
{
  const Film f = make_film(0.8, 2.0, Range::CUT, 0.6);
  const double a = 1.3, kr = 50.0, rate = -0.2, u = 0.05;
  // pi eta a^3 u ln(1/u), written out
  const double resistance = 3.141592653589793 * 0.8 * 2.197 * 0.05 * 2.995732273553991;
  EXPECT_NEAR(twist_resistance(f, a, u, std::log(u)), resistance, 1e-12);
  for (const double dt : {1e-3, 0.1, 10.0}) {
    double q = 0.0;
    for (int n = 0; n < 30 || n * dt * kr < 60.0 * resistance; n++)
      q = next_twist(q, rate * dt, twist_resistance(f, a, u, std::log(u)), kr * dt);
    EXPECT_NEAR(kr * q, resistance * rate, 1e-10 * resistance) << "dt = " << dt;
  }
}

TEST(Twist, IsOddAndNeverLargerThanItsInputs)
{
  Random rnd(1);
  for (int trial = 0; trial < 2000; trial++) {
    const double q0 = rnd.uniform(-1.0, 1.0), twist = rnd.uniform(-1.0, 1.0);
    const double x = rnd.log_uniform(1e-10, 1e10);
    EXPECT_EQ(next_twist(-q0, -twist, 1.0, x), -next_twist(q0, twist, 1.0, x));
    EXPECT_LE(std::fabs(next_twist(q0, twist, 1.0, x)), std::fabs(q0) + std::fabs(twist));
  }
}
