// Shows that the servos settle on what is asked for, without tuning, over the whole range of
// materials for which they are meant. What they act on are models of a few equations, below.

#include "pore_closure.h"
#include "pore_layer.h"
#include "rheometer_servo.h"
#include "tools.h"

#include <algorithm>
#include <sstream>

using namespace LAMMPS_NS::Rheometer_NS;
using namespace testing_tools;

namespace {

constexpr double A = 1.0;    // radius of the particles

/* A dense suspension, from its dilation and rate to its pressure and stress.

   Its unstressed volume fraction phi_e, the state of its structure, approaches jamming as films and
   collisions allow; the contacts carry the pressure as springs in series:
     d ln phi_e/dt = (p X/eta - |g|)/film,   X = (phi_m/phi_e - 1)^2,   p = modulus ln(phi/phi_e)
   At a steady rate that is p X = eta |g|: the law phi = phi_m/(1 + sqrt(Iv)) of Boyer et al.
   (2011). Compressed at the rate e the pressure is p + film eta e/X: the viscosity of compression
   is `film` eta/Iv. For a dry suspension eta is that of the collisions, density d^2 |g| times
   INERTIAL, so that X is Iv + INERTIAL I^2 (Trulsson et al. 2012).
   The shear stress rises with the modulus, too, and flows where its friction exceeds that of
   mu = mu1 + 5/2 phi_m sqrt(X) + Iv, of which the fluid has the last term. */
struct Suspension {
  static constexpr double INERTIAL = 0.6, PHI_M = 0.585, MU_1 = 0.32;
  double eta, density, modulus, film;
  double ln_phi = 0.0, ln_phi_e = 0.0;
  double shear = 0.0;    // stress of the particles
  double flow = 0.0;     // rate at which the structure shears

  double pressure() const { return modulus * (ln_phi - ln_phi_e); }
  double phi() const { return std::exp(ln_phi); }
  double openness() const
  {
    const double x = std::max(0.0, PHI_M * std::exp(-ln_phi_e) - 1.0);
    return x * x;
  }
  double collisions() const { return INERTIAL * 4.0 * A * A * density; }

  double number(double rate, double p) const
  {
    return (eta + collisions() * std::fabs(rate)) * std::fabs(rate) / p;
  }
  double steady_phi(double rate, double p) const
  {
    return PHI_M / (1.0 + std::sqrt(number(rate, p))) * std::exp(p / modulus);
  }
  double steady_friction(double rate, double p) const
  {
    return MU_1 + 2.5 * PHI_M * std::sqrt(number(rate, p)) + eta * std::fabs(rate) / p;
  }

  void settle(double rate, double p)    // as if it had flowed like that for ever
  {
    ln_phi = std::log(steady_phi(rate, p));
    ln_phi_e = ln_phi - p / modulus;
    flow = rate;
  }
  void loosen(double fraction) { ln_phi = ln_phi_e = std::log(fraction); }

  void compress(double dilation, double dt)
  {
    const double slow = eta + collisions() * (std::fabs(flow) + std::fabs(dilation)) + 1e-30;
    const double relax = modulus * openness() / (slow * film) * dt;
    const double strain = (ln_phi - ln_phi_e) * std::exp(-relax) +
        (std::fabs(flow) / film - dilation) * dt * decay_mean(relax);
    ln_phi -= dilation * dt;
    ln_phi_e = ln_phi - strain;
  }

  // at a rate that the structure follows at once
  void step(double rate, double dilation, double dt)
  {
    flow = rate;
    compress(dilation, dt);
  }

  // rate at which the structure yields to a stress > 0, and its derivative
  double plastic_rate(double stress, double &slope) const
  {
    const double p = std::max(pressure(), 1e-6);
    const double root = std::max(0.0, stress / p - MU_1) / (2.5 * PHI_M);
    const double drive = root * root * p;    // eta g + collisions g^2
    slope = 0.0;
    if (drive == 0.0) return 0.0;
    const double both = std::sqrt(eta * eta + 4.0 * collisions() * drive);
    slope = 2.0 * root / (2.5 * PHI_M) / both;
    return 2.0 * drive / (eta + both);
  }

  // with a yield stress: the stress after the step, implicit, by Newton's rule on a convex function
  void step_with_stress(double rate, double dilation, double dt)
  {
    const double trial = shear + modulus * rate * dt, sign = trial < 0.0 ? -1.0 : 1.0;
    double size = std::fabs(trial), slope;
    for (int n = 0; n < 20; n++) {
      const double excess = size + modulus * dt * plastic_rate(size, slope) - std::fabs(trial);
      size -= excess / (1.0 + modulus * dt * slope);
      if (std::fabs(excess) < 1e-12 * size) break;
    }
    shear = sign * size;
    flow = sign * plastic_rate(size, slope);
    compress(dilation, dt);
  }
};

// Correlated over `length` of strain, of variance one.
class Noise {
 public:
  Noise(std::uint64_t seed, double length) : rnd(seed), memory(length) {}
  double next(double strain)
  {
    const double keep = std::max(0.0, 1.0 - strain / memory);
    now = keep * now + std::sqrt(3.0 * (1.0 - keep * keep)) * rnd.uniform(-1.0, 1.0);
    return now;
  }

