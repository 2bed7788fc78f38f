// Two spheres with extreme coefficients: asperities crushed or a million times harder than the
// bulk, every Stokes number, hardly any viscosity and very much, steps up to the limit. Oracles:
// closed forms.

#include "falling.h"
#include "lubcontact_stiffness.h"

#include <complex>

using namespace hard_cases;
using namespace testing_tools;

TEST(HardCoefficients, AsperitiesUnderAnyWeightFollowTheLogisticLaw)
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

TEST(HardCoefficients, AsperitiesAMillionTimesHarderThanTheBulk)
{
  // dropped from touch: m un'' = -W + g (eps - un), u = eps - P/k, at the border in each period
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

TEST(HardCoefficients, EveryStokesNumber)
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

TEST(HardCoefficients, ViscosityTimesOneHundredMillionAndOverIt)
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

TEST(HardCoefficients, AThinFilmThatWasSqueezedOutOpensAsLateAsItClosed)
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

TEST(HardCoefficients, RollingSpringsAMillionTimesSofterAndHarderThanTheBulk)
{
  // two spheres with spins +w and -w at a fixed gap: J w' = -kr q, q' = 2 w - q/T, kr = kt a^2, T =
  // resistance/kr, hence q'' + q'/T + (2 kr/J) q = 0; films from 10 times softer to harder
  const double g = 1e3, mass = 1.0, J = 0.4 * mass, gap = 0.1, courant = 0.02, w0 = 1e-6;
  for (const double ratio : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    for (const double strength : {0.1, 1.0, 10.0}) {
      const double kr = ratio * g, omega = std::sqrt(2.0 * kr / J), T = strength / omega;
      // (3/5 + (63/125) u) pi eta ln(1/u), the resistance of equal spheres of radius 1
      const double shape = PI * (0.6 + 0.504 * gap) * std::log(1.0 / gap);
      Scene s{FULL, make_coeffs(g, g, 0.0, kr, 0.0),
              make_film(T * kr / shape, 1.0, Range::CUT, 0.6)};
      s.dt = courant / omega;
      s.spheres = {{{0.0, 0.0, 2.0 + gap}, {}, {w0, 0.0, 0.0}, 1.0, mass},
                   {{}, {}, {-w0, 0.0, 0.0}, 1.0, mass}};
      s.start();
      const std::complex<double> root =
          std::sqrt(std::complex<double>(0.25 / (T * T) - omega * omega, 1e-9 * omega * omega));
      const std::complex<double> fast = -0.5 / T - root, slow = -0.5 / T + root;
      for (int n = 1; n <= 2000; n++) {
        s.step();
        const double t = n * s.dt;
        const std::complex<double> a = std::exp(slow * t), b = std::exp(fast * t);
        const double q = 2.0 * w0 * std::real((a - b) / (2.0 * root));
        const double rate = 2.0 * w0 * std::real((slow * a - fast * b) / (2.0 * root));
        const double error = courant * courant * w0;
        ASSERT_NEAR(s.spheres[0].omega.x, 0.5 * (rate + q / T), error * (1.0 + omega * t / 10.0))
            << "kt/g " << ratio << " film " << strength << " step " << n;
        ASSERT_LT(norm(s.spheres[0].v), 1e-3 * w0) << "only by rounding";
      }
    }
}

TEST(HardCoefficients, StepsUpToTheStabilityLimitKeepTheEnergyBounded)
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

TEST(HardCoefficients, AFreeSpinningPairNeverGainsEnergy)
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
