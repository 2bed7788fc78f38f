// Shows the composed law: balance, parity, objectivity, passivity, and every mask against others.

#include "lubcontact_pair.h"
#include "tools.h"

#include <stdexcept>
#include <vector>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

PairCoeffs make_coeffs(double g, double k, double eps, double kt, double mu)
{
  PairCoeffs c{{g, k, {k / g, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, false}}, kt, mu};
  c.normal.gap.release_a = eps;
  c.normal.gap.ln_release = c.normal.gap.ln_eps;
  return c;
}

// with what the extensions need, where a mask has them
PairCoeffs extended(PairCoeffs c, double delta, double F0, double per_length, double critical)
{
  c.normal.gap.release_a = c.normal.gap.eps_a + delta;
  if (delta > 0.0) c.normal.gap.ln_release = std::log(c.normal.gap.release_a);
  c.normal.repulsion = {F0, per_length};
  c.threshold = make_threshold(FrictionLaw::RAMP, critical);
  c.restitution = restitution_coeff(0.6, dry_stiffness(c.normal.g, c.normal.asperity, 1.0));
  return c;
}

static const PairCoeffs ROUGH =
    extended(make_coeffs(1000.0, 1000.0, 0.03, 700.0, 0.5), 0.01, 20.0, 50.0, 15.0);
static const Film VISCOUS = make_film(2.0, 1.0, Range::CUT, 0.6);

// The functions of one mask, so that each is compiled once however many tests call it.
struct Law {
  unsigned mask;
  int size, shear_slot, roll_slot, twist_slot;
  void (*first)(const PairCoeffs &, const PairGeometry &, double *);
  void (*next)(const PairCoeffs &, const Film &, const PairGeometry &, const Body &, const Body &,
               double, const double *, double *);
  Load (*load)(const PairCoeffs &, const Film &, const PairGeometry &, const double *);
  double (*energy)(const PairCoeffs &, const PairGeometry &, const Load &);
  void (*exchange)(const double *, double *);

  bool has(unsigned effect) const { return mask & effect; }
};

template <unsigned MASK> Law make_law()
{
  using E = Effects<MASK>;
  return {MASK,
          E::HISTORY_SIZE,
          E::SHEAR_SLOT,
          E::ROLL_SLOT,
          E::TWIST_SLOT,
          &first_history<E>,
          &next_history<E>,
          &pair_load<E>,
          &pair_energy<E>,
          &exchange_history<E>};
}

template <unsigned... MASK, unsigned... EXTENDED>
std::vector<Law> make_laws(std::integer_sequence<unsigned, MASK...>,
                           std::integer_sequence<unsigned, EXTENDED...>)
{
  return {make_law<MASK>()..., make_law<EXTENDED>()...};
}

// the basic masks, by number, and a choice of extended ones
const std::vector<Law> LAWS =
    make_laws(std::make_integer_sequence<unsigned, 32>{}, ExtendedMasks{});

const Law &law_of(unsigned mask)
{
  for (const Law &law : LAWS)
    if (law.mask == mask) return law;
  throw std::out_of_range("mask " + std::to_string(mask));
}

template <class F> void for_each_law(F &&f)
{
  for (const Law &law : LAWS) {
    SCOPED_TRACE("mask " + std::to_string(law.mask));
    f(law);
  }
}

template <class F> void for_each_basic_law(F &&f)
{
  for_each_law([&f](const Law &law) {
    if (law.mask < 32) f(law);
  });
}

// Two spheres on smooth random paths through contact and out of it.
struct Motion {
  double ri, rj, a;
  Vec3 axis;
  Wave gap;
  WaveVector direction, drift, wi, wj;

  explicit Motion(Random &rnd) :
      ri(rnd.uniform(0.5, 1.5)), rj(rnd.uniform(0.5, 1.5)),
      a(effective_radius(Radius::HARMONIC, ri, rj)), axis(rnd.unit()), gap(rnd, 0.15),
      direction(rnd, 0.6), drift(rnd, 1.0), wi(rnd, 0.5), wj(rnd, 0.5)
  {
  }
  Vec3 xj(double t) const { return drift(t); }
  Vec3 xi(double t) const
  {
    const Vec3 d = axis + direction(t);
    return xj(t) + ((ri + rj + a * (0.04 + gap(t))) / norm(d)) * d;
  }
};

// A pair that is driven: all that a step of the run knows.
struct Pair {
  const Law &law;
  PairCoeffs c;
  Film f;
  PairGeometry g{};
  Body i{}, j{};
  double history[12] = {};

