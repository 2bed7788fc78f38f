// Two spheres where the film is hardest to follow: closed, pressed for long, released, crushed, born
// overlapping, at the border of contact, with extreme coefficients. Oracles: closed forms of
// du/dt = u (r - A u) and of Newton's law m v' = P, P = -c u'/u, which integrates to
//     c ln u + m v = const + (outer force) t          c = (3/2) pi eta a^2
// for smooth spheres whatever the stiffness, and stored SciPy solutions.

#include "../kernel/reference/gap_reference.h"
#include "lubcontact_stiffness.h"
#include "scene.h"

using namespace hard_cases;
using namespace testing_tools;

namespace {

constexpr unsigned EVERYTHING = SQUEEZE | SHEAR | FRICTION | ROLL | TWIST;
const Law FULL = make_law<EVERYTHING>();

GapLaw gap_law(double alpha, double eps)
{
  return {alpha, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, false};
}

double film_coefficient(double eta, double a)
{
  return 1.5 * PI_ * eta * a * a;
}

// A sphere above a fixed one of the same radius 1, at the gap un; range of the film 1.
Scene above(const PairCoeffs &c, double eta, double un, double mass, double weight, double dt)
{
  Scene s{FULL, c, make_film(eta, 1.0, Range::CUT, 0.6)};
  s.dt = dt;
  s.gravity = {0.0, 0.0, -weight / mass};
  s.spheres = {{{}, {}, {}, 1.0, 0.0}, {{0.0, 0.0, 2.0 + un}, {}, {}, 1.0, mass}};
  s.start();
  return s;
}

double ln_gap(const Scene &s)
{
  return s.pairs[0].history[1];
}

double speed(const Scene &s)
{
  return s.spheres[1].v.z;
}

// ln u of an opening pair, un linear from un0 to un1 over h, A = 1: quadrature of
// w1 = w0 exp(-X(h)) + integral exp(X(t) - X(h)) dt, X the integral of un.
double opened(double u0, double un0, double un1, double h)
{
  auto X = [=](long double t) {
    return un0 * t + (un1 - un0) * t * t / (2.0L * h);
  };
  const long double begin = std::max(0.0L, static_cast<long double>(h) - 60.0L / un1);
  const int n = 100000;
  long double sum = 0.0;
  for (int m = 0; m <= n; m++) {
    const long double t = begin + (h - begin) * m / n;
    sum += (m == 0 || m == n ? 1.0L : m % 2 ? 4.0L : 2.0L) * std::exp(X(t) - X(h));
  }
  sum *= (h - begin) / (3.0L * n);
  return static_cast<double>(-std::log(std::exp(-X(h)) / u0 + sum));
}

}    // namespace

