// Time of the physics of one pair and one time step, without LAMMPS: next_history(), pair_load(),
// force and torques, for everything, everything but one effect, and nothing but dry contact.

#include "lubcontact_batch.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace LAMMPS_NS::Lubcontact_NS;

namespace {

constexpr int NUM_PAIRS = 4096;
constexpr double TIME_STEP = 2e-5;    // of in.speed, as are the coefficients
constexpr int STEPS_PER_CYCLE = 500;

const Film FILM = make_film(1.0, 0.5, Range::CUT, 0.6);
const PairCoeffs COEFFS = {{1e4, 1e4, {1.0, 0.01, std::log(0.01), false}}, 1e4, 0.5};

// A pair that moves to and fro about its mean position, at a gap of its own.
struct Oscillator {
  Vec3 mean_i, mean_j;        // positions
  Vec3 move_i, move_j;        // amplitudes of the displacement
  Vec3 rotate_i, rotate_j;    // and of the rotation
  double radius_i, radius_j;
};

class Pairs {
 public:
  Pairs() : random(4711)
  {
    for (int m = 0; m < NUM_PAIRS; m++) pairs.push_back(make_pair());
  }

  // Mixture of a dense suspension, phi = 0.55 with friction: 45 % of the pairs within 0.5 a touch.
  Oscillator make_pair()
  {
    const bool touch = uniform() < 0.45;
    const double gap = touch ? 0.01 - 0.008 * uniform() : 0.01 * std::pow(50.0, uniform());
    const Vec3 n = direction(), t = tangential(direction(), n);
    Oscillator p;
    p.radius_i = 1.0 + 0.05 * normal();
    p.radius_j = 1.0 + 0.05 * normal();
    p.mean_j = {10.0 * uniform(), 10.0 * uniform(), 10.0 * uniform()};
    p.mean_i = p.mean_j + (p.radius_i + p.radius_j + gap) * n;
    p.move_j = 0.01 * direction();
    // the surfaces may slip by more than friction holds, the gap changes by a fraction of itself
    p.move_i = p.move_j + 0.1 * gap * normal() * n + 0.005 * normal() * t;
    p.rotate_i = 0.005 * direction();
    p.rotate_j = 0.005 * direction();
    return p;
  }

  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }
  double normal() { return std::normal_distribution<double>(0.0, 1.0)(random); }
  Vec3 direction()
  {
    const Vec3 a{normal(), normal(), normal()};
    return (1.0 / norm(a)) * a;
  }

  std::vector<Oscillator> pairs;
  std::mt19937_64 random;
};

// One time step of all pairs, eight together as in the pair style.
template <unsigned MASK>
[[gnu::noinline]] Vec3 one_step(const std::vector<Oscillator> &pairs, int step, double *histories)
{
  using E = Effects<MASK>;
  const double phase = 2.0 * PI / STEPS_PER_CYCLE;
  const double shift = std::sin(phase * step);
  const double rate = (shift - std::sin(phase * (step - 1))) / TIME_STEP;
  Vec3 sum;
  Batch b{};
  for (int first = 0; first < NUM_PAIRS; first += Batch::WIDTH) {
    double *of_batch = histories + first * E::HISTORY_SIZE;
    for (int l = 0; l < Batch::WIDTH; l++) {
      const Oscillator &p = pairs[static_cast<std::size_t>(first + l)];
      put_lane(p.mean_i + shift * p.move_i - (p.mean_j + shift * p.move_j), b.x, l);
      put_lane(rate * (p.move_i - p.move_j), b.v, l);
      put_lane(rate * p.rotate_i, b.omega_i, l);
      put_lane(rate * p.rotate_j, b.omega_j, l);
      b.radius_i[l] = p.radius_i;
      b.radius_j[l] = p.radius_j;
      b.a[l] = effective_radius(Radius::HARMONIC, p.radius_i, p.radius_j);
      b.g[l] = COEFFS.normal.g;
      b.asperity[l] = COEFFS.normal.asperity;
      b.alpha[l] = COEFFS.normal.gap.alpha;
      b.eps_a[l] = COEFFS.normal.gap.eps_a;
      b.ln_eps[l] = COEFFS.normal.gap.ln_eps;
      b.kt[l] = COEFFS.kt;
      b.mu[l] = COEFFS.mu;
      for (int m = 0; m < E::HISTORY_SIZE; m++) b.history[m][l] = of_batch[E::HISTORY_SIZE * l + m];
    }
    step_together<E>(b, FILM, TIME_STEP);
    for (int l = 0; l < Batch::WIDTH; l++) {
      double *history = of_batch + E::HISTORY_SIZE * l;
      if (step > 0 && b.usual[l] != 0.0) {
        for (int m = 0; m < E::HISTORY_SIZE; m++) history[m] = b.history[m][l];
        sum = sum + get_lane(b.force, l);
        if constexpr (E::turns || E::twist)
          sum = sum + get_lane(b.torque_i, l) + get_lane(b.torque_j, l);
        continue;
      }
      const Body i{get_lane(b.x, l), get_lane(b.v, l), get_lane(b.omega_i, l), b.radius_i[l]};
      const Body j{{}, {}, get_lane(b.omega_j, l), b.radius_j[l]};
      const PairGeometry geometry = pair_geometry(i.x, j.x, i.radius, j.radius, b.a[l]);
      if (step == 0)
        first_history<E>(COEFFS, geometry, history);
      else
        next_history<E>(COEFFS, FILM, geometry, i, j, TIME_STEP, history, history);
      sum = sum + force_on_i(pair_load<E>(COEFFS, FILM, geometry, history), geometry);
    }
  }
  return sum;
}

template <unsigned MASK> void kernel(benchmark::State &state)
{
  const std::vector<Oscillator> pairs = Pairs().pairs;
  std::vector<double> histories(NUM_PAIRS * Effects<MASK>::HISTORY_SIZE + 1);
  int step = 0;
  one_step<MASK>(pairs, step, histories.data());
  for (auto _ : state) benchmark::DoNotOptimize(one_step<MASK>(pairs, ++step, histories.data()));
  using benchmark::Counter;
  state.counters["pair"] =
      Counter(NUM_PAIRS, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

constexpr unsigned ALL = RESTITUTION - 1;

BENCHMARK(kernel<ALL>)->Name("all");
BENCHMARK(kernel<ALL & ~SQUEEZE>)->Name("no_squeeze");
BENCHMARK(kernel<ALL & ~SHEAR>)->Name("no_shear");
BENCHMARK(kernel<ALL & ~ROLL>)->Name("no_roll");
BENCHMARK(kernel<ALL & ~TWIST>)->Name("no_twist");
BENCHMARK(kernel<ALL & ~FRICTION>)->Name("no_friction");
BENCHMARK(kernel<SQUEEZE>)->Name("squeeze");
BENCHMARK(kernel<SQUEEZE | FRICTION>)->Name("squeeze_friction");
BENCHMARK(kernel<0>)->Name("contact");
BENCHMARK(kernel<FRICTION>)->Name("contact_friction");

}    // namespace

BENCHMARK_MAIN();
