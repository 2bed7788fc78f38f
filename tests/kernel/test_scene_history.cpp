#include "scene_history.h"

#include <gtest/gtest.h>

using namespace lubcontact;
using scene::history_map;

static constexpr unsigned ALL = NUM_COMBINATIONS - 1;

TEST(SceneHistory, IsCarriedOverAsItIs)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    const std::vector<int> map = history_map(mask, mask);
    ASSERT_EQ(static_cast<int>(map.size()), scene::slots_of(mask).back());
    for (int m = 0; m < static_cast<int>(map.size()); m++) EXPECT_EQ(map[m], m);
  }
}

// GAP 2, SURFACE 1, SHEAR 3, ROLL 3, TWIST 1, BOND 1
TEST(SceneHistory, LeavesOutTheSlotsOfAnEffect)
{
  EXPECT_EQ(history_map(ALL, ALL & ~TWIST), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 10}));
  EXPECT_EQ(history_map(ALL, ALL & ~ROLL), (std::vector<int>{0, 1, 2, 3, 4, 5, 9, 10}));
  EXPECT_EQ(history_map(ALL, ALL & ~SQUEEZE), (std::vector<int>{2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(history_map(ALL, ALL & ~ADHESION), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(history_map(ALL, ALL & ~FRICTION), history_map(ALL, ALL));    // it shares SHEAR
  EXPECT_EQ(history_map(ALL, ALL & ~SHEAR), history_map(ALL, ALL));
}

TEST(SceneHistory, SaysWhichSlotsAreMissing)
{
  EXPECT_EQ(history_map(ALL & ~ROLL, ALL), (std::vector<int>{0, 1, 2, 3, 4, 5, -1, -1, -1, 6, 7}));
}
