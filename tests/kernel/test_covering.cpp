// The instances of the loop that cover others: what they have besides does nothing, to the last
// bit.

#include "lubcontact_batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace LAMMPS_NS::Lubcontact_NS;

constexpr double DT = 1e-3;

Film film_of(unsigned mask)
{
  return without_films(make_film(1.0, 0.5, Range::CUT, 0.6), mask & SHEAR, mask & ROLL,
                       mask & TWIST);
}

PairCoeffs coeffs_of(unsigned mask)
{
  const double eps = 0.01;
  GapLaw gap{1.0, eps, std::log(eps), false};
  gap.release_a = eps;
  gap.ln_release = gap.ln_eps;
  PairCoeffs c{{1e3, 1e3, gap}, 5e2, mask & FRICTION ? 0.5 : 0.0};
  if (mask & THRESHOLD) c.threshold = make_threshold(FrictionLaw::SHIFT, 0.5);
  if (mask & RESTITUTION) c.restitution = restitution_coeff(0.5, 5e2);
  return c;
}

struct Scene {
  Body i, j;
};

std::vector<Scene> random_pairs()
{
  std::mt19937 engine(4711);
  auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  std::vector<Scene> pairs(64);
  for (Scene &s : pairs) {
    const double ri = uniform(0.8, 1.2), rj = uniform(0.8, 1.2);
    const double r = ri + rj + uniform(-0.005, 0.3), z = uniform(-1.0, 1.0),
                 w = std::sqrt(1 - z * z);
    const double angle = uniform(0.0, 2.0 * PI);
    auto any = [&] {
      return Vec3{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    };
    s.i = {r * Vec3{w * std::cos(angle), w * std::sin(angle), z}, any(), any(), ri};
    s.j = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, any(), rj};
  }
  return pairs;
}

struct Result {
  Vec3 force, torque_i, torque_j;
};

// Forces after ten steps, pair by pair or eight at a time.
template <unsigned INSTANCE> std::vector<Result> run(unsigned mask, bool together)
{
  using E = Effects<INSTANCE>;
  const Film film = film_of(mask);
  const PairCoeffs c = coeffs_of(mask);
  std::vector<Result> results;
  for (Scene s : random_pairs()) {
    double history[E::HISTORY_SIZE + 1];
    auto geometry = [&s] {
      return pair_geometry(s.i.x, s.j.x, s.i.radius, s.j.radius,
                           effective_radius(Radius::HARMONIC, s.i.radius, s.j.radius));
    };
    first_history<E>(c, geometry(), history);
    Result result{};
    for (int step = 0; step < 10; step++) {
      s.i.x = s.i.x + DT * s.i.v;
      const PairGeometry g = geometry();
      if (together) {
        Batch b = idle_batch();
        put_lane(s.i.x - s.j.x, b.x, 0);
        put_lane(s.i.v - s.j.v, b.v, 0);
        put_lane(s.i.omega, b.omega_i, 0);
        put_lane(s.j.omega, b.omega_j, 0);
        b.radius_i[0] = s.i.radius;
        b.radius_j[0] = s.j.radius;
        b.a[0] = g.a;
        b.g[0] = c.normal.g;
        b.asperity[0] = c.normal.asperity;
        b.alpha[0] = c.normal.gap.alpha;
        b.eps_a[0] = c.normal.gap.eps_a;
        b.ln_eps[0] = c.normal.gap.ln_eps;
        b.kt[0] = c.kt;
        b.mu[0] = c.mu;
        b.restitution[0] = c.restitution;
        b.least[0] = c.threshold.least;
        b.shift[0] = c.threshold.shift;
        b.per_ramp[0] = c.threshold.per_ramp;
        for (int m = 0; m < E::HISTORY_SIZE; m++) b.history[m][0] = history[m];
        step_batch<E>(b, film, DT);
        if (b.usual[0] != 0.0) {
          for (int m = 0; m < E::HISTORY_SIZE; m++) history[m] = b.history[m][0];
          result = {get_lane(b.force, 0), {}, {}};
          if constexpr (E::turns || E::twist)
            result = {get_lane(b.force, 0), get_lane(b.torque_i, 0), get_lane(b.torque_j, 0)};
          continue;
        }
      }
      next_history<E>(c, film, g, s.i, s.j, DT, history, history);
      const Load load = pair_load<E>(c, film, g, history);
      result = {force_on_i(load, g), torque_on_i(load, g), torque_on_j(load, g)};
    }
    results.push_back(result);
  }
  return results;
}

bool same(const Vec3 &a, const Vec3 &b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

template <unsigned MASK> void compare()
{
  static_assert((covering(MASK) & MASK) == MASK, "an instance lacks an effect");
  for (bool together : {false, true}) {
    const auto exact = run<MASK>(MASK, together), covered = run<covering(MASK)>(MASK, together);
    for (std::size_t n = 0; n < exact.size(); n++) {
      EXPECT_TRUE(same(exact[n].force, covered[n].force)) << MASK << " pair " << n;
      EXPECT_TRUE(same(exact[n].torque_i, covered[n].torque_i)) << MASK << " pair " << n;
      EXPECT_TRUE(same(exact[n].torque_j, covered[n].torque_j)) << MASK << " pair " << n;
    }
  }
}

TEST(Covering, OfFilms)
{
  compare<SQUEEZE | ROLL>();
  compare<SQUEEZE | FRICTION | SHEAR | TWIST>();
  compare<ROLL>();
}

TEST(Covering, OfACriticalLoad)
{
  compare<SQUEEZE | FRICTION | SHEAR | REPULSION>();
}

TEST(Covering, OfADashpot)
{
  compare<RESTITUTION | SQUEEZE>();
  compare<RESTITUTION | SHEAR | FRICTION>();
  compare<RESTITUTION | FRICTION>();
}

// All masks are covered by themselves or by more, and what covers them is compiled: once, in one
// share.
TEST(Covering, IsWhatIsCompiled)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    const unsigned instance = covering(mask), extensions = mask & EXTENSIONS;
    EXPECT_EQ(instance & canonical(mask), canonical(mask)) << mask;
    EXPECT_EQ(covering(instance), instance);
    EXPECT_EQ(instance & EXTENSIONS, extensions);
    int found = 0, in_shares = 0;
    with_effects(instance, [&](auto effects) {
      found++;
      EXPECT_EQ(effects.mask, instance);
    });
    auto count = [&](auto) {
      in_shares++;
    };
    with_share_of_effects<0>(instance, count);
    with_share_of_effects<1>(instance, count);
    with_share_of_effects<2>(instance, count);
    with_share_of_effects<3>(instance, count);
    EXPECT_EQ(found, 1) << mask;
    EXPECT_EQ(in_shares, 1) << mask;
  }
}

}    // namespace
