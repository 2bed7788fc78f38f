// Shows that the heat and the stored energy of a step add up to the work done on the pair, by
// origin.

#include "lubcontact_power.h"
#include "tools.h"

#include <numeric>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

static constexpr unsigned ALL = NUM_COMBINATIONS - 1;
static const Film VISCOUS = make_film(2.0, 1.0, Range::SHIFTED, 0.6);

// RESIDUAL: in a flow.
template <class E> Film film_of()
{
  if (!E::residual) return VISCOUS;
  Film f = make_film(2.0, 2.0, Range::RESIDUAL, 0.6);
  f.strain = {0.2, -0.05, -0.15, 0.3, -0.1, 0.25};
  return f;
}

double power(const SymmetricTensor &s, const Strain &e)
{
  return s.xx * e.xx + s.yy * e.yy + s.zz * e.zz + 2.0 * (s.xy * e.xy + s.xz * e.xz + s.yz * e.yz);
}

// That a flow puts into a pair beside the work of its forces.
template <class E>
double stresslet_power(const PairCoeffs &c, const Film &f, const PairGeometry &g, const Load &load,
                       const double *history)
{
  if constexpr (E::residual) {
    const FilmStresslet s = present_stresslet<E>(c, f, g, load, history);
    return power(s.normal + s.tangential, f.strain);
  }
  return 0.0;
}

PairCoeffs make_coeffs()
{
  PairCoeffs c{{1000.0, 800.0, {0.8, 0.03, std::log(0.03), false}}, 700.0, 0.5};
  c.normal.gap.release_a = 0.04;
  c.normal.gap.ln_release = std::log(0.04);
  c.normal.repulsion = {2.0, 20.0};
  c.threshold = make_threshold(FrictionLaw::SHIFT, 3.0);
  c.restitution = restitution_coeff(0.5, 1000.0 / (1.0 + 1000.0 / 800.0));
  return c;
}

// What became of the work done on a pair along a smooth motion.
struct Sums {
  double work = 0.0, change = 0.0, peak = 0.0;
  Energies heat;
  double defect() const
  {
    return work - change - std::accumulate(heat.of, heat.of + NUM_ORIGINS, 0.0);
  }
};

template <class E> Sums follow(std::uint64_t seed, int steps, double dt)
{
  Random rnd(seed);
  const Wave gap(rnd, 0.1), wobble(rnd, 0.5);
  const WaveVector direction(rnd, 0.6), wi(rnd, 0.5), wj(rnd, 0.5);
  const Vec3 axis = rnd.unit();
  const double ri = 1.2, rj = 0.8, a = 0.96;
  auto place = [&](double t) {
    const Vec3 d = axis + direction(t);
    return ((ri + rj + a * (0.03 + gap(t))) / norm(d)) * d;
  };
  const PairCoeffs c = make_coeffs();
  const Film film = film_of<E>();
  double history[E::HISTORY_SIZE + 1], old[E::HISTORY_SIZE + 1];
  PairGeometry g = pair_geometry(place(0.0), {}, ri, rj, a);
  first_history<E>(c, g, history);
  auto total = [&](const Energies &e) {
    return std::accumulate(e.of, e.of + NUM_ORIGINS, 0.0);
  };
  Load load = pair_load<E>(c, film, g, history);
  double stored = total(stored_energy<E>(c, g, load, history));

  Sums sums;
  for (int n = 1; n <= steps; n++) {
    const double t = n * dt;
    const Body i{place(t), (1.0 / dt) * (place(t) - place(t - dt)), wi(t - 0.5 * dt), ri};
    const Body j{{}, {}, wj(t - 0.5 * dt), rj};
    const PairGeometry g0 = g;
    const Load l0 = load;
    const double put0 = stresslet_power<E>(c, film, g, load, history);
    for (int m = 0; m < E::HISTORY_SIZE; m++) old[m] = history[m];
    g = pair_geometry(i.x, j.x, ri, rj, a);
    next_history<E>(c, film, g, i, j, dt, old, history);
    load = pair_load<E>(c, film, g, history);
    const Vec3 F = 0.5 * (force_on_i(l0, g0) + force_on_i(load, g));
    const Vec3 Ti = 0.5 * (torque_on_i(l0, g0) + torque_on_i(load, g));
    const Vec3 Tj = 0.5 * (torque_on_j(l0, g0) + torque_on_j(load, g));
    sums.work -= dt * (dot(F, i.v) + dot(Ti, i.omega) + dot(Tj, j.omega));
    sums.work += 0.5 * dt * (put0 + stresslet_power<E>(c, film, g, load, history));
    const Energies heat = step_loss<E>(c, film, g, i, j, dt, old, history);
    for (int m = 0; m < NUM_ORIGINS; m++) sums.heat.of[m] += heat.of[m];
    const double now = total(stored_energy<E>(c, g, load, history));
    sums.change += now - stored;
    stored = now;
    sums.peak = std::fmax(sums.peak, std::fabs(sums.work));
  }
  return sums;
}