  void start(const Vec3 &xi, const Vec3 &xj, double ri, double rj, double a)
  {
    i = {xi, {}, {}, ri};
    j = {xj, {}, {}, rj};
    g = pair_geometry(xi, xj, ri, rj, a);
    law.first(c, g, history);
  }
  void move(const Vec3 &xi, const Vec3 &xj, const Vec3 &wi, const Vec3 &wj, double dt)
  {
    i = {xi, (1.0 / dt) * (xi - i.x), wi, i.radius};
    j = {xj, (1.0 / dt) * (xj - j.x), wj, j.radius};
    g = pair_geometry(xi, xj, i.radius, j.radius, g.a);
    law.next(c, f, g, i, j, dt, history, history);
  }
  void start(const Motion &m) { start(m.xi(0.0), m.xj(0.0), m.ri, m.rj, m.a); }
  void follow(const Motion &m, int n, double dt)
  {
    const double t = n * dt, middle = (n - 0.5) * dt;
    move(m.xi(t), m.xj(t), m.wi(middle), m.wj(middle), dt);
  }
  Load load() const { return law.load(c, f, g, history); }
};

void expect_same_load(const Load &a, const Load &b)
{
  EXPECT_EQ(a.contact, b.contact);
  EXPECT_EQ(a.film, b.film);
  EXPECT_EQ(a.repulsion, b.repulsion);
  expect_same(a.shear, b.shear);
  expect_same(a.couple, b.couple);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.cone, b.cone);
}

// Loads of a mask along the motion of a seed.
std::vector<Load> loads_along(unsigned mask, std::uint64_t seed, const PairCoeffs &c, const Film &f,
                              int steps, double dt)
{
  Random rnd(seed);
  const Motion m(rnd);
  Pair pair{law_of(mask), c, f};
  pair.start(m);
  std::vector<Load> loads;
  for (int n = 1; n <= steps; n++) {
    pair.follow(m, n, dt);
    loads.push_back(pair.load());
  }
  return loads;
}

// The part of a load that force_on_i() and the torques see.
Load only(double normal, const Vec3 &shear, const Vec3 &couple)
{
  Load load{};
  load.normal = normal;
  load.shear = shear;
  load.couple = couple;
  return load;
}

// Work put into a pair by a motion, and what became of it, by mode.
struct Balance {
  double work[4] = {}, dissipated[4] = {}, deepest[4] = {};    // normal, tangential, couple, all
  double peak = 0.0;                                           // largest stored energy
};

Balance balance_along(unsigned mask, std::uint64_t seed, const PairCoeffs &c, const Film &f,
                      int steps, double dt)
{
  Random rnd(seed);
  const Motion m(rnd);
  Pair pair{law_of(mask), c, f};
  pair.start(m);
  Balance b;
  auto stored = [&](const Load &l, double *energy) {
    energy[3] = pair.law.energy(c, pair.g, l);
    energy[0] = energy[3] - 0.5 * dot(l.shear, l.shear) / c.kt -
        0.5 * dot(l.couple, l.couple) / (c.kt * pair.g.a * pair.g.a);
    energy[1] = 0.5 * dot(l.shear, l.shear) / c.kt;
    energy[2] = 0.5 * dot(l.couple, l.couple) / (c.kt * pair.g.a * pair.g.a);
  };
  double before[4], after[4], highest[4] = {};
  Load l0 = pair.load();
  PairGeometry g0 = pair.g;
  stored(l0, before);
  for (int n = 1; n <= steps; n++) {
    pair.follow(m, n, dt);
    const Load l1 = pair.load();
    const PairGeometry g1 = pair.g;
    stored(l1, after);
    auto mean_power = [&](auto part) {
      // force and torques of one origin, trapezoidal
      const Load p0 = part(l0), p1 = part(l1);
      const Vec3 F = 0.5 * (force_on_i(p0, g0) + force_on_i(p1, g1));
      const Vec3 Ti = 0.5 * (torque_on_i(p0, g0) + torque_on_i(p1, g1));
      const Vec3 Tj = 0.5 * (torque_on_j(p0, g0) + torque_on_j(p1, g1));
      return -(dot(F, pair.i.v - pair.j.v) + dot(Ti, pair.i.omega) + dot(Tj, pair.j.omega));
    };
    const double power[4] = {mean_power([](const Load &l) {
                               return only(l.normal, {}, {});
                             }),
                             mean_power([](const Load &l) {
                               return only(0.0, l.shear, {});
                             }),
                             mean_power([](const Load &l) {
                               return only(0.0, {}, l.couple);
                             }),
                             mean_power([](const Load &l) {
                               return l;
                             })};
    for (int k = 0; k < 4; k++) {
      b.work[k] += dt * power[k];
      b.dissipated[k] += dt * power[k] - (after[k] - before[k]);
      highest[k] = std::fmax(highest[k], b.dissipated[k]);
      b.deepest[k] = std::fmax(b.deepest[k], highest[k] - b.dissipated[k]);    // energy made
      before[k] = after[k];
    }
    b.peak = std::fmax(b.peak, after[3]);
    l0 = l1;
    g0 = g1;
  }
  return b;
}

}    // namespace

