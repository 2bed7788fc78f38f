// What must hold whatever the scene: two or three spheres with random sizes, densities, laws and
// motions. Each scene is made from its seed, which a failure prints with the parameters.

#include "lubcontact_stiffness.h"
#include "scene.h"

#include <sstream>

using namespace hard_cases;
using namespace testing_tools;

namespace {

template <unsigned... MASK> std::vector<Law> make_laws(std::integer_sequence<unsigned, MASK...>)
{
  return {make_law<MASK>()...};
}

// bare contact, each film and friction by itself, basic combinations, the extensions
const std::vector<Law> LAWS =
    make_laws(std::integer_sequence<unsigned, 0, 1, 2, 3, 4, 7, 8, 16, 24, 30, 31, 36, 37, 63, 64,
                                    65, 95, 128, 129, 159, 192, 223, 229, 254, 255>{});

constexpr std::uint64_t SEEDS = 400;

// speed of a sphere so light that it would bring this share of its radius of overlap
double speed_of(double g, double mass, double share)
{
  return share * std::sqrt(g / mass);
}

struct Draw {
  Scene scene;
  bool flat;
  double least_mass = HUGE_VAL;

  // wild: stiffnesses, viscosities and steps that nobody would choose
  explicit Draw(std::uint64_t seed, bool wild = false) :
      scene{LAWS[seed % LAWS.size()], {}, {}}, flat((seed / LAWS.size()) % 2 == 1)
  {
    Random rnd(seed);
    choose_laws(rnd, wild);
    place(rnd);
    scene.start();
    choose_step();
  }

  void choose_laws(Random &rnd, bool wild)
  {
    const double w = wild ? 1e5 : 1.0, wt = wild ? 1e3 : 1.0;
    const double g = 1e3, hc = rnd.uniform(0.3, 1.0);
    const double eps = rnd.uniform(0.0, 1.0) < 0.75 ? rnd.log_uniform(1e-4, 3e-2) : 0.0;
    scene.c = make_coeffs(g, g * rnd.log_uniform(0.1 / w, 10.0 * w), eps,
                          g * rnd.log_uniform(0.1 / wt, wt),
                          rnd.uniform(0.0, 1.0) < 0.8 ? rnd.uniform(0.0, 1.0) : 0.0);
    GapLaw &law = scene.c.normal.gap;
    if (eps > 0.0) {
      law.release_a = eps + rnd.uniform(0.0, 0.5) * eps / (1.0 + law.alpha);
      law.ln_release = std::log(law.release_a);
    }
    // 1e-6 of the repulsion at least dies out within the range
    scene.c.normal.repulsion = {rnd.log_uniform(0.1, 20.0), rnd.uniform(14.0, 60.0) / hc};
    const FrictionLaw friction =
        static_cast<FrictionLaw>(rnd.engine() % static_cast<unsigned>(FrictionLaw::NUM_LAWS));
    scene.c.threshold = make_threshold(friction, rnd.log_uniform(0.1, 10.0));
    scene.film = make_film(rnd.uniform(0.0, 1.0) < 0.8 ? rnd.log_uniform(1e-3 / w, 1e2 * w) : 0.0,
                           hc, rnd.coin() ? Range::CUT : Range::SHIFTED, rnd.coin() ? 0.6 : 1.5);
    scene.rule = rnd.coin() ? Radius::HARMONIC : Radius::MEAN;
  }

  Vec3 in_plane(Vec3 a) const { return flat ? Vec3{a.x, a.y, 0.0} : a; }

  // each sphere beside the first, at a gap or a small overlap, and on its way to the others
  void place(Random &rnd)
  {
    const int n = 2 + static_cast<int>(rnd.engine() % 2);
    std::vector<Sphere> &all = scene.spheres;
    while (static_cast<int>(all.size()) < n) {
      const double radius = all.empty() ? 1.0 : rnd.log_uniform(0.2, 5.0);
      Sphere s{{}, {}, {}, radius, ball_mass(rnd.log_uniform(0.1, 10.0), radius)};
      if (!all.empty()) {
        const double least = std::fmin(1.0, radius);
        Vec3 d = in_plane(rnd.unit());
        d = (1.0 / norm(d)) * d;
        s.x = (1.0 + radius + least * rnd.uniform(-0.02, 0.3)) * d;
        bool clear = true;
        for (std::size_t m = 1; m < all.size(); m++)
          clear = clear && norm(s.x - all[m].x) > radius + all[m].radius;
        if (!clear) continue;
        s.v = -rnd.uniform(0.0, 1.0) * d;
      }
      all.push_back(s);
      least_mass = std::fmin(least_mass, s.mass);
    }
    for (Sphere &s : all) {
      const double size = std::fmin(1.0, s.radius);
      const double fast = size * speed_of(scene.c.normal.g, s.mass, rnd.log_uniform(1e-4, 0.05));
      s.v = fast * (s.v + in_plane(rnd.vector(0.5)));
      const Vec3 spin = (fast / s.radius) * rnd.vector(1.0);
      s.omega = flat ? Vec3{0.0, 0.0, spin.z} : spin;
    }
  }