template <class E> void expect_balance()
{
  SCOPED_TRACE("mask " + std::to_string(E::mask) + (E::residual ? " residual" : ""));
  for (std::uint64_t seed = 1; seed < 5; seed++) {
    const Sums coarse = follow<E>(seed, 2000, 0.01), fine = follow<E>(seed, 8000, 0.0025);
    EXPECT_LE(std::fabs(fine.defect()), 2e-4 * fine.peak);
    EXPECT_LE(std::fabs(fine.defect()), 0.3 * std::fabs(coarse.defect()) + 1e-5 * fine.peak);
    for (const double heat : fine.heat.of) EXPECT_GE(heat, -1e-4 * fine.peak);
  }
}

}    // namespace

TEST(Power, WorkIsHeatPlusStored)
{
  expect_balance<Effects<ALL>>();
  expect_balance<Effects<ALL & ~SQUEEZE>>();
  expect_balance<Effects<ALL & ~SHEAR>>();
  expect_balance<Effects<ALL & ~REPULSION>>();
  expect_balance<Effects<31>>();
  expect_balance<Effects<SQUEEZE>>();
  expect_balance<Effects<FRICTION>>();
  expect_balance<Effects<ADHESION>>();
  expect_balance<Effects<ADHESION | REPULSION | FRICTION>>();
  expect_balance<Effects<ROLL | TWIST>>();
  expect_balance<Effects<RESTITUTION>>();
  expect_balance<Effects<RESTITUTION | FRICTION>>();
  expect_balance<Effects<RESTITUTION | SQUEEZE>>();
  expect_balance<Effects<RESTITUTION - 1>>();
}

TEST(Power, AlsoOfResidualFilmsInAFlow)
{
  static constexpr unsigned FILMS = SQUEEZE | SHEAR | ROLL | TWIST;
  expect_balance<WithResidual<Effects<FILMS>>>();
  expect_balance<WithResidual<Effects<FILMS | FRICTION>>>();
  expect_balance<WithResidual<Effects<ALL>>>();
}

TEST(Power, EveryOriginOfHeatTakesPart)
{
  const Sums sums = follow<Effects<RESTITUTION - 1>>(2, 8000, 0.0025);
  for (const int m : {FRICTION_CONTACT, SQUEEZE_FILM, SHEAR_FILM, ROLL_FILM, TWIST_FILM})
    EXPECT_GT(sums.heat.of[m], 1e-3 * sums.peak) << ORIGIN_NAME[m];
  EXPECT_EQ(sums.heat.of[REPULSIVE_FORCE], 0.0);
  // each time that an adhesive contact breaks the asperities lose (k/2) (delta a)^2
  const double breaks = sums.heat.of[NORMAL_CONTACT] / (0.5 * 800.0 * 0.0096 * 0.0096);
  EXPECT_GT(breaks, 0.5);
  EXPECT_NEAR(breaks, std::round(breaks), 1e-9);
  // and a dashpot adds to it
  const Sums damped = follow<Effects<ALL>>(2, 8000, 0.0025);
  EXPECT_GT(damped.heat.of[NORMAL_CONTACT], 1.05 * sums.heat.of[NORMAL_CONTACT]);
}

TEST(Power, ElasticContactMakesNoHeat)
{
  const Sums sums = follow<Effects<REPULSION>>(3, 4000, 0.005);
  for (const double heat : sums.heat.of) EXPECT_EQ(heat, 0.0);
  EXPECT_NEAR(sums.work, sums.change, 1e-3 * sums.peak);
}

// Two spheres of radius 1 that slide or part steadily: heat of a step over dt.
template <class E> static Energies steady(const PairCoeffs &c, double un, const Vec3 &velocity)
{
  const double dt = 1e-3;
  double history[E::HISTORY_SIZE + 1], old[E::HISTORY_SIZE + 1];
  const double r = 2.0 + un, around = velocity.y / r;
  auto at = [&](double t) {
    return (r + velocity.x * t) * Vec3{std::cos(around * t), std::sin(around * t), 0.0};
  };
  first_history<E>(c, pair_geometry(at(0.0), {}, 1.0, 1.0, 1.0), history);
  Energies heat;
  for (int n = 1; n <= 400; n++) {
    const Body i{at(n * dt), (1.0 / dt) * (at(n * dt) - at((n - 1) * dt)), {}, 1.0};
    const Body j{{}, {}, {}, 1.0};
    for (int m = 0; m < E::HISTORY_SIZE; m++) old[m] = history[m];
    const PairGeometry g = pair_geometry(i.x, j.x, 1.0, 1.0, 1.0);
    next_history<E>(c, VISCOUS, g, i, j, dt, old, history);
    heat = step_loss<E>(c, VISCOUS, g, i, j, dt, old, history);
  }
  for (double &h : heat.of) h /= dt;
  return heat;
}