TEST(PairLaw, FirstHistoryIsTheElasticGapAndNothingElse)
{
  for_each_law([](const Law &law) {
    const PairGeometry g = pair_geometry({2.0, 0, 0}, {}, 1.0, 1.02, 1.01);    // un = -0.02
    double history[13];
    for (double &h : history) h = 99.0;
    law.first(ROUGH, g, history);
    int m = 0;
    if (law.has(SQUEEZE)) {
      // 2 u = un + eps, and the repulsion if there is one
      const double pushed = law.has(REPULSION) ? 20.0 * std::exp(-50.0 * 1.01 * history[0]) : 0.0;
      const double u = 0.5 * (-0.02 / 1.01 + 0.03 + pushed / 1010.0);
      EXPECT_NEAR(history[m++], u, 1e-15);
      EXPECT_NEAR(history[m++], std::log(u), 1e-13);
    }
    if (law.mask % 32 != 0 || law.has(RESTITUTION)) { EXPECT_NEAR(history[m++], -0.02, 1e-15); }
    const int last = law.size - (law.has(ADHESION) ? 1 : 0) - (law.has(RESTITUTION) ? 1 : 0);
    for (; m < last; m++) EXPECT_EQ(history[m], 0.0);
    if (law.has(ADHESION)) { EXPECT_EQ(history[m++], 1.0); }
    if (law.has(RESTITUTION)) { EXPECT_EQ(history[m++], 0.0); }
    for (; m < 13; m++) EXPECT_EQ(history[m], 99.0);    // nothing beyond
  });
}

TEST(PairLaw, LoadDependsOnGeometryAndHistoryAlone)
{
  for_each_law([](const Law &law) {
    Random rnd(1);
    const Motion m(rnd);
    Pair pair{law, ROUGH, VISCOUS};
    pair.start(m);
    for (int n = 1; n <= 300; n++) {
      pair.follow(m, n, 0.02);
      const Load once = pair.load();
      expect_same_load(once, pair.load());
      double copy[12];
      for (int k = 0; k < 12; k++) copy[k] = pair.history[k];
      const PairGeometry again = pair_geometry(pair.i.x, pair.j.x, m.ri, m.rj, m.a);
      expect_same_load(once, law.load(ROUGH, VISCOUS, again, copy));
    }
  });
}

TEST(PairLaw, HistoryMayBeWrittenInPlace)
{
  for_each_law([](const Law &law) {
    Random rnd(2);
    const Motion m(rnd);
    Pair pair{law, ROUGH, VISCOUS};
    pair.start(m);
    for (int n = 1; n <= 300; n++) {
      double old[12], apart[13];
      for (int k = 0; k < 12; k++) old[k] = pair.history[k];
      for (double &x : apart) x = 99.0;
      pair.follow(m, n, 0.02);
      law.next(ROUGH, VISCOUS, pair.g, pair.i, pair.j, 0.02, old, apart);
      for (int k = 0; k < 13; k++) {
        EXPECT_EQ(apart[k], k < law.size ? pair.history[k] : 99.0) << "double " << k;
      }
    }
  });
}

TEST(PairLaw, ForceAndTorquesBalanceWithUnequalRadii)
{
  for_each_law([](const Law &law) {
    Random rnd(3);
    const Motion m(rnd);
    Pair pair{law, ROUGH, VISCOUS};
    pair.start(m);
    for (int n = 1; n <= 500; n++) {
      pair.follow(m, n, 0.02);
      const Load l = pair.load();
      const Vec3 lever = cross(pair.i.x - pair.j.x, force_on_i(l, pair.g));
      const Vec3 sum = lever + torque_on_i(l, pair.g) + torque_on_j(l, pair.g);
      const double size = norm(force_on_i(l, pair.g)) + norm(l.couple);
      EXPECT_LE(norm(sum), 1e-14 * pair.g.r * size);
    }
  });
}

TEST(PairLaw, ExchangeOfTheSpheresOnlyChangesTheSign)
{
  for_each_law([](const Law &law) {
    Random rnd(4);
    const Motion m(rnd);
    Pair ij{law, ROUGH, VISCOUS}, ji{law, ROUGH, VISCOUS};
    ij.start(m);
    ji.start(m.xj(0.0), m.xi(0.0), m.rj, m.ri, m.a);
    for (int n = 1; n <= 500; n++) {
      const double dt = 0.02, t = n * dt, middle = (n - 0.5) * dt;
      ij.follow(m, n, dt);
      ji.move(m.xj(t), m.xi(t), m.wj(middle), m.wi(middle), dt);
      double expected[12];
      law.exchange(ij.history, expected);
      for (int k = 0; k < law.size; k++) ASSERT_EQ(ji.history[k], expected[k]) << k;
      const Load a = ij.load(), b = ji.load();
      expect_same(force_on_i(a, ij.g), -1.0 * force_on_i(b, ji.g));
      expect_same(torque_on_i(a, ij.g), torque_on_j(b, ji.g));
      expect_same(torque_on_j(a, ij.g), torque_on_i(b, ji.g));
      EXPECT_EQ(law.energy(ROUGH, ij.g, a), law.energy(ROUGH, ji.g, b));
      EXPECT_EQ(split(a).contact, split(b).contact);
    }
  });
}

