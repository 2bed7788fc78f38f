// Shows which doubles of history each mask keeps, and how they change under i <-> j.

#include "lubcontact_effects.h"
#include "tools.h"

#include <array>
#include <string>
#include <utility>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

// Without adhesion and restitution; one letter a double, in order: g gap and its logarithm,
// u surface, s shear, r roll, t twist.
static constexpr const char *LAYOUT[32] = {
    "",         "ggu",        "usss",     "ggusss",    "usss",      "ggusss",   "usss",
    "ggusss",   "urrr",       "ggurrr",   "usssrrr",   "ggusssrrr", "usssrrr",  "ggusssrrr",
    "usssrrr",  "ggusssrrr",  "ut",       "ggut",      "ussst",     "ggussst",  "ussst",
    "ggussst",  "ussst",      "ggussst",  "urrrt",     "ggurrrt",   "usssrrrt", "ggusssrrrt",
    "usssrrrt", "ggusssrrrt", "usssrrrt", "ggusssrrrt"};

// A bond (b) and a dashpot (d), which needs the surface, come last.
static std::string layout_of(unsigned mask)
{
  const std::string basic = mask % 32 == 0 && (mask & RESTITUTION) ? "u" : LAYOUT[mask % 32];
  return basic + (mask & ADHESION ? "b" : "") + (mask & RESTITUTION ? "d" : "");
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
  EXPECT_EQ(RESTITUTION, 256u);
  EXPECT_EQ(NUM_COMBINATIONS, 512u);
}

TEST(Effects, ThresholdIsNothingWithoutFriction)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    const bool idle = (mask & THRESHOLD) && !(mask & FRICTION);
    EXPECT_EQ(canonical(mask), idle ? mask - THRESHOLD : mask);
  }
}

// What the compiler knows of a mask, as numbers: the tests below are compiled once, not for each
// mask.
struct Traits {
  bool squeeze, shear, friction, roll, twist, threshold, adhesion, repulsion, restitution;
  unsigned normal;
  bool tangential, reads_gap, turns, gap_history, surface_history;
  int gap, surface, shears, rolls, twists, bond, dashpot, size;
  void (*exchange)(const double *, double *);
};

template <unsigned MASK> static constexpr Traits traits_of()
{
  using E = Effects<MASK>;
  return {E::squeeze,      E::shear,        E::friction,        E::roll,
          E::twist,        E::threshold,    E::adhesion,        E::repulsion,
          E::restitution,  E::normal,       E::tangential,      E::reads_gap,
          E::turns,        E::gap_history,  E::surface_history, E::GAP_SLOT,
          E::SURFACE_SLOT, E::SHEAR_SLOT,   E::ROLL_SLOT,       E::TWIST_SLOT,
          E::BOND_SLOT,    E::DASHPOT_SLOT, E::HISTORY_SIZE,    &exchange_history<E>};
}

// a constant: filled at run time it takes a sanitizing compiler two minutes
template <unsigned... MASK>
static constexpr std::array<Traits, sizeof...(MASK)>
all_traits(std::integer_sequence<unsigned, MASK...>)
{
  return {traits_of<MASK>()...};
}

static constexpr auto TRAITS = all_traits(std::make_integer_sequence<unsigned, NUM_COMBINATIONS>());

TEST(Effects, EachBitSwitchesItsOwnEffect)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    const Traits &e = TRAITS[mask];
    SCOPED_TRACE(mask);
    EXPECT_EQ(e.squeeze, mask % 2 == 1);
    EXPECT_EQ(e.shear, mask / 2 % 2 == 1);
    EXPECT_EQ(e.friction, mask / 4 % 2 == 1);
    EXPECT_EQ(e.roll, mask / 8 % 2 == 1);
    EXPECT_EQ(e.twist, mask / 16 % 2 == 1);
    EXPECT_EQ(e.threshold, mask / 32 % 2 == 1 && e.friction);
    EXPECT_EQ(e.adhesion, mask / 64 % 2 == 1);
    EXPECT_EQ(e.repulsion, mask / 128 % 2 == 1);
    EXPECT_EQ(e.restitution, mask / 256 == 1);
    EXPECT_EQ(e.normal, mask / 64 % 4 * 64);
    const std::string layout = layout_of(mask);
    EXPECT_EQ(e.tangential, layout.find('s') != std::string::npos);
    EXPECT_EQ(e.reads_gap, layout.find_first_of("srt") != std::string::npos);
    EXPECT_EQ(e.turns, layout.find_first_of("sr") != std::string::npos);
  }
}

TEST(Effects, HistoryHasTheSlotsOfTheTableWithoutGaps)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    const Traits &e = TRAITS[mask];
    SCOPED_TRACE(mask);
    std::string layout(static_cast<std::size_t>(e.size), '-');
    auto mark = [&layout](bool on, int slot, std::size_t size, char letter) {
      if (!on) return;
      ASSERT_LE(static_cast<std::size_t>(slot) + size, layout.size());
      layout.replace(static_cast<std::size_t>(slot), size, size, letter);
    };
    mark(e.gap_history, e.gap, 2, 'g');
    mark(e.surface_history, e.surface, 1, 'u');
    mark(e.tangential, e.shears, 3, 's');
    mark(e.roll, e.rolls, 3, 'r');
    mark(e.twist, e.twists, 1, 't');
    mark(e.adhesion, e.bond, 1, 'b');
    mark(e.restitution, e.dashpot, 1, 'd');
    EXPECT_EQ(layout, layout_of(mask));
  }
}

TEST(ExchangeHistory, ScalarsAreEvenAndVectorsAreOdd)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    const std::string layout = layout_of(mask);
    SCOPED_TRACE(mask);
    double source[13], target[13];
    for (int m = 0; m < 13; m++) {
      source[m] = m + 1.0;
      target[m] = -77.0;
    }
    TRAITS[mask].exchange(source, target);
    for (std::size_t m = 0; m < 13; m++) {
      if (m >= layout.size())
        EXPECT_EQ(target[m], -77.0) << "wrote beyond the history, slot " << m;
      else if (layout[m] == 's' || layout[m] == 'r')
        EXPECT_EQ(target[m], -source[m]) << "slot " << m;
      else
        EXPECT_EQ(target[m], source[m]) << "slot " << m;
    }
  }
}

TEST(ExchangeHistory, TwiceIsTheIdentityAlsoInPlace)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    SCOPED_TRACE(mask);
    double history[12];
    for (int m = 0; m < 12; m++) history[m] = 0.5 - m;
    TRAITS[mask].exchange(history, history);
    TRAITS[mask].exchange(history, history);
    for (int m = 0; m < 12; m++) EXPECT_EQ(history[m], 0.5 - m);
  }
}
