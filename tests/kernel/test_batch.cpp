// Shows that a batch is the pair by itself, bit for bit, wherever it says that the step was usual.

#include "batch_case.h"

#include <vector>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

// Compares a batch of random pairs with the same pairs one by one; returns how many were usual.
template <class E> int compare(Random &rnd, const Film &f, double dt)
{
  std::vector<Case> cases;
  Batch b{};
  for (int l = 0; l < Batch::WIDTH; l++) {
    cases.emplace_back(rnd);
    cases.back().template set_history<E>(rnd, cases.back().geometry());
    put(cases.back(), b, l);
  }
  step_batch<E>(b, f, dt);
  if constexpr (E::residual) stresslets_together<E>(b, f);

  int usual = 0;
  for (int l = 0; l < Batch::WIDTH; l++) {
    if (b.usual[l] == 0.0) continue;
    usual++;
    Case &k = cases[static_cast<std::size_t>(l)];
    const PairGeometry g = k.geometry();
    next_history<E>(k.c, f, g, k.i, k.j, dt, k.history, k.history);
    for (int m = 0; m < E::HISTORY_SIZE; m++) EXPECT_EQ(b.history[m][l], k.history[m]);
    const Load load = pair_load<E>(k.c, f, g, k.history);
    expect_same(get_lane(b.force, l), force_on_i(load, g));
    expect_same(get_lane(b.torque_i, l), torque_on_i(load, g));
    if (E::turns || E::twist) expect_same(get_lane(b.torque_j, l), torque_on_j(load, g));
    if constexpr (E::residual) {
      const FilmStresslet both = present_stresslet<E>(k.c, f, g, load, k.history);
      const SymmetricTensor s = both.normal + both.tangential;
      const double six[6] = {s.xx, s.yy, s.zz, s.xy, s.xz, s.yz};
      for (int n = 0; n < 6; n++) EXPECT_EQ(b.stresslet[n][l], six[n]);
    }
  }
  return usual;
}

}    // namespace

TEST(Batch, IsThePairByItselfBitForBit)
{
  for (const Range rule : {Range::CUT, Range::SHIFTED}) {
    const Film f = make_film(1.0, 0.5, rule, 0.6);
    auto check = [&f](auto mask) {
      Random rnd(mask.value);
      int usual = 0;
      for (int trial = 0; trial < 200; trial++)
        usual += compare<Effects<mask.value>>(rnd, f, rnd.log_uniform(1e-5, 1e-2));
      EXPECT_GT(usual, 1000);    // of 1600
    };
    for_each_mask(check);
    for_extended_masks(check);
  }
}

TEST(Batch, OfResidualFilmsToo)
{
  Film f = make_film(1.0, 0.5, Range::RESIDUAL, 0.6);
  f.strain = {0.3, -0.1, -0.2, 0.5, 0.2, -0.4};
  Random rnd(5);
  for (const unsigned mask : {27u, 31u, 63u, 95u, 155u, 255u})
    with_residual_effects(covering_residual(mask), [&](auto effects) {
      int usual = 0;
      for (int trial = 0; trial < 200; trial++)
        usual += compare<decltype(effects)>(rnd, f, rnd.log_uniform(1e-5, 1e-2));
      EXPECT_GT(usual, 1000) << mask;
    });
}

TEST(Batch, SaysWhichStepsAreNotUsual)
{
  using E = Effects<SQUEEZE>;
  const Film f = make_film(1.0, 0.5, Range::CUT, 0.6);
  Random rnd(1);
  const Case k(rnd);
  const double eps = 0.03;
  auto is_usual = [&](double u, double un0, double un1, double dt, const Film &film) {
    Batch b{};
    for (int l = 0; l < Batch::WIDTH; l++) {
      put(k, b, l);
      put_lane({2.0 + un1, 0.0, 0.0}, b.x, l);
      b.radius_i[l] = b.radius_j[l] = b.a[l] = 1.0;
      b.g[l] = b.asperity[l] = 1000.0;
      b.alpha[l] = 1.0;
      b.eps_a[l] = eps;
      b.ln_eps[l] = std::log(eps);
      b.history[E::GAP_SLOT][l] = u;
      b.history[E::GAP_SLOT + 1][l] = std::log(u);
      b.history[E::SURFACE_SLOT][l] = un0;
    }
    step_batch<E>(b, film, dt);
    return b.usual[0] != 0.0;
  };
  EXPECT_TRUE(is_usual(0.1, 0.1, 0.1, 1e-4, f));
  EXPECT_TRUE(is_usual(0.01, 0.0, 0.0, 1e-4, f));
  EXPECT_FALSE(is_usual(0.0301, 0.0, 0.0, 1e-2, f));                                      // crosses
  EXPECT_FALSE(is_usual(0.1, 0.3, 0.1, 1e-2, f));                                         // far
  EXPECT_FALSE(is_usual(1e-200, 0.1, 0.1, 1e-4, f));                                      // thin
  EXPECT_FALSE(is_usual(0.1, 0.1, 0.1, 1e-4, make_film(1e-20, 0.5, Range::CUT, 0.6)));    // dry
  EXPECT_TRUE(is_usual(0.1, 0.4, 0.4, 1.0, f));                                           // long
  EXPECT_FALSE(is_usual(0.1, -0.4, -0.4, 1.0, f));    // the same, pressed
}
