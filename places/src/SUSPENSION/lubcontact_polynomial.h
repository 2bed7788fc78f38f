/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Polynomials for the series of the kernel, and the exponential and logarithm made of them: without
// call or branch, so that a loop over pairs becomes vector instructions.

#ifndef LUBCONTACT_POLYNOMIAL_H
#define LUBCONTACT_POLYNOMIAL_H

#include "lubcontact_defs.h"

#include <cstdint>
#include <cstring>

namespace LAMMPS_NS::Lubcontact_NS {

// A series is a type: how many coefficients, and which. So they are constants in the instructions,
// not a table in memory.
constexpr double factorial(int n)
{
  return n > 0 ? n * factorial(n - 1) : 1.0;
}

template <int N> struct ExpSeries {
  static constexpr int SIZE = N;
  static constexpr double at(int n) { return 1.0 / factorial(n); }
};

// artanh(s) = s sum s^(2n)/(2n+1), to rounding for |s| < 0.172
struct ArtanhSeries {
  static constexpr int SIZE = 11;
  static constexpr double at(int n) { return 1.0 / (2 * n + 1); }
};

// Horner's rule for every other coefficient from the one at FIRST on.
template <class Series, int FIRST> LUBCONTACT_FN inline double every_other(double t)
{
  constexpr double c = Series::at(FIRST);
  if constexpr (FIRST + 2 < Series::SIZE)
    return every_other<Series, FIRST + 2>(t) * t + c;
  else
    return c;
}

// sum at(n) x^n, even and odd powers side by side: half the latency of Horner's rule.
template <class Series> LUBCONTACT_FN inline double polynomial(double x)
{
  const double t = x * x;
  return every_other<Series, 0>(t) + x * every_other<Series, 1>(t);
}

// ln 2 in two parts: the multiples of the first by a binary exponent are exact
static constexpr double LN2_HIGH = 6.93147180369123816490e-01;
static constexpr double LN2_LOW = 1.90821492927058770002e-10;

LUBCONTACT_FN inline std::uint64_t bits_of(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

LUBCONTACT_FN inline double from_bits(std::uint64_t bits)
{
  double x;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}

// exp(x) for |x| < 700: x = k ln 2 + r, and k goes into the exponent bits.
LUBCONTACT_FN inline double exponential(double x)
{
  static constexpr double ROUND = 0x1.8p52;    // added, it leaves k in the lowest bits
  const double shifted = x * 1.4426950408889634 + ROUND;
  const double k = shifted - ROUND;
  const double r = (x - k * LN2_HIGH) - k * LN2_LOW;
  return from_bits(bits_of(polynomial<ExpSeries<14>>(r)) + (bits_of(shifted) << 52));
}

// ln(x) for a normal x > 0: x = 2^k m with m between the roots of 1/2 and 2.
LUBCONTACT_FN inline double logarithm(double x)
{
  static constexpr std::uint64_t ROOT_HALF = 0x3FE6A09E667F3BCD, ONE = 0x3FF0000000000000;
  static constexpr std::uint64_t MANTISSA = 0x000FFFFFFFFFFFFF, INTEGER = 0x4330000000000000;
  const std::uint64_t bits = bits_of(x) - ROOT_HALF + ONE;
  const double k = from_bits((bits >> 52) | INTEGER) - (0x1p52 + 1023.0);
  const double m = from_bits((bits & MANTISSA) + ROOT_HALF);
  const double s = (m - 1.0) / (m + 1.0);
  return k * LN2_HIGH + (2.0 * s * polynomial<ArtanhSeries>(s * s) + k * LN2_LOW);
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