TEST(PairLaw, TangentialForceAndRollingTorqueStayInTheTangentPlane)
{
  Random rnd(5);
  const Motion m(rnd);
  Pair pair{LAWS[31 - TWIST], ROUGH, VISCOUS};
  pair.start(m);
  for (int n = 1; n <= 20000; n++) {
    pair.follow(m, n, 0.02);
    const Load l = pair.load();
    EXPECT_LE(std::fabs(dot(l.shear, pair.g.n)), 1e-13 * (1.0 + norm(l.shear)));
    EXPECT_LE(std::fabs(dot(l.couple, pair.g.n)), 1e-12 * (1.0 + norm(l.couple)));
  }
}

TEST(PairLaw, FrictionObeysCoulombInEveryMask)
{
  for_each_law([](const Law &law) {
    for (std::uint64_t seed = 20; seed < 24; seed++) {
      for (const Load &l : loads_along(law.mask, seed, ROUGH, VISCOUS, 1000, 0.02)) {
        const ShearSplit s = split(l);
        if (law.has(FRICTION)) {
          const double N = std::fmax(0.0, l.contact);
          EXPECT_EQ(l.cone, 0.5 * (law.has(THRESHOLD) ? rubbing_load(ROUGH.threshold, N) : N));
        } else {
          EXPECT_EQ(l.cone, 0.0);
        }
        if (law.has(FRICTION)) { EXPECT_LE(s.contact * norm(l.shear), l.cone * (1.0 + 1e-12)); }
        // a bond stays where a dashpot takes all of its load
        if (l.contact == 0.0 && !(law.has(ADHESION) && law.has(RESTITUTION))) {
          EXPECT_EQ(s.state, ContactState::NONE);
          EXPECT_EQ(s.contact, 0.0);
        }
        // nothing but friction can act tangentially without a film
        if (!law.has(SHEAR)) { EXPECT_LE(norm(l.shear), l.cone * (1.0 + 1e-12)); }
      }
    }
  });
}

TEST(PairLaw, APairThatDoesNotTouchHasNoContact)
{
  // rounding of un/a and back must not make one
  for_each_law([](const Law &law) {
    Random rnd(6);
    for (int trial = 0; trial < 1000; trial++) {
      const double ri = rnd.uniform(0.5, 1.5), rj = rnd.uniform(0.5, 1.5), a = 0.5 * (ri + rj);
      Pair pair{law, ROUGH, VISCOUS};
      pair.start((ri + rj + a * rnd.uniform(0.031, 0.5)) * rnd.unit(), {}, ri, rj, a);
      EXPECT_EQ(pair.load().contact, 0.0);
      EXPECT_EQ(split(pair.load()).state, ContactState::NONE);
    }
  });
}

// Load over rate of equal spheres of radius a at the gap u, spinning slowly on stiff springs, so
// that the films have relaxed: resistances of the composed law.
static Load slow_spin(unsigned mask, double a, double u, const Vec3 &wi, const Vec3 &wj)
{
  const double kt = 1e9, dt = 1.0, rate = 1e-6;
  const PairCoeffs c = make_coeffs(1.0, 1.0, 0.0, kt, 0.0);
  Pair pair{law_of(mask), c, make_film(1.0, 2.0, Range::CUT, 0.6)};
  const Vec3 xi{a * (2.0 + u), 0.0, 0.0};
  pair.start(xi, {}, a, a, a);
  for (int n = 0; n < 3; n++) pair.move(xi, {}, rate * wi, rate * wj, dt);
  Load l = pair.load();
  l.shear = (1.0 / rate) * l.shear;
  l.couple = (1.0 / rate) * l.couple;
  return l;
}

TEST(PairLaw, TorquesOfASpinningSphereAreThoseOfJeffreyAndOnishi)
{
  // coefficients of ln(1/xi) over 6 pi eta a^3: Y^C11 4/15, Y^C12 1/15; over 6 pi eta a^2:
  // Y^B11 -1/6
  for (const double a : {1.0, 3.0}) {
    const double per_force = 1.0 / (6.0 * PI_ * a * a), per_torque = per_force / a;
    double c11[2], c12[2], b11[2];
    for (int m = 0; m < 2; m++) {
      const double u = m ? 1e-8 : 1e-6;
      const Load l = slow_spin(SHEAR | ROLL, a, u, {0.0, 0.0, 1.0}, {});
      const PairGeometry g = pair_geometry({a * (2.0 + u), 0.0, 0.0}, {}, a, a, a);
      c11[m] = -torque_on_i(l, g).z * per_torque;
      c12[m] = -torque_on_j(l, g).z * per_torque;
      b11[m] = force_on_i(l, g).y * per_force;
    }
    const double ln = std::log(100.0);
    EXPECT_NEAR((c11[1] - c11[0]) / ln, 4.0 / 15.0, 2e-5);
    EXPECT_NEAR((c12[1] - c12[0]) / ln, 1.0 / 15.0, 2e-5);
    EXPECT_NEAR((b11[1] - b11[0]) / ln, 1.0 / 6.0, 2e-5);
  }
}

