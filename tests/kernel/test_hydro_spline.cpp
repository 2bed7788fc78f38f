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
  return {{{1.0, 2.0, -3.0}, 8.0, 9.0, 10.0, 2.5, -1.5, 0.9}, 9, 7, 8, 1.0, 1.0};
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

  explicit Place(Random &rnd) :
      x(lattice.cell.origin + rnd.vector(6.0)),
      brick(spline_brick(lattice_place(lattice, x), lattice_place(lattice, x))),
      spline(spline_at(lattice, x))
  {
  }
};

TEST(HydroSpline, ALinearFlowIsInterpolatedExactly)
{
  Random rnd(81);
  for (int trial = 0; trial < 20; trial++) {
    const Place p(rnd);
    const Vec3 constant = rnd.vector(1.0);
    const Tensor gradient{rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)};
    std::vector<double> field(3 * p.brick.points());
    for_points(p.brick, [&](int i, int j, int k) {
      const Vec3 u = constant + gradient * point(p.lattice, i, j, k);
      const std::size_t n = p.brick.index(i, j, k);
      field[n] = u.x;
      field[n + p.brick.points()] = u.y;
      field[n + 2 * p.brick.points()] = u.z;
    });
    const Motion m = interpolate(p.spline, p.to, p.brick, field.data());
    EXPECT_LT(norm(m.velocity - (constant + gradient * p.x)), 1e-13);
    EXPECT_LT(contraction(m.gradient + -1.0 * gradient, m.gradient + -1.0 * gradient), 1e-26);
  }
}

// forces and moments of what is spread: those of the load
TEST(HydroSpline, ForceAndDipoleAreSpread)
{
  Random rnd(82);
  for (int trial = 0; trial < 20; trial++) {
    const Place p(rnd);
    const Load load{rnd.vector(1.0), {rnd.vector(1.0), rnd.vector(1.0), rnd.vector(1.0)}};
    std::vector<double> field(3 * p.brick.points());
    spread(p.spline, p.to, p.brick, load, field.data());
    Vec3 force;
    Tensor moment;
    for_points(p.brick, [&](int i, int j, int k) {
      const std::size_t n = p.brick.index(i, j, k), all = p.brick.points();
      const Vec3 f{field[n], field[n + all], field[n + 2 * all]};
      force = force + f;
      moment = moment + outer(f, point(p.lattice, i, j, k) - p.x);
    });
    EXPECT_LT(norm(force - load.force), 1e-13);
    const Tensor error = moment + -1.0 * load.dipole;
    EXPECT_LT(contraction(error, error), 1e-24);
  }
}

// of the transform of what is spread, mean over places
TEST(HydroSpline, FactorOfAWave)
{
  Random rnd(83);
  for (const int number : {0, 1, -3, 5}) {
    const int n = 12;
    std::complex<double> mean = 0.0;
    for (int place = 0; place < 2000; place++) {
      const double xi = 12.0 * place / 2000.0;
      const Lattice line{{{}, 12.0, 12.0, 12.0}, n, n, n, 1.0, 1.0};
      const Spline s = spline_at(line, {xi, 0.0, 0.0});
      for (int i = 0; i < 4; i++)
        mean += s.weight[0][i] / 2000.0 *
            std::polar(1.0, -2.0 * PI_ * number * (s.first[0] + i - xi) / n);
    }
    EXPECT_NEAR(mean.real(), spline_wave(number, n), 1e-12);
    EXPECT_NEAR(mean.imag(), 0.0, 1e-12);
  }
}

}    // namespace