 private:
  Random rnd;
  double memory, now = 0.0;
};

Material material_of(const Suspension &s)
{
  return {s.eta, s.density, 2.0 * A, 4.0 * A * A * s.density};
}

// of examples/pressure_shear: 0.15 sqrt(mass/stiffness)
double time_step(double density, double modulus)
{
  return 0.15 * std::sqrt(density * 4.0 / 3.0 * PI_ * A * A / modulus);
}

// Sheared at a rate under the pressure 1, as drawn from the ranges of a rheometer.
struct Draw {
  double rate, dt;
  Suspension plant;
};

Draw wet(double viscous_number, double stokes, double hardness, double film)
{
  // viscosity 1 and pressure 1: the viscous number is the rate
  Draw d{viscous_number, 0.0, {}};
  d.plant.eta = 1.0;
  d.plant.density = stokes / (d.rate * A * A);
  d.plant.modulus = hardness * (1.0 + 10.0 * d.rate);
  d.plant.film = film;
  d.dt = time_step(d.plant.density, d.plant.modulus);
  return d;
}

Draw dry(double inertial_number, double hardness, double film)
{
  // density 1 and pressure 1: I = d rate
  Draw d{inertial_number / (2.0 * A), 0.0, {}};
  d.plant.eta = 0.0;
  d.plant.density = 1.0;
  d.plant.modulus = hardness;
  d.plant.film = film;
  d.dt = time_step(1.0, hardness);
  return d;
}

// films resist compression with one to five times eta/Iv
Draw draw(Random &rnd, bool with_fluid)
{
  const double hardness = rnd.log_uniform(1e4, 1e6), film = rnd.uniform(1.0, 5.0);
  if (!with_fluid) return dry(rnd.log_uniform(1e-3, 1.0), hardness, film);
  const double viscous_number = rnd.log_uniform(1e-4, 10.0);
  return wet(viscous_number, rnd.log_uniform(1e-4, 10.0), hardness, film);
}

std::ostream &operator<<(std::ostream &out, const Draw &d)
{
  const Suspension &s = d.plant;
  return out << "rate " << d.rate << " dt " << d.dt << " eta " << s.eta << " density " << s.density
             << " modulus " << s.modulus << " film " << s.film;
}

double inertial_number(const Draw &d)
{
  return 2.0 * A * d.rate * std::sqrt(d.plant.density);
}

constexpr double DESIGNED = 0.02;    // lag, in strain

// The longest step that the lag of the piston allows on a spring, a quarter of 2 sqrt(I/modulus).
// Steps of a run are often much shorter: then these show the same, in less time.
double long_step(const Draw &d, double gain)
{
  return std::max(d.dt, 0.5 * std::sqrt(DESIGNED / (gain * d.plant.modulus)) / d.rate);
}

// strain until pressure and volume are found from anywhere: an undisturbed piston takes ln 2 over
// its gain, the films slow down by 1 + film, a heavy piston by the inertial number
double transient(const Draw &d, double gain)
{
  return 4.0 / std::min(gain, 1.0) + 3.0 + 3.0 * d.plant.film + 8.0 * inertial_number(d);
}

struct Record {
  double pressure = 0.0, volume = 0.0;    // means over ten units of strain, over the targets
  double early = 0.0, late = 0.0;         // standard deviation of the pressure in both halves
  double peak = 0.0;                      // highest pressure
  double fastest = 0.0;                   // dilation, over gain*w
  double inertial = 0.0;                  // I
  bool warned = false;
};

// After the transient: ten units of strain. noise: standard deviation of the measured pressure
Record hold(Draw d, double gain, double noise, double dt, double strain = 10.0)
{
  Suspension &s = d.plant;
  const Material m = material_of(s);
  const double w = servo_rate(m, d.rate, 1.0, PRESSURE_FLOOR);
  const auto first = static_cast<long>(transient(d, gain) / (d.rate * dt));
  const auto steps = first + static_cast<long>(strain / (d.rate * dt));
  Noise disturbance(1, 0.01);
  Watch seen;
  Record r;
  r.inertial = inertial_number(d);
  double dilation = 0.0, squares[2] = {};
  for (long n = 0; n < steps; n++) {
    double p = s.pressure();
    if (noise > 0.0) p += noise * disturbance.next(d.rate * dt);
    dilation = next_dilation(m, dilation, p, 1.0, d.rate, gain, dt);
    s.step(d.rate, dilation, dt);
    seen = watch(seen, p - 1.0, w, dt);
    r.peak = std::max(r.peak, p);
    r.fastest = std::max(r.fastest, std::fabs(dilation) / (gain * w));
    r.warned = r.warned || unreachable(seen);
    if (n < first) continue;
    r.pressure += p;
    r.volume += s.steady_phi(d.rate, 1.0) / s.phi();
    squares[2 * (n - first) >= steps - first] += (p - 1.0) * (p - 1.0);
  }
  const auto count = static_cast<double>(steps - first);
  r.pressure /= count;
  r.volume /= count;
  r.early = std::sqrt(2.0 * squares[0] / count);
  r.late = std::sqrt(2.0 * squares[1] / count);
  return r;
}

void start(Draw &d, bool loose)
{
  if (loose)
    d.plant.loosen(0.5 * d.plant.steady_phi(d.rate, 1.0));
  else
    d.plant.settle(d.rate, 1e3);    // at the volume where the pressure is a thousand times too high
}

// what a run has to show; noise of 10 % is quieter after the lag than before
void expect_held(const Record &r, double noise)
{
  EXPECT_NEAR(r.pressure, 1.0, 0.01);
  EXPECT_NEAR(r.volume, 1.0, 0.01);
  EXPECT_LT(r.late, 1.5 * noise + 1e-2);
  EXPECT_LT(r.late, 1.5 * r.early + 1e-6);
  EXPECT_LE(r.fastest, 1.0 + 1e-12);
  EXPECT_FALSE(r.warned && r.inertial < 1.0);    // a heavier piston takes longer
}

// Draws until `number` plants have taken part; those with more steps than `affordable` do not.
template <class F>
void for_each_draw(std::uint64_t seed, int number, bool with_fluid, double gain_range,
                   double affordable, F &&f)
{
  Random rnd(seed);
  while (number > 0) {
    Draw d = draw(rnd, with_fluid);
    const double gain = rnd.log_uniform(1.0 / gain_range, gain_range);
    const bool loose = rnd.coin();
    start(d, loose);
    const double dt = long_step(d, gain);
    if ((transient(d, gain) + 10.0) / (d.rate * dt) > affordable) continue;
    std::ostringstream words;
    words << d << " gain " << gain << (loose ? " from loose" : " from dense");
    SCOPED_TRACE(words.str());
    f(d, gain, dt);
    number--;
  }
}

// A material of stress G*strain below its yield stress, and a Bingham fluid above.
struct Yielding {
  double modulus, yield, viscosity;
  double stress = 0.0;
  void step(double rate, double dt)
  {
    const double trial = stress + modulus * rate * dt, excess = std::fabs(trial) - yield;
    stress = trial;
    if (excess > 0.0)
      stress = std::copysign(yield + excess / (1.0 + modulus * dt / viscosity), trial);
  }
};

// density of particles and step of a run at the stress 1 in the fluid of viscosity 1 (or none)
Material at_stress_one(double eta, double density)
{
  return {eta, density, 2.0 * A, 4.0 * A * A * density};
}

}    // namespace

