// Splines on a coarse grid.

#include "hydro_spline.h"

#include "tools.h"

#include <complex>

using namespace LAMMPS_NS::Hydro_NS;
using testing_tools::PI_;
using testing_tools::Random;

namespace {

Lattice tilted_lattice()
{
  return {{{1.0, 2.0, -3.0}, 8.0, 9.0, 10.0, 2.5, -1.5, 0.9}, 9, 7, 8};
}

Vec3 point(const Lattice &lattice, int i, int j, int k)
{
  const Cell &c = lattice.cell;
  const double x = static_cast<double>(i) / lattice.nx, y = static_cast<double>(j) / lattice.ny;
  const double z = static_cast<double>(k) / lattice.nz;
  return c.origin + Vec3{x * c.xprd + y * c.xy + z * c.xz, y * c.yprd + z * c.yz, z * c.zprd};
}

template <class F> void for_points(const Brick &b, F &&f)
{
  for (int k = b.low[2]; k < b.low[2] + b.size[2]; k++)
    for (int j = b.low[1]; j < b.low[1] + b.size[1]; j++)
      for (int i = b.low[0]; i < b.low[0] + b.size[0]; i++) f(i, j, k);
}

struct Place {
  Lattice lattice = tilted_lattice();
  Vec3 x;
  Brick brick;
  Spline spline;
  LatticeGradients to = lattice_gradients(lattice);

  Place(Random &rnd, int order) :
      x(lattice.cell.origin + rnd.vector(6.0)),
      brick(spline_brick(lattice_place(lattice, x), lattice_place(lattice, x), order)),
      spline(spline_at(lattice, x, order))
  {
  }
};

constexpr int ORDERS[] = {4, 6, 8, 10, 12};
constexpr OfLaplacian C = {0.3, -0.2};

// of four points written out: C. de Boor
TEST(HydroSpline, CubicWeights)
{
  for (const double t : {0.0, 0.2, 0.5, 0.9}) {
    const double u = 1.0 - t;
    const double weights[4] = {u * u * u / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
                               (4.0 - 6.0 * u * u + 3.0 * u * u * u) / 6.0, t * t * t / 6.0};
    const double slopes[4] = {-0.5 * u * u, 1.5 * t * t - 2.0 * t, 2.0 * u - 1.5 * u * u,
                              0.5 * t * t};
    double w[MOST_POINTS], s[MOST_POINTS];
    spline_weights(t, 4, w, s);
    for (int n = 0; n < 4; n++) {
      EXPECT_NEAR(w[n], weights[n], 1e-15);
      EXPECT_NEAR(s[n], slopes[n], 1e-15);
    }
  }
}

// a linear flow, with a companion of which c is seen
TEST(HydroSpline, ALinearFlowIsInterpolatedExactly)
{
  Random rnd(81);
  for (const int order : ORDERS)
    for (int trial = 0; trial < 5; trial++) {
      const Place p(rnd, order);
      const Vec3 constant = rnd.vector(1.0), other = rnd.vector(1.0);
      const Tensor gradient{rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)};
      const Tensor turned{gradient.y, gradient.z, gradient.x};
      std::vector<double> plain(4 * p.brick.points()), both(8 * p.brick.points());
      for_points(p.brick, [&](int i, int j, int k) {
        const Vec3 x = point(p.lattice, i, j, k);
        const Vec3 u = constant + gradient * x, lap = other + turned * x;
        const std::size_t n = p.brick.index(i, j, k);
        const double numbers[6] = {u.x, u.y, u.z, lap.x, lap.y, lap.z};
        std::copy_n(numbers, 3, &plain[4 * n]);
        std::copy_n(numbers, 6, &both[8 * n]);
      });
      const Motion m = interpolate<VECTOR>(p.spline, p.to, p.brick, C, plain.data());
      EXPECT_LT(norm(m.velocity - (constant + gradient * p.x)), 1e-13);
      const Tensor off = m.gradient + -1.0 * gradient;
      EXPECT_LT(contraction(off, off), 1e-26);
      const Motion w = interpolate<WITH_COMPANION>(p.spline, p.to, p.brick, C, both.data());
      const Vec3 lap = other + turned * p.x;
      EXPECT_LT(norm(w.velocity - (constant + gradient * p.x + C.force * lap)), 1e-13);
      const Tensor error = w.gradient + -1.0 * (gradient + C.dipole * turned);
      EXPECT_LT(contraction(error, error), 1e-24);
    }
}

