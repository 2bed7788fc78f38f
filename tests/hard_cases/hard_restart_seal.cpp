// The checksum that guards restart files.

#include "restart_seal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

// first 52 bits of what the authors of FNV-1a publish for these strings
TEST(RestartSeal, PublishedValues)
{
  EXPECT_EQ(suspension::seal("", 0), static_cast<double>(0xcbf29ce484222325ULL >> 12));
  EXPECT_EQ(suspension::seal("a", 1), static_cast<double>(0xaf63dc4c8601ec8cULL >> 12));
  EXPECT_EQ(suspension::seal("foobar", 6), static_cast<double>(0x85944171f73967e8ULL >> 12));
}

TEST(RestartSeal, AnyBitChangesIt)
{
  std::string bytes(128, '\0');
  for (std::size_t n = 0; n < bytes.size(); n++) bytes[n] = static_cast<char>(n * n);
  const double whole = suspension::seal(bytes.data(), bytes.size());
  EXPECT_EQ(whole, std::floor(whole));
  for (std::size_t n = 0; n < bytes.size(); n++)
    for (int bit = 0; bit < 8; bit++) {
      std::string damaged = bytes;
      damaged[n] = static_cast<char>(damaged[n] ^ (1 << bit));
      EXPECT_NE(suspension::seal(damaged.data(), damaged.size()), whole) << n << " " << bit;
    }
  EXPECT_NE(suspension::seal(bytes.data(), bytes.size() - 1), whole);
}

TEST(RestartSeal, PartsOfAnAtom)
{
  const double inf = HUGE_VAL, nan = std::nan("");
  double values[] = {2, 7, 3, 8, 9, 2, 6};
  EXPECT_EQ(suspension::part_of_atom(values, 0, 7), values);
  EXPECT_EQ(suspension::part_of_atom(values, 2, 7), values + 5);
  for (const double damaged : {0.0, -3.0, 5.0, 1e300, inf, -inf, nan}) {
    values[2] = damaged;
    EXPECT_EQ(suspension::part_of_atom(values, 2, 7), nullptr) << damaged;
  }
}