TEST(PressureServo, FindsPressureAndVolumeOfAnySuspension)
{
  for_each_draw(1, 50, true, 1.0, 2e5, [](const Draw &d, double gain, double dt) {
    expect_held(hold(d, gain, 0.1, dt), 0.1);
  });
}

TEST(PressureServo, FindsPressureAndVolumeOfAnyDryGranularFlow)
{
  for_each_draw(2, 40, false, 1.0, 2e5, [](const Draw &d, double gain, double dt) {
    expect_held(hold(d, gain, 0.1, dt), 0.1);
  });
}

TEST(PressureServo, DoesNotRingWithoutNoise)
{
  for (const bool with_fluid : {true, false})
    for_each_draw(3, 15, with_fluid, 1.0, 1e5, [](const Draw &d, double gain, double dt) {
      const Record r = hold(d, gain, 0.0, dt);
      expect_held(r, 0.0);
      EXPECT_LT(r.late, 3e-3);
    });
}

TEST(PressureServo, NeedsNoTuningOfItsGain)
{
  for (const bool with_fluid : {true, false})
    for_each_draw(4, 20, with_fluid, 10.0, 2e5, [](const Draw &d, double gain, double dt) {
      Record r = hold(d, gain, 0.1, dt);
      if (gain < 0.5) r.warned = false;    // it takes longer than the patience
      expect_held(r, 0.1);
    });
}

TEST(PressureServo, FindsTheSameWithTheShortStepsOfARun)
{
  for (const double viscous_number : {1e-2, 0.3}) {
    Draw d = wet(viscous_number, 0.003, 1e4, 2.0);
    start(d, true);
    const Record run = hold(d, 1.0, 0.1, d.dt), longer = hold(d, 1.0, 0.1, long_step(d, 1.0));
    expect_held(run, 0.1);
    EXPECT_NEAR(run.volume, longer.volume, 3e-3);
    EXPECT_LT(3.0 * d.dt, long_step(d, 1.0));
  }
}

TEST(PressureServo, HeavyPistonDoesNotCoast)
{
  // dilating from a dense start the mass must not carry the volume away: I = 20
  Draw d = wet(10.0, 10.0, 1e4, 1.0);
  start(d, false);
  const double target = d.plant.steady_phi(d.rate, 1.0);
  const Material m = material_of(d.plant);
  double dilation = 0.0, lowest = 1.0;
  for (double strain = 0.0; strain < 200.0; strain += d.rate * d.dt) {
    dilation = next_dilation(m, dilation, d.plant.pressure(), 1.0, d.rate, 1.0, d.dt);
    d.plant.step(d.rate, dilation, d.dt);
    lowest = std::min(lowest, d.plant.phi());
  }
  EXPECT_NEAR(d.plant.phi() / target, 1.0, 0.01);
  EXPECT_GT(lowest / target, 0.7);
}

TEST(PressureServo, ConsolidatesAtRestWithoutImpact)
{
  for (const double eta : {1.0, 0.0})
    for (const double hardness : {1e4, 1e6})
      for (const double film : {1.0, 4.0}) {
        Draw d = eta > 0.0 ? wet(1.0, 1.0, hardness, film) : dry(1.0, hardness, film);
        SCOPED_TRACE(testing::Message() << d);
        Suspension &s = d.plant;
        const Material m = material_of(s);
        const double t = 1.0 / rearrangement_rate(m, 1.0);
        const double dt = 0.02 * t * std::sqrt(1e4 / hardness) * (hardness > 1e5 ? 2.0 : 1.0);
        s.loosen(0.45);
        double dilation = 0.0, peak = 0.0;
        for (double time = 0.0; time < 6e3 * t; time += dt) {
          dilation = next_dilation(m, dilation, s.pressure(), 1.0, 0.0, 1.0, dt);
          s.step(0.0, dilation, dt);
          peak = std::max(peak, s.pressure());
          ASSERT_LE(std::fabs(dilation), PRESSURE_FLOOR / t * (1.0 + 1e-12));
        }
        EXPECT_LT(peak, 1.2);
        EXPECT_NEAR(s.pressure(), 1.0, 0.01);
        EXPECT_NEAR(s.phi(), Suspension::PHI_M, 0.002);
      }
}

