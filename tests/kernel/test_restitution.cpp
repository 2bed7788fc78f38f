// Shows the coefficient of restitution: its damping ratio against an integration of the contact,
// collisions of any two spheres, the order of the step, and that nothing attracts.

#include "lubcontact_law.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

// -ln e of x'' = -x - 2 beta x' from x = 0, x' = 1 to x'' = 0: Runge-Kutta of fourth order, the end
// by Newton's rule.
double integrated_exponent(double beta)
{
  struct State {
    double x, v;
  };
  auto slope = [beta](const State &s) {
    return State{s.v, -s.x - 2.0 * beta * s.v};
  };
  auto moved = [](const State &s, const State &by, double h) {
    return State{s.x + h * by.x, s.v + h * by.v};
  };
  auto step = [&](const State &s, double h) {
    const State a = slope(s), b = slope(moved(s, a, 0.5 * h)), c = slope(moved(s, b, 0.5 * h)),
                d = slope(moved(s, c, h));
    return State{s.x + h / 6.0 * (a.x + 2.0 * b.x + 2.0 * c.x + d.x),
                 s.v + h / 6.0 * (a.v + 2.0 * b.v + 2.0 * c.v + d.v)};
  };
  const double h = 1e-3 / (1.0 + beta);
  auto force = [beta](const State &s) {
    return s.x + 2.0 * beta * s.v;
  };
  State now{0.0, 1.0}, next = step(now, h);
  while (force(next) > 0.0) {
    now = next;
    next = step(now, h);
  }
  double t = 0.5 * h;
  for (int n = 0; n < 20; n++) {
    const State there = step(now, t);
    t -= force(there) / (there.v + 2.0 * beta * slope(there).v);
  }
  return -std::log(-step(now, t).v);
}

// Two spheres or discs that collide head on, one of the masses m, at a steps per contact: the
// fraction of their velocity that is left.
struct Collision {
  double e = 0.5, g = 1000.0, k = 1000.0, eps = 0.0;
  double mi = 1.0, mj = 1.0, ri = 1.0, rj = 1.0;
  double omega_dt = 0.1, phase = 0.3;

  double deepest_pull = 0.0;
  int steps = 0;

  double run()
  {
    using E = Effects<RESTITUTION>;
    TypeCoeffs types;
    types.g = g;
    types.kt = 0.5 * g;
    types.asperity = k;
    types.roughness_a = eps;
    types.restitution = e;
    Settings settings;
    settings.viscosity = 0.0;
    settings.films = 0;
    const PairCoeffs c = pair_coeffs(settings, types);
    const Film film = film_of(settings);
    const double m = mi * mj / (mi + mj);
    const double whole = eps > 0.0 ? 1.0 / (1.0 / g + 1.0 / k) : g;
    const double dt = omega_dt / std::sqrt(whole / m);
    const double a = effective_radius(Radius::HARMONIC, ri, rj);
    const double speed = 0.1 * a * (eps > 0.0 ? eps : 0.01) * std::sqrt(whole / m);
    double x = ri + rj + a * eps + phase * speed * dt, v = -speed, F = 0.0;    // of i from j
    double history[E::HISTORY_SIZE + 1];
    bool known = false;
    // velocity Verlet of the relative motion; a pair is known while it touches
    for (steps = 0; steps < 100000; steps++) {
      v += 0.5 * dt * F / m;
      x += dt * v;
      const PairGeometry geometry = pair_geometry({x, 0.0, 0.0}, {}, ri, rj, a);
      Body i{{x, 0.0, 0.0}, {v, 0.0, 0.0}, {}, ri}, j{{}, {}, {}, rj};
      i.mass = mi;
      j.mass = mj;
      F = 0.0;
      if (geometry.un < a * eps) {
        if (!known) earlier_history<E>(c, geometry, i, j, dt, history);
        known = true;
        next_history<E>(c, film, geometry, i, j, dt, history, history);
        const Load load = pair_load<E>(c, film, geometry, history);
        F = force_on_i(load, geometry).x;
        deepest_pull = std::fmin(deepest_pull, F);
      } else if (known) {
        return v / speed;
      }
      v += 0.5 * dt * F / m;
    }
    return -1.0;
  }
};

// Largest error of e over where the contact begins in a step.
double worst_error(Collision c)
{
  double worst = 0.0;
  for (c.phase = 0.05; c.phase < 1.0; c.phase += 0.1)
    worst = std::fmax(worst, std::fabs(c.run() - c.e));
  return worst;
}

}    // namespace

TEST(Restitution, IsThatOfAContactWhoseForceVanishes)
{
  for (const double beta : {1e-3, 0.1, 0.4, 0.7, 0.99, 1.0, 1.01, 1.5, 4.0, 20.0})
    EXPECT_NEAR(restitution_exponent(beta), integrated_exponent(beta), 1e-9) << beta;
  // about the critical damping nothing jumps
  EXPECT_NEAR(restitution_exponent(1.0 - 1e-12), 2.0, 1e-11);
  EXPECT_NEAR(restitution_exponent(1.0 + 1e-12), 2.0, 1e-11);
  // weak damping, of any rule for the end: pi beta; with attraction to the end more is lost
  EXPECT_NEAR(restitution_exponent(1e-6), PI * 1e-6, 3e-12);
  EXPECT_LT(restitution_exponent(0.5), PI * 0.5 / std::sqrt(0.75));
}

