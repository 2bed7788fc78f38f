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

// In a flow that the spheres follow exactly there is no force, and the stresslet is that of the
// form at rest; a turned frame turns everything.
TEST(PairResidual, HasNoForceOfItsOwnMotionInAFlow)
{
  const Strain strain = way_strain();
  const WayCase &c = WAY_CASES[0];
  const double a = effective_radius(Radius::HARMONIC, c.radius_i, c.radius_j);
  const PairGeometry g = pair_geometry((c.radius_i + c.radius_j + 0.4 * a) * Vec3{0.6, 0.0, 0.8},
                                       {}, c.radius_i, c.radius_j, a);
  Film f = make_residual(WAY_ETA, 2.0, strain);
  const PairStrain flow = pair_strain(strain, g.n);
  const double delta = size_difference(g);
  const ResidualPlace p = residual_place(0.4, std::log(0.4), delta);
  // at the force F = 0 of each film the rates are part e, slide e_t, turn e_t: dPhi/dw = 0 and so on
  const FlowResponse r = flow_response(f, g, 0.4, std::log(0.4), false);
  const double A = squeeze_coeff(WAY_ETA) * a / 0.4 * residual<RESIDUAL_SQUEEZE>(p);
  const double push = WAY_ETA * a * a * residual<RESIDUAL_PUSH>(p);
  EXPECT_NEAR(A * r.part, push, 1e-14);
  const double C = WAY_ETA * a * a * a * residual<RESIDUAL_STRETCH>(p);
  EXPECT_NEAR(r.stretch, C - push * push / A, 1e-14);
  // a rubbing contact keeps its place and all of the heat of slip
  const FlowResponse rubs = flow_response(f, g, 0.4, std::log(0.4), true);
  EXPECT_EQ(rubs.slide, 0.0);
  const TangentialResidual t = residual_films(f, a, delta, p);
  EXPECT_NEAR(rubs.extend - r.extend, t.shear * t.slide * t.slide, 1e-14);
  // sizes: e and e_t of the flow, traceless
  const FilmStresslet s = film_stresslet(r, strain, g.n, 0.3, {0.8, 1.0, -0.6}, {0.0, 2.0, 0.0});
  EXPECT_NEAR(s.normal.xx + s.normal.yy + s.normal.zz, 0.0, 1e-15);
  EXPECT_NEAR(s.tangential.xx + s.tangential.yy + s.tangential.zz, 0.0, 1e-15);
  const Vec3 of_n = strained(s.normal, g.n);
  EXPECT_NEAR(dot(of_n, g.n), 2.0 / 3.0 * (r.part * 0.3 + r.stretch * flow.along), 1e-14);
}

// Without a film there is nothing of it, in the flow either.
TEST(PairResidual, FilmsThatAreOffDoNothing)
{
  const WayCase &c = WAY_CASES[0];
  const double a = effective_radius(Radius::HARMONIC, c.radius_i, c.radius_j);
  const PairGeometry g = pair_geometry(place(c, 0.0), {}, c.radius_i, c.radius_j, a);
  const Film all = make_residual(WAY_ETA, 2.0, way_strain());
  const double delta = size_difference(g), u_a = 0.2, ln_u = std::log(u_a);
  const ResidualPlace p = residual_place(u_a, ln_u, delta);
  const TangentialResidual off =
      residual_films(without_films(all, false, false, false), a, delta, p);
  EXPECT_EQ(off.shear, 0.0);
  EXPECT_EQ(off.roll, 0.0);
  EXPECT_EQ(off.twist, 0.0);
  const TangentialResidual on = residual_films(without_films(all, true, true, true), a, delta, p);
  EXPECT_GT(on.shear, 0.0);
  EXPECT_GT(on.roll, 0.0);
  EXPECT_GT(on.twist, 0.0);
  EXPECT_EQ(flow_response(without_films(all, false, true, true), g, u_a, ln_u, false).extend, 0.0);
  EXPECT_NE(flow_response(all, g, u_a, ln_u, false).extend, 0.0);
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
    EXPECT_EQ(found, 1) << mask;
  }
}