TEST(HardGaps, SmoothSpheresUnderAWeightForAMillionSteps)
{
  // u passes 1e-280 and the smallest number
  const double g = 5e3, weight = 100.0, mass = 1e-3, eta = 1.0, u0 = 0.1;
  const double c = film_coefficient(eta, 1.0);
  Scene s = above(make_coeffs(g, g, 0.0, g, 0.5), eta, u0, mass, weight, 0.1 * std::sqrt(mass / g));
  double worst = 0.0;
  for (int n = 1; n <= 1000000; n++) {
    s.step();
    if (n % 1000) continue;
    const double exact = std::log(u0) - weight / c * n * s.dt - mass * speed(s) / c;
    worst = std::fmax(worst, std::fabs(ln_gap(s) - exact));
    ASSERT_EQ(s.pairs[0].load.contact, 0.0) << "smooth spheres do not touch";
    ASSERT_EQ(s.pairs[0].load.cone, 0.0) << "nor rub";
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(ln_gap(s), -745.0);    // exp() of it is 0
}

TEST(HardGaps, SuctionLastsAsLongAsThePressure)
{
  // pressed by the weight for t1, then pulled by it: m v + c ln u says when the gap is back
  const double g = 5e3, weight = 100.0, mass = 1e-3, eta = 1.0, u0 = 0.1;
  const double c = film_coefficient(eta, 1.0);
  for (const int pressed : {1000, 10000, 100000}) {
    Scene s =
        above(make_coeffs(g, g, 0.0, g, 0.5), eta, u0, mass, weight, 0.1 * std::sqrt(mass / g));
    for (int n = 0; n < pressed; n++) s.step();
    s.gravity = -1.0 * s.gravity;
    const double deepest = ln_gap(s);
    int pulled = 0;
    while (ln_gap(s) < std::log(u0) && pulled < 3 * pressed) {
      s.step();
      pulled++;
    }
    EXPECT_LT(deepest, std::log(u0) - 0.8 * weight / c * pressed * s.dt);
    // the impulse m v of the sphere, which already leaves, is the rest
    const double late = (pulled - pressed) * s.dt * weight;
    EXPECT_NEAR(late, mass * speed(s), 2.0 * weight * s.dt) << pressed;
  }
}

TEST(HardGaps, SmoothSpheresBornDeepInsideEachOtherKeepTheirImpulse)
{
  // a film of the least thickness holds them: they swing on the bulk and stay
  const double g = 1e3, mass = 2.0, eta = 1.0;
  for (const double un : {-1e-9, -0.01, -0.3, -0.4, -0.95}) {
    Scene s =
        above(make_coeffs(g, g, 0.0, g, 0.5), eta, un, mass, 1e-300, 0.02 * std::sqrt(mass / g));
    EXPECT_NEAR(s.pairs[0].load.normal, -g * un, 2.0 * THINNEST * g) << "repels at once";
    const double c = film_coefficient(eta, 1.0), energy = s.stored() + s.kinetic();
    const double most = mass * std::fabs(un) * std::sqrt(g / mass) / c;
    for (int n = 1; n <= 20000 && s.pairs[0].known; n++) {
      s.step();
      if (!s.pairs[0].known) break;
      const double impulse = ln_gap(s) + mass * speed(s) / c;
      ASSERT_NEAR(impulse, std::log(THINNEST), 1e-3 * most + 1e-9) << "un " << un << " step " << n;
      ASSERT_LE(s.stored() + s.kinetic(), energy * (1.0 + 1e-3));
      ASSERT_LT(s.spheres[1].x.z - 2.0, std::fabs(un) * 1.001 + 2.0 * THINNEST);
    }
  }
}

TEST(HardGaps, DrySpheresBornDeepInsideEachOtherLeaveWithTheEnergyOfTheirSprings)
{
  const double g = 1e3, k = 500.0, eps = 0.02, mass = 2.0;
  for (const double un : {-1e-6, -0.005, -0.3, -0.95}) {
    const double dt = 2e-3 * std::sqrt(mass / g);
    Scene s = above(make_coeffs(g, k, eps, g, 0.5), 0.0, un, mass, 1e-300, dt);
    for (int n = 0; n < 1000000 && s.spheres[1].x.z < 2.1; n++) {
      s.step();
      ASSERT_GE(s.pairs[0].load.normal, 0.0) << "never attracts";
      ASSERT_EQ(s.pairs[0].load.film, 0.0);
    }
    // asperities and bulk in series until the asperities are flat, at un = -(k/g) eps; then the bulk
    const double series = g * k / (g + k), flat = -k / g * eps, soft = std::fmax(un, flat);
    double energy = 0.5 * series * (eps - soft) * (eps - soft);
    if (un < flat) energy += 0.5 * g * (un * un - flat * flat);
    EXPECT_NEAR(0.5 * mass * speed(s) * speed(s) / energy, 1.0, 1e-4) << "un " << un;
  }
}

TEST(HardGaps, TransitionsOfContactAtAnyAlignmentWithTheStep)
{
  for (const GapCase &c : GAP_CASES) {
    if (c.shift != 0.0 || c.transitions == 0) continue;
    SCOPED_TRACE(c.name);
    auto error = [&c](int steps, double first) {
      const GapLaw law = gap_law(c.alpha, c.eps);
      const double h = c.end / steps;
      Gap gap{c.u0, std::log(c.u0)};
      double from = 0.0;
      for (double to = first * h; from < c.end; to += h) {
        to = c.end - to < 1e-9 * h ? c.end : to;
        gap = gap_step(law, gap, c.c0 + c.c1 * std::cos(c.w * from + c.p),
                       c.c0 + c.c1 * std::cos(c.w * to + c.p), to - from);
        from = to;
      }
      return std::fabs(gap.ln_u - c.y[15]);
    };
    const double coarse = error(256, 1.0), fine = error(1024, 1.0);
    EXPECT_GT(coarse / fine, 14.0);    // second order
    for (int m = 1; m < 64; m++) {
      EXPECT_LT(error(256, m / 64.0), 1.1 * coarse) << m;
      EXPECT_LT(error(1024, m / 64.0), 1.1 * fine) << m;
    }
  }
}

TEST(HardGaps, NoChatterAtTheBorderOfContact)
{
  // surfaces that pass eps (1 +- d) in turn: u may not leave these bounds, however stiff the film
  const double eps = 0.01;
  for (const double alpha : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    for (const double h : {1e-2, 1.0, 1e2, 1e4, 1e6, 1e9})
      for (const double d : {1e-12, 1e-6, 1e-3}) {
        const GapLaw law = gap_law(alpha, eps);
        Gap gap{eps, law.ln_eps};
        for (int n = 0; n < 2000; n++) {
          const double way = n % 2 ? d : -d;
          gap = gap_step(law, gap, eps * (1.0 - way), eps * (1.0 + way), h);
          ASSERT_LE(std::fabs(gap.ln_u - law.ln_eps), 1.001 * d + 1e-14)
              << alpha << " " << h << " " << d;
        }
      }
}

TEST(HardGaps, AnAdhesiveContactFormsAndBreaksOnceHoweverTheSurfacesTremble)
{
  GapLaw law = gap_law(2.0, 0.01);
  law.release = 0.012;
  law.ln_release = std::log(0.012);
  const double broken = 0.012 + 2.0 * 0.002;    // un at which it breaks, film at rest
  Gap gap{0.02, std::log(0.02)};
  int changes = 0;
  const double h = 1e5;
  double un = 0.02;
  // down to the border of contact, up to that of release; at each tremble for 1000 steps
  for (const double stay : {0.01, broken, 0.02}) {
    for (int n = 0; n < 1000; n++) {
      const double next = stay * (1.0 + (n % 2 ? 1e-4 : -1e-4));
      const Gap after = gap_step<ADHESION>(law, gap, un, next, h);
      changes += after.bond != gap.bond;
      gap = after;
      un = next;
    }
  }
  EXPECT_EQ(changes, 2);
  EXPECT_EQ(gap.bond, 0.0);
}

TEST(HardGaps, APairAtOneHundredMillionthPulledOpenInAFewSteps)
{
  const GapLaw smooth = gap_law(1.0, 0.0);
  const double u0 = 1e-8, un1 = 0.3;
  for (const int steps : {1, 3, 10})
    for (const double h : {1e-2, 1.0, 1e2, 1e3, 1e4, 1e6, 1e8}) {    // from slow films to fast ones
      const double exact = opened(u0, u0, un1, h);
      Gap gap{u0, std::log(u0)};
      for (int n = 0; n < steps; n++) {
        gap = gap_step(smooth, gap, u0 + (un1 - u0) * n / steps, u0 + (un1 - u0) * (n + 1) / steps,
                       h / steps);
        // suction: never more than the bulk holds, never repulsion
        ASSERT_LT(gap.u, u0 + (un1 - u0) * (n + 1) / steps);
        ASSERT_GT(gap.u, 0.0);
      }
      // sixteen pieces of a step: an exponential of a mean instead of a mean of exponentials
      EXPECT_NEAR(gap.ln_u, exact, h > 1.0 ? 3e-4 : 1e-9) << steps << " steps, h " << h;
    }
}

TEST(HardGaps, AsperitiesUnderAnyWeightFollowTheLogisticLaw)
{
  // the bulk takes no part: c u'/u = k (eps - u) - W, K = k eps/W from half crushed to hard, K = 1
  // closing as 1/t
  const double eps = 0.01, eta = 1.0, g = 1e3, c = film_coefficient(eta, 1.0);
  for (const double alpha : {1e-6, 0.4, 1e6})
    for (const double K : {0.5, 1.0 - 1e-6, 1.0, 1.0 + 1e-6, 2.0}) {
      const double k = alpha * g, weight = k * eps / K;
      if (weight > 0.3 * g) continue;    // the bulk would be deeper than the sphere
      const double start = 0.9 * eps, mass = 1e-6;
      // at un where the elastic rest is `start`, which carries k (eps - start)
      const double un = start - k / g * (eps - start);
      Scene s =
          above(make_coeffs(g, k, eps, g, 0.5), eta, un, mass, weight, 0.2 * std::sqrt(mass / g));
      EXPECT_NEAR(ln_gap(s), std::log(start), 1e-12);
      const double r = (k * eps - weight) / c, A = k / c;
      for (int n = 1; n <= 100000; n++) {
        s.step();
        if (n % 1000) continue;
        const double x = r * n * s.dt;
        const double integral = std::fabs(x) < 1e-12 ? n * s.dt : -std::expm1(-x) / r;
        const double exact = -std::log(std::exp(-x) / start + A * integral);
        const double impulse = weight * std::sqrt(mass / g) / c;    // of the swing on the bulk
        ASSERT_NEAR(ln_gap(s), exact, 2.0 * impulse + 1e-9)
            << "alpha " << alpha << " K " << K << " step " << n;
      }
    }
}

TEST(HardGaps, AsperitiesAMillionTimesHarderThanTheBulk)
{
  // dropped from touch: m un'' = -W + g (eps - un), u = eps - P/k, back at the border in each period
  const double eps = 0.01, g = 1e3, mass = 1.0, weight = 0.1 * g, courant = 0.02;
  for (const double alpha : {1e4, 1e6}) {
    const double k = alpha * g, w = std::sqrt(g / mass);
    Scene s = above(make_coeffs(g, k, eps, g, 0.5), 1e-3, eps, mass, weight, courant / w);
    for (int n = 1; n <= 20000; n++) {
      s.step();
      const double phase = w * n * s.dt, sag = weight / g;
      // velocity Verlet runs ahead by courant^2/24 of the phase; asperities add g/k of the sag
      const double error = sag * (1.1 * phase * courant * courant / 24.0 + phase / alpha + 1e-3);
      ASSERT_NEAR(s.spheres[1].x.z - 2.0, eps - sag * (1.0 - std::cos(phase)), error)
          << alpha << " step " << n;
      ASSERT_NEAR(s.pairs[0].load.contact, g * (std::exp(ln_gap(s)) - (s.spheres[1].x.z - 2.0)),
                  0.02 * weight);
    }
  }
}

TEST(HardGaps, EveryStokesNumber)
{
  // lengths in a, times in eta/(a rho gravity); a free fall from u0
  const double u0 = 0.1, g = 5e3, weight = 4.0 / 3.0 * PI_, c = film_coefficient(1.0, 1.0);
  for (const double stokes : {1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4}) {
    const double density = stokes * stokes / (2.0 * u0), mass = ball_mass(density, 1.0);
    const double courant = 0.1;
    Scene s =
        above(make_coeffs(g, g, 0.0, g, 0.5), 1.0, u0, mass, weight, courant * std::sqrt(mass / g));
    double worst = 0.0;
    for (int n = 1; n <= 50000; n++) {
      s.step();
      ASSERT_TRUE(s.pairs[0].known);
      const double exact = std::log(u0) - weight / c * n * s.dt - mass * speed(s) / c;
      worst = std::fmax(worst, std::fabs(ln_gap(s) - exact));
    }
    // second order: a share of courant^2 of the impulse of the fall
    const double impulse = mass * std::sqrt(2.0 * u0 * weight / mass) / c;
    EXPECT_LT(worst, 0.25 * courant * courant * impulse + 1e-9) << "St " << stokes;
  }
}

TEST(HardGaps, ViscosityTimesOneHundredMillionAndOverIt)
{
  const double g = 1e3, eps = 0.01, mass = 1.0, courant = 0.01;
  auto fall = [&](double eta, double v0) {
    Scene s = above(make_coeffs(g, g, eps, g, 0.5), eta, 0.05, mass, 1e-300,
                    courant * std::sqrt(mass / g));
    s.spheres[1].v.z = -v0;
    while (s.spheres[1].x.z <= 2.05 && s.dt * speed(s) < 1.0) s.step();
    return s;
  };
  // nearly none: the bounce of dry spheres, but for c ln(u0/eps) of impulse on either way
  const double v0 = 0.3;
  const Scene dry = fall(0.0, v0);
  EXPECT_NEAR(speed(dry), v0, 1e-4 * v0);
  for (const double eta : {1e-6, 1e-8, 1e-11})
    EXPECT_NEAR(speed(fall(eta, v0)), speed(dry), 10.0 * film_coefficient(eta, 1.0) / mass + 1e-9);

  // very much: the sphere swings on the bulk behind a film that does not move, m v' = g (u0 - un)
  Scene thick =
      above(make_coeffs(g, g, eps, g, 0.5), 1e8, 0.05, mass, 1e-300, courant * std::sqrt(mass / g));
  thick.spheres[1].v.z = -v0;
  for (int n = 0; n < 4000; n++) thick.step();
  const double w = std::sqrt(g / mass), phase = w * 4000 * thick.dt;
  EXPECT_NEAR(thick.spheres[1].x.z - 2.0, 0.05 - v0 / w * std::sin(phase),
              1.1 * phase * courant * courant / 24.0 * v0 / w);
  EXPECT_NEAR(std::exp(ln_gap(thick)), 0.05, 1e-8);
}

TEST(HardGaps, AThinFilmThatWasSqueezedOutOpensAsLateAsItClosed)
{
  // A bounce that crushes the asperities flat (un < -alpha eps): in the limit of no viscosity the
  // film is closed while the integral of un + alpha eps is negative, then the gap springs open. So
  // the loss does not vanish with the viscosity; only dry spheres are elastic.
  const double g = 1e3, eps = 0.01, mass = 1.0, v0 = 0.5, w = std::sqrt(g / mass);
  const double series = 0.5 * g, flat = -eps;    // alpha = 1
  const double vc = -std::sqrt(v0 * v0 - series / mass * (eps - flat) * (eps - flat));
  auto un = [&](double t) {
    return flat * std::cos(w * t) + vc / w * std::sin(w * t);
  };
  auto area = [&](double t) {
    return flat / w * std::sin(w * t) + vc / (w * w) * (1.0 - std::cos(w * t)) - flat * t;
  };
  double lo = 1e-3 / w, hi = 3.0 / w;    // area < 0, > 0
  ASSERT_TRUE(area(lo) < 0.0 && area(hi) > 0.0);
  for (int n = 0; n < 60; n++) (area(0.5 * (lo + hi)) < 0.0 ? lo : hi) = 0.5 * (lo + hi);
  const double v = -flat * w * std::sin(w * lo) + vc * std::cos(w * lo);
  const double left = eps - un(lo);
  const double exact = std::sqrt(v * v + series / mass * left * left);
  EXPECT_LT(exact, 0.98 * v0);

  for (const double eta : {1e-6, 1e-8, 1e-10}) {
    Scene s = above(make_coeffs(g, g, eps, g, 0.5), eta, 0.05, mass, 1e-300, 1e-3 / w);
    s.spheres[1].v.z = -v0;
    while (s.spheres[1].x.z <= 2.05) s.step();
    EXPECT_NEAR(speed(s), exact, 1e-3 * v0) << "eta " << eta;
  }
}

TEST(HardGaps, StepsUpToTheStabilityLimitKeepTheEnergyBounded)
{
  // thick films, so that every mode rings on its spring, sizes to 1:20, densities to 1:100. In
  // velocity Verlet 1/(1 - f^2) bounds the energy of springs at the share f of the limit.
  Random rnd(2);
  for (int trial = 0; trial < 200; trial++) {
    const double rj = rnd.log_uniform(1.0, 20.0), gap = rnd.uniform(0.02, 0.4);
    const double g = 1e3, kt = g * rnd.log_uniform(0.1, 10.0);
    const double mi = ball_mass(1.0, 1.0), mj = ball_mass(rnd.log_uniform(0.1, 10.0), rj);
    Scene s{FULL, make_coeffs(g, g, 1e-3, kt, 0.5), make_film(1e9, 2.0, Range::CUT, 0.6),
            rnd.coin() ? Radius::MEAN : Radius::HARMONIC};
    const double small = 1e-4;
    s.spheres = {{(1.0 + rj + gap) * rnd.unit(), rnd.vector(small), rnd.vector(small), 1.0, mi},
                 {{}, rnd.vector(small), rnd.vector(small), rj, mj}};
    s.start();
    const PairStiffness k =
        pair_stiffness(g, kt, SPIN_OF_INERTIA, s.pairs[0].g, 1.0, rj, true, true);
    const double limit = 2.0 / std::sqrt(2.0 * std::fmax(k.i / mi, k.j / mj));
    for (const double share : {1e-3, 0.1, 0.5, 0.9}) {
      Scene run = s;
      run.dt = share * limit;
      const double start = run.kinetic() + run.stored();
      for (int n = 0; n < 2000; n++) {
        run.step();
        ASSERT_LE(run.kinetic() + run.stored(), 1.01 * start / (1.0 - share * share))
            << "trial " << trial << " share " << share << " step " << n << " sizes 1:" << rj;
      }
    }
  }
}

TEST(HardGaps, AFreeSpinningPairNeverGainsEnergy)
{
  Random rnd(1);
  for (int trial = 0; trial < 300; trial++) {
    const double gap = rnd.log_uniform(1e-12, 3.0), eta = rnd.log_uniform(1e-4, 1e6);
    const double rj = rnd.log_uniform(1.0, 20.0), g = 1e3, kt = rnd.log_uniform(0.1, 1.0) * g;
    const double mi = ball_mass(1.0, 1.0), mj = ball_mass(rnd.log_uniform(0.1, 10.0), rj);
    Scene s{FULL, make_coeffs(g, g, 0.01, kt, 0.5),
            make_film(eta, 1.5, rnd.coin() ? Range::CUT : Range::SHIFTED, 0.6)};
    s.dt = 0.02 * std::sqrt(mi / g);
    s.spheres = {{(1.0 + rj + gap) * rnd.unit(), {}, rnd.vector(1.0), 1.0, mi},
                 {{}, {}, rnd.vector(1.0), rj, mj}};
    s.start();
    const Vec3 before = s.spheres[0].omega;
    const double start = s.kinetic() + s.stored();
    double most = 0.0;
    for (int n = 0; n < 2000; n++) {
      s.step();
      most = std::fmax(most, s.kinetic() + s.stored());
    }
    ASSERT_LE(most, start * (1.0 + 1e-3)) << "trial " << trial;
    if (gap > 1.5 * s.pairs[0].g.a) expect_same(s.spheres[0].omega, before);
  }
}