TEST(Restitution, HasOneDampingRatio)
{
  for (const double e : {1e-12, 1e-3, 0.1, std::exp(-2.0), 0.3, 0.5, 0.9, 1.0 - 1e-9})
    EXPECT_NEAR(restitution_exponent(damping_ratio(e)), -std::log(e), 1e-13 * (1.0 - std::log(e)));
  EXPECT_EQ(damping_ratio(1.0), 0.0);
  EXPECT_NEAR(damping_ratio(std::exp(-2.0)), 1.0, 1e-12);
}

TEST(Restitution, ComesOutOfACollisionWithinTheErrorOfTheStep)
{
  for (const double e : {0.02, 0.1, 0.3, 0.5, 0.8, 0.95, 1.0})
    for (const double mass : {0.02, 1.0, 300.0})
      for (const double size : {1.0, 0.2})
        for (const double eps : {0.0, 0.02}) {
          Collision c;
          c.e = e;
          c.mj = mass;
          c.rj = size;
          c.eps = eps;
          c.k = 400.0;
          c.omega_dt = 0.05;
          EXPECT_LE(worst_error(c), 1e-3) << e << ' ' << mass << ' ' << size << ' ' << eps;
        }
}

TEST(Restitution, IsOfSecondOrderInTheStep)
{
  for (const double e : {0.1, 0.5, 0.9}) {
    Collision c;
    c.e = e;
    auto at = [&c](double omega_dt) {
      c.omega_dt = omega_dt;
      return worst_error(c);
    };
    EXPECT_NEAR(at(0.08) / at(0.02), 16.0, 6.0) << e;
  }
}

TEST(Restitution, NeverAttractsAndEndsAtAnyStableStep)
{
  for (const double e : {1e-4, 0.01, 0.1, 0.5, 0.9})
    for (const double omega_dt : {0.02, 0.2, 0.5, 0.7}) {
      Collision c;
      c.e = e;
      c.omega_dt = omega_dt;
      const double left = c.run();
      EXPECT_GE(left, 0.0) << e << ' ' << omega_dt;
      EXPECT_LE(left, 1.0) << e << ' ' << omega_dt;
      EXPECT_EQ(c.deepest_pull, 0.0);
    }
}

// The time (pi - 2 arcsin beta)/sqrt(1 - beta^2) until the force vanishes, and the rest of the way
// at the velocity that is left.
TEST(Restitution, ForceLastsAsLongAsTheContactOfTheDampedOscillator)
{
  const double beta = 0.3, t = (PI - 2.0 * std::asin(beta)) / std::sqrt(1.0 - beta * beta);
  Collision c;
  c.e = std::exp(-restitution_exponent(beta));
  c.omega_dt = 1e-3;
  c.run();
  // x at the end of the force is -2 beta x'
  EXPECT_NEAR(c.steps * c.omega_dt, t + 2.0 * beta, 3e-3);
}

TEST(Restitution, ContactAtRestHasNoDashpot)
{
  EXPECT_EQ(dashpot_force(5.0, 2.0, 0.0, -0.1, -0.1, 1e-3), 0.0);
  EXPECT_EQ(dashpot_force(5.0, 2.0, 0.01, 0.02, 0.011, 1e-3), 0.0);    // does not touch
  EXPECT_GT(dashpot_force(5.0, 2.0, 0.01, 0.02, 0.009, 1e-3), 0.0);
  EXPECT_LT(dashpot_force(5.0, 2.0, 0.01, -0.02, -0.019, 1e-3), 0.0);
  EXPECT_EQ(dashpot_force(0.0, 2.0, 0.01, 0.02, -0.02, 1e-3), 0.0);
  EXPECT_EQ(damped_contact(2.0, -3.0), 0.0);
  EXPECT_EQ(damped_contact(-1.0, 3.0), -1.0);    // held by adhesion
  EXPECT_EQ(damped_contact(0.0, 3.0), 0.0);
  EXPECT_EQ(damped_contact(2.0, -1.5), 0.5);
}

TEST(Restitution, ResistanceIsThatOfTheContactInShortStepsAndBoundedInLongOnes)
{
  const double coeff = 30.0, mass = 2.0, zeta = coeff * std::sqrt(mass);
  EXPECT_NEAR(step_resistance(coeff, mass, 1e-9), zeta, 1e-6 * zeta);
  for (const double dt : {1e-3, 0.1, 10.0, 1e9}) {
    const double r = step_resistance(coeff, mass, dt);
    EXPECT_LT(r, zeta);
    EXPECT_LE(r * dt, 2.0 * mass * (1.0 + 1e-12));
    EXPECT_LE(dashpot_stiffness(coeff, mass, dt), 2.0 * mass / (dt * dt) * (1.0 + 1e-12));
    // of the oscillator with the inertia that half a step leaves: the same damping ratio
    EXPECT_NEAR(r / std::sqrt(1.0 - 0.5 * r * dt / mass), zeta, 1e-6 * zeta) << dt;
    if (dt > 0.1) break;
  }
}

TEST(Restitution, OfBulkAndAsperitiesTogether)
{
  EXPECT_DOUBLE_EQ(dry_stiffness(600.0, 300.0, 0.01), 200.0);
  EXPECT_DOUBLE_EQ(dry_stiffness(600.0, 300.0, 0.0), 600.0);
  EXPECT_DOUBLE_EQ(restitution_coeff(1.0, 600.0), 0.0);
}