TEST(PressureServo, FollowsStepsOfPressureAndRateByAThousand)
{
  for (const double eta : {1.0, 0.0})
    for (const double pressure_after : {1.0, 1e3, 1e-3})
      for (const double rate_after : {1.0, 1e3, 1e-3}) {
        if (pressure_after != 1.0 && rate_after != 1.0) continue;
        // such that Iv and I stay within 1e-4 ... 1
        const bool opens = rate_after > 1.0 || pressure_after < 1.0;
        Draw d = eta > 0.0 ? wet(opens ? 1e-3 : 0.1, opens ? 1e-4 : 1e-2, 1e5, 2.0)
                           : dry(opens ? 1e-3 : 0.5, 1e5, 2.0);
        SCOPED_TRACE(testing::Message()
                     << d << " pressure " << pressure_after << " rate " << rate_after);
        Suspension &s = d.plant;
        s.modulus = 1e5 * std::max(1.0, pressure_after);
        s.settle(d.rate, 1.0);
        const Material m = material_of(s);
        const double rate = d.rate * rate_after, p = pressure_after;
        const double t = 1.0 / rearrangement_rate(m, p);
        const double dt =
            std::max(time_step(s.density, s.modulus),
                     std::min(0.1 * t, 0.5 * std::sqrt(DESIGNED * p / s.modulus) / rate));
        const double number = 2.0 * A * rate * std::sqrt(s.density / p);
        const double w = servo_rate(m, rate, p, PRESSURE_FLOOR);
        Watch seen{0.0, 100.0};
        double dilation = 0.0, mean = 0.0, volume = 0.0, count = 0.0;
        bool warned = false;
        const double settled = 16.0 + 8.0 * number;
        for (double strain = 0.0; strain < settled + 3.0; strain += rate * dt) {
          dilation = next_dilation(m, dilation, s.pressure(), p, rate, 1.0, dt);
          s.step(rate, dilation, dt);
          seen = watch(seen, s.pressure() / p - 1.0, w, dt);
          warned = warned || unreachable(seen);
          if (strain < settled) continue;
          mean += s.pressure() / p;
          volume += s.steady_phi(rate, p) / s.phi();
          count += 1.0;
        }
        EXPECT_NEAR(mean / count, 1.0, 0.01);
        EXPECT_NEAR(volume / count, 1.0, 0.01);
        EXPECT_FALSE(warned);
      }
}

TEST(PressureServo, HoldsThePressureOfAnOscillation)
{
  // The rate goes through zero: averages are weighted by |rate|. The lag, which grows where the
  // rate is small, correlates with the pressure: up to 3 % where a swing is not long against it.
  for (const double amplitude : {0.1, 1.0, 5.0})
    for (const double viscous_number : {1e-3, 0.1, 1.0}) {
      Draw d = wet(viscous_number, 0.01, 1e4, 2.0);
      SCOPED_TRACE(testing::Message() << d << " amplitude " << amplitude);
      Suspension &s = d.plant;
      const Material m = material_of(s);
      const double dt = long_step(d, 1.0), w = d.rate / amplitude;
      start(d, true);
      double dilation = 0.0, mean[2] = {}, weight[2] = {}, volume[2] = {}, path = 0.0;
      for (double t = 0.0; path < 32.0; t += dt) {
        const double rate = d.rate * std::cos(w * t);
        path += std::fabs(rate) * dt;
        dilation = next_dilation(m, dilation, s.pressure(), 1.0, rate, 1.0, dt);
        s.step(rate, dilation, dt);
        if (path < 12.0) continue;
        const bool half = path > 22.0;
        mean[half] += std::fabs(rate) * s.pressure();
        volume[half] += std::fabs(rate) / s.phi();
        weight[half] += std::fabs(rate);
      }
      EXPECT_NEAR(mean[0] / weight[0], 1.0, amplitude < 0.5 ? 0.04 : 0.01);
      EXPECT_NEAR(mean[1] / weight[1], 1.0, amplitude < 0.5 ? 0.04 : 0.01);
      EXPECT_NEAR(volume[1] / weight[1] / (volume[0] / weight[0]), 1.0, 0.01);
    }
}

TEST(PressureServo, DilationStaysWithinItsLimitForAnything)
{
  Random rnd(5);
  for (int trial = 0; trial < 20000; trial++) {
    const Material m{rnd.coin() ? rnd.log_uniform(1e-6, 1e6) : 0.0, rnd.log_uniform(1e-6, 1e6),
                     rnd.log_uniform(1e-3, 1e3), rnd.log_uniform(1e-9, 1e9)};
    const double rate = rnd.coin() ? rnd.uniform(-1.0, 1.0) * rnd.log_uniform(1e-6, 1e6) : 0.0;
    const double gain = rnd.log_uniform(0.1, 10.0), target = rnd.log_uniform(1e-6, 1e6);
    const double limit = gain * servo_rate(m, rate, target, PRESSURE_FLOOR);
    const double before = limit * rnd.uniform(-1.0, 1.0);
    const double p = target * rnd.uniform(-1.0, 1.0) * rnd.log_uniform(1e-6, 1e6);
    const double dt = rnd.log_uniform(1e-9, 1e9);
    const double next = next_dilation(m, before, p, target, rate, gain, dt);
    ASSERT_LE(std::fabs(next), limit * (1.0 + 1e-12));
    // more pressure, more dilation; no pressure compresses
    ASSERT_GE(next_dilation(m, before, p + target, target, rate, gain, dt), next);
    ASSERT_LE(next_dilation(m, 0.0, 0.0, target, rate, gain, dt), 0.0);
    ASSERT_TRUE(std::isfinite(next_rate(m, rate, p, rnd.coin() ? target : 0.0, 3.0, dt)));
  }
}

