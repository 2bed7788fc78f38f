// Shows that a batch is the pair by itself, bit for bit, wherever it says that the step was usual.

#include "lubcontact_batch.h"
#include "tools.h"

#include <vector>

using namespace lubcontact;
using namespace testing_tools;

namespace {

struct Case {
  PairCoeffs c;
  Body i, j;
  double a, history[Batch::HISTORY];

  explicit Case(Random &rnd)
  {
    const double g = rnd.log_uniform(1e2, 1e4), k = rnd.log_uniform(1e2, 1e5);
    const double eps = rnd.coin() ? rnd.log_uniform(1e-3, 0.1) : 0.0;
    c = {{g, k, {k / g, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, false}},
         rnd.log_uniform(1e2, 1e4),
         rnd.uniform(0.0, 1.0)};
    c.normal.gap.release = eps > 0.0 && rnd.coin() ? eps * rnd.uniform(1.0, 2.0) : eps;
    c.normal.gap.ln_release = c.normal.gap.release > eps ? std::log(c.normal.gap.release)
                                                         : c.normal.gap.ln_eps;
    if (rnd.coin()) c.normal.repulsion = {rnd.log_uniform(1e-2, 1e2), rnd.log_uniform(10.0, 1e3)};
    const FrictionLaw laws[] = {FrictionLaw::COULOMB, FrictionLaw::STEP, FrictionLaw::SHIFT,
                                FrictionLaw::RAMP};
    c.threshold = make_threshold(laws[rnd.engine() % 4], rnd.log_uniform(1e-2, 1e2));
    const double ri = rnd.uniform(0.5, 1.5), rj = rnd.uniform(0.5, 1.5);
    a = effective_radius(Radius::HARMONIC, ri, rj);
    const double un = a * rnd.uniform(-0.02, 0.4);
    const Vec3 xj = rnd.vector(10.0);
    i = {xj + (ri + rj + un) * rnd.unit(), rnd.vector(1.0), rnd.vector(1.0), ri};
    j = {xj, rnd.vector(1.0), rnd.vector(1.0), rj};
    for (double &slot : history) slot = rnd.uniform(-1e-2, 1e-2);
  }

  template <class E> void set_history(Random &rnd, const PairGeometry &g)
  {
    if constexpr (E::gap_history) {
      const double u = g.un > 0.0 ? g.gap * rnd.uniform(0.9, 1.1) : rnd.log_uniform(1e-4, 1e-2);
      history[E::GAP_SLOT] = u;
      history[E::GAP_SLOT + 1] = std::log(u);
    }
    if constexpr (E::adhesion) {
      const double u = E::gap_history ? history[E::GAP_SLOT] : g.gap;
      const bool may = u < c.normal.gap.release && rnd.coin();
      history[E::BOND_SLOT] = may || u < c.normal.gap.eps ? 1.0 : 0.0;
    }
    if constexpr (E::surface_history)
      history[E::SURFACE_SLOT] = g.un + g.a * rnd.uniform(-1e-4, 1e-4);
  }

  PairGeometry geometry() const { return pair_geometry(i.x, j.x, i.radius, j.radius, a); }
};

void put(const Case &k, Batch &b, int l)
{
  put_lane(k.i.x - k.j.x, b.x, l);
  put_lane(k.i.v - k.j.v, b.v, l);
  put_lane(k.i.omega, b.omega_i, l);
  put_lane(k.j.omega, b.omega_j, l);
  b.radius_i[l] = k.i.radius;
  b.radius_j[l] = k.j.radius;
  b.a[l] = k.a;
  b.g[l] = k.c.normal.g;
  b.asperity[l] = k.c.normal.asperity;
  b.alpha[l] = k.c.normal.gap.alpha;
  b.eps[l] = k.c.normal.gap.eps;
  b.ln_eps[l] = k.c.normal.gap.ln_eps;
  b.release[l] = k.c.normal.gap.release;
  b.ln_release[l] = k.c.normal.gap.ln_release;
  b.repulsion[l] = k.c.normal.repulsion.force;
  b.per_screening[l] = k.c.normal.repulsion.per_length;
  b.least[l] = k.c.threshold.least;
  b.shift[l] = k.c.threshold.shift;
  b.per_ramp[l] = k.c.threshold.per_ramp;
  b.kt[l] = k.c.kt;
  b.mu[l] = k.c.mu;
  for (int m = 0; m < Batch::HISTORY; m++) b.history[m][l] = k.history[m];
}

// Compares a batch of random pairs with the same pairs one by one; returns how many were usual.
template <class E> int compare(Random &rnd, const Film &f, double dt)
{
  std::vector<Case> cases;
  Batch b{};
  for (int l = 0; l < Batch::WIDTH; l++) {
    cases.emplace_back(rnd);
    cases[l].template set_history<E>(rnd, cases[l].geometry());
    put(cases[l], b, l);
  }
  step_batch<E>(b, f, dt);

  int usual = 0;
  for (int l = 0; l < Batch::WIDTH; l++) {
    if (b.usual[l] == 0.0) continue;
    usual++;
    Case &k = cases[l];
    const PairGeometry g = k.geometry();
    next_history<E>(k.c, f, g, k.i, k.j, dt, k.history, k.history);
    for (int m = 0; m < E::HISTORY_SIZE; m++) EXPECT_EQ(b.history[m][l], k.history[m]);
    const Load load = pair_load<E>(k.c, f, g, k.history);
    expect_same(get_lane(b.force, l), force_on_i(load, g));
    expect_same(get_lane(b.torque_i, l), torque_on_i(load, g));
    if (E::turns || E::twist) expect_same(get_lane(b.torque_j, l), torque_on_j(load, g));
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
      b.eps[l] = eps;
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
  EXPECT_FALSE(is_usual(0.1, 0.4, 0.4, 1.0, f));                                          // long
}
