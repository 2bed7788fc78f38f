// Shows that the film resistances have the coefficients of Jeffrey & Onishi (1984) near contact.

#include "lubcontact_film.h"
#include "lubcontact_geometry.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

// coefficient of ln(1/u) of a resistance f(u), from two gaps a hundred apart
template <class F> double log_coefficient(F f)
{
  return (f(1e-8) - f(1e-6)) / std::log(100.0);
}

double shear(const Film &f, double a, double u)
{
  return shear_resistance(f, a, u, std::log(u));
}
double roll(const Film &f, double a, double u)
{
  return roll_resistance(f, a, u, std::log(u));
}
double twist(const Film &f, double a, double u)
{
  return twist_resistance(f, a, u, std::log(u));
}

static constexpr double SIX_PI = 18.849555921538759, EIGHT_PI = 25.132741228718345;

}    // namespace

TEST(Film, SqueezeCoefficientIsThreeHalvesPiEta)
{
  EXPECT_NEAR(squeeze_coeff(2.0), 9.42477796076938, 1e-14);
}

TEST(Film, ShearIsThatOfFrankelAndAcrivos)
{
  // nu_t = (pi eta/2) (-2 a + (2 a + h) ln((2 a + h)/h)) at eta = 0.7, a = 3, h = 0.3
  const double exact = 0.5 * PI_ * 0.7 * (-6.0 + 6.3 * std::log(21.0));
  EXPECT_NEAR(shear(make_film(0.7, 2.0, Range::CUT, 0.6), 3.0, 0.1), exact, 1e-13);
  EXPECT_NEAR(shear_shape(2.0, std::log(2.0)), 0.3862943611198906, 1e-15);    // 2 ln 2 - 1
}

TEST(Film, RollAndTwistAgreeWithHandComputedValues)
{
  // u = 0.1, ln(1/u) = 2.302585092994046; over pi eta a^3
  const Film f = make_film(1.0 / PI_, 2.0, Range::CUT, 0.6);
  EXPECT_NEAR(roll(f, 2.0, 0.1), 8.0 * (0.6 + 0.0504) * 2.302585092994046, 1e-13);
  EXPECT_NEAR(twist(f, 2.0, 0.1), 8.0 * 0.1 * 2.302585092994046, 1e-14);
}

TEST(Film, RollAndTwistEndAtOneRadius)
{
  const Film f = make_film(1.0, 2.0, Range::CUT, 0.6);
  for (const double u : {1.0, 1.5, 1.99}) {
    EXPECT_EQ(roll(f, 1.0, u), 0.0);
    EXPECT_EQ(twist(f, 1.0, u), 0.0);
  }
  EXPECT_GT(roll(f, 1.0, 0.999), 0.0);
  EXPECT_GT(twist(f, 1.0, 0.999), 0.0);
}

TEST(Film, ShearForceHasTheLogarithmOfJeffreyAndOnishi)
{
  // Y^A11 ~ (1/6) ln(1/xi) over 6 pi eta a
  const Film f = make_film(1.0, 2.0, Range::CUT, 0.6);
  EXPECT_NEAR(log_coefficient([&](double u) {
                return shear(f, 1.0, u) / SIX_PI;
              }),
              1.0 / 6.0, 1e-6);
}

// Torques over 6 pi eta a^3 on the two spheres when i spins across n and j rests: Y^C11, Y^C12,
// the slip of a unit spin being -arm (section 4 of the model).
static double spin_torque(const Film &f, double u, bool on_i)
{
  const double arm = 1.0 + 0.5 * u;
  const double from_shear = shear(f, 1.0, u) * arm * arm, from_roll = roll(f, 1.0, u);
  return (on_i ? from_shear + from_roll : from_shear - from_roll) / SIX_PI;
}

TEST(Film, RollCoefficientThreeFifthsGivesBothTorquesOfJeffreyAndOnishi)
{
  const Film f = make_film(1.0, 2.0, Range::CUT, 0.6);
  EXPECT_NEAR(log_coefficient([&](double u) {
                return spin_torque(f, u, true);
              }),
              4.0 / 15.0, 2e-6);
  EXPECT_NEAR(log_coefficient([&](double u) {
                return spin_torque(f, u, false);
              }),
              1.0 / 15.0, 2e-6);
}