namespace {

// A layer whose pores drain, under a piston; drainage: from none to a million times its dashpot
struct Layer {
  Material m;
  double rate, gain, target, dashpot, inertia, drainage;
  explicit Layer(Random &rnd)
  {
    m = {rnd.coin() ? rnd.log_uniform(1e-3, 1e3) : 0.0, rnd.log_uniform(1e-3, 1e3),
         rnd.log_uniform(0.1, 10.0), rnd.log_uniform(1e-6, 1.0)};
    target = rnd.log_uniform(1e-2, 1e2);
    gain = rnd.log_uniform(0.3, 3.0);
    rate = rearrangement_rate(m, target) * rnd.log_uniform(0.1, 10.0);
    const double w = servo_rate(m, rate, target, PRESSURE_FLOOR);
    dashpot = piston_dashpot(m, target, w, gain);
    inertia = DESIGNED * target / (gain * w * w) + m.inertia;
    drainage = rnd.coin() ? dashpot * rnd.log_uniform(1e-3, 1e6) : 0.0;
  }
  double next(double dilation, double pressure, double dt) const
  {
    return next_dilation(m, dilation, pressure, target, rate, gain, dt, drainage);
  }
};

std::ostream &operator<<(std::ostream &out, const Layer &one)
{
  return out << "rate " << one.rate << " gain " << one.gain << " target " << one.target
             << " dashpot " << one.dashpot << " inertia " << one.inertia << " drainage "
             << one.drainage;
}

}    // namespace

TEST(DrainingLayer, NoneIsThePistonAloneToTheLastBit)
{
  Random rnd(11);
  for (int trial = 0; trial < 20000; trial++) {
    const Layer one(rnd);
    const double before = one.target / one.dashpot * rnd.uniform(-1.0, 1.0);
    const double p = one.target * rnd.uniform(-1.0, 5.0),
                 dt = rnd.log_uniform(1e-6, 1.0) / one.rate;
    EXPECT_EQ(next_dilation(one.m, before, p, one.target, one.rate, one.gain, dt),
              next_dilation(one.m, before, p, one.target, one.rate, one.gain, dt, 0.0));
  }
}

TEST(DrainingLayer, RelaxesToAStepOfPressureAsItsFluidDrains)
{
  // a packing of the modulus E: what is left after the time (C + eta H^2/(3 k))/E is 1/e
  Random rnd(12);
  int draining = 0;
  for (int trial = 0; trial < 300; trial++) {
    Layer one(rnd);
    const double eta = rnd.log_uniform(1e-3, 1e3), k = rnd.log_uniform(1e-6, 1.0);
    const double height = std::sqrt(3.0 * k * one.drainage / eta);
    one.drainage = LAMMPS_NS::Pore_NS::layer_drainage(eta, height, k);
    const double damping = one.dashpot + one.drainage;
    SCOPED_TRACE(testing::Message() << one);
    const double modulus = damping * damping / (4.0 * one.inertia) * rnd.log_uniform(1e-5, 1e-3);
    const double time = damping / modulus, dt = time / 3000.0;
    const double start = rnd.uniform(-0.5, 0.5) * one.target;
    double p = one.target + start, dilation = 0.0, passed = 0.0, before = std::fabs(start);
    while (passed < 3.0 * time) {
      dilation = one.next(dilation, p, dt);
      p -= modulus * dilation * dt;
      passed += dt;
      const double left = (p - one.target) / start;
      ASSERT_LE(std::fabs(p - one.target), before);    // it does not ring
      ASSERT_NEAR(left, std::exp(-passed / time), 2e-3);
      before = std::fabs(p - one.target);
    }
    if (one.drainage < 1e3 * one.dashpot) continue;
    draining++;
    EXPECT_NEAR(eta * height * height / (3.0 * k * modulus) / time, 1.0, 1.1e-3);
  }
  EXPECT_GT(draining, 30);
}

TEST(DrainingLayer, OfAnySizeMakesNoLoopLessStable)
{
  // springs and films, which answer at once, up to what the piston alone can hold
  Random rnd(13);
  int smooth = 0;
  for (int trial = 0; trial < 3000; trial++) {
    const Layer one(rnd);
    SCOPED_TRACE(testing::Message() << one);
    const double dt = rnd.log_uniform(1e-6, 1e-2) / one.rate;
    const double modulus = one.inertia / (dt * dt) * rnd.log_uniform(1e-8, 0.2);
    const double film = one.inertia / dt * rnd.uniform(0.0, 0.5) * (rnd.coin() ? 1.0 : 0.0);
    const double damping = one.dashpot + one.drainage + film;
    const bool rings = damping * damping < 6.0 * one.inertia * modulus;
    const double start = rnd.uniform(0.1, 0.5) * one.target;
    double p = one.target + start, dilation = 0.0, peak = 0.0, late = 0.0;
    bool crossed = false;
    for (int n = 0; n < 4000; n++) {
      dilation = one.next(dilation, p - film * dilation, dt);
      p -= modulus * dilation * dt;
      const double off = p - one.target;
      peak = std::max(peak, std::fabs(off));
      if (n >= 2000) late = std::max(late, std::fabs(off));
      if (off < -1e-9 * start) crossed = true;
    }
    ASSERT_LE(peak, 1.2 * start);
    ASSERT_LE(late, 1.2 * start);
    if (rings) continue;
    smooth++;
    ASSERT_FALSE(crossed);
    ASSERT_LE(peak, start);
  }
  EXPECT_GT(smooth, 1000);
}

TEST(DrainingLayer, SucksWithManyTimesTheTargetButMovesNoFasterThanThePiston)
{
  const Material m{1.0, 1e-6, 2.0, 1e-9};
  const double rate = 0.1, dashpot = piston_dashpot(m, 1.0, rate, 1.0);
  for (const double drainage : {0.0, 1.0, 1e3, 1e6}) {
    const double layer = drainage * dashpot;
    // dense: it dilates at a rate at which the fluid takes up what the particles press too much
    const double dilation = next_dilation(m, 0.0, 41.0, 1.0, rate, 1.0, 1e9, layer);
    const double expected = std::fmin(40.0 / (dashpot + layer), dilation_limit(m, 1.0, rate, 1.0));
    EXPECT_NEAR(dilation, expected, 1e-6 * expected);
    if (drainage > 100.0) { EXPECT_NEAR(layer * dilation, 40.0, 0.1); }
  }
}

