// Integrals in long double, as an oracle: Gauss-Legendre with twenty points a panel.

#ifndef KERNEL_QUADRATURE_H
#define KERNEL_QUADRATURE_H

#include <cmath>

namespace testing_tools {

using Real = long double;

struct GaussLegendre {
  static constexpr int N = 20;
  Real x[N], w[N];    // on (-1, 1)

  GaussLegendre()
  {
    for (int k = 0; k < N; k++) {
      Real z = std::cos(3.14159265358979323846L * (k + 0.75L) / (N + 0.5L)), slope = 0.0L;
      for (int newton = 0; newton < 10; newton++) {
        Real p = 1.0L, before = 0.0L;
        for (int n = 1; n <= N; n++) {
          const Real next = ((2 * n - 1) * z * p - (n - 1) * before) / n;
          before = p;
          p = next;
        }
        slope = N * (z * p - before) / (z * z - 1.0L);
        z -= p / slope;
      }
      x[k] = z;
      w[k] = 2.0L / ((1.0L - z * z) * slope * slope);
    }
  }

  template <class F> Real operator()(F f, Real from, Real to) const
  {
    const Real middle = 0.5L * (from + to), half = 0.5L * (to - from);
    Real sum = 0.0L;
    for (int k = 0; k < N; k++) sum += w[k] * f(middle + half * x[k]);
    return half * sum;
  }
};

// ln of the integral of exp(-z s + D s^2) over (0, 1), and the mean of s^2 under this weight.
struct Weighted {
  Real ln, mean_s2;
};

inline Weighted weighted(Real z, Real D)
{
  static const GaussLegendre rule;
  auto exponent = [=](Real s) {
    return s * (D * s - z);
  };
  // the largest value is at an end or, for D < 0, between them; away from it panels of its width
  Real top = exponent(1.0L) > 0.0L ? 1.0L : 0.0L;
  const Real inner = D < 0.0L ? 0.5L * z / D : -1.0L;
  if (inner > 0.0L && inner < 1.0L) top = inner;
  const Real slope = std::fabs(2.0L * D * top - z);
  const Real width = 1.0L / (1.0L + slope + std::sqrt(std::fabs(D)));
  Real sum = 0.0L, second = 0.0L;
  auto add = [&](Real from, Real to) {
    sum += rule(
        [=](Real s) {
          return std::exp(exponent(s) - exponent(top));
        },
        from, to);
    second += rule(
        [=](Real s) {
          return s * s * std::exp(exponent(s) - exponent(top));
        },
        from, to);
  };
  for (Real s = top; s < 1.0L && exponent(s) - exponent(top) > -60.0L; s += width)
    add(s, std::fmin(1.0L, s + width));
  for (Real s = top; s > 0.0L && exponent(s) - exponent(top) > -60.0L; s -= width)
    add(std::fmax(0.0L, s - width), s);
  return {exponent(top) + std::log(sum), second / sum};
}

}    // namespace testing_tools

#endif
