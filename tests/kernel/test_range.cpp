// Which pairs act: by distance, sizes and faces.

#include "lubcontact_range.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace LAMMPS_NS::Lubcontact_NS;

namespace {

TypeCoeffs rough(double eps)
{
  TypeCoeffs c;
  c.g = c.kt = c.asperity = 1e4;
  c.roughness_a = eps;
  return c;
}

RangeTable table(double reach_a)
{
  Settings s;
  s.reach_a = reach_a;
  RangeTable t;
  t.resize(2);
  t.set(1, 1, s, rough(0.01));
  t.set(1, 2, s, rough(0.05));
  t.set(2, 2, s, rough(0.1));
  return t;
}

double acting(const RangeTable &t, double un, double ri, double rj, const char *faces = nullptr,
              int type_j = 1)
{
  const double r = ri + rj + un;
  return t.around(1, ri, faces).acting(r * r, rj, type_j, 0);
}

TEST(Range, EndsAtAGapInUnitsOfTheEffectiveRadius)
{
  const RangeTable t = table(0.5);
  const double a = 2.0 * 1.0 * 3.0 / 4.0;    // harmonic
  EXPECT_DOUBLE_EQ(acting(t, 0.4999 * a, 1.0, 3.0), a);
  EXPECT_EQ(acting(t, 0.5001 * a, 1.0, 3.0), 0.0);
  EXPECT_DOUBLE_EQ(acting(t, -0.1, 1.0, 3.0), a);
}

TEST(Range, TheQuickTestNeverLosesAPair)
{
  // sizes of any ratio: the harmonic radius is at most the mean one, which the quick test takes
  const RangeTable t = table(1.0);
  for (double ratio = 1.0; ratio < 1e3; ratio *= 1.7) {
    const double a = 2.0 * ratio / (1.0 + ratio);
    EXPECT_DOUBLE_EQ(acting(t, 0.999 * a, 1.0, ratio), a) << ratio;
    EXPECT_EQ(acting(t, 1.001 * a, 1.0, ratio), 0.0) << ratio;
  }
}

TEST(Range, WithoutACommonFaceOnlyWhatTouchesActs)
{
  const RangeTable t = table(0.5);
  const char none = 0, shared = 1;
  EXPECT_EQ(acting(t, 0.02, 1.0, 1.0, &none), 0.0);
  EXPECT_DOUBLE_EQ(acting(t, 0.009, 1.0, 1.0, &none), 1.0);
  EXPECT_DOUBLE_EQ(acting(t, 0.02, 1.0, 1.0, &shared), 1.0);
  EXPECT_DOUBLE_EQ(acting(t, 0.04, 1.0, 1.0, &none, 2), 1.0);    // rougher
}

TEST(Range, IsTheSameFromEitherSide)
{
  const RangeTable t = table(0.5);
  EXPECT_EQ(t.reach_a_of(1, 2), t.reach_a_of(2, 1));
  EXPECT_EQ(t.of(1, 2).normal.gap.eps_a, t.of(2, 1).normal.gap.eps_a);
}

}    // namespace
