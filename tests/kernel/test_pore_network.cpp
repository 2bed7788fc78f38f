// Pores and their connections.

#include "network_case.h"

using namespace network_case;

namespace {

TEST(PoreNetwork, PoresOfALatticeFillItsCell)
{
  Random rnd(311);
  for (const double tilt : {0.0, 0.4}) {
    Lattice s = make_lattice(2, rnd, 0.03, tilt);
    Network net;
    EXPECT_EQ(connect(s.pores, 16, net), 0);
    EXPECT_EQ(net.pores.size(), 96u);
    EXPECT_EQ(net.links.size(), 192u);
    double volume = 0.0;
    for (const PoreShape &shape : s.flow.shape) {
      EXPECT_GT(shape.volume, 0.05);
      volume += shape.volume;
    }
    EXPECT_NEAR(volume, s.edge_volume(), 1e-13);
    int places = 0;
    for (int k = 0; k < 16; k++)
      for (int n = net.first[k]; n < net.first[k + 1]; n++, places++)
        EXPECT_EQ(net.pores[net.at[n].pore][net.at[n].corner].particle, k);
    EXPECT_EQ(places, 4 * 96);
  }
}

TEST(PoreNetwork, LinkedPoresShareTheCornersOfAFacet)
{
  Random rnd(312);
  const Lattice s = make_lattice(2, rnd, 0.03, 0.3);
  for (const Link &link : s.net.links) {
    const auto a = facet_opposite(s.net.pores[link.pore[0]], link.opposite[0]);
    const auto b = facet_opposite(s.net.pores[link.pore[1]], link.opposite[1]);
    Vec3 left, right;
    for (int n = 0; n < 3; n++) {
      left = left + s.x[a[n].particle] + shift(s.cell, a[n].image);
      right = right + s.x[b[n].particle] + shift(s.cell, sum(b[n].image, link.image));
    }
    EXPECT_NEAR(norm(left - right), 0.0, 1e-13);
    EXPECT_LT(link.pore[0], link.pore[1]);
  }
}

TEST(PoreNetwork, MissingPoreLeavesFourFacetsOpen)
{
  Random rnd(313);
  Lattice s = make_lattice(2, rnd);
  Network net;
  s.pores.pop_back();
  EXPECT_EQ(connect(s.pores, 16, net), 4);
  s.pores.push_back(s.pores.front());    // twice
  EXPECT_EQ(connect(s.pores, 16, net), 4 + 3 * 4);
}

TEST(PoreNetwork, OrderAndImageOfThePoresDoNotMatter)
{
  Random rnd(314);
  const Lattice s = make_lattice(3, rnd);
  std::vector<Pore> others(s.pores.rbegin(), s.pores.rend());
  for (Pore &pore : others) {
    const Image away = {rnd.coin() ? 1 : -2, rnd.coin() ? 1 : 0, rnd.coin() ? 3 : 0};
    for (Corner &c : pore) c.image = sum(c.image, away);
    std::swap(pore[0], pore[3]);
    pore = canonical(pore);
  }
  Network net;
  EXPECT_EQ(connect(others, 54, net), 0);
  EXPECT_TRUE(std::equal(net.pores.begin(), net.pores.end(), s.net.pores.begin()));
}

TEST(PoreNetwork, PressureStaysInPoresThatStay)
{
  Random rnd(315);
  const Lattice s = make_lattice(2, rnd);
  const std::vector<double> p = random_pressure(rnd, s), volume(p.size(), 1.0);
  EXPECT_EQ(carry_over(s.net.pores, volume, p, s.net.pores, volume), p);
}

// two tetrahedra become three about the line between their tips
TEST(PoreNetwork, ExchangedPoresKeepTheFluidOfTheirCavity)
{
  auto pore = [](int a, int b, int c, int d) {
    Pore made;
    made[0].particle = a;
    made[1].particle = b;
    made[2].particle = c;
    made[3].particle = d;
    return canonical(made);
  };
  std::vector<Pore> before = {pore(0, 1, 2, 3), pore(0, 1, 2, 4), pore(5, 6, 7, 8),
                              pore(6, 7, 8, 9)};
  std::vector<Pore> now = {pore(0, 1, 3, 4), pore(0, 2, 3, 4), pore(1, 2, 3, 4), pore(5, 6, 7, 8),
                           pore(6, 7, 8, 10)};
  const auto p = carry_over(before, {1.0, 3.0, 2.0, 2.0}, {5.0, 1.0, 7.0, -3.0}, now,
                            {1.0, 1.0, 2.0, 2.0, 4.0});
  const std::vector<double> expected = {2.0, 2.0, 2.0, 7.0, -1.5};
  EXPECT_EQ(p, expected);
}

TEST(PoreNetwork, TiesAreBrokenByTheTagAlone)
{
  const Vec3 a = hashed_direction(7, 0), again = hashed_direction(7, 0), b = hashed_direction(7, 1);
  EXPECT_EQ(a.x, again.x);
  EXPECT_NE(a.x, b.x);
  Vec3 mean;
  double square = 0.0;
  for (unsigned tag = 1; tag <= 10000; tag++) {
    const Vec3 d = hashed_direction(tag, 3);
    EXPECT_LE(std::fmax(std::fabs(d.x), std::fmax(std::fabs(d.y), std::fabs(d.z))), 1.0);
    mean = mean + 1e-4 * d;
    square += 1e-4 * dot(d, d);
  }
  EXPECT_NEAR(norm(mean), 0.0, 0.03);
  EXPECT_NEAR(square, 1.0, 0.03);
}

}    // namespace
