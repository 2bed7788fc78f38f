// Shared by the kernel tests: seeded random numbers, smooth motions, a loop over effect masks.

#ifndef KERNEL_TEST_TOOLS_H
#define KERNEL_TEST_TOOLS_H

#include "lubcontact_effects.h"
#include "lubcontact_vec3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>

namespace testing_tools {

using LAMMPS_NS::Lubcontact_NS::Vec3;

static constexpr double PI_ = 3.141592653589793;

// The same numbers with every standard library, unlike std::uniform_real_distribution.
struct Random {
  std::mt19937_64 engine;
  explicit Random(std::uint64_t seed) : engine(seed) {}

  double uniform(double lo, double hi)
  {
    return lo + (hi - lo) * static_cast<double>(engine() >> 11) * 0x1p-53;
  }
  double log_uniform(double lo, double hi) { return std::exp(uniform(std::log(lo), std::log(hi))); }
  bool coin() { return engine() >> 63; }
  Vec3 vector(double size)
  {
    const double x = uniform(-size, size), y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
  }
  Vec3 unit()
  {
    const double z = uniform(-1.0, 1.0), angle = uniform(-PI_, PI_);
    const double rho = std::sqrt(1.0 - z * z);
    return {rho * std::cos(angle), rho * std::sin(angle), z};
  }
};

// Rotation about the unit vector axis by Rodrigues' formula: trigonometry, unlike turned().
inline Vec3 rotated(const Vec3 &a, const Vec3 &axis, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return c * a + s * LAMMPS_NS::Lubcontact_NS::cross(axis, a) +
      ((1.0 - c) * LAMMPS_NS::Lubcontact_NS::dot(axis, a)) * axis;
}

// Three sinusoids of angular frequency 0.3 to 1.3 about zero, at most `size` in all.
class Wave {
 public:
  Wave(Random &rnd, double size)
  {
    for (int m = 0; m < 3; m++) {
      height[m] = size / 3.0 * rnd.uniform(0.3, 1.0);
      frequency[m] = rnd.uniform(0.3, 1.3);
      phase[m] = rnd.uniform(-PI_, PI_);
    }
  }
  double operator()(double t) const
  {
    double sum = 0.0;
    for (int m = 0; m < 3; m++) sum += height[m] * std::sin(frequency[m] * t + phase[m]);
    return sum;
  }

 private:
  double height[3], frequency[3], phase[3];
};

struct WaveVector {
  Wave x, y, z;
  WaveVector(Random &rnd, double size) : x(rnd, size), y(rnd, size), z(rnd, size) {}
  Vec3 operator()(double t) const { return {x(t), y(t), z(t)}; }
};

// Calls f(std::integral_constant<unsigned, MASK>) for the 32 basic masks.
template <class F, unsigned... MASK> void call_each(F &&f, std::integer_sequence<unsigned, MASK...>)
{
  auto one = [&f](auto mask) {
    SCOPED_TRACE("mask " + std::to_string(mask.value));
    f(mask);
  };
  (one(std::integral_constant<unsigned, MASK>{}), ...);
}

template <class F> void for_each_mask(F &&f)
{
  call_each(f, std::make_integer_sequence<unsigned, 32>{});
}

// Bits beyond the 32 basic ones, for the masks whose laws are compiled and tested in full: each
// extension by itself and all of them, on the bare contact, squeeze, friction, and everything.
using ExtendedMasks = std::integer_sequence<unsigned, 36, 37, 63, 64, 65, 95, 128, 129, 159, 192,
                                            223, 229, 254, 255, 256, 257, 260, 293, 448, 511>;

template <class F> void for_extended_masks(F &&f)
{
  call_each(f, ExtendedMasks{});
}

inline void expect_near(const Vec3 &a, const Vec3 &b, double tolerance)
{
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

// Bit for bit, but for the sign of zero.
inline void expect_same(const Vec3 &a, const Vec3 &b)
{
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.z, b.z);
}

}    // namespace testing_tools

#endif