TEST(PairLaw, OppositeSpinsAreResistedByTheRollingTorqueAlone)
{
  for (const double a : {1.0, 3.0}) {
    const Load l = slow_spin(SHEAR | ROLL | TWIST, a, 0.01, {0.0, 0.5, 0.0}, {0.0, -0.5, 0.0});
    expect_near(l.shear, {}, 1e-12);
    // pi eta a^3 (3/5 + 0.504 u) ln(1/u)
    const double torque = PI_ * a * a * a * (0.6 + 0.00504) * std::log(100.0);
    expect_near(l.couple, {0.0, -torque, 0.0}, 1e-6 * torque);
  }
}

TEST(PairLaw, TwistIsResistedAboutTheNormal)
{
  for (const double a : {1.0, 3.0}) {
    const Load l = slow_spin(SHEAR | ROLL | TWIST, a, 0.01, {1.0, 0.0, 0.0}, {});
    // pi eta a^3 u ln(1/u)
    const double torque = PI_ * a * a * a * 0.01 * std::log(100.0);
    expect_near(l.couple, {-torque, 0.0, 0.0}, 1e-6 * torque);
  }
}

TEST(PairLaw, FilmModesFollowAMovingGapToSecondOrder)
{
  // differences of three steps, a half each, short beside the relaxation of the films; friction is
  // of first order and off
  const PairCoeffs soft = make_coeffs(1000.0, 1000.0, 0.03, 2.0, 0.0);
  for_each_basic_law([&](const Law &law) {
    if (law.has(FRICTION)) return;
    Vec3 shear[3], couple[3];
    for (int k = 0; k < 3; k++) {
      const int steps = 1000 << k;
      const Load l = loads_along(law.mask, 64, soft, VISCOUS, steps, 8.0 / steps).back();
      shear[k] = l.shear;
      couple[k] = l.couple;
    }
    if (law.has(SHEAR)) {
      EXPECT_NEAR(norm(shear[0] - shear[1]) / norm(shear[1] - shear[2]), 4.0, 0.4);
    }
    if (law.has(ROLL | TWIST)) {
      EXPECT_NEAR(norm(couple[0] - couple[1]) / norm(couple[1] - couple[2]), 4.0, 0.4);
    }
  });
}

TEST(PairLaw, SlidingIsResistedByTheFilmOfFrankelAndAcrivos)
{
  const double u = 0.02, dt = 1e-3, speed = 1e-4;
  const PairCoeffs c = make_coeffs(1.0, 1.0, 0.0, 1e8, 0.0);
  Pair pair{LAWS[SHEAR], c, VISCOUS};
  pair.start({2.0 + u, 0.0, 0.0}, {}, 1.0, 1.0, 1.0);
  for (int n = 1; n <= 5; n++) pair.move({2.0 + u, speed * n * dt, 0.0}, {}, {}, {}, dt);
  const double resistance = 0.5 * PI_ * 2.0 * (-2.0 + 2.02 * std::log(101.0));
  EXPECT_NEAR(pair.load().shear.y / speed, -resistance, 1e-5 * resistance);
}

TEST(PairLaw, PressedRoughPairSticksThenSlidesAtMuN)
{
  const PairCoeffs c = make_coeffs(1000.0, 1000.0, 0.03, 700.0, 0.5);
  Pair pair{LAWS[FRICTION], c, VISCOUS};
  const double r = 1.99;    // un = -0.01: N = 500*(0.03 + 0.01) = 20
  pair.start({r, 0.0, 0.0}, {}, 1.0, 1.0, 1.0);
  double x = 0.0;
  auto slide = [&](double distance) {
    x += distance;
    // round the other sphere, so that the gap stays
    pair.move({r * std::cos(x / r), r * std::sin(x / r), 0.0}, {}, {}, {}, 1e-3);
  };
  slide(0.01);
  EXPECT_NEAR(norm(pair.load().shear), 7.0, 1e-3);
  EXPECT_EQ(split(pair.load()).state, ContactState::STICK);
  for (int n = 0; n < 20; n++) slide(0.01);
  EXPECT_NEAR(pair.load().contact, 20.0, 1e-9);
  EXPECT_NEAR(norm(pair.load().shear), 10.0, 1e-9);
  EXPECT_EQ(split(pair.load()).state, ContactState::SLIP);
}

