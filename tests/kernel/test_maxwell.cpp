// Shows that the Maxwell element is of second order and right in all limits of the film.

#include "lubcontact_maxwell.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Maxwell, OneRelaxationTimeKeepsTwoFifths)
{
  // 1/(1 + x + x^2/2) and (1 + x/2) times it, x = stiffness dt/resistance = 1
  const Relaxation f = relaxation(3.0, 3.0);
  EXPECT_NEAR(f.keep, 0.4, 1e-16);
  EXPECT_NEAR(f.gain, 0.6, 1e-16);
}

TEST(Maxwell, DependsOnTheRatioOfStiffnessAndResistanceOnly)
{
  Random rnd(1);
  for (int trial = 0; trial < 5000; trial++) {
    const double x = rnd.log_uniform(1e-9, 1e9), scale = rnd.log_uniform(1e-30, 1e30);
    const Relaxation a = relaxation(1.0, x), b = relaxation(scale, scale * x);
    EXPECT_NEAR(b.keep / a.keep, 1.0, 1e-14);
    EXPECT_NEAR(b.gain / a.gain, 1.0, 1e-14);
  }
}

TEST(Maxwell, WithoutFilmNothingIsKept)
{
  for (const double S : {1e-12, 1.0, 1e12}) {
    EXPECT_EQ(relaxation(0.0, S).keep, 0.0);
    EXPECT_EQ(relaxation(0.0, S).gain, 0.0);
  }
}

TEST(Maxwell, RigidFilmIsASpring)
{
  for (const double x : {1e-300, 1e-30, 1e-17}) {
    const Relaxation f = relaxation(2.0, 2.0 * x);
    EXPECT_EQ(f.keep, 1.0);
    EXPECT_EQ(f.gain, 1.0);
  }
}

TEST(Maxwell, ErrorOfAStepIsOfThirdOrder)
{
  // against exp(-x) and (1 - exp(-x))/x: x^3/6 and x^2/6 at most
  for (const double x : {0.3, 0.1, 0.03, 0.01}) {
    const Relaxation f = relaxation(1.0, x);
    EXPECT_NEAR((f.keep - std::exp(-x)) / (x * x * x), 1.0 / 6.0, 0.4 * x);
    EXPECT_NEAR((f.gain + std::expm1(-x) / x) / (x * x), -1.0 / 6.0, 0.4 * x);
  }
}

TEST(Maxwell, OscillationIsFollowedToSecondOrder)
{
  // dq/dt = cos(t) - q/T from rest: q = T (cos t + T sin t - exp(-t/T))/(1 + T^2)
  for (const double T : {0.1, 1.0, 10.0}) {
    double old_error = 0.0;
    for (const int steps : {400, 800, 1600}) {
      const double end = 7.0, dt = end / steps;
      double q = 0.0, error = 0.0;
      for (int n = 1; n <= steps; n++) {
        const Relaxation f = relaxation(T, dt);
        q = f.keep * q + f.gain * (std::sin(n * dt) - std::sin((n - 1) * dt));
        const double t = n * dt;
        const double exact = T * (std::cos(t) + T * std::sin(t) - std::exp(-t / T)) / (1.0 + T * T);
        error = std::fmax(error, std::fabs(q - exact));
      }
      if (steps > 400) { EXPECT_NEAR(old_error / error, 4.0, 0.4) << "T = " << T; }
      old_error = error;
    }
    EXPECT_LT(old_error, 1e-4);
  }
}

TEST(Maxwell, SteadyForceIsTheResistanceTimesTheRateForAnyStep)
{
  // q = rate dt/x is stationary
  for (const double x : {1e-6, 1e-3, 0.3, 20.0, 1e5}) {
    const Relaxation f = relaxation(0.7, 0.7 * x);
    EXPECT_NEAR(f.keep / x + f.gain, 1.0 / x, 1e-14 / x) << "x = " << x;
  }
}

TEST(Maxwell, DecaysWithoutChangingSignForAnyStep)
{
  Random rnd(2);
  double last_keep = 1.0, last_gain = 1.0;
  for (double x = 1e-6; x < 1e12; x *= 1.3) {
    const Relaxation f = relaxation(1.0, x);
    EXPECT_GT(f.keep, 0.0);
    EXPECT_LT(f.keep, last_keep);
    EXPECT_GT(f.gain, 0.0);
    EXPECT_LT(f.gain, last_gain);
    last_keep = f.keep;
    last_gain = f.gain;
  }
  EXPECT_LT(last_keep, 1e-22);    // L-stable
  EXPECT_LT(last_gain, 2e-12);
}

TEST(Maxwell, IsPassiveInEveryStep)
{
  // work of the mean force, (q0 + q1)/2 slip, covers the energy gained and what a film dissipates
  // when the slip is that of a steady motion, and when there is none
  Random rnd(3);
  for (int trial = 0; trial < 5000; trial++) {
    const double x = rnd.log_uniform(1e-9, 1e9), q0 = rnd.uniform(-1.0, 1.0);
    for (const double slip : {0.0, x * q0}) {
      const Relaxation f = relaxation(1.0, x);
      const double q1 = f.keep * q0 + f.gain * slip;
      const double work = 0.5 * (q0 + q1) * slip, stored = 0.5 * (q1 * q1 - q0 * q0);
      EXPECT_GE(work - stored, -1e-15);
    }
  }
}