TEST(PressureServo, StepDoesNotDependOnWhereItIsCut)
{
  const Material m{1.0, 0.3, 2.0, 1.2};
  const double whole = next_dilation(m, 0.01, 1.1, 1.0, 0.2, 2.0, 0.05);
  const double half = next_dilation(m, 0.01, 1.1, 1.0, 0.2, 2.0, 0.02);
  EXPECT_NEAR(next_dilation(m, half, 1.1, 1.0, 0.2, 2.0, 0.03), whole, 1e-15);
  // and its end is C e = p - P, C = P/(K w) but for the mass
  const Material light{1.0, 1e-12, 2.0, 1e-12};
  EXPECT_NEAR(next_dilation(light, 0.01, 1.1, 1.0, 0.2, 2.0, 1e3), 0.1 * 2.0 * 0.2, 1e-6);
}

TEST(PressureServo, RestsWhereThereIsNothingToSetItsTime)
{
  EXPECT_EQ(next_rate({1.0, 1.0, 2.0, 4.0}, 0.0, 0.0, 0.0, 1.0, 0.1), 0.0);
  EXPECT_EQ(rearrangement_rate({1.0, 1.0, 2.0, 4.0}, 0.0), 0.0);
  // viscous and inertial time of a particle: eta/P = 2, d sqrt(rho/P) = 6
  EXPECT_DOUBLE_EQ(rearrangement_rate({8.0, 16.0, 3.0, 0.0}, -4.0), 1.0 / 8.0);
  EXPECT_DOUBLE_EQ(servo_rate({8.0, 16.0, 3.0, 0.0}, 3.0, 4.0, 32.0), 5.0);
}

TEST(StressServo, ReachesTheRateOfAnyNewtonianFluidWithoutOvershoot)
{
  Random rnd(6);
  for (int plants = 0; plants < 60;) {
    const double viscosity = rnd.log_uniform(1.0, 1e4), rate_end = 1.0 / viscosity;
    const double stokes = rnd.log_uniform(1e-4, 10.0), modulus = rnd.log_uniform(1e4, 1e6);
    const Material m = at_stress_one(1.0, stokes / rate_end);
    const double t = 1.0 / rearrangement_rate(m, 1.0);
    // t/3 for the start, then lag and mass
    const double dt = time_step(m.density, modulus);
    const double end = t / 3.0 + 6.0 * (DESIGNED / rate_end + m.inertia / viscosity);
    if (end / dt > 3e5) continue;
    plants++;
    SCOPED_TRACE(testing::Message() << "viscosity " << viscosity << " stokes " << stokes);
    double rate = 0.0, highest = 0.0;
    for (double time = 0.0; time < end; time += dt) {
      rate = next_rate(m, rate, (viscosity - 1.0) * rate, 1.0, 1.0, dt);
      highest = std::max(highest, rate);
    }
    EXPECT_NEAR(rate / rate_end, 1.0, 0.02);
    EXPECT_LT(highest / rate_end, 1.0 + 1e-9);
  }
}

TEST(StressServo, MeanStressIsTheTargetInNoise)
{
  for (const double viscosity : {3.0, 1e3}) {
    const Material m = at_stress_one(1.0, 0.1 * viscosity);
    const double dt = time_step(m.density, 1e4);
    Noise noise(7, 0.003);
    double rate = 1.0 / viscosity, stress = 0.0, strain = 0.0, time = 0.0;
    while (strain < 10.0 && time < 20.0 * viscosity) {
      const double s = (viscosity - 1.0) * rate + 0.3 * noise.next(std::fabs(rate) * dt);
      stress += dt * (s + rate);
      time += dt;
      rate = next_rate(m, rate, s, 1.0, 1.0, dt);
      strain += rate * dt;
    }
    EXPECT_GE(strain, 10.0);
    EXPECT_NEAR(stress / time, 1.0, 1e-3);
  }
}

TEST(StressServo, CountsTheFluidWithTheTroutonRatio)
{
  // without particles: s = T eta rate
  for (const double trouton : {1.0, 3.0, 4.0}) {
    const Material m = at_stress_one(0.5, 1e-3);
    double rate = 0.0;
    for (int n = 0; n < 100000; n++) rate = next_rate(m, rate, 0.0, 1.0, trouton, 1e-3);
    EXPECT_NEAR(rate * trouton * 0.5, 1.0, 1e-6);
  }
}

TEST(StressServo, FollowsAShearThinningFluid)
{
  // s = 5 sqrt(rate) and the fluid
  for (const double target : {0.1, 1.0, 30.0}) {
    const Material m = at_stress_one(1.0, 0.01);
    const double root = 0.5 * (std::sqrt(25.0 + 4.0 * target) - 5.0);
    double rate = 0.0, highest = 0.0;
    for (int n = 0; n < 200000; n++) {
      rate = next_rate(m, rate, 5.0 * std::sqrt(rate), target, 1.0, 3e-3 / target);
      highest = std::max(highest, rate);
    }
    EXPECT_NEAR(rate / (root * root), 1.0, 2e-3);
    EXPECT_LT(highest / (root * root), 1.01);
  }
}