// Largest difference of force and couple, seen from the turning frame, when the whole motion is
// superposed with a rotation of angular velocity `rate` about `spin`.
static double turning_difference(unsigned mask, std::uint64_t seed, int steps, double end)
{
  Random rnd(seed);
  const Motion m(rnd);
  const Vec3 spin = rnd.unit();
  const double dt = end / steps, rate = 1.5;
  Pair plain{law_of(mask), ROUGH, VISCOUS}, turning{law_of(mask), ROUGH, VISCOUS};
  plain.start(m);
  turning.start(m);
  double worst = 0.0, size = 0.0;
  for (int n = 1; n <= steps; n++) {
    const double t = n * dt, middle = t - 0.5 * dt;
    plain.follow(m, n, dt);
    turning.move(rotated(m.xi(t), spin, rate * t), rotated(m.xj(t), spin, rate * t),
                 rate * spin + rotated(m.wi(middle), spin, rate * middle),
                 rate * spin + rotated(m.wj(middle), spin, rate * middle), dt);
    const Load a = plain.load(), b = turning.load();
    const Vec3 back = rotated(force_on_i(b, turning.g), spin, -rate * t);
    const Vec3 back_couple = rotated(b.couple, spin, -rate * t);
    worst = std::fmax(worst, norm(back - force_on_i(a, plain.g)));
    worst = std::fmax(worst, norm(back_couple - a.couple));
    size = std::fmax(size, norm(force_on_i(a, plain.g)));
  }
  return worst / size;
}

TEST(PairLaw, SuperposedRotationDoesNotChangeTheLoad)
{
  for_each_law([](const Law &law) {
    const double coarse = turning_difference(law.mask, 7, 2000, 10.0);
    const double fine = turning_difference(law.mask, 7, 4000, 10.0);
    EXPECT_LT(fine, 2e-3);
    // an error of the step, not of the law: it goes away with the step
    EXPECT_LE(fine, 0.6 * coarse + 1e-12);
  });
}

TEST(PairLaw, SuperposedRotationIsOfSecondOrderWithoutFriction)
{
  // friction is of first order, where it turns and where it begins to slip
  for_each_basic_law([](const Law &law) {
    if (law.has(FRICTION)) return;
    const double coarse = turning_difference(law.mask, 8, 2000, 10.0);
    const double fine = turning_difference(law.mask, 8, 4000, 10.0);
    if (fine > 1e-11) { EXPECT_NEAR(coarse / fine, 4.0, 0.5); }
  });
}

TEST(PairLaw, LoadedPairThatTurnsAsASolidKeepsItsLoad)
{
  // dt tiny beside every relaxation: only the turning acts
  for_each_law([](const Law &law) {
    Random rnd(9);
    const Film stiff = make_film(1e12, 1.0, Range::CUT, 0.6);
    Pair pair{law, ROUGH, stiff};
    const Vec3 n = rnd.unit(), spin = rnd.unit(), centre = rnd.vector(1.0);
    const Vec3 xi = 1.19 * n, xj = -0.8 * n;
    pair.start(xi, xj, 1.2, 0.8, 0.96);
    // a load to carry: sticking shear, roll, twist
    Vec3 q = tangential(rnd.unit(), n);
    if (law.has(SHEAR | FRICTION)) put_vector(1e-3 * q, pair.history + law.shear_slot);
    if (law.has(ROLL)) put_vector(2e-3 * q, pair.history + law.roll_slot);
    if (law.has(TWIST)) pair.history[law.twist_slot] = 3e-3;
    const Load before = pair.load();
    const Vec3 force = force_on_i(before, pair.g);
    const int steps = 4000;
    const double angle = 3.0 / steps, dt = 1e-6;
    for (int m = 1; m <= steps; m++) {
      pair.move(centre + rotated(xi - centre, spin, m * angle),
                centre + rotated(xj - centre, spin, m * angle), (angle / dt) * spin,
                (angle / dt) * spin, dt);
    }
    const Load after = pair.load();
    expect_near(rotated(force_on_i(after, pair.g), spin, -3.0), force, 1e-5 * norm(force));
    expect_near(rotated(after.couple, spin, -3.0), before.couple,
                1e-5 * norm(before.couple) + 1e-6);
  });
}