TEST(Film, PrintedRollCoefficientThreeHalvesGivesNeither)
{
  const Film f = make_film(1.0, 2.0, Range::CUT, 1.5);
  EXPECT_GT(log_coefficient([&](double u) {
              return spin_torque(f, u, true);
            }),
            4.0 / 15.0 + 0.1);
  EXPECT_LT(log_coefficient([&](double u) {
              return spin_torque(f, u, false);
            }),
            1.0 / 15.0 - 0.1);
}

TEST(Film, CoupleOfOppositeSpinsIsHalfTheDifferenceOfTheTwo)
{
  // spins +w/2 and -w/2, over 8 pi eta a^3: (Y^C11 - Y^C12)/2 = (1/5 - 1/20)/2 ln(1/xi)
  const Film f = make_film(1.0, 2.0, Range::CUT, 0.6);
  EXPECT_NEAR(log_coefficient([&](double u) {
                return roll(f, 1.0, u) / EIGHT_PI;
              }),
              0.075, 1e-6);
}

TEST(Film, LubricationPressureOfRollingSpheresGivesThreeFifths)
{
  // Both surfaces move with U = -w a/2 past the gap H = h + rho^2/a. The pressure C x/H^2 solves
  // div(H^3 grad p) = 12 eta U dH/dx for C = -12 eta U/5; checked by differences, then integrated:
  // torque on i = (a/2) integral of H dp/dx.
  const double a = 1.0, eta = 1.0, w = 1.0, U = -0.5 * w * a, C = -2.4 * eta * U;
  {
    const double h = 0.3, e = 1e-3;
    auto H = [=](double x, double y) {
      return h + (x * x + y * y) / a;
    };
    auto p = [=](double x, double y) {
      return C * x / (H(x, y) * H(x, y));
    };
    auto flux = [=](double x0, double y0, double x1, double y1) {
      const double middle = H(0.5 * (x0 + x1), 0.5 * (y0 + y1));
      return middle * middle * middle * (p(x1, y1) - p(x0, y0)) / e;
    };
    for (const double x : {-0.4, 0.1, 0.7})
      for (const double y : {-0.2, 0.5}) {
        const double divergence = (flux(x, y, x + e, y) - flux(x - e, y, x, y) +
                                   flux(x, y, x, y + e) - flux(x, y - e, x, y)) /
            e;
        EXPECT_NEAR(divergence, 12.0 * eta * U * 2.0 * x / a, 1e-4);
      }
  }
  auto torque = [=](double h) {
    // angular mean of H dp/dx, by the midpoint rule in ln(rho), out to rho = 0.3 a
    double sum = 0.0;
    const int n = 20000;
    const double lo = std::log(1e-3 * std::sqrt(h)), hi = std::log(0.3), dl = (hi - lo) / n;
    for (int m = 0; m < n; m++) {
      const double rho = std::exp(lo + (m + 0.5) * dl), H = h + rho * rho / a;
      const double mean = C * (1.0 / H - 2.0 * rho * rho / (a * H * H));
      sum += mean * 2.0 * PI_ * rho * rho * dl;
    }
    return 0.5 * a * sum;
  };
  const double per_log = (torque(1e-8) - torque(1e-6)) / std::log(100.0);
  EXPECT_NEAR(per_log / (PI_ * eta * a * a * a), -0.6 * w, 1e-4);
  const Film f = make_film(eta, 2.0, Range::CUT, 0.6);
  EXPECT_NEAR(-log_coefficient([&](double u) {
    return roll(f, a, u);
  }),
              per_log, 1e-3);
}

TEST(Film, SqueezeOfUnequalSpheresIsExactWithTheHarmonicRadius)
{
  // over 6 pi eta a1: X^A11 ~ g1/xi, g1 = 2 l^2/(1+l)^3, l = a2/a1, xi = 2 h/(a1 + a2)
  for (const double l : {0.1, 0.5, 1.0, 3.0, 50.0}) {
    const double a1 = 0.8, a2 = l * a1, h = 1e-5, eta = 1.3;
    const double a = effective_radius(Radius::HARMONIC, a1, a2);
    const double g1 = 2.0 * l * l / ((1.0 + l) * (1.0 + l) * (1.0 + l));
    const double exact = SIX_PI * eta * a1 * g1 * (a1 + a2) / (2.0 * h);
    EXPECT_NEAR(squeeze_coeff(eta) * a * a / h / exact, 1.0, 1e-13) << "l = " << l;
  }
}

