// Shows that the headers of the pair law are fit for a device: each function carries the mark, none
// uses what a device does not have, and with a mark and without exceptions the bits are the same.

#include "lubcontact_defs.h"
#include "marked_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

int put_all_marked(double *out);

TEST(Marks, ChangeNoBit)
{
  std::vector<double> plain(Numbers::MOST), marked(Numbers::MOST);
  const int size = put_all(plain.data());
  ASSERT_EQ(put_all_marked(marked.data()), size);
  ASSERT_LT(size, Numbers::MOST);
  EXPECT_GT(size, 50000);
  for (std::size_t m = 0; m < plain.size(); m++) {
    ASSERT_TRUE(std::isfinite(plain[m])) << m;
    ASSERT_EQ(bits_of(plain[m]), bits_of(marked[m])) << m;
  }
}

TEST(Marks, AreOnEveryFunction)
{
  const char *headers[] = {"lubcontact_defs",       "lubcontact_vec3",
                           "lubcontact_geometry",   "lubcontact_film",
                           "lubcontact_polynomial", "lubcontact_gap",
                           "lubcontact_normal",     "lubcontact_maxwell",
                           "lubcontact_shear",      "lubcontact_roll",
                           "lubcontact_twist",      "lubcontact_friction",
                           "lubcontact_pair",       "lubcontact_repulsion",
                           "lubcontact_power",      "fluid_drag",
                           "lubcontact_stiffness",  "fluid_flow",
                           "lubcontact_strain",     "lubcontact_residual",
                           "lubcontact_stresslet",  "lubcontact_restitution"};
  const char *absent[] = {"std::min",    "std::max",    "std::clamp", "std::array",
                          "std::vector", "std::string", "throw ",     "virtual "};
  for (const std::string header : headers) {
    std::ifstream file(std::string(SUSPENSION_SOURCE) + "/" + header + ".h");
    int functions = 0;
    for (std::string line; std::getline(file, line);) {
      const std::string code = line.substr(0, line.find("//"));
      for (const char *word : absent)
        EXPECT_EQ(code.find(word), std::string::npos) << header << ": " << line;
      const std::size_t inlined = code.find("inline ");
      if (inlined == std::string::npos || code.compare(inlined, 16, "inline constexpr") == 0)
        continue;
      functions++;
      const std::size_t mark = code.find("LUBCONTACT_FN ");
      EXPECT_TRUE(mark < inlined) << header << ": " << line;
    }
    EXPECT_GT(functions, 0) << header;
  }
}

TEST(Choices, AreThoseOfTheProcessor)
{
  EXPECT_EQ(larger(1.0, 2.0), 2.0);
  EXPECT_EQ(larger(2.0, 1.0), 2.0);
  EXPECT_EQ(smaller(1.0, 2.0), 1.0);
  EXPECT_EQ(smaller(2.0, 1.0), 1.0);
  EXPECT_EQ(select(true, 1.0, 2.0), 1.0);
  EXPECT_EQ(select(false, 1.0, 2.0), 2.0);
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(larger(none, 1.0), 1.0);
  EXPECT_EQ(smaller(none, 1.0), 1.0);
  EXPECT_TRUE(std::isnan(larger(1.0, none)));
}

TEST(Choices, PiIsHalfATurn)
{
  EXPECT_EQ(std::sin(0.5 * PI), 1.0);
  EXPECT_EQ(PI, 2.0 * std::acos(0.0));
}