TEST(PairLaw, NoModeOfAnyMaskMakesEnergy)
{
  for_each_law([](const Law &law) {
    for (std::uint64_t seed = 30; seed < 33; seed++) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random rnd(seed);
      const Film film = make_film(rnd.log_uniform(0.03, 30.0), rnd.uniform(0.1, 1.0),
                                  rnd.coin() ? Range::CUT : Range::SHIFTED, 0.6);
      const PairCoeffs basic =
          make_coeffs(1000.0, 1000.0 * rnd.log_uniform(0.1, 10.0), rnd.log_uniform(0.005, 0.05),
                      700.0, rnd.uniform(0.0, 1.0));
      const PairCoeffs c = extended(basic, rnd.uniform(0.0, 0.01), rnd.log_uniform(1.0, 50.0),
                                    rnd.log_uniform(20.0, 100.0), rnd.log_uniform(1.0, 50.0));
      const Balance b = balance_along(law.mask, seed, c, film, 4000, 0.005);
      // the trapezoidal work of a step is off by its curvature, dt^2 of a motion of frequency 1
      const char *name[4] = {"normal", "tangential", "couple", "all"};
      for (int k = 0; k < 4; k++) {
        EXPECT_LE(b.deepest[k], 3e-4 * b.peak + 1e-12) << name[k];
        EXPECT_GE(b.dissipated[k], -3e-4 * b.peak - 1e-12) << name[k];
      }
    }
  });
}

TEST(PairLaw, EnergyMadeByStepsVanishesWithTheStep)
{
  for_each_law([](const Law &law) {
    const double coarse = balance_along(law.mask, 40, ROUGH, VISCOUS, 2000, 0.01).deepest[3];
    const double fine = balance_along(law.mask, 40, ROUGH, VISCOUS, 8000, 0.0025).deepest[3];
    EXPECT_LE(fine, 0.3 * coarse + 1e-12);
  });
}

TEST(PairLaw, FilmsAndFrictionDoDissipate)
{
  // or else the inequality above would be no test
  const Balance b = balance_along(31, 41, ROUGH, VISCOUS, 4000, 0.005);
  for (int k = 0; k < 4; k++) EXPECT_GT(b.dissipated[k], 0.05 * b.peak) << k;
}

TEST(PairLaw, WithoutViscosityAndFrictionEnergyIsConserved)
{
  const Film dry = make_film(0.0, 1.0, Range::CUT, 0.6);
  // a bond would lose energy where it breaks, a dashpot always
  PairCoeffs smooth =
      extended(make_coeffs(1000.0, 1000.0, 0.03, 700.0, 0.0), 0.0, 20.0, 50.0, 15.0);
  smooth.restitution = 0.0;
  for_each_law([&](const Law &law) {
    for (std::uint64_t seed = 50; seed < 53; seed++) {
      const Balance b = balance_along(law.mask, seed, smooth, dry, 8000, 0.0025);
      EXPECT_GT(b.peak, 0.0);
      EXPECT_NEAR(b.dissipated[3], 0.0, 1e-4 * b.peak);
      EXPECT_LE(b.deepest[3], 1e-4 * b.peak);
      EXPECT_EQ(b.work[1], 0.0);
      EXPECT_EQ(b.work[2], 0.0);
    }
  });
}

TEST(PairLaw, ModesOnlyMeetInTheGap)
{
  // each origin is that of the mask with its own bits and the squeeze bit alone, bit for bit
  for_each_basic_law([](const Law &law) {
    const unsigned M = law.mask, gap = M & SQUEEZE, own = M & (SHEAR | FRICTION);
    const auto full = loads_along(M, 60, ROUGH, VISCOUS, 600, 0.02);
    const auto normal = loads_along(gap, 60, ROUGH, VISCOUS, 600, 0.02);
    const auto shear = loads_along(gap | own, 60, ROUGH, VISCOUS, 600, 0.02);
    const auto roll = loads_along(gap | (M & ROLL), 60, ROUGH, VISCOUS, 600, 0.02);
    const auto twist = loads_along(gap | (M & TWIST), 60, ROUGH, VISCOUS, 600, 0.02);
    for (std::size_t n = 0; n < full.size(); n++) {
      ASSERT_EQ(full[n].contact, normal[n].contact);
      ASSERT_EQ(full[n].film, normal[n].film);
      ASSERT_EQ(full[n].u, normal[n].u);
      expect_same(full[n].shear, shear[n].shear);
      ASSERT_EQ(full[n].cone, shear[n].cone);
      expect_near(full[n].couple, roll[n].couple + twist[n].couple, 1e-12);
    }
  });
}

TEST(PairLaw, WithoutFrictionIsFrictionWithMuZero)
{
  PairCoeffs frictionless = ROUGH;
  frictionless.mu = 0.0;
  for_each_basic_law([&](const Law &law) {
    const auto with = loads_along(law.mask | FRICTION, 61, frictionless, VISCOUS, 600, 0.02);
    const auto without = loads_along(law.mask & ~unsigned(FRICTION), 61, ROUGH, VISCOUS, 600, 0.02);
    for (std::size_t n = 0; n < with.size(); n++) expect_same_load(with[n], without[n]);
  });
}

TEST(PairLaw, WithoutFilmModesIsTheFullLawWithoutViscosity)
{
  // dry: only friction and the elastic contact are left of mask 31
  const Film dry = make_film(0.0, 1.0, Range::CUT, 0.6);
  const auto bare = loads_along(FRICTION, 62, ROUGH, VISCOUS, 600, 0.02);
  for_each_basic_law([&](const Law &law) {
    if (!law.has(FRICTION)) return;
    const auto full = loads_along(law.mask, 62, ROUGH, dry, 600, 0.02);
    for (std::size_t n = 0; n < full.size(); n++) expect_same_load(full[n], bare[n]);
  });
}

