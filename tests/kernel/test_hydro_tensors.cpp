// Response of a fluid to Gaussian loads.

#include "hydro_tensors.h"
#include "tools.h"

#include <array>
#include <vector>

using namespace LAMMPS_NS::Hydro_NS;
using testing_tools::expect_near;
using testing_tools::PI_;
using testing_tools::Random;

namespace {

// mean of |x + r| over a Gaussian of variance q: the potential itself
double mean_distance(double r, double q)
{
  return (r + q / r) * std::erf(r / std::sqrt(2.0 * q)) +
      std::sqrt(2.0 * q / PI_) * std::exp(-r * r / (2.0 * q));
}

template <class F> double slope(F f, double r, double step)
{
  return (8.0 * (f(r + step) - f(r - step)) - f(r + 2.0 * step) + f(r - 2.0 * step)) /
      (12.0 * step);
}

TEST(HydroTensors, RadialFunctionsAreDerivatives)
{
  for (const double q : {0.4, 1.0, 2.3})
    for (const double r : {0.3, 1.0, 1.9, 2.6, 4.0, 9.0}) {
      SCOPED_TRACE("q " + std::to_string(q) + " r " + std::to_string(r));
      const Radial f = gaussian_radial(r, q);
      const double step = 3e-3 * std::sqrt(q);
      const auto h = [q](double t) {
        return mean_distance(t, q);
      };
      EXPECT_NEAR(f.h[1], slope(h, r, step) / r, 1e-8 * std::fabs(f.h[1]));
      for (int n = 1; n < 4; n++) {
        const auto of_h = [q, n](double t) {
          return gaussian_radial(t, q).h[n];
        };
        EXPECT_NEAR(f.h[n + 1], slope(of_h, r, step) / r, 1e-7 * std::fabs(f.h[n] / (r * step)));
      }
      for (int n = 0; n < 4; n++) {
        const auto of_p = [q, n](double t) {
          return gaussian_radial(t, q).p[n];
        };
        EXPECT_NEAR(f.p[n + 1], slope(of_p, r, step) / r, 1e-7 * std::fabs(f.p[n] / (r * step)));
      }
      // lap h = h'' + 2 h'/r
      EXPECT_NEAR(f.p[0], r * r * f.h[2] + 3.0 * f.h[1], 1e-13);
    }
}

TEST(HydroTensors, SeriesMeetsTheClosedForm)
{
  for (const double q : {0.2, 1.0, 5.0}) {
    const double r = 2.0 * std::sqrt(q);
    const Radial below = gaussian_radial(r * (1.0 - 1e-15), q), above = gaussian_radial(r, q);
    for (int n = 0; n < 5; n++) {
      EXPECT_NEAR(below.p[n], above.p[n], 1e-12 * std::fabs(above.p[n]));
      EXPECT_NEAR(below.h[n], above.h[n], 1e-12 * std::fabs(above.h[n]));
    }
    for (const double value : gaussian_radial(0.0, q).p) EXPECT_TRUE(std::isfinite(value));
  }
}

using Three = std::array<double, 3>;
using Nine = std::array<Three, 3>;

// G_ab of a Gaussian force, over 8 pi eta
Nine green(const Three &x, double q)
{
  const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  const Radial f = gaussian_radial(r, q);
  Nine g;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) g[a][b] = (a == b ? f.p[0] - f.h[1] : 0.0) - x[a] * x[b] * f.h[2];
  return g;
}

Three moved(Three x, int d, double by)
{
  x[d] += by;
  return x;
}

double part(const Vec3 &v, int d)
{
  return d == 0 ? v.x : d == 1 ? v.y : v.z;
}
double part(const Tensor &t, int a, int b)
{
  return part(a == 0 ? t.x : a == 1 ? t.y : t.z, b);
}

Load random_load(Random &rnd)
{
  double n[NUMBERS];
  for (double &value : n) value = rnd.uniform(-1.0, 1.0);
  return get_load(n);
}

PairResponse random_pair(const Vec3 &x)
{
  const double r = norm(x);
  return pair_response(x, gaussian_radial(r, 0.64), gaussian_radial(r, 0.5),
                       gaussian_radial(r, 0.55), gaussian_radial(r, 0.4));
}

// u_a = G_ab F_b - C_bc d_c G_ab by differences, each Gaussian with its own variance
TEST(HydroTensors, PairIsTheFlowOfForceAndDipole)
{
  Random rnd(3);
  const double e = 2e-3;
  for (int trial = 0; trial < 5; trial++) {
    const Vec3 at = rnd.uniform(1.2, 3.0) * rnd.unit();
    const Three x = {at.x, at.y, at.z};
    const Load load = random_load(rnd);
    Motion i, j;
    add_pair(random_pair(at), 1.0, Load(), load, i, j);
    const auto velocity = [&](const Three &y, int a, double of_force, double of_dipole) {
      double u = 0.0;
      for (int b = 0; b < 3; b++) {
        u += green(y, of_force)[a][b] * part(load.force, b);
        for (int c = 0; c < 3; c++)
          u -= part(load.dipole, b, c) / (2.0 * e) *
              (green(moved(y, c, e), of_dipole)[a][b] - green(moved(y, c, -e), of_dipole)[a][b]);
      }
      return u;
    };
    for (int a = 0; a < 3; a++) {
      EXPECT_NEAR(part(i.velocity, a), velocity(x, a, 0.64, 0.5), 1e-5);
      for (int d = 0; d < 3; d++) {
        const double g =
            (velocity(moved(x, d, e), a, 0.55, 0.4) - velocity(moved(x, d, -e), a, 0.55, 0.4)) /
            (2.0 * e);
        EXPECT_NEAR(part(i.gradient, a, d), g, 1e-5) << a << d;
      }
    }
    expect_near(j.velocity, {}, 0.0);
  }
}

