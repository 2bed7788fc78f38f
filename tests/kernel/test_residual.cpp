// Shows that residual films are the exact resistance of two spheres minus that of force coupling.

#include "lubcontact_residual.h"
#include "reference/residual_reference.h"
#include "tools.h"

#include <array>
#include <cmath>
#include <utility>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

using Values = std::array<double, NUM_RESIDUAL_PARTS>;

template <int... PART> Values all_parts(const ResidualPlace &p, std::integer_sequence<int, PART...>)
{
  return {residual<PART>(p)...};
}

double delta_of(double ratio)
{
  return (1.0 - ratio) / (1.0 + ratio);
}

Values values_at(double u_a, double delta)
{
  return all_parts(residual_place(u_a, std::log(u_a), delta),
                   std::make_integer_sequence<int, NUM_RESIDUAL_PARTS>());
}

// Largest error over the exact function, which is what the sum with the far field is, and over the
// residual itself where it is above 1e-3 of that.
struct Bounds {
  double exact, residual;
};
constexpr Bounds BOUNDS[NUM_RESIDUAL_PARTS] = {
    {5e-4, 1e-2}, {6e-4, 6e-3}, {6e-5, 0.06}, {2e-4, 5e-3}, {6e-5, 2e-2},
    {6e-5, 0.05}, {1e-4, 5e-3}, {1e-4, 5e-3}, {3e-4, 0.02}, {6e-5, 0.05}};

bool is_odd(int part)    // their fit is without the factor delta
{
  return part == RESIDUAL_LEVER || part == RESIDUAL_TURN;
}

}    // namespace

TEST(Residual, IsThatOfTheExactSeriesMinusForceCoupling)
{
  for (const ResidualCase &c : RESIDUAL_CASES) {
    const Values v = values_at(c.u_a, delta_of(c.ratio));
    for (int part = 0; part < NUM_RESIDUAL_PARTS; part++) {
      if (is_odd(part) && c.ratio == 1.0) continue;
      const double error = std::fabs(v[part] - c.residual[part]);
      EXPECT_LT(error, BOUNDS[part].exact * std::fabs(c.exact[part]))
          << part << " at " << c.ratio << ", " << c.u_a;
      if (std::fabs(c.residual[part]) < 1e-3 * std::fabs(c.exact[part])) continue;
      EXPECT_LT(error, BOUNDS[part].residual * std::fabs(c.residual[part]))
          << part << " at " << c.ratio << ", " << c.u_a;
    }
  }
}

// From the scalar functions of the series to order 300, the rest summed from the asymptotic forms
// near contact: an independent computation. Errors over the exact functions, of which the first
// line of each size ratio has the size.
TEST(Residual, GoesOnToContact)
{
  struct Case {
    double ratio, u_a, residual[NUM_RESIDUAL_PARTS];
  };
  const Case cases[] = {
      {1.0,
       1e-4,
       {1.00028, 1.69392, 0.45005, 7.07455, -1.96550, 0.60250, 4.32585, 0.0, 0.25008, 0.0}},
      {1.0,
       1e-5,
       {1.00005, 1.69380, 0.45127, 9.37669, -2.45957, 0.68759, 5.70685, 0.0, 0.25079, 0.0}},
      {0.5,
       1.5e-4,
       {1.00054, 5.88682, 1.67107, 7.36342, 0.04620, 0.72361, 4.15044, 4.40094, 0.27245, -0.16071}},
      {0.5,
       1.5e-5,
       {1.00008, 5.88650, 1.66416, 9.81892, 0.02768, 0.87799, 5.53115, 5.78232, 0.27347, -0.12783}},
      {0.25,
       2.5e-4,
       {1.00098, 8.40048, -0.46119, 8.42418, 2.08882, 1.37477, 4.04122, 4.58940, 0.25353, 3.04009}},
      {0.25,
       2.5e-5,
       {1.00014, 8.40337, -0.45870, 11.2232, 2.20315, 1.58732, 5.42124, 5.97060, 0.25507,
        3.12133}}};
  const double size[NUM_RESIDUAL_PARTS] = {1.0, 21.0, 120.0, 10.6, 14.0, 96.0, 7.3, 8.5, 2.2, 39.0};
  for (const Case &c : cases) {
    const Values v = values_at(c.u_a, delta_of(c.ratio));
    for (int part = 0; part < NUM_RESIDUAL_PARTS; part++) {
      if (is_odd(part) && c.ratio == 1.0) continue;
      EXPECT_NEAR(v[part], c.residual[part], 2e-3 * size[part])
          << c.ratio << " " << c.u_a << " " << part;
    }
  }
}