TEST(PairLaw, WithoutSqueezeIsTheFullLawWhereTheFilmIsAtRest)
{
  // surfaces that stay: the film of the normal mode carries nothing, u is that of elastic rest
  for_each_basic_law([](const Law &law) {
    if (law.has(SQUEEZE)) return;

    for (const double un : {0.2, 0.01, -0.01}) {
      Random rnd(63);
      const WaveVector direction(rnd, 0.6), wi(rnd, 0.5), wj(rnd, 0.5);
      Pair off{law, ROUGH, VISCOUS};
      Pair on{LAWS[law.mask | SQUEEZE], ROUGH, VISCOUS};
      auto at = [&](double t) {
        const Vec3 d = Vec3{1.0, 0.2, 0.3} + direction(t);
        return ((2.0 + un) / norm(d)) * d;
      };
      off.start(at(0.0), {}, 1.2, 0.8, 0.96);
      on.start(at(0.0), {}, 1.2, 0.8, 0.96);
      for (int n = 1; n <= 500; n++) {
        const double t = 0.02 * n;
        off.move(at(t), {}, wi(t), wj(t), 0.02);
        on.move(at(t), {}, wi(t), wj(t), 0.02);
        const Load a = off.load(), b = on.load();
        const double tolerance = 1e-9 * (1.0 + a.contact);
        EXPECT_NEAR(a.contact, b.contact, tolerance);
        EXPECT_NEAR(b.film, 0.0, tolerance);
        expect_near(a.shear, b.shear, tolerance);
        expect_near(a.couple, b.couple, tolerance);
      }
    }
  });
}

TEST(PairLaw, AModeThatIsNotExcitedMakesNoDifference)
{
  // head-on, without spins: every mask has the force of its squeeze bit
  for_each_basic_law([](const Law &law) {
    Pair full{law, ROUGH, VISCOUS};
    Pair normal{LAWS[law.mask & SQUEEZE], ROUGH, VISCOUS};
    const Vec3 e{0.6, 0.0, 0.8};
    auto at = [&](double t) {
      return (2.04 + 0.08 * std::cos(t)) * e;
    };
    full.start(at(0.0), {}, 1.2, 0.8, 0.96);
    normal.start(at(0.0), {}, 1.2, 0.8, 0.96);
    for (int n = 1; n <= 500; n++) {
      full.move(at(0.02 * n), {}, {}, {}, 0.02);
      normal.move(at(0.02 * n), {}, {}, {}, 0.02);
      const Load a = full.load(), b = normal.load();
      EXPECT_EQ(a.contact, b.contact);
      EXPECT_EQ(a.film, b.film);
      expect_near(a.shear, {}, 1e-11);
      expect_near(a.couple, {}, 1e-11);
    }
  });
}

TEST(PairLaw, IsFiniteForAnythingInEveryMask)
{
  for_each_law([](const Law &law) {
    Random rnd(70);
    for (int trial = 0; trial < 300; trial++) {
      const double eps = rnd.coin() ? rnd.log_uniform(1e-6, 0.1) : 0.0;
      const PairCoeffs basic = make_coeffs(1.0, rnd.log_uniform(1e-6, 1e6), eps,
                                           rnd.log_uniform(1e-6, 1e6), rnd.uniform(0.0, 2.0));
      const PairCoeffs c = extended(basic, eps * rnd.uniform(0.0, 1.0), rnd.log_uniform(1e-9, 1e3),
                                    rnd.log_uniform(1.0, 1e6), rnd.log_uniform(1e-6, 1e6));
      const double eta = rnd.coin() ? rnd.log_uniform(1e-13, 1e13) : 0.0;
      const Film f =
          make_film(eta, rnd.log_uniform(1e-2, 2.0), rnd.coin() ? Range::CUT : Range::SHIFTED, 0.6);
      Pair pair{law, c, f};
      auto place = [&] {
        return (2.0 + rnd.uniform(-0.5, 0.5)) * rnd.unit();
      };
      pair.start(place(), {}, 1.2, 0.8, 0.96);
      for (int n = 0; n < 10; n++) {
        const double dt = rnd.log_uniform(1e-6, 1e3);
        pair.move(place(), {}, rnd.vector(1.0 / dt), rnd.vector(1.0 / dt), dt);
        const Load l = pair.load();
        ASSERT_TRUE(std::isfinite(norm(force_on_i(l, pair.g)))) << "trial " << trial;
        ASSERT_TRUE(std::isfinite(norm(torque_on_i(l, pair.g)))) << "trial " << trial;
      }
    }
  });
}
