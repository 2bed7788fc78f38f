// Shows that the pair law with residual films follows the form of their dissipation, integrated by
// SciPy on prescribed ways, in forces, torques, stresslet and heat.

#include "batch_case.h"
#include "lubcontact_power.h"
#include "reference/pair_residual_reference.h"
#include "tools.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

static constexpr unsigned FILMS = SQUEEZE | SHEAR | ROLL | TWIST;
using E = WithResidual<Effects<FILMS>>;
static constexpr int NUMBERS = 23;
using Row = std::array<double, NUMBERS>;

Film make_residual(double eta, double reach_a, const Strain &strain)
{
  Film f = make_film(eta, reach_a, Range::RESIDUAL, 0.6);
  f.strain = strain;
  return f;
}

Strain way_strain()
{
  const double *e = WAY_STRAIN;
  return {e[0], e[1], e[2], e[3], e[4], e[5]};
}

Vec3 place(const WayCase &c, double t)
{
  const double a = effective_radius(Radius::HARMONIC, c.radius_i, c.radius_j);
  const double un = a * (c.middle + c.swing * std::cos(1.1 * t + 0.3));
  const double th = 0.3 * t + 0.5 * std::sin(0.9 * t), ph = 0.4 * std::sin(0.7 * t + 0.4);
  return (c.radius_i + c.radius_j + un) *
      Vec3{std::cos(th) * std::cos(ph), std::sin(th) * std::cos(ph), std::sin(ph)};
}

Vec3 spin_i(double t)
{
  return {0.6 * std::sin(1.2 * t), 0.5 * std::cos(0.8 * t), -0.4 + 0.3 * std::sin(t)};
}

Vec3 spin_j(double t)
{
  return {0.4 * std::cos(0.9 * t), -0.3 * std::sin(1.4 * t + 1.0), 0.5 * std::cos(0.6 * t)};
}

// Rows at the times of the reference; swapped: as the other sphere sees the pair.
std::vector<Row> follow(const WayCase &c, int steps, bool swapped = false)
{
  const double dt = WAY_END / steps, sign = swapped ? -1.0 : 1.0;
  const Film f = make_residual(WAY_ETA, 2.0, way_strain());
  PairCoeffs k{{WAY_G,
                WAY_ALPHA * WAY_G,
                {WAY_ALPHA, c.eps, c.eps > 0.0 ? std::log(c.eps) : -HUGE_VAL, false}},
               WAY_KT,
               0.0};
  const double ri = swapped ? c.radius_j : c.radius_i, rj = swapped ? c.radius_i : c.radius_j;
  const double a = effective_radius(Radius::HARMONIC, ri, rj);
  double old[E::HISTORY_SIZE], next[E::HISTORY_SIZE];
  first_history<E>(k, pair_geometry(sign * place(c, 0.0), {}, ri, rj, a), old);
  std::vector<Row> rows;
  double heat = 0.0;
  for (int n = 1; n <= steps; n++) {
    const double t = n * dt;
    const Vec3 x = sign * place(c, t), v = (1.0 / dt) * (x - sign * place(c, t - dt));
    const Vec3 w1 = spin_i(t - 0.5 * dt), w2 = spin_j(t - 0.5 * dt);
    const Body i{x, v, swapped ? w2 : w1, ri}, j{{}, {}, swapped ? w1 : w2, rj};
    const PairGeometry g = pair_geometry(i.x, j.x, ri, rj, a);
    next_history<E>(k, f, g, i, j, dt, old, next);
    const Energies loss = step_loss<E>(k, f, g, i, j, dt, old, next);
    heat += std::accumulate(loss.of, loss.of + NUM_ORIGINS, 0.0);
    std::copy_n(next, +E::HISTORY_SIZE, old);
    if (n % (steps / WAY_ROWS)) continue;
    const Load load = pair_load<E>(k, f, g, next);
    const FilmStresslet s = present_stresslet<E>(k, f, g, load, next);
    const Vec3 force = sign * force_on_i(load, g);
    Vec3 ti = torque_on_i(load, g), tj = torque_on_j(load, g);
    if (swapped) std::swap(ti, tj);
    rows.push_back({load.u / a,
                    force.x,
                    force.y,
                    force.z,
                    ti.x,
                    ti.y,
                    ti.z,
                    tj.x,
                    tj.y,
                    tj.z,
                    s.normal.xx,
                    s.normal.yy,
                    s.normal.zz,
                    s.normal.xy,
                    s.normal.xz,
                    s.normal.yz,
                    s.tangential.xx,
                    s.tangential.yy,
                    s.tangential.zz,
                    s.tangential.xy,
                    s.tangential.xz,
                    s.tangential.yz,
                    heat});
  }
  return rows;
}

// Largest error over the size of each kind of number: gap, force, torques, stresslets, heat.
std::array<double, 5> errors(const WayCase &c, const std::vector<Row> &rows)
{
  const int first[] = {0, 1, 4, 10, 22, NUMBERS};
  std::array<double, 5> worst{};
  for (int kind = 0; kind < 5; kind++) {
    double size = 0.0;
    for (int row = 0; row < WAY_ROWS; row++)
      for (int n = first[kind]; n < first[kind + 1]; n++)
        size = std::fmax(size, std::fabs(c.rows[row][n]));
    for (int row = 0; row < WAY_ROWS; row++)
      for (int n = first[kind]; n < first[kind + 1]; n++)
        worst[kind] = std::fmax(worst[kind], std::fabs(rows[row][n] - c.rows[row][n]) / size);
  }
  return worst;
}

}    // namespace

TEST(PairResidual, FollowsTheFormOfItsDissipation)
{
  for (const WayCase &c : WAY_CASES) {
    const auto coarse = errors(c, follow(c, 5000)), fine = errors(c, follow(c, 20000));
    for (int kind = 0; kind < 5; kind++) {
      EXPECT_LT(fine[kind], 2e-5) << c.radius_i << " " << kind;
      EXPECT_LT(fine[kind], coarse[kind] / 12.0 + 1e-8) << c.radius_i << " " << kind;
    }
  }
}

TEST(PairResidual, IsTheSameFromEitherSphere)
{
  for (const WayCase &c : WAY_CASES) {
    const auto one = follow(c, 400), other = follow(c, 400, true);
    for (int row = 0; row < WAY_ROWS; row++)
      for (int n = 0; n < NUMBERS; n++) EXPECT_NEAR(one[row][n], other[row][n], 1e-12) << n;
  }
}

TEST(PairResidual, InstancesCoverAllEffects)
{
  for (unsigned mask = 0; mask < NUM_COMBINATIONS; mask++) {
    const unsigned instance = covering_residual(mask);
    EXPECT_EQ(instance & canonical(mask), canonical(mask)) << mask;
    int found = 0;
    with_residual_effects(instance, [&](auto effects) {
      found++;
      EXPECT_EQ(effects.mask, instance);
      EXPECT_TRUE(effects.residual);
    });
    EXPECT_EQ(found, mask & RESTITUTION ? 0 : 1) << mask;    // for dry grains: refused
  }
}