TEST(StressServo, FlowsAboveTheYieldStressAndJamsBelow)
{
  for (const double eta : {1.0, 0.0})
    for (const double yield : {0.9, 1.1, 2.5})
      for (const double modulus : {1e4, 3e4}) {
        const Material m = at_stress_one(eta, 1.0);
        const double t = 1.0 / rearrangement_rate(m, 1.0), dt = 3.0 * time_step(1.0, modulus);
        SCOPED_TRACE(testing::Message() << "eta " << eta << " yield " << yield << " G " << modulus);
        Yielding plant{modulus, yield, 20.0 * t};
        Watch seen;
        const double slow = STRESS_FLOOR / t;
        double rate = 0.0, mean = 0.0, strain = 0.0, count = 0.0, fastest = 0.0;
        for (double time = 0.0; time < 1200.0 * t; time += dt) {
          rate = next_rate(m, rate, plant.stress, 1.0, 1.0, dt);
          plant.step(rate, dt);
          strain += rate * dt;
          fastest = std::max(fastest, std::fabs(rate));
          seen = watch(seen, std::fabs(rate) / slow, servo_rate(m, rate, 1.0, STRESS_FLOOR), dt);
          if (time < 1000.0 * t) continue;
          mean += plant.stress + eta * rate;
          count += 1.0;
        }
        EXPECT_NEAR(mean / count, 1.0, 1e-3);
        if (yield < 1.0) {
          EXPECT_NEAR(rate * (20.0 * t + eta) / (1.0 - yield), 1.0, 0.01);
          EXPECT_FALSE(jammed(seen));
        } else {
          EXPECT_LT(std::fabs(rate), 1e-8 / t);
          EXPECT_LT(fastest, 0.01 / t);
          EXPECT_LT(strain, 5e-3);
          EXPECT_NEAR(plant.stress, 1.0, 1e-6);    // carried by the springs
          EXPECT_TRUE(jammed(seen));
        }
      }
}

TEST(StressServo, JamsAfterAFlowWhenTheStressFalls)
{
  const Material m = at_stress_one(1.0, 1.0);
  const double t = 1.0 / rearrangement_rate(m, 0.5), dt = 3.0 * time_step(1.0, 1e4);
  Yielding plant{1e4, 0.8, 20.0};
  Watch seen;
  double rate = 0.0;
  for (double time = 0.0; time < 500.0; time += dt) {
    rate = next_rate(m, rate, plant.stress, 1.0, 1.0, dt);
    plant.step(rate, dt);
    seen =
        watch(seen, std::fabs(rate) * t / STRESS_FLOOR, servo_rate(m, rate, 1.0, STRESS_FLOOR), dt);
  }
  EXPECT_FALSE(jammed(seen));
  for (double time = 0.0; time < 4000.0 * t; time += dt) {
    rate = next_rate(m, rate, plant.stress, 0.5, 1.0, dt);
    plant.step(rate, dt);
    seen =
        watch(seen, std::fabs(rate) * t / STRESS_FLOOR, servo_rate(m, rate, 0.5, STRESS_FLOOR), dt);
  }
  EXPECT_TRUE(jammed(seen));
  EXPECT_NEAR(plant.stress, 0.5, 1e-6);
}

TEST(StressServo, StopsTheFlowAtStressZeroAndReversesIt)
{
  for (const double viscosity : {1.0, 30.0, 3e3})
    for (const double stokes : {1e-3, 1.0}) {
      SCOPED_TRACE(testing::Message() << "viscosity " << viscosity << " stokes " << stokes);
      const double rate_before = 1.0 / viscosity;
      const Material m = at_stress_one(1.0, stokes / rate_before);
      const double dt = time_step(m.density, 1e4);
      const double settle = DESIGNED / rate_before + m.inertia / viscosity;
      double rate = rate_before, strain = 0.0;
      // the rate falls by e in a lag of strain: in time like lag/time
      for (double time = 0.0; time < 30.0 * settle; time += dt) {
        rate = next_rate(m, rate, (viscosity - 1.0) * rate, 0.0, 1.0, dt);
        strain += rate * dt;
        ASSERT_GE(rate, 0.0);
      }
      EXPECT_LT(rate / rate_before, 0.1);
      EXPECT_LT(strain, 4.0 * settle * rate_before);

      rate = rate_before;
      const double t = 1.0 / rearrangement_rate(m, 1.0);
      for (double time = 0.0; time < t / 2.0 + 10.0 * settle; time += dt) {
        rate = next_rate(m, rate, (viscosity - 1.0) * rate, -1.0, 1.0, dt);
        ASSERT_GT(rate / rate_before, -1.0 - 1e-9);
      }
      EXPECT_NEAR(rate / rate_before, -1.0, 0.02);
    }
}

TEST(StressServo, FollowsAnOscillatingStressThroughZero)
{
  // late by the start from rest, which takes longer the thinner the fluid: a period of five strains
  const struct {
    double viscosity, stokes, error;
  } cases[] = {{30.0, 1e-3, 0.12}, {100.0, 1e-2, 0.07}, {100.0, 1e-3, 0.07}, {1e3, 1e-2, 0.02}};
  for (const auto &c : cases) {
    const double rate_end = 1.0 / c.viscosity, period = 5.0 * c.viscosity;
    const Material m = at_stress_one(1.0, c.stokes / rate_end);
    const double dt = time_step(m.density, 1e4);
    double rate = 0.0, worst = 0.0;
    for (double time = 0.0; time < 1.2 * period; time += dt) {
      const double target = std::cos(2.0 * PI_ * time / period);
      rate = next_rate(m, rate, (c.viscosity - 1.0) * rate, target, 1.0, dt);
      if (time > 0.25 * period) worst = std::max(worst, std::fabs(rate / rate_end - target));
    }
    EXPECT_LT(worst, c.error) << "viscosity " << c.viscosity << " stokes " << c.stokes;
  }
}

TEST(StressServo, UnopposedStressAcceleratesTheMassAndNothingElse)
{
  // no fluid, no contacts: I0 dg/dt = s in the end, no faster
  const Material m = at_stress_one(0.0, 1.0);
  const double t = 1.0 / rearrangement_rate(m, 1.0);
  double rate = 0.0, before = 0.0;
  for (int n = 0; n < 100000; n++) {
    before = rate;
    rate = next_rate(m, rate, 0.0, 1.0, 1.0, 1e-3 * t);
    ASSERT_LE((rate - before) * m.inertia, 1e-3 * t * (1.0 + 1e-12));
  }
  EXPECT_NEAR(rate * m.inertia / (100.0 * t), 1.0, 0.02);
}

