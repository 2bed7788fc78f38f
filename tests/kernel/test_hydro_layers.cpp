// Bricks of points and layers of a periodic grid.

#include "hydro_layers.h"
#include "tools.h"

using namespace LAMMPS_NS::Hydro_NS;
using testing_tools::Random;

namespace {

const Points POINTS = {6, 4, 10};
const Brick WIDE = {{-9, 3, -4}, {20, 7, 17}};    // with several images of the same points

std::size_t of_cell(int i, int j, int k)
{
  return (static_cast<std::size_t>(wrapped(k, 10)) * 4 + wrapped(j, 4)) * 6 + wrapped(i, 6);
}

TEST(HydroLayers, SharesAreAllOfIt)
{
  for (const int ranks : {1, 3, 7, 16}) {
    int next = 0;
    for (int r = 0; r < ranks; r++) {
      EXPECT_EQ(share(10, r, ranks).first, next);
      next = share(10, r, ranks).last;
    }
    EXPECT_EQ(next, 10);
  }
  EXPECT_EQ(wrapped(-1, 4), 3);
  EXPECT_EQ(wrapped(-8, 4), 0);
  EXPECT_EQ(wrapped(9, 4), 1);
}

// three and six components, padded to four and eight
TEST(HydroLayers, ImagesAddUpAndComeBack)
{
  Random rnd(21);
  for (const int components : {VECTOR, WITH_COMPANION}) {
    const int stride = padded(components);
    std::vector<double> field(stride * WIDE.points());
    for (double &value : field) value = rnd.uniform(-1.0, 1.0);
    std::vector<double> expected(components * 240);
    const auto for_each = [&](const auto &f) {
      for (int c = 0; c < components; c++)
        for (int k = -4; k < 13; k++)
          for (int j = 3; j < 10; j++)
            for (int i = -9; i < 11; i++)
              f(240 * c + of_cell(i, j, k), stride * WIDE.index(i, j, k) + c);
    };
    for_each([&](std::size_t at, std::size_t from) {
      expected[at] += field[from];
    });
    for (const int ranks : {1, 3, 16}) {
      std::vector<double> back(field.size(), 99.0);
      for (int r = 0; r < ranks; r++) {
        const Share mine = share(10, r, ranks);
        std::vector<double> layers(24 * components * mine.number());
        std::vector<double> numbers(numbers_in(WIDE, POINTS, mine, components));
        pack_brick(WIDE, POINTS, mine, components, field.data(), numbers.data());
        add_to_layers(WIDE, POINTS, mine, components, numbers.data(), layers.data());
        for (int c = 0; c < components; c++)
          for (int n = 0; n < 24 * mine.number(); n++)
            EXPECT_NEAR(layers[24 * mine.number() * c + n], expected[240 * c + 24 * mine.first + n],
                        1e-14);
        take_from_layers(WIDE, POINTS, mine, components, layers.data(), numbers.data());
        unpack_brick(WIDE, POINTS, mine, components, numbers.data(), back.data());
      }
      for_each([&](std::size_t at, std::size_t to) {
        EXPECT_NEAR(back[to], expected[at], 1e-14);
      });
    }
  }
}

}    // namespace
