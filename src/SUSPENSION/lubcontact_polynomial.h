// Polynomials for the series of the kernel.

#ifndef LUBCONTACT_POLYNOMIAL_H
#define LUBCONTACT_POLYNOMIAL_H

#include <cstddef>

namespace lubcontact {

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

// artanh(s) = s sum s^(2n)/(2n+1)
static constexpr double ARTANH_SERIES[8] = {1.0,     1.0 / 3,  1.0 / 5,  1.0 / 7,
                                            1.0 / 9, 1.0 / 11, 1.0 / 13, 1.0 / 15};

}    // namespace lubcontact

#endif
