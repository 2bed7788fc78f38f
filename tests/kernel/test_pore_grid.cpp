// Geometry of the grid: tilted cells, corners, layers.

#include "pore_case.h"

#include <set>

using namespace pore_case;

namespace {

Grid tilted()
{
  Grid g;
  g.nx = 4;
  g.ny = 3;
  g.nz = 5;
  g.cell = {{0.3, -0.2, 1.0}, 4.0, 2.5, 6.0, 1.1, -0.7, 0.4};
  return g;
}

TEST(PoreGrid, LatticeCoordinatesCountElementsAlongTheEdges)
{
  const Grid g = tilted();
  const Metric m = metric(g);
  const Cell &c = g.cell;
  const Vec3 edges[3] = {{4.0, 0.0, 0.0}, {1.1, 2.5, 0.0}, {-0.7, 0.4, 6.0}};
  testing_tools::expect_near(lattice(g, m, c.origin), {0.0, 0.0, 0.0}, 1e-15);
  testing_tools::expect_near(lattice(g, m, c.origin + edges[0]), {4.0, 0.0, 0.0}, 1e-14);
  testing_tools::expect_near(lattice(g, m, c.origin + edges[1]), {0.0, 3.0, 0.0}, 1e-14);
  testing_tools::expect_near(lattice(g, m, c.origin + edges[2]), {0.0, 0.0, 5.0}, 1e-14);
  testing_tools::expect_near(lattice(g, m, center(g, 2, 0, 4)), {2.5, 0.5, 4.5}, 1e-14);
}

TEST(PoreGrid, VolumeIsThatOfTheParallelepiped)
{
  const Grid g = tilted();
  EXPECT_DOUBLE_EQ(g.volume(), 60.0);
  EXPECT_DOUBLE_EQ(g.element_volume(), 1.0);
}

TEST(PoreGrid, SpacingIsTheSmallestHeight)
{
  Grid g;
  g.nx = g.ny = g.nz = 2;
  g.cell = {{}, 4.0, 3.0, 8.0, 0.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(spacing(g), 1.5);
  g.cell.xy = 4.0;    // edges 4 and 5 at 3 over 4: distance of the sides 12/5
  EXPECT_DOUBLE_EQ(spacing(g), 1.2);
}

TEST(PoreGrid, EachNodeIsACornerOfEightElementsOrOfFourAtAPlate)
{
  for (const Sides &sides : SIDES) {
    Grid g = tilted();
    g.lower = sides.lower;
    g.upper = sides.upper;
    EXPECT_EQ(g.nodes(), g.has_plates() ? 80u : 60u);
    std::vector<int> met(g.nodes(), 0);
    std::set<int> elements;
    for_each_element(g, [&](int e, const int *corner) {
      elements.insert(e);
      for (int c = 0; c < CORNERS; c++) met[corner[c]]++;
    });
    EXPECT_EQ(elements.size(), 60u);
    for (int j = 0; j < g.layers(); j++)
      for (int k = 0; k < g.nz; k++)
        for (int i = 0; i < g.nx; i++)
          EXPECT_EQ(met[g.index(i, j, k)], node_share(g, j) == 0.5 ? 4 : 8);
  }
}

TEST(PoreGrid, TiltThatIsNotPeriodicIsRefused)
{
  Grid g = tilted();
  EXPECT_TRUE(is_possible(g));
  g.lower = Wall::DRAINED;
  EXPECT_FALSE(is_possible(g));
  g.upper = Wall::IMPERMEABLE;
  EXPECT_FALSE(is_possible(g));
  g.cell.xy = g.cell.yz = 0.0;
  EXPECT_TRUE(is_possible(g));
  g.nz = 0;
  EXPECT_FALSE(is_possible(g));
}

}    // namespace