  void choose_step()
  {
    double most = 0.0;
    for (const Pair &p : scene.pairs) {
      const Sphere &i = scene.spheres[static_cast<std::size_t>(p.i)];
      const Sphere &j = scene.spheres[static_cast<std::size_t>(p.j)];
      const PairStiffness k = pair_stiffness(scene.c.normal.g, scene.c.kt, SPIN_OF_INERTIA, p.g,
                                             i.radius, j.radius, true, true);
      most = std::fmax(most, std::fmax(2.0 * k.i / i.mass, 2.0 * k.j / j.mass));
    }
    scene.dt = 0.03 * 2.0 / std::sqrt(most * static_cast<double>(scene.spheres.size() - 1));
  }

  bool dry() const { return scene.film.viscosity == 0.0; }
};

std::string words(std::uint64_t seed, const Draw &d)
{
  std::ostringstream out;
  out.precision(17);
  const Scene &s = d.scene;
  out << "seed " << seed << (d.flat ? " 2d" : " 3d") << " mask " << s.law.mask << " eta "
      << s.film.viscosity << " range " << s.film.reach_a
      << (s.film.shift > 0.0 ? " shifted" : " cut") << " k " << s.c.normal.asperity << " kt "
      << s.c.kt << " eps " << s.c.normal.gap.eps_a << " release " << s.c.normal.gap.release_a
      << " mu " << s.c.mu << " dt " << s.dt;
  for (const Sphere &p : s.spheres) out << "\n  radius " << p.radius << " mass " << p.mass;
  return out.str();
}

template <class F> void for_each_scene(std::uint64_t first, F &&f, bool wild = false)
{
  for (std::uint64_t seed = first; seed < first + SEEDS; seed++) {
    const Draw d(seed, wild);
    SCOPED_TRACE(words(seed, d));
    f(d);
    if (testing::Test::HasFailure()) return;
  }
}

double scale_of_momentum(const Scene &s)
{
  double sum = 0.0;
  for (const Sphere &p : s.spheres) sum += p.mass * (norm(p.v) + p.radius * norm(p.omega));
  return sum;
}

void expect_state_is_sound(const Scene &s, const Draw &d)
{
  for (const Pair &p : s.pairs) {
    if (!p.known) continue;
    ASSERT_TRUE(std::isfinite(norm(force_on_i(p.load, p.g)))) << "no NaN";
    ASSERT_TRUE(std::isfinite(norm(torque_on_i(p.load, p.g))));
    const double ln_u = s.law.mask & SQUEEZE ? p.history[1] : std::log(p.load.u / p.g.a);
    ASSERT_TRUE(std::isfinite(ln_u)) << "the gap is positive";
    ASSERT_TRUE(p.load.u > 0.0 || ln_u < -700.0) << "or below the smallest number";
    const double friction = split(p.load).contact * norm(p.load.shear);
    ASSERT_LE(friction, p.load.cone * (1.0 + 1e-9) + 1e-300) << "Coulomb";
    const double load = std::fmax(0.0, p.load.contact);
    ASSERT_LE(p.load.cone, s.c.mu * load * (1.0 + 1e-12)) << "no law of friction exceeds mu N";
    const bool slips_in_film = !d.dry() && (s.law.mask & SHEAR);
    const double shear = slips_in_film ? 0.0 : norm(p.load.shear);
    ASSERT_LE(shear, p.load.cone * (1.0 + 1e-9) + 1e-300) << "without film friction is all";
    const bool sucks = (!d.dry() && (s.law.mask & SQUEEZE)) || (s.law.mask & ADHESION);
    ASSERT_GE(sucks ? 0.0 : p.load.normal, 0.0) << "without film and adhesion nothing attracts";
    ASSERT_GE(p.load.repulsion, 0.0);
  }
}

}    // namespace

// Largest error of the balance of energy over the largest energy.
static double defect_of(Scene s, int steps, double dt)
{
  s.dt = dt;
  const double start = s.kinetic() + s.stored();
  double peak = start, defect = 0.0;
  for (int n = 0; n < steps; n++) {
    s.step();
    const double energy = s.kinetic() + s.stored();
    peak = std::fmax(peak, energy);
    const double now = energy + Scene::total(s.heat) + s.dropped - s.brought - start;
    defect = std::fmax(defect, std::fabs(now));
  }
  return defect / peak;
}

struct Counts {
  int touched = 0, slid = 0, pulled = 0, left = 0;
};

