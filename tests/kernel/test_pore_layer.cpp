// The even layer: its pressure against Darcy's law summed up over the height.

#include "pore_layer.h"

#include <gtest/gtest.h>

using namespace LAMMPS_NS::Pore_NS;

namespace {

constexpr double ETA = 1.7, K = 0.03, GAP = 5.0, RATE = 0.2;

// Particles move at RATE y. The flux of both phases is the same at every height: 0 with a closed
// plate at rest, what that plate moves if it is the upper one, and half of it between two drained
// ones, by symmetry.
struct Column {
  double mean = 0.0, lower, upper = 0.0;    // pressures; the first one from below is 0
  explicit Column(double flux)
  {
    constexpr int SLICES = 2000;
    const double dy = GAP / SLICES;
    double p = 0.0;
    for (int n = 0; n < SLICES; n++) {
      const double slope = ETA / K * (RATE * (n + 0.5) * dy - flux);
      mean += (p + 0.5 * slope * dy) / SLICES;
      p += slope * dy;
    }
    lower = 0.0;
    upper = p;
  }
  void set_upper(double p)    // all pressures are known but for a constant
  {
    mean += p - upper;
    lower += p - upper;
    upper = p;
  }
};

TEST(PoreLayer, DrainsOnOneSide)
{
  Column above(0.0);
  above.set_upper(0.0);
  const double drainage = layer_drainage(ETA, GAP, K, Wall::IMPERMEABLE, Wall::DRAINED);
  EXPECT_NEAR(-drainage * RATE / above.mean, 1.0, 1e-5);
  EXPECT_NEAR(above.lower / above.mean, layer_pressure(Wall::IMPERMEABLE), 1e-5);
  EXPECT_EQ(layer_pressure(Wall::DRAINED), 0.0);
  EXPECT_EQ(layer_drainage(ETA, GAP, K), drainage);

  const Column below(RATE * GAP);
  EXPECT_NEAR(-layer_drainage(ETA, GAP, K, Wall::DRAINED, Wall::IMPERMEABLE) * RATE / below.mean,
              1.0, 1e-5);
  EXPECT_NEAR(below.upper / below.mean, layer_pressure(Wall::IMPERMEABLE), 1e-5);
}

TEST(PoreLayer, DrainsOnBothSides)
{
  const Column both(0.5 * RATE * GAP);
  EXPECT_NEAR(both.upper / both.mean, 0.0, 1e-5);
  EXPECT_NEAR(-layer_drainage(ETA, GAP, K, Wall::DRAINED, Wall::DRAINED) * RATE / both.mean, 1.0,
              1e-5);
  // in the middle: p = -eta e (H/2)^2/(2 k)
  EXPECT_NEAR(-ETA * RATE * GAP * GAP / (8.0 * K) / both.mean, LAYER_PEAK, 1e-5);
}

TEST(PoreLayer, WithoutAWayOutNothingDilates)
{
  EXPECT_EQ(layer_drainage(ETA, GAP, K, Wall::IMPERMEABLE, Wall::IMPERMEABLE), 0.0);
}

TEST(PoreLayer, FluidThatEntersIsWhatTheGapGains)
{
  for (const Wall lower : {Wall::DRAINED, Wall::IMPERMEABLE})
    for (const Wall upper : {Wall::DRAINED, Wall::IMPERMEABLE}) {
      if (outlets(lower, upper) == 0) continue;
      const double out = layer_flux(lower, upper, GAP, RATE) + layer_flux(upper, lower, GAP, RATE);
      EXPECT_NEAR(out, -RATE * GAP, 1e-14);
      if (lower == upper) {
        EXPECT_EQ(layer_flux(lower, upper, GAP, RATE), 0.5 * out);
      }
      if (lower == Wall::IMPERMEABLE) {
        EXPECT_EQ(layer_flux(lower, upper, GAP, RATE), 0.0);
      }
    }
}

}    // namespace