// forces and moments of what is spread: those of the load
TEST(HydroSpline, ForceAndDipoleAreSpread)
{
  Random rnd(82);
  for (const int order : ORDERS)
    for (int trial = 0; trial < 5; trial++) {
      const Place p(rnd, order);
      const Load load{rnd.vector(1.0), {rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)}};
      std::vector<double> field(8 * p.brick.points());
      spread<WITH_COMPANION>(p.spline, p.to, p.brick, C, load, field.data());
      Vec3 force, other;
      Tensor moment, of_other;
      for_points(p.brick, [&](int i, int j, int k) {
        const double *n = &field[8 * p.brick.index(i, j, k)];
        const Vec3 f{n[0], n[1], n[2]}, g{n[3], n[4], n[5]}, x = point(p.lattice, i, j, k) - p.x;
        EXPECT_EQ(n[6], 0.0);
        EXPECT_EQ(n[7], 0.0);
        force = force + f;
        other = other + g;
        moment = moment + outer(f, x);
        of_other = of_other + outer(g, x);
      });
      EXPECT_LT(norm(force - load.force), 1e-13);
      EXPECT_LT(norm(other - C.force * load.force), 1e-13);
      const Tensor error = moment + -1.0 * load.dipole;
      EXPECT_LT(contraction(error, error), 1e-24);
      const Tensor error2 = of_other + -C.dipole * load.dipole;
      EXPECT_LT(contraction(error2, error2), 1e-24);
    }
}

TEST(HydroSpline, SpreadAndInterpolateAreAdjoint)
{
  Random rnd(84);
  for (const int order : ORDERS) {
    const Place p(rnd, order);
    const Load load{rnd.vector(1.0), {rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)}};
    std::vector<double> f(8 * p.brick.points()), u(f.size());
    for (double &value : u) value = rnd.uniform(-1.0, 1.0);
    spread<WITH_COMPANION>(p.spline, p.to, p.brick, C, load, f.data());
    const Motion m = interpolate<WITH_COMPANION>(p.spline, p.to, p.brick, C, u.data());
    double sum = 0.0;
    for (std::size_t n = 0; n < f.size(); n++) sum += f[n] * u[n];
    EXPECT_NEAR(dot(load.force, m.velocity) + contraction(load.dipole, m.gradient), sum, 1e-13);
  }
}

// in a brick that holds it as in one that is too large
TEST(HydroSpline, BrickHoldsWhatItsCentersReach)
{
  Random rnd(85);
  const Lattice l = tilted_lattice();
  const Vec3 low{-3.0, 2.0, 5.0}, high{4.0, 6.0, 9.0};
  for (const int order : ORDERS) {
    const Brick b = spline_brick(low, high, order);
    const LatticeGradients to = lattice_gradients(l);
    for (int trial = 0; trial < 10; trial++) {
      const double x = rnd.uniform(low.x, high.x) / l.nx, y = rnd.uniform(low.y, high.y) / l.ny,
                   z = rnd.uniform(low.z, high.z) / l.nz;
      const Cell &c = l.cell;
      const Vec3 center =
          c.origin + Vec3{x * c.xprd + y * c.xy + z * c.xz, y * c.yprd + z * c.yz, z * c.zprd};
      const Vec3 g = lattice_place(l, center);
      const Brick own = spline_brick(g, g, order);
      for (int d = 0; d < 3; d++) {
        EXPECT_EQ(own.size[d], order);
        EXPECT_GE(own.low[d], b.low[d]);
        EXPECT_LE(own.low[d] + own.size[d], b.low[d] + b.size[d]);
      }
      std::vector<double> f(4 * own.points()), more(4 * b.points());
      const Load load{rnd.vector(1.0), {rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)}};
      spread<VECTOR>(spline_at(l, center, order), to, own, C, load, f.data());
      spread<VECTOR>(spline_at(l, center, order), to, b, C, load, more.data());
      for_points(own, [&](int i, int j, int k) {
        for (int n = 0; n < 3; n++)
          EXPECT_EQ(f[4 * own.index(i, j, k) + n], more[4 * b.index(i, j, k) + n]);
      });
    }
  }
}

// of the transform of what is spread, mean over places
TEST(HydroSpline, FactorOfAWave)
{
  Random rnd(83);
  for (const int order : ORDERS)
    for (const int number : {0, 1, -3, 5}) {
      const int n = 12;
      std::complex<double> mean = 0.0;
      for (int place = 0; place < 2000; place++) {
        const double xi = 12.0 * place / 2000.0;
        const Lattice line{{{}, 12.0, 12.0, 12.0}, n, n, n};
        const Spline s = spline_at(line, {xi, 0.0, 0.0}, order);
        for (int i = 0; i < order; i++)
          mean += s.weight[0][i] / 2000.0 *
              std::polar(1.0, -2.0 * PI_ * number * (s.first[0] + i - xi) / n);
      }
      EXPECT_NEAR(mean.real(), spline_wave(number, n, order), 1e-12);
      EXPECT_NEAR(mean.imag(), 0.0, 1e-12);
    }
}

TEST(HydroSpline, NumbersOfPointsHaveSmallFactors)
{
  EXPECT_EQ(good_number(9.7), 10);
  EXPECT_EQ(good_number(12.0), 12);
  EXPECT_EQ(good_number(21.5), 24);
  EXPECT_EQ(good_number(24.8), 25);
  EXPECT_EQ(good_number(0.1), 2);
}

}    // namespace