// tolerance of the energy: a kink of a force inside a step costs up to (frequency dt)^2 of it
static void expect_laws_of_mechanics(const Draw &d, Scene s, double tolerance, Counts &seen)
{
  const Vec3 P = s.momentum(), L = s.angular_momentum();
  double momentum = scale_of_momentum(s), peak = s.kinetic() + s.stored();
  for (int n = 1; n <= 1500; n++) {
    s.step();
    expect_state_is_sound(s, d);
    if (testing::Test::HasFatalFailure()) return;
    momentum = std::fmax(momentum, scale_of_momentum(s));
    peak = std::fmax(peak, s.kinetic() + s.stored());
    for (const Pair &p : s.pairs) {
      seen.touched += p.known && p.load.touch;
      seen.slid += p.known && split(p.load).state == ContactState::SLIP;
      seen.pulled += p.known && p.load.normal < 0.0;
    }
  }
  for (const Pair &p : s.pairs) seen.left += !p.known;
  expect_near(s.momentum(), P, 1e-12 * momentum);
  expect_near(s.angular_momentum(), L, 1e-11 * momentum);
  for (int m = 0; m < NUM_ORIGINS; m++)
    EXPECT_GE(s.heat.of[m], -tolerance * peak) << ORIGIN_NAME[m] << " makes energy";
  for (const Sphere &p : s.spheres) {
    const Vec3 out{p.omega.x, p.omega.y, p.v.z};
    EXPECT_EQ(d.flat ? std::fabs(p.x.z) + norm(out) : 0.0, 0.0) << "2d remains 2d";
  }
}

TEST(HardProperties, ConservationAndBoundsInEveryScene)
{
  Counts seen;
  for_each_scene(1000, [&](const Draw &d) {
    expect_laws_of_mechanics(d, d.scene, 1e-3, seen);
  });
  // the scenes do what they should
  EXPECT_GT(seen.touched, 10000);
  EXPECT_GT(seen.slid, 5000);
  EXPECT_GT(seen.pulled, 10000);
  EXPECT_GT(seen.left, 50);
}

TEST(HardProperties, ConservationAndBoundsWithWildCoefficientsAndLongSteps)
{
  Counts seen;
  auto longer = [&](const Draw &d) {
    Scene s = d.scene;
    s.dt *= 3.0;
    expect_laws_of_mechanics(d, s, 1e-2, seen);
  };
  for_each_scene(4000, longer, true);
  EXPECT_GT(seen.touched, 10000);
  EXPECT_GT(seen.left, 50);
}

TEST(HardProperties, TheBalanceOfEnergyClosesWithTheStep)
{
  double coarse = 0.0, fine = 0.0;
  for_each_scene(3000, [&](const Draw &d) {
    const double error = defect_of(d.scene, 800, d.scene.dt);
    EXPECT_LT(error, 2e-3);
    coarse += error;
    const double rest = defect_of(d.scene, 3200, 0.25 * d.scene.dt);
    EXPECT_LT(rest, 4e-4);
    fine += rest;
  });
  EXPECT_LT(fine, coarse / 12.0) << "second order";
}

TEST(HardProperties, RotationTranslationBoostAndOrderChangeNothing)
{
  for_each_scene(2000, [](const Draw &d) {
    Random rnd(7);
    const Vec3 axis = d.flat ? Vec3{0.0, 0.0, 1.0} : rnd.unit();
    const Vec3 shift = d.in_plane(rnd.vector(30.0));
    const double angle = rnd.uniform(-PI_, PI_);
    double fastest = 0.0;
    for (const Sphere &s : d.scene.spheres)
      fastest = std::fmax(fastest, norm(s.v) + s.radius * norm(s.omega));
    const Vec3 boost = fastest * d.in_plane(rnd.unit());

    Scene plain = d.scene, moved = d.scene;
    for (Sphere &s : moved.spheres) {
      s.x = shift + rotated(s.x, axis, angle);
      s.v = boost + rotated(s.v, axis, angle);
      s.omega = rotated(s.omega, axis, angle);
    }
    std::reverse(moved.spheres.begin(), moved.spheres.end());
    moved.start();
    const int steps = 600;
    for (int n = 0; n < steps; n++) {
      plain.step();
      moved.step();
    }
    for (std::size_t m = 0; m < plain.spheres.size(); m++) {
      const Sphere &a = plain.spheres[m], &b = moved.spheres[plain.spheres.size() - 1 - m];
      const Vec3 drift = shift + (steps * plain.dt) * boost;
      expect_near(b.x, drift + rotated(a.x, axis, angle), 1e-10);
      expect_near(b.v, boost + rotated(a.v, axis, angle), 1e-7 * fastest);
      expect_near(a.radius * b.omega, a.radius * rotated(a.omega, axis, angle), 1e-7 * fastest);
    }
  });
}
