#include "scene_history.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace LAMMPS_NS::Lubcontact_NS;
using LAMMPS_NS::Scene_NS::history_map;

static constexpr unsigned ALL = RESTITUTION - 1;

TEST(SceneHistory, IsCarriedOverAsItIs)
{
  for (unsigned effects = 0; effects < NUM_COMBINATIONS; effects++) {
    const unsigned mask = covering(effects);
    const std::vector<int> map = history_map(mask, mask);
    EXPECT_GE(map.size(), mask & (SQUEEZE | SHEAR) ? 3u : 0u);
    ASSERT_EQ(static_cast<int>(map.size()), LAMMPS_NS::Scene_NS::slots_of(mask).back());
    for (int m = 0; m < static_cast<int>(map.size()); m++) EXPECT_EQ(map[m], m);
  }
}

// GAP 2, SURFACE 1, SHEAR 3, ROLL 3, TWIST 1, BOND 1, DASHPOT 1
TEST(SceneHistory, LeavesOutTheSlotsOfAnEffect)
{
  const unsigned no_torque = covering(ALL & ~ROLL & ~TWIST);
  EXPECT_EQ(history_map(ALL, no_torque), (std::vector<int>{0, 1, 2, 3, 4, 5, 10}));
  EXPECT_EQ(history_map(ALL, covering(ALL & ~SQUEEZE)),
            (std::vector<int>{2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(history_map(ALL, covering(ALL & ~ADHESION)),
            (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(history_map(ALL, covering(ALL & ~FRICTION)),
            history_map(ALL, ALL));                                              // it shares SHEAR
  EXPECT_EQ(history_map(ALL, covering(ALL & ~TWIST)), history_map(ALL, ALL));    // ROLL has all
}

TEST(SceneHistory, SaysWhichSlotsAreMissing)
{
  EXPECT_EQ(history_map(FRICTION, FRICTION | THRESHOLD | RESTITUTION),
            (std::vector<int>{0, 1, 2, 3, -1}));
  EXPECT_EQ(history_map(covering(ALL & ~ROLL & ~TWIST), ALL),
            (std::vector<int>{0, 1, 2, 3, 4, 5, -1, -1, -1, -1, 6}));
}

// --- what a history with more effects gets. Bulk 3, asperities 1.5, eps 0.1, breaks at 0.15; a = 2

static NormalCoeffs sticky()
{
  NormalCoeffs c{3.0, 1.5, {0.5, 0.1, std::log(0.1), false}};
  c.gap.release_a = 0.15;
  c.gap.ln_release = std::log(0.15);
  return c;
}

using History = std::vector<double>;

static History adopt(unsigned from, unsigned to, double un, const History &old,
                     const NormalCoeffs &c = sticky())
{
  History next(LAMMPS_NS::Scene_NS::slots_of(to).back(), -9.0);
  LAMMPS_NS::Scene_NS::adopt_history(from, to, c, 2.0, un, old.data(), next.data());
  return next;
}

TEST(SceneHistory, NewFilmsBeginWithoutForce)
{
  const History old{0.03, std::log(0.03), 0.05, 1, 2, 3};    // gap, surface, shear
  const unsigned from = SQUEEZE | SHEAR;
  EXPECT_EQ(adopt(from, from | ROLL | TWIST, 9.0, old),
            (History{0.03, std::log(0.03), 0.05, 1, 2, 3, 0, 0, 0, 0}));
  EXPECT_EQ(adopt(SQUEEZE, SQUEEZE | FRICTION, 9.0, {0.03, std::log(0.03), 0.05}),
            (History{0.03, std::log(0.03), 0.05, 0, 0, 0}));
}

// springs in series at elastic rest: g (u - un) = k (eps a - u); without contact u = un
TEST(SceneHistory, NewGapsAreAtElasticRest)
{
  const double a = 2.0;
  for (const double un : {0.02, 0.1, 0.3}) {
    const double pressed = (3.0 * un + 1.5 * 0.1 * a) / 4.5;
    const double u = (un < 0.1 * a ? pressed : un) / a;
    const History next = adopt(SHEAR, SHEAR | SQUEEZE, 9.0, {un, 1, 2, 3});    // un is remembered
    ASSERT_EQ(next.size(), 6u);
    EXPECT_NEAR(next[0], u, 1e-12);
    EXPECT_NEAR(next[1], std::log(u), 1e-12);
    EXPECT_EQ(History(next.begin() + 2, next.end()), (History{un, 1, 2, 3}));
    const History first = adopt(0, SQUEEZE, un, {0.0});    // nothing is remembered
    EXPECT_NEAR(first[0], u, 1e-12);
    EXPECT_EQ(first[2], un);
  }
}

TEST(SceneHistory, NewBondsHoldWhereAsperitiesTouch)
{
  // the gap that is carried over decides, whatever the surfaces do
  for (const double u : {0.09, 0.11})
    EXPECT_EQ(adopt(SQUEEZE, SQUEEZE | ADHESION, 9.0, {u, std::log(u), 0.15}),
              (History{u, std::log(u), 0.15, u < 0.1 ? 1.0 : 0.0}));
  for (const double un : {0.19, 0.21})
    EXPECT_EQ(adopt(0, ADHESION, un, {0.0}), (History{un < 0.2 ? 1.0 : 0.0}));
}

// un 0.25 is beyond eps a = 0.2: a bond holds 3 (u - un) = 1.5 (eps a - u), an open pair has u = un
TEST(SceneHistory, NewGapsKeepTheirBond)
{
  const History held = adopt(ADHESION, SQUEEZE | ADHESION, 0.25, {1.0});
  EXPECT_NEAR(held[0], (3.0 * 0.25 + 1.5 * 0.2) / 4.5 / 2.0, 1e-12);
  EXPECT_EQ(held[3], 1.0);
  const History open = adopt(ADHESION, SQUEEZE | ADHESION, 0.25, {0.0});
  EXPECT_NEAR(open[0], 0.125, 1e-12);
  EXPECT_EQ(open[3], 0.0);
}

// g (u - un) = F exp(-u/lambda) for surfaces that do not touch
TEST(SceneHistory, NewGapsFeelTheRepulsion)
{
  NormalCoeffs c = sticky();
  c.repulsion = {0.6, 1.0 / 0.4};
  const double u = 2.0 * adopt(0, SQUEEZE | REPULSION, 0.3, {0.0}, c)[0];
  EXPECT_NEAR(3.0 * (u - 0.3), 0.6 * std::exp(-u / 0.4), 1e-12);
  EXPECT_GT(u, 0.33);
}

// un 0.25: open at 0.125, or held (0.75 + 0.3)/4.5/2, and the repulsion of either gap
TEST(SceneHistory, NewGapsKeepTheirBondUnderRepulsionToo)
{
  NormalCoeffs c = sticky();
  c.repulsion = {1e-3, 1.0 / 0.4};
  const unsigned both = ADHESION | REPULSION;
  const double held = adopt(both, SQUEEZE | both, 0.25, {1.0}, c)[0];
  const double open = adopt(both, SQUEEZE | both, 0.25, {0.0}, c)[0];
  EXPECT_NEAR(held, (3.0 * 0.25 + 1.5 * 0.2) / 4.5 / 2.0, 2e-4);
  EXPECT_NEAR(open, 0.125, 2e-4);
}