TEST(BothServos, SettleOnTheLawOfFrictionOrJamBelowIt)
{
  for (const double eta : {1.0, 0.0})
    for (const double number : {0.01, 0.1, 0.0}) {
      // the stress that is the friction of this number; 0: below that of the yield
      Draw d = eta > 0.0 ? wet(std::max(number, 0.1), 0.1, 1e4, 2.0)
                         : dry(std::sqrt(std::max(number, 0.01) / 0.6), 1e4, 2.0);
      SCOPED_TRACE(testing::Message() << d << " number " << number);
      Suspension &s = d.plant;
      s.modulus = 1e4;
      const Material m = material_of(s);
      const double rate_end =
          number > 0.0 ? (eta > 0.0 ? number : std::sqrt(number / s.collisions())) : 0.0;
      const double stress = number > 0.0 ? s.steady_friction(rate_end, 1.0) : 0.25;
      const double t = 1.0 / rearrangement_rate(m, stress), dt = 1.5 * time_step(s.density, 1e4);
      s.settle(eta > 0.0 ? 0.1 : 0.2, 1.0);
      const double slow = STRESS_FLOOR / t;
      Watch seen;
      double rate = 0.0, dilation = 0.0, mean[4] = {}, count = 0.0;
      const double end = number > 0.0 ? 100.0 * t + 10.0 / rate_end : 3000.0 * t;
      for (double time = 0.0; time < end; time += dt) {
        const double p = s.pressure(), now = s.shear;
        const double rate_next = next_rate(m, rate, now, stress, 1.0, dt);
        dilation = next_dilation(m, dilation, p, 1.0, rate, 1.0, dt);
        rate = rate_next;
        s.step_with_stress(rate, dilation, dt);
        seen = watch(seen, std::fabs(rate) / slow, servo_rate(m, rate, stress, STRESS_FLOOR), dt);
        if (time < 0.6 * end) continue;
        const double values[] = {rate, s.pressure(), s.shear + eta * rate, s.phi()};
        for (int n = 0; n < 4; n++) mean[n] += values[n];
        count += 1.0;
      }
      EXPECT_NEAR(mean[1] / count, 1.0, 0.01);
      EXPECT_NEAR(mean[2] / count / stress, 1.0, 0.01);
      EXPECT_EQ(jammed(seen), number == 0.0);
      if (number > 0.0) {
        EXPECT_NEAR(mean[0] / count / rate_end, 1.0, 0.03);
        EXPECT_NEAR(mean[3] / count / s.steady_phi(rate_end, 1.0), 1.0, 0.01);
      } else {
        EXPECT_LT(std::fabs(rate) * t, 1e-6);
      }
    }
}

TEST(Watch, WarnsOfATargetThatIsOutOfReachAfterItsPatience)
{
  // no particles that push
  const Material m{1.0, 1e-3, 2.0, 4e-3};
  const double rate = 0.1, dt = 0.01, w = servo_rate(m, rate, 1.0, PRESSURE_FLOOR);
  Watch seen;
  double strain = 0.0;
  while (!unreachable(seen) && strain < 100.0) {
    seen = watch(seen, -1.0, w, dt);
    strain += rate * dt;
  }
  EXPECT_NEAR(strain, PATIENCE, 0.1);
  EXPECT_NEAR(seen.deviation, -1.0, 1e-12);
  // and forgets when it is reached again
  for (strain = 0.0; unreachable(seen) && strain < 100.0; strain += rate * dt)
    seen = watch(seen, 0.0, w, dt);
  EXPECT_LT(strain, MEMORY);
}

TEST(Watch, IsSilentThroughTwentyThousandCorrelationsOfNoise)
{
  // a thousand units of strain; a noise of 10 %, and the 50 % of a few particles
  for (const double size : {0.1, 0.5}) {
    Noise noise(8, 0.05);
    Watch seen;
    for (int n = 0; n < 200000; n++) {
      seen = watch(seen, size * noise.next(5e-3), 1.0, 5e-3);
      ASSERT_FALSE(unreachable(seen));
      ASSERT_LT(std::fabs(seen.deviation), seen.age > MEMORY ? 0.6 * size : 10.0);
    }
    EXPECT_NEAR(seen.age, 1000.0, 1e-6);
  }
}

TEST(Watch, ForgivesAStepOfTheTarget)
{
  for (const double deviation : {-1.0, 999.0}) {
    Watch seen{0.0, 500.0};
    for (int n = 0; n < 3000; n++) {
      seen = watch(seen, deviation, 1.0, 1e-3);
      ASSERT_FALSE(unreachable(seen)) << n;
    }
    for (int n = 0; n < 2000; n++) seen = watch(seen, deviation, 1.0, 1e-3);
    EXPECT_TRUE(unreachable(seen));
  }
}

TEST(Watch, IsTheMeanAtFirstAndStandsStillWithoutTime)
{
  Watch seen;
  seen = watch(seen, 0.3, 0.0, 0.1);
  EXPECT_EQ(seen.deviation, 0.0);
  EXPECT_EQ(seen.age, 0.0);
  for (int n = 0; n < 10; n++) seen = watch(seen, n % 2 ? 0.5 : 0.1, 1.0, 0.1);
  EXPECT_NEAR(seen.deviation, 0.3, 1e-12);
}

TEST(Watch, CallsNothingJammedBeforeItsPatienceIsOver)
{
  EXPECT_FALSE(jammed({0.0, 0.0}));
  EXPECT_FALSE(jammed({0.0, 9.9}));
  EXPECT_TRUE(jammed({0.0, 10.1}));
  EXPECT_FALSE(jammed({0.02, 10.1}));
}