TEST(Power, SlidingFilmHeatsWithItsResistance)
{
  PairCoeffs stiff = make_coeffs();
  stiff.kt = 1e7;
  const double u = 0.2, v = 0.03;
  const Energies heat = steady<Effects<SHEAR>>(stiff, u, {0.0, v, 0.0});
  EXPECT_NEAR(heat.of[SHEAR_FILM], shear_resistance(VISCOUS, 1.0, u, std::log(u)) * v * v,
              1e-4 * v * v);
  EXPECT_EQ(heat.of[FRICTION_CONTACT], 0.0);
}

TEST(Power, SlidingContactHeatsWithMuN)
{
  PairCoeffs c = make_coeffs();
  const double v = 0.5;
  // N = alpha g/(1+alpha) (eps - un) = 444.4 (0.03 + 0.01)
  const double N = 800.0 / 1.8 * 0.04;
  const Energies heat = steady<Effects<FRICTION>>(c, -0.01, {0.0, v, 0.0});
  EXPECT_NEAR(heat.of[FRICTION_CONTACT], 0.5 * N * v, 1e-6 * N);
  const Energies less = steady<Effects<FRICTION | THRESHOLD>>(c, -0.01, {0.0, v, 0.0});
  EXPECT_NEAR(less.of[FRICTION_CONTACT], 0.5 * (N - 3.0) * v, 1e-6 * N);
}

TEST(Power, AnAdhesiveContactThatBreaksLosesItsSprings)
{
  // pulled apart without film: at release bulk and asperities hold k delta a, in series
  using E = Effects<ADHESION>;
  const PairCoeffs c = make_coeffs();
  const double F = 800.0 * 0.01, lost_energy = 0.5 * F * F * (1.0 / 800.0 + 1.0 / 1000.0);
  double history[E::HISTORY_SIZE + 1], old[E::HISTORY_SIZE + 1], heat = 0.0;
  const double dt = 1e-3, v = 1e-3;
  first_history<E>(c, pair_geometry({2.0, 0, 0}, {}, 1.0, 1.0, 1.0), history);
  for (int n = 1; n <= 100000 * 0.06; n++) {
    const Body i{{2.0 + n * v * 1e-2, 0.0, 0.0}, {v * 1e-2 / dt, 0.0, 0.0}, {}, 1.0};
    const Body j{{}, {}, {}, 1.0};
    for (int m = 0; m < E::HISTORY_SIZE; m++) old[m] = history[m];
    const PairGeometry g = pair_geometry(i.x, j.x, 1.0, 1.0, 1.0);
    next_history<E>(c, VISCOUS, g, i, j, dt, old, history);
    heat += step_loss<E>(c, VISCOUS, g, i, j, dt, old, history).of[NORMAL_CONTACT];
  }
  EXPECT_NEAR(heat, lost_energy, 1e-2 * lost_energy);
}

TEST(Power, SpringsOfTheFilmsStoreHalfOfStiffnessTimesSquare)
{
  using E = Effects<SQUEEZE | SHEAR | ROLL | TWIST>;
  const PairCoeffs c = make_coeffs();
  const double a = 0.96, kr = 700.0 * a * a;
  const PairGeometry g = pair_geometry({2.1, 0, 0}, {}, 1.2, 0.8, a);
  double history[E::HISTORY_SIZE] = {};
  first_history<E>(c, g, history);
  history[E::SHEAR_SLOT + 1] = 0.003;
  history[E::ROLL_SLOT + 2] = -0.02;
  history[E::TWIST_SLOT] = 0.05;
  const Load load = pair_load<E>(c, VISCOUS, g, history);
  const Energies e = stored_energy<E>(c, g, load, history);
  EXPECT_NEAR(e.of[SHEAR_FILM], 0.5 * 700.0 * 9e-6, 1e-14);
  EXPECT_NEAR(e.of[ROLL_FILM], 0.5 * kr * 4e-4, 1e-14);
  EXPECT_NEAR(e.of[TWIST_FILM], 0.5 * kr * 25e-4, 1e-14);
  EXPECT_EQ(e.of[FRICTION_CONTACT], 0.0);
}