TEST(Residual, LimitsAreThoseOfLubrication)
{
  // Jeffrey and Onishi: (3/2) pi a^2/u; (8/5) pi R l (2+l+2l^2)/(1+l)^3, 3/5 pi a^3 and
  // 3/5 pi a^2 (1-l)/(1+l) times ln(1/u)
  for (const double l : {1.0, 0.6, 0.25}) {
    const double a = 2.0 * l / (1.0 + l), delta = delta_of(l);
    EXPECT_EQ(values_at(1e-300, delta)[RESIDUAL_SQUEEZE], 1.0);
    const Values one = values_at(1e-200, delta), other = values_at(1e-202, delta);
    auto log_of = [&](int part) {
      return (other[part] - one[part]) / std::log(100.0);
    };
    EXPECT_NEAR(a * log_of(RESIDUAL_SHEAR),
                1.6 * l * (2.0 + l + 2.0 * l * l) / std::pow(1.0 + l, 3), 1e-12);
    EXPECT_NEAR(log_of(RESIDUAL_ROLL), 0.6, 1e-12);
    EXPECT_NEAR(log_of(RESIDUAL_LEVER), 0.6, 1e-12);
    for (const int part : {RESIDUAL_PUSH, RESIDUAL_STRETCH, RESIDUAL_TWIST})
      EXPECT_EQ(log_of(part), 0.0) << part;
  }
}

TEST(Residual, ResistancesArePositiveAndFallWithTheGap)
{
  for (double beta = 0.0; beta < RESIDUAL_END_BETA + 1e-9; beta += 0.02) {
    const double delta = std::sqrt(beta);
    double squeeze = HUGE_VAL, shear = HUGE_VAL, roll = HUGE_VAL, twist = HUGE_VAL;
    for (double u = 1e-6; u < 1.05 * RESIDUAL_END_A; u *= 1.02) {
      const ResidualPlace p = residual_place(u, std::log(u), delta);
      const TangentialResidual t = tangential_residual(1.0, 1.0, delta, p);
      const double s = residual<RESIDUAL_SQUEEZE>(p) / u;
      EXPECT_GT(s, 0.0);
      EXPECT_LT(s, squeeze) << u << " " << beta;
      EXPECT_GT(t.shear, 1e-5) << u << " " << beta;
      EXPECT_LT(t.shear, shear) << u << " " << beta;
      EXPECT_GT(t.roll, 1e-5) << u << " " << beta;
      EXPECT_LT(t.roll, roll) << u << " " << beta;
      EXPECT_GE(t.twist, 0.0) << u << " " << beta;
      EXPECT_LE(t.twist, twist + 1e-3) << u << " " << beta;
      squeeze = s, shear = t.shear, roll = t.roll, twist = t.twist;
    }
  }
}

TEST(Residual, ModesWithoutCouplingAreTheSameForm)
{
  Random rnd(7);
  for (int trial = 0; trial < 100; trial++) {
    const double u = rnd.log_uniform(1e-5, 1.9), delta = rnd.uniform(-0.6, 0.6), a = 1.3, eta = 0.7;
    const ResidualPlace p = residual_place(u, std::log(u), delta);
    const TangentialResidual t = tangential_residual(eta, a, delta, p);
    const double s = rnd.uniform(-1, 1), sigma = rnd.uniform(-1, 1), e = rnd.uniform(-1, 1);
    const double As = PI_ * eta * a * residual<RESIDUAL_SHEAR>(p);
    const double Rsr = PI_ * eta * a * a * delta * residual<RESIDUAL_LEVER>(p);
    const double Rr = PI_ * eta * a * a * a * residual<RESIDUAL_ROLL>(p);
    const double Bsr = eta * a * a * residual<RESIDUAL_SLIDE>(p);
    const double Br = eta * a * a * a * delta * residual<RESIDUAL_TURN>(p);
    const double form =
        As * s * s / 2 + Rsr * s * sigma + Rr * sigma * sigma / 2 - (Bsr * s + Br * sigma) * e;
    const double off = s + t.lever * sigma;
    const double parts = t.shear * off * off / 2 + t.roll * sigma * sigma / 2 -
        t.shear * t.slide * off * e - t.roll * t.turn * sigma * e;
    EXPECT_NEAR(parts, form, 1e-12 * (1.0 + std::fabs(form)));
  }
}

TEST(Residual, StaysFiniteAtAnyGap)
{
  for (const double ln_u : {-2000.0, -700.0, 0.0, 5.0}) {
    const Values v = all_parts(residual_place(std::exp(ln_u), ln_u, 0.9),
                               std::make_integer_sequence<int, NUM_RESIDUAL_PARTS>());
    for (const double part : v) EXPECT_TRUE(std::isfinite(part)) << ln_u;
  }
  const Values last = values_at(2.2, 0.3), beyond = values_at(7.0, 0.3);
  for (int part = 0; part < NUM_RESIDUAL_PARTS; part++)
    EXPECT_NEAR(beyond[part], last[part], 1e-12) << part;
}
