// Shows which doubles of history each mask keeps, and how they change under i <-> j.

#include "lubcontact_effects.h"
#include "tools.h"

using namespace lubcontact;
using namespace testing_tools;

// Without adhesion; one letter a double, in order: g gap and its logarithm, u surface, s shear,
// r roll, t twist.
static constexpr const char *LAYOUT[32] = {
    "",         "ggu",        "usss",     "ggusss",    "usss",      "ggusss",   "usss",
    "ggusss",   "urrr",       "ggurrr",   "usssrrr",   "ggusssrrr", "usssrrr",  "ggusssrrr",
    "usssrrr",  "ggusssrrr",  "ut",       "ggut",      "ussst",     "ggussst",  "ussst",
    "ggussst",  "ussst",      "ggussst",  "urrrt",     "ggurrrt",   "usssrrrt", "ggusssrrrt",
    "usssrrrt", "ggusssrrrt", "usssrrrt", "ggusssrrrt"};

// A bond (b) comes last.
static std::string layout_of(unsigned mask)
{
  return std::string(LAYOUT[mask % 32]) + (mask & ADHESION ? "b" : "");
}

TEST(Effects, BitsOfTheMaskAreTheDocumentedOnes)
{
  EXPECT_EQ(SQUEEZE, 1u);
  EXPECT_EQ(SHEAR, 2u);
  EXPECT_EQ(FRICTION, 4u);
  EXPECT_EQ(ROLL, 8u);
  EXPECT_EQ(TWIST, 16u);
  EXPECT_EQ(THRESHOLD, 32u);
  EXPECT_EQ(ADHESION, 64u);
  EXPECT_EQ(REPULSION, 128u);
  EXPECT_EQ(NUM_COMBINATIONS, 256u);
}

TEST(Effects, ThresholdIsNothingWithoutFriction)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    const bool idle = (mask & THRESHOLD) && !(mask & FRICTION);
    EXPECT_EQ(canonical(mask), idle ? mask - THRESHOLD : mask);
  }
}

TEST(Effects, EachBitSwitchesItsOwnEffect)
{
  for_all_masks([](auto mask) {
    using E = Effects<mask.value>;
    EXPECT_EQ(E::squeeze, mask.value % 2 == 1);
    EXPECT_EQ(E::shear, mask.value / 2 % 2 == 1);
    EXPECT_EQ(E::friction, mask.value / 4 % 2 == 1);
    EXPECT_EQ(E::roll, mask.value / 8 % 2 == 1);
    EXPECT_EQ(E::twist, mask.value / 16 % 2 == 1);
    EXPECT_EQ(E::threshold, mask.value / 32 % 2 == 1 && E::friction);
    EXPECT_EQ(E::adhesion, mask.value / 64 % 2 == 1);
    EXPECT_EQ(E::repulsion, mask.value / 128 == 1);
    EXPECT_EQ(E::normal, mask.value / 64 * 64);
    const std::string layout = layout_of(mask.value);
    EXPECT_EQ(E::tangential, layout.find('s') != std::string::npos);
    EXPECT_EQ(E::reads_gap, layout.find_first_of("srt") != std::string::npos);
    EXPECT_EQ(E::turns, layout.find_first_of("sr") != std::string::npos);
  });
}

TEST(Effects, HistoryHasTheSlotsOfTheTableWithoutGaps)
{
  for_all_masks([](auto mask) {
    using E = Effects<mask.value>;
    std::string layout(static_cast<std::size_t>(E::HISTORY_SIZE), '-');
    auto mark = [&layout](bool on, int slot, std::size_t size, char letter) {
      if (!on) return;
      ASSERT_LE(static_cast<std::size_t>(slot) + size, layout.size());
      layout.replace(static_cast<std::size_t>(slot), size, size, letter);
    };
    mark(E::gap_history, E::GAP_SLOT, 2, 'g');
    mark(E::surface_history, E::SURFACE_SLOT, 1, 'u');
    mark(E::tangential, E::SHEAR_SLOT, 3, 's');
    mark(E::roll, E::ROLL_SLOT, 3, 'r');
    mark(E::twist, E::TWIST_SLOT, 1, 't');
    mark(E::adhesion, E::BOND_SLOT, 1, 'b');
    EXPECT_EQ(layout, layout_of(mask.value));
  });
}

TEST(ExchangeHistory, ScalarsAreEvenAndVectorsAreOdd)
{
  for_all_masks([](auto mask) {
    const std::string layout = layout_of(mask.value);
    double source[12], target[12];
    for (int m = 0; m < 12; m++) {
      source[m] = m + 1.0;
      target[m] = -77.0;
    }
    exchange_history<Effects<mask.value>>(source, target);
    for (std::size_t m = 0; m < 12; m++) {
      if (m >= layout.size())
        EXPECT_EQ(target[m], -77.0) << "wrote beyond the history, slot " << m;
      else if (layout[m] == 's' || layout[m] == 'r')
        EXPECT_EQ(target[m], -source[m]) << "slot " << m;
      else
        EXPECT_EQ(target[m], source[m]) << "slot " << m;
    }
  });
}

TEST(ExchangeHistory, TwiceIsTheIdentityAlsoInPlace)
{
  for_all_masks([](auto mask) {
    double history[11];
    for (int m = 0; m < 11; m++) history[m] = 0.5 - m;
    exchange_history<Effects<mask.value>>(history, history);
    exchange_history<Effects<mask.value>>(history, history);
    for (int m = 0; m < 11; m++) EXPECT_EQ(history[m], 0.5 - m);
  });
}