TEST(Film, MeanRadiusOverestimatesTheSqueezeOfUnequalSpheres)
{
  const double mean = effective_radius(Radius::MEAN, 1.0, 3.0);
  const double exact = effective_radius(Radius::HARMONIC, 1.0, 3.0);
  EXPECT_NEAR(mean * mean / (exact * exact), 16.0 / 9.0, 1e-14);
}

TEST(Film, ResistancesAreNeverNegativeOrInfinite)
{
  Random rnd(2);
  for (int trial = 0; trial < 50000; trial++) {
    const double range = rnd.log_uniform(1e-3, 10.0);
    const Film f = make_film(rnd.log_uniform(1e-9, 1e3), range,
                             rnd.coin() ? Range::CUT : Range::SHIFTED, rnd.uniform(0.0, 1.5));
    const double ln_u = rnd.coin() ? rnd.uniform(-30.0, 30.0) : -rnd.log_uniform(1.0, 1e5);
    const double u = std::exp(ln_u);
    for (const double value : {shear_resistance(f, 1.1, u, ln_u), roll_resistance(f, 1.1, u, ln_u),
                               twist_resistance(f, 1.1, u, ln_u)}) {
      EXPECT_GE(value, 0.0);
      EXPECT_TRUE(std::isfinite(value));
    }
  }
}

TEST(Film, ShiftedResistancesVanishAtTheEndOfTheRangeAndBeyond)
{
  for (const double range : {0.05, 0.25, 0.9, 2.0}) {
    const Film f = make_film(1.0, range, Range::SHIFTED, 0.6);
    EXPECT_EQ(f.shift, 1.0 / range);
    for (const double u : {range, 1.001 * range, 1.5 * range}) {
      EXPECT_NEAR(shear(f, 1.0, u), 0.0, 1e-14) << range;
      EXPECT_NEAR(roll(f, 1.0, u), 0.0, 1e-14) << range;
      EXPECT_NEAR(twist(f, 1.0, u), 0.0, 1e-14) << range;
    }
    EXPECT_GT(shear(f, 1.0, 0.99 * range), 0.0);
    if (range < 1.0) { EXPECT_GT(roll(f, 1.0, 0.99 * range), 0.0); }
    if (range < 1.0) { EXPECT_GT(twist(f, 1.0, 0.99 * range), 0.0); }
  }
}

TEST(Film, ShiftTakesTheValueAtTheRangeAndNothingElse)
{
  const double range = 0.3, u = 0.02, a = 1.7;
  const Film cut = make_film(0.9, range, Range::CUT, 0.6);
  const Film shifted = make_film(0.9, range, Range::SHIFTED, 0.6);
  EXPECT_EQ(cut.shift, 0.0);
  EXPECT_NEAR(shear(shifted, a, u), shear(cut, a, u) - shear(cut, a, range), 1e-13);
  EXPECT_NEAR(roll(shifted, a, u), roll(cut, a, u) - roll(cut, a, range), 1e-13);
  // twist: ln(range/u) instead of ln(1/u)
  EXPECT_NEAR(twist(shifted, a, u), PI_ * 0.9 * a * a * a * u * std::log(0.3 / 0.02), 1e-13);
}

TEST(Film, WithoutViscosityThereIsNone)
{
  const Film f = make_film(0.0, 2.0, Range::CUT, 0.6);
  EXPECT_EQ(shear(f, 1.0, 0.1), 0.0);
  EXPECT_EQ(roll(f, 1.0, 0.1), 0.0);
  EXPECT_EQ(twist(f, 1.0, 0.1), 0.0);
}

TEST(Film, UnderflowOfTheGapLeavesTheLogarithm)
{
  // u = exp(-1e4) is zero in double precision
  const Film f = make_film(1.0 / PI_, 2.0, Range::CUT, 0.6);
  EXPECT_NEAR(shear_resistance(f, 1.0, 0.0, -1e4), 1e4 + std::log(2.0) - 1.0, 1e-9);
  EXPECT_NEAR(roll_resistance(f, 1.0, 0.0, -1e4), 6e3, 1e-9);
  EXPECT_EQ(twist_resistance(f, 1.0, 0.0, -1e4), 0.0);
}

TEST(Film, TwistEndsAtOneRadiusAlsoWhereTheRangeIsLonger)
{
  EXPECT_EQ(make_film(1.0, 1.5, Range::SHIFTED, 0.6).twist_end, 0.0);
  EXPECT_EQ(make_film(1.0, 0.5, Range::SHIFTED, 0.6).twist_end, std::log(0.5));
}