double power(const Load &load, const Motion &motion)
{
  return dot(load.force, motion.velocity) + contraction(load.dipole, motion.gradient);
}

TEST(HydroTensors, PairIsReciprocal)
{
  Random rnd(4);
  for (int trial = 0; trial < 20; trial++) {
    const PairResponse r = random_pair(rnd.uniform(0.5, 5.0) * rnd.unit());
    const Load a1 = random_load(rnd), a2 = random_load(rnd), b1 = random_load(rnd);
    const Load b2 = random_load(rnd);
    Motion a_i, a_j, b_i, b_j;
    add_pair(r, 1.0, a1, a2, a_i, a_j);
    add_pair(r, 1.0, b1, b2, b_i, b_j);
    EXPECT_NEAR(power(b1, a_i) + power(b2, a_j), power(a1, b_i) + power(a2, b_j), 1e-13);
  }
}

Tensor turned_tensor(const Tensor &t, const Vec3 &axis, double angle)
{
  using testing_tools::rotated;
  const Tensor half =
      transposed({rotated(t.x, axis, angle), rotated(t.y, axis, angle), rotated(t.z, axis, angle)});
  return transposed(
      {rotated(half.x, axis, angle), rotated(half.y, axis, angle), rotated(half.z, axis, angle)});
}

TEST(HydroTensors, NoFrameIsSpecial)
{
  Random rnd(5);
  using testing_tools::rotated;
  for (int trial = 0; trial < 10; trial++) {
    const Vec3 axis = rnd.unit(), x = rnd.uniform(0.7, 4.0) * rnd.unit();
    const double angle = rnd.uniform(0.0, 3.0);
    const Load a = random_load(rnd), b = random_load(rnd);
    const auto turn = [&](const Load &l) {
      return Load{rotated(l.force, axis, angle), turned_tensor(l.dipole, axis, angle)};
    };
    Motion i, j, turned_i, turned_j;
    add_pair(random_pair(x), 1.0, a, b, i, j);
    add_pair(random_pair(rotated(x, axis, angle)), 1.0, turn(a), turn(b), turned_i, turned_j);
    expect_near(rotated(i.velocity, axis, angle), turned_i.velocity, 1e-13);
    expect_near(rotated(j.velocity, axis, angle), turned_j.velocity, 1e-13);
    const Tensor g = turned_tensor(i.gradient, axis, angle);
    expect_near(g.x, turned_i.gradient.x, 1e-13);
    expect_near(g.z, turned_i.gradient.z, 1e-13);
  }
}

TEST(HydroTensors, FarApartTheSizeDoesNotMatter)
{
  const Vec3 x{60.0, 0.0, 0.0};
  Motion i, j;
  add_pair(random_pair(x), 1.0 / (8.0 * PI_), Load(), {{1.0, 1.0, 0.0}, {}}, i, j);
  EXPECT_NEAR(i.velocity.x, 2.0 / (8.0 * PI_ * 60.0), 1e-6);    // Oseen, and rotation 1/8 pi r^2
  EXPECT_NEAR(i.velocity.y, 1.0 / (8.0 * PI_ * 60.0), 1e-6);
  EXPECT_NEAR(spin(i.gradient).z, -1.0 / (8.0 * PI_ * 3600.0), 1e-10);
}

TEST(HydroTensors, ElevenNumbersHaveThePower)
{
  Random rnd(6);
  for (int trial = 0; trial < 10; trial++) {
    double load[NUMBERS], motion[NUMBERS] = {}, sum = 0.0;
    for (double &value : load) value = rnd.uniform(-1.0, 1.0);
    Motion m{rnd.vector(1.0), {rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)}};
    m.gradient.z.z = -m.gradient.x.x - m.gradient.y.y;
    add_motion(m, motion);
    for (int n = 0; n < NUMBERS; n++) sum += load[n] * motion[n];
    EXPECT_NEAR(power(get_load(load), m), sum, 1e-14);
    // torque: first moment of the force
    const Tensor c = get_load(load).dipole;
    expect_near({c.z.y - c.y.z, c.x.z - c.z.x, c.y.x - c.x.y}, {load[3], load[4], load[5]}, 1e-15);
    // a symmetric tensor to numbers and back
    double five[5];
    put_strain(get_strain(load + 6), five);
    for (int n = 0; n < 5; n++) EXPECT_NEAR(five[n], load[6 + n], 1e-15);
    EXPECT_NEAR(contraction(get_strain(load + 6), rotation({1.0, 2.0, 3.0})), 0.0, 1e-15);
    expect_near(spin(rotation({1.0, 2.0, 3.0})), {1.0, 2.0, 3.0}, 0.0);
  }
}

}    // namespace
