// Pairs of spheres eight at once: as one after the other.

#include "hydro_pairs.h"

#include "hydro_wide.h"
#include "tools.h"

using namespace LAMMPS_NS::Hydro_NS;
using testing_tools::expect_near;
using testing_tools::Random;

namespace {

// as many as fill some blocks, and a part of one
TEST(HydroPairs, BlocksAreTheirPairs)
{
  Random rnd(91);
  constexpr int ATOMS = 7;
  std::vector<Load> loads;
  for (int n = 0; n < ATOMS; n++)
    loads.push_back({rnd.vector(1.0), {rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)}});
  std::vector<PairBlock> blocks;
  std::vector<Motion> expected(ATOMS), found(ATOMS);
  for (int i = 0; i < ATOMS; i++)
    for (int j = 0; j < i; j++) {
      const PairResponse r =
          missing_response(rnd.vector(3.0), make_body(1.0, 0.9), make_body(1.3, 0.9), 0.9);
      add_to(blocks, i, j, r);
      add_pair(r, 0.3, loads[i], loads[j], expected[i], expected[j]);
    }
  EXPECT_EQ(blocks.size(), 3U);
  add_pairs(blocks, 0.3, loads.data(), found.data());
  for (int n = 0; n < ATOMS; n++) {
    expect_near(found[n].velocity, expected[n].velocity, 1e-14);
    expect_near(found[n].gradient.x, expected[n].gradient.x, 1e-14);
    expect_near(found[n].gradient.y, expected[n].gradient.y, 1e-14);
    expect_near(found[n].gradient.z, expected[n].gradient.z, 1e-14);
  }
}

}    // namespace
