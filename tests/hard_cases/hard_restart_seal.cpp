// The checksum that guards restart files.

#include "restart_seal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

// first 52 bits of what the authors of FNV-1a publish for these strings
TEST(RestartSeal, PublishedValues)
{
  EXPECT_EQ(LAMMPS_NS::Suspension_NS::seal("", 0),
            static_cast<double>(0xcbf29ce484222325ULL >> 12));
  EXPECT_EQ(LAMMPS_NS::Suspension_NS::seal("a", 1),
            static_cast<double>(0xaf63dc4c8601ec8cULL >> 12));
  EXPECT_EQ(LAMMPS_NS::Suspension_NS::seal("foobar", 6),
            static_cast<double>(0x85944171f73967e8ULL >> 12));
}

TEST(RestartSeal, AnyBitChangesIt)
{
  std::string bytes(128, '\0');
  for (std::size_t n = 0; n < bytes.size(); n++) bytes[n] = static_cast<char>(n * n);
  const double whole = LAMMPS_NS::Suspension_NS::seal(bytes.data(), bytes.size());
  EXPECT_EQ(whole, std::floor(whole));
  for (std::size_t n = 0; n < bytes.size(); n++)
    for (int bit = 0; bit < 8; bit++) {
      std::string damaged = bytes;
      damaged[n] = static_cast<char>(damaged[n] ^ (1 << bit));
      EXPECT_NE(LAMMPS_NS::Suspension_NS::seal(damaged.data(), damaged.size()), whole)
          << n << " " << bit;
    }
  EXPECT_NE(LAMMPS_NS::Suspension_NS::seal(bytes.data(), bytes.size() - 1), whole);
}

TEST(RestartSeal, PartsOfAnAtom)
{
  const double inf = HUGE_VAL, nan = std::nan("");
  double values[] = {2, 7, 3, 8, 9, 2, 6};
  EXPECT_EQ(LAMMPS_NS::Suspension_NS::part_of_atom(values, 0, 7), values);
  EXPECT_EQ(LAMMPS_NS::Suspension_NS::part_of_atom(values, 2, 7), values + 5);
  for (const double damaged : {0.0, -3.0, 5.0, 1e300, inf, -inf, nan}) {
    values[2] = damaged;
    EXPECT_EQ(LAMMPS_NS::Suspension_NS::part_of_atom(values, 2, 7), nullptr) << damaged;
  }
}

namespace {

struct Small {
  double a, b;
};
struct Large {
  double a, b, c, d, e;
};

// what LAMMPS hands to restart(): the bytes after the length, in memory of exactly that size
template <class State> std::vector<char> written(const State &state)
{
  FILE *fp = std::tmpfile();
  LAMMPS_NS::Suspension_NS::write_sealed(fp, state);
  std::rewind(fp);
  int size = 0;
  EXPECT_EQ(std::fread(&size, sizeof(size), 1, fp), 1U);
  std::vector<char> bytes(static_cast<std::size_t>(size));
  EXPECT_EQ(std::fread(bytes.data(), 1, bytes.size(), fp), bytes.size());
  EXPECT_EQ(std::fgetc(fp), EOF);
  std::fclose(fp);
  return bytes;
}

}    // namespace

TEST(RestartSeal, RecordThereAndBack)
{
  const std::vector<char> bytes = written(Large{1, 2, 3, 4, 5});
  Large back{};
  EXPECT_EQ(LAMMPS_NS::Suspension_NS::read_sealed(bytes.data(), back), nullptr);
  EXPECT_EQ(back.a, 1);
  EXPECT_EQ(back.e, 5);
}

TEST(RestartSeal, RecordOfAnotherLength)
{
  Large large{7, 7, 7, 7, 7};
  const std::vector<char> shorter = written(Small{1, 2});    // the sanitizer sees a byte behind it
  EXPECT_NE(
      std::strstr(LAMMPS_NS::Suspension_NS::read_sealed(shorter.data(), large), "another version"),
      nullptr);
  EXPECT_EQ(large.a, 7);
  Small small{7, 7};
  const std::vector<char> longer = written(Large{1, 2, 3, 4, 5});
  EXPECT_NE(
      std::strstr(LAMMPS_NS::Suspension_NS::read_sealed(longer.data(), small), "another version"),
      nullptr);
  const std::vector<double> bare = {32.0, 0.5};    // without a mark, as earlier versions wrote it
  EXPECT_NE(
      LAMMPS_NS::Suspension_NS::read_sealed(reinterpret_cast<const char *>(bare.data()), small),
      nullptr);
}

TEST(RestartSeal, AnyBitOfARecordCounts)
{
  const std::vector<char> whole = written(Small{1.5, -2.5});
  for (std::size_t n = 0; n < whole.size(); n++)
    for (int bit = 0; bit < 8; bit++) {
      std::vector<char> bytes = whole;
      bytes[n] = static_cast<char>(bytes[n] ^ (1 << bit));
      Small state{7, 7};
      EXPECT_NE(LAMMPS_NS::Suspension_NS::read_sealed(bytes.data(), state), nullptr)
          << n << " " << bit;
      EXPECT_EQ(state.a, 7);
    }
}
