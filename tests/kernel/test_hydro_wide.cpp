// Spheres of any radius as Gaussians of one width.

#include "hydro_wide.h"
#include "tools.h"

#include <array>

using namespace LAMMPS_NS::Hydro_NS;
using testing_tools::PI_;
using testing_tools::Random;

namespace {

// j_n(x)/x^n, as a series where that converges
double bessel(int n, double x)
{
  if (x > n + 1.0) {
    double last = std::sin(x) / x, next = last / x - std::cos(x) / x;
    if (n == 0) return last;
    for (int m = 1; m < n; m++) {
      const double more = (2 * m + 1) / x * next - last;
      last = next;
      next = more;
    }
    return next / std::pow(x, n);
  }
  double term = 1.0, sum = 0.0;
  for (int m = 1; m <= n; m++) term /= 2 * m + 1;
  for (int k = 0; k < 40; k++) {
    sum += term;
    term *= -0.5 * x * x / ((k + 1) * (2 * (n + k + 1) + 1));
  }
  return sum;
}

// trapezoidal rule over waves: exact for Gaussians
template <class F> double over_waves(F f, double most)
{
  const int steps = 4000;
  double sum = 0.5 * f(1e-9);
  for (int n = 1; n < steps; n++) sum += f(most * n / steps);
  return sum * most / steps;
}

// lap h = (4/pi) int exp(-q k^2/2) (1 - ci k^2)(1 - cj k^2) sin(kr)/(kr) dk, and its derivatives
TEST(HydroWide, RadialFunctionsAreSumsOverWaves)
{
  const double width = 0.9, q = 2.0 * width * width;
  for (const double r : {0.4, 1.3, 2.0, 3.7, 6.0})
    for (const double ci : {0.0, -0.3, 0.15})
      for (const double cj : {0.0, 0.2}) {
        const Radial f = with_coefficients(wide_radial(r, width), ci, cj);
        for (int n = 0; n < 5; n++) {
          const auto integral = [&](int power) {
            return over_waves(
                [&](double k) {
                  const double k2 = k * k;
                  return 4.0 / PI_ * std::exp(-0.5 * q * k2) * (1.0 - ci * k2) * (1.0 - cj * k2) *
                      std::pow(k, power) * bessel(n, k * r);
                },
                12.0);
          };
          const double sign = n % 2 ? -1.0 : 1.0;
          if (n < 3) { EXPECT_NEAR(f.p[n], sign * integral(2 * n), 1e-9) << n; }
          if (n > 0) { EXPECT_NEAR(f.h[n], -sign * integral(2 * n - 2), 1e-9) << n; }
        }
      }
}

TEST(HydroWide, ASphereAloneIsExact)
{
  Random rnd(7);
  for (int trial = 0; trial < 5; trial++) {
    const double a = rnd.uniform(0.2, 2.0), eta = rnd.uniform(0.5, 2.0);
    const Self exact = sphere_self(a, eta);
    EXPECT_NEAR(exact.translation, 1.0 / (6.0 * PI_ * eta * a), 1e-14);
    EXPECT_NEAR(exact.rotation, 1.0 / (8.0 * PI_ * eta * a * a * a), 1e-12);
    // Einstein: the stresslet of a sphere in the strain E is 20 pi eta a^3 E/3
    EXPECT_NEAR(exact.strain * 20.0 * PI_ * eta * a * a * a / 3.0, 1.0, 1e-14);
    // on a grid of the widths of its own Gaussians nothing is missing
    const Widths v = widths(a);
    const double force = std::sqrt(v.force), dipole = std::sqrt(v.dipole);
    EXPECT_NEAR(wide_self(make_body(a, force), force, eta).translation, exact.translation, 1e-13);
    const Self wide = wide_self(make_body(a, dipole), dipole, eta);
    EXPECT_NEAR(wide.rotation / exact.rotation, 1.0, 1e-13);
    EXPECT_NEAR(wide.strain / exact.strain, 1.0, 1e-13);
  }
}

// mean over directions of the response to a force, a torque and a stresslet: 2/3, 1/6, 1/5
TEST(HydroWide, SelfIsASumOverWaves)
{
  for (const double a : {0.4, 1.0, 1.7})
    for (const double width : {0.7, 1.0}) {
      const Body body = make_body(a, width);
      const auto integral = [&](double c, int power) {
        return over_waves(
                   [&](double k) {
                     const double f = 1.0 - c * k * k;
                     return std::exp(-width * width * k * k) * f * f * std::pow(k, power);
                   },
                   14.0) /
            (2.0 * PI_ * PI_);
      };
      const Self self = wide_self(body, width, 2.0);
      EXPECT_NEAR(2.0 * self.translation, integral(body.c_force, 0) * 2.0 / 3.0, 1e-12);
      EXPECT_NEAR(2.0 * self.rotation, integral(body.c_dipole, 2) / 6.0, 1e-12);
      EXPECT_NEAR(2.0 * self.strain, integral(body.c_dipole, 2) / 5.0, 1e-12);
    }
}

TEST(HydroWide, WhatIsMissingIsShortRanged)
{
  const Body i = make_body(1.0, 1.0), j = make_body(0.4, 1.0);
  Load load{{1.0, 0.5, -0.2}, get_strain(std::array<double, 5>{1.0, 0.3, 0.2, 0.1, 0.4}.data())};
  double before = 1.0;
  for (const double r : {2.0, 4.0, 5.0, 6.0, 8.0}) {
    Motion at_i, at_j;
    add_pair(missing_response({0.6 * r, 0.0, 0.8 * r}, i, j, 1.0), 1.0, load, load, at_i, at_j);
    const double size = norm(at_i.velocity) + norm(at_j.velocity) + norm(at_i.gradient.x);
    EXPECT_LT(size, before);
    before = size;
  }
  EXPECT_LT(before, 1e-4);    // at 8 widths: polynomial times exp(-16)
}

TEST(HydroWide, SelfIsDiagonal)
{
  double load[NUMBERS], motion[NUMBERS] = {};
  for (int n = 0; n < NUMBERS; n++) load[n] = n + 1.0;
  add_self({2.0, 3.0, 5.0}, load, motion);
  for (int n = 0; n < NUMBERS; n++)
    EXPECT_EQ(motion[n], (n < 3 ? 2.0 : n < 6 ? 3.0 : 5.0) * load[n]);
}

}    // namespace
