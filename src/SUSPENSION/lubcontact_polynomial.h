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

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace LAMMPS_NS::Lubcontact_NS {

// sum c[n] x^n, even and odd powers side by side: half the latency of Horner's rule.
template <std::size_t N> inline double polynomial(const double (&c)[N], double x)
{
  const double t = x * x;
  double high = c[N - 1], low = c[N - 2];    // every other coefficient, down from these two
  for (int n = static_cast<int>(N) - 3; n >= 0; n -= 2) {
    high = high * t + c[n];
    if (n > 0) low = low * t + c[n - 1];
  }
  return N % 2 ? high + x * low : low + x * high;
}

// artanh(s) = s sum s^(2n)/(2n+1), to rounding for |s| < 0.172
static constexpr double ARTANH_SERIES[11] = {1.0,      1.0 / 3,  1.0 / 5,  1.0 / 7,
                                             1.0 / 9,  1.0 / 11, 1.0 / 13, 1.0 / 15,
                                             1.0 / 17, 1.0 / 19, 1.0 / 21};

static constexpr double EXP_SERIES[14] = {1.0,
                                          1.0,
                                          1.0 / 2,
                                          1.0 / 6,
                                          1.0 / 24,
                                          1.0 / 120,
                                          1.0 / 720,
                                          1.0 / 5040,
                                          1.0 / 40320,
                                          1.0 / 362880,
                                          1.0 / 3628800,
                                          1.0 / 39916800,
                                          1.0 / 479001600,
                                          1.0 / 6227020800};

// ln 2 in two parts: the multiples of the first by a binary exponent are exact
static constexpr double LN2_HIGH = 6.93147180369123816490e-01;
static constexpr double LN2_LOW = 1.90821492927058770002e-10;

inline std::uint64_t bits_of(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

inline double from_bits(std::uint64_t bits)
{
  double x;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}

// exp(x) for |x| < 700: x = k ln 2 + r, and k goes into the exponent bits.
inline double exponential(double x)
{
  static constexpr double ROUND = 0x1.8p52;    // added, it leaves k in the lowest bits
  const double shifted = x * 1.4426950408889634 + ROUND;
  const double k = shifted - ROUND;
  const double r = (x - k * LN2_HIGH) - k * LN2_LOW;
  return from_bits(bits_of(polynomial(EXP_SERIES, r)) + (bits_of(shifted) << 52));
}

// ln(x) for a normal x > 0: x = 2^k m with m between the roots of 1/2 and 2.
inline double logarithm(double x)
{
  static constexpr std::uint64_t ROOT_HALF = 0x3FE6A09E667F3BCD, ONE = 0x3FF0000000000000;
  static constexpr std::uint64_t MANTISSA = 0x000FFFFFFFFFFFFF, INTEGER = 0x4330000000000000;
  const std::uint64_t bits = bits_of(x) - ROOT_HALF + ONE;
  const double k = from_bits((bits >> 52) | INTEGER) - (0x1p52 + 1023.0);
  const double m = from_bits((bits & MANTISSA) + ROOT_HALF);
  const double s = (m - 1.0) / (m + 1.0);
  return k * LN2_HIGH + (2.0 * s * polynomial(ARTANH_SERIES, s * s) + k * LN2_LOW);
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
