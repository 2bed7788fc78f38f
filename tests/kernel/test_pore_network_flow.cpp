// Flow through a network of pores, and its forces.

#include "network_case.h"
#include "pore_cg.h"

#ifdef SUSPENSION_EIGEN
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <tuple>
#endif

using namespace network_case;

namespace {

double same(double value)
{
  return value;
}

// A with storage S/dt, and its diagonal
struct Implicit {
  ImplicitMatrix a;
  Implicit(const Lattice &s, double dt, double storage) :
      a(implicit_matrix(s.net, s.flow, dt, storage, s.inverse_mass))
  {
  }
  void operator()(const std::vector<double> &p, std::vector<double> &y) const
  {
    std::vector<Vec3> acceleration;
    for (std::size_t k = 0; k + 1 < a.first.size(); k++)
      acceleration.push_back(acceleration_of(a, p, static_cast<int>(k)));
    y.resize(p.size());
    for (std::size_t i = 0; i < p.size(); i++)
      y[i] = implicit_row(a, p, acceleration, static_cast<int>(i));
  }
  std::vector<double> solve(const std::vector<double> &rhs) const
  {
    std::vector<double> p(rhs.size(), 0.0);
    auto precondition = [this](const std::vector<double> &r, std::vector<double> &z) {
      z.resize(r.size());
      for (std::size_t i = 0; i < r.size(); i++) z[i] = r[i] / a.rows[i].diagonal;
    };
    const Convergence c = conjugate_gradients(*this, precondition, same, rhs, 1e-12, 2000, p);
    EXPECT_LE(c.residual, 1e-12);
    return p;
  }
};

std::vector<Vec3> random_velocities(Random &rnd, const Lattice &s)
{
  std::vector<Vec3> v;
  for (std::size_t k = 0; k < s.x.size(); k++) v.push_back(rnd.vector(1.0));
  return v;
}

std::vector<double> growths(const Lattice &s, const std::vector<Vec3> &v, double sign = 1.0)
{
  std::vector<double> d;
  for (std::size_t i = 0; i < s.net.pores.size(); i++)
    d.push_back(sign * growth(s.net, s.flow, v, static_cast<int>(i)));
  return d;
}

TEST(PoreNetworkFlow, ForcesAddUpToZeroAndTheirPowerIsThatOfTheFlow)
{
  Random rnd(321);
  const Lattice s = make_lattice(3, rnd, 0.03, 0.3);
  const auto v = random_velocities(rnd, s);
  const auto p = Implicit(s, 0.0, 0.0).solve(growths(s, v, -1.0));    // K p = -D v
  const auto f = forces(s, p);
  Vec3 sum;
  double power = 0.0, size = 0.0, flow = 0.0;
  for (std::size_t k = 0; k < f.size(); k++) {
    sum = sum + f[k];
    size += norm(f[k]);
    power += dot(f[k], v[k]);
  }
  for (std::size_t i = 0; i < p.size(); i++)
    flow += p[i] * outflow(s.net, s.flow, p, static_cast<int>(i));
  EXPECT_NEAR(norm(sum), 0.0, 1e-13 * size);
  EXPECT_GT(flow, 0.0);
  EXPECT_NEAR(power, -flow, 1e-11 * flow);
  EXPECT_NEAR(network_dissipation(s.net, s.flow, p, std::vector<double>(s.net.links.size(), 0.0)),
              flow, 1e-12 * flow);
}

TEST(PoreNetworkFlow, GrowthIsThatOfFiniteDifferences)
{
  Random rnd(322);
  Lattice s = make_lattice(2, rnd, 0.03, -0.3);
  const auto v = random_velocities(rnd, s), x = s.x;
  const auto d = growths(s, v);
  std::vector<double> change(d.size(), 0.0);
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t k = 0; k < x.size(); k++) s.x[k] = x[k] + sign * 1e-4 * v[k];
    s.shape();
    for (std::size_t i = 0; i < d.size(); i++) change[i] += sign / 2e-4 * s.flow.shape[i].volume;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < d.size(); i++) {
    EXPECT_NEAR(d[i], change[i], 1e-7);
    sum += d[i];
  }
  EXPECT_NEAR(sum, 0.0, 1e-13);
}

// Their stress is that of the pressures alone, without any shear.
TEST(PoreNetworkFlow, StressOfTheForcesIsMinusTheMeanPressure)
{
  Random rnd(323);
  const Lattice s = make_lattice(2, rnd, 0.03, 0.2);
  const auto p = random_pressure(rnd, s);
  double stress[3][3] = {}, pv = 0.0;
  for (std::size_t i = 0; i < p.size(); i++) {
    const Tetrahedron t = corners_of(s.net.pores[i], s.x, s.cell);
    for (int n = 0; n < 4; n++) {
      const Vec3 f = p[i] * s.flow.shape[i].gradient[n];
      const double fs[3] = {f.x, f.y, f.z}, xs[3] = {t[n].x, t[n].y, t[n].z};
      for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) stress[a][b] += fs[a] * xs[b];
    }
    pv += p[i] * s.flow.shape[i].volume;
  }
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) EXPECT_NEAR(stress[a][b], a == b ? pv : 0.0, 1e-13);
}

// All throats are alike there, and the pressure is linear. alpha = 1. The value: areas, and solid
// angles by L'Huilier's formula, in Python. Displaced spheres (oracle of the project) have 159.36.
TEST(PoreNetworkFlow, TouchingBodyCenteredSpheresHaveTheirPermeability)
{
  Random rnd(324);
  const Lattice s = make_lattice(2, rnd);
  const double a = 0.25 * std::sqrt(3.0), phi = 2.0 * 4.0 / 3.0 * testing_tools::PI_ * a * a * a;
  for (const Vec3 &gradient : {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.6, 0.8}}) {
    std::vector<double> rises, into(s.net.pores.size(), 0.0);
    for (std::size_t n = 0; n < s.net.links.size(); n++) {
      rises.push_back(rise_of(s.net.links[n], s.centers, s.cell, gradient));
      EXPECT_NEAR(s.flow.g[n], s.flow.g[0], 1e-15);
      into[s.net.links[n].pore[0]] += s.flow.g[n] * rises[n];
      into[s.net.links[n].pore[1]] -= s.flow.g[n] * rises[n];
    }
    for (const double rate : into) EXPECT_NEAR(rate, 0.0, 1e-16);
    const double k =
        network_dissipation(s.net, s.flow, std::vector<double>(into.size(), 0.0), rises) / 8.0;
    EXPECT_NEAR(2.0 * a * a / (9.0 * phi * k), 159.31037, 1e-4);
  }
}

// Backward Euler of Darcy's law with the velocities at the end of the step.
TEST(PoreNetworkFlow, ImplicitStepHoldsDarcysLawAtItsEnd)
{
  Random rnd(325);
  const Lattice s = make_lattice(3, rnd, 0.03, 0.1);
  const auto before = random_pressure(rnd, s);
  for (const double dt : {1e-4, 1.0, 100.0})
    for (const double storage : {0.0, 0.2}) {
      auto v = random_velocities(rnd, s);
      auto rhs = growths(s, v, -1.0);
      for (std::size_t i = 0; i < rhs.size(); i++)
        rhs[i] += storage / dt * s.flow.shape[i].volume * before[i];
      const auto p = Implicit(s, dt, storage / dt).solve(rhs);
      const auto f = forces(s, p);
      for (std::size_t k = 0; k < v.size(); k++) v[k] = v[k] + (dt * s.inverse_mass[k]) * f[k];
      double worst = 0.0, size = 0.0;
      for (std::size_t i = 0; i < p.size(); i++) {
        const int row = static_cast<int>(i);
        const double stored = storage / dt * s.flow.shape[i].volume * (p[i] - before[i]);
        worst = std::fmax(
            worst,
            std::fabs(stored + outflow(s.net, s.flow, p, row) + growth(s.net, s.flow, v, row)));
        size = std::fmax(size, std::fabs(rhs[i]));
      }
      EXPECT_LT(worst, 1e-10 * size) << dt << " " << storage;
    }
}

// also the diagonal
TEST(PoreNetworkFlow, ImplicitMatrixIsTheSumOfItsParts)
{
  Random rnd(327);
  const Lattice s = make_lattice(2, rnd, 0.03);
  const Implicit implicit(s, 0.7, 0.3);
  const auto p = random_pressure(rnd, s);
  std::vector<double> y, unit(p.size(), 0.0);
  implicit(p, y);
  auto f = forces(s, p);
  for (std::size_t k = 0; k < f.size(); k++) f[k] = s.inverse_mass[k] * f[k];
  for (std::size_t i = 0; i < p.size(); i++) {
    const int row = static_cast<int>(i);
    EXPECT_NEAR(y[i],
                outflow(s.net, s.flow, p, row) + 0.7 * growth(s.net, s.flow, f, row) +
                    0.3 * s.flow.shape[i].volume * p[i],
                1e-13);
  }
  for (const std::size_t i : {std::size_t(0), std::size_t(17), p.size() - 1}) {
    unit[i] = 1.0;
    implicit(unit, y);
    EXPECT_NEAR(implicit.a.rows[i].diagonal, y[i], 1e-14);
    unit[i] = 0.0;
  }
}

// the largest rate of K^-1 D M^-1 D^T, by iteration
TEST(PoreNetworkFlow, ExplicitStepIsOnTheSafeSide)
{
  Random rnd(326);
  const Lattice s = make_lattice(2, rnd, 0.03);
  auto p = random_pressure(rnd, s);
  double rate = 0.0;
  for (int n = 0; n < 300; n++) {
    auto f = forces(s, p);
    for (std::size_t k = 0; k < f.size(); k++) f[k] = s.inverse_mass[k] * f[k];
    p = Implicit(s, 0.0, 0.0).solve(growths(s, f));
    rate = std::sqrt(scalar_product(p, p));
    for (double &value : p) value /= rate;
  }
  const double step = network_explicit_step(s.net, s.flow, s.inverse_mass);
  EXPECT_LT(step, 2.0 / rate);
  EXPECT_GT(step, 0.1 * 2.0 / rate);
}

#ifdef SUSPENSION_EIGEN
// The matrices built as such, link by link and pore by pore, and solved by elimination.
TEST(PoreNetworkFlow, ImplicitStepIsThatOfTheAssembledMatrices)
{
  Random rnd(331);
  const Lattice s = make_lattice(3, rnd, 0.03, 0.25);
  const int pores = static_cast<int>(s.net.pores.size()), particles = static_cast<int>(s.x.size());
  const double dt = 0.7, storage = 0.3;
  std::vector<Eigen::Triplet<double>> of_k, of_d, of_m;
  for (std::size_t n = 0; n < s.net.links.size(); n++) {
    const int a = s.net.links[n].pore[0], b = s.net.links[n].pore[1];
    const double g = s.flow.g[n];
    for (const auto &[row, column, value] :
         {std::tuple{a, a, g}, std::tuple{b, b, g}, std::tuple{a, b, -g}, std::tuple{b, a, -g}})
      of_k.emplace_back(row, column, value);
  }
  for (int i = 0; i < pores; i++) {
    of_k.emplace_back(i, i, storage * s.flow.shape[i].volume);
    for (int n = 0; n < 4; n++) {
      const Vec3 g = s.flow.shape[i].gradient[n];
      const double components[3] = {g.x, g.y, g.z};
      for (int axis = 0; axis < 3; axis++)
        of_d.emplace_back(i, 3 * s.net.pores[i][n].particle + axis, components[axis]);
    }
  }
  for (int n = 0; n < 3 * particles; n++) of_m.emplace_back(n, n, s.inverse_mass[n / 3]);
  Eigen::SparseMatrix<double> k(pores, pores), d(pores, 3 * particles),
      m(3 * particles, 3 * particles);
  k.setFromTriplets(of_k.begin(), of_k.end());
  d.setFromTriplets(of_d.begin(), of_d.end());
  m.setFromTriplets(of_m.begin(), of_m.end());
  const Eigen::SparseMatrix<double> a =
      k + dt * (d * m * Eigen::SparseMatrix<double>(d.transpose()));
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(a);
  ASSERT_EQ(factors.info(), Eigen::Success);

  std::vector<double> rhs(pores);
  for (double &value : rhs) value = rnd.uniform(-1.0, 1.0);
  const Eigen::VectorXd expected =
      factors.solve(Eigen::Map<const Eigen::VectorXd>(rhs.data(), pores));
  const std::vector<double> found = Implicit(s, dt, storage).solve(rhs);
  for (int i = 0; i < pores; i++)
    EXPECT_NEAR(found[i], expected[i], 1e-9 * expected.cwiseAbs().maxCoeff());
}
#endif

TEST(PoreNetworkFlow, SharesOfTheParticlesHaveTheIntegralOfThePressure)
{
  Random rnd(332);
  const Lattice s = make_lattice(2, rnd, 0.03, 0.2);
  const auto p = random_pressure(rnd, s);
  double sum = 0.0, expected = 0.0;
  for (std::size_t k = 0; k < s.x.size(); k++)
    sum += share_of(s.net, s.flow, p, static_cast<int>(k));
  for (std::size_t i = 0; i < p.size(); i++) expected += p[i] * s.flow.shape[i].volume;
  EXPECT_NEAR(sum, expected, 1e-13);
  // a pressure in one pore only: its corners have a quarter each
  std::vector<double> one(p.size(), 0.0);
  one[5] = 2.0;
  for (const Corner &c : s.net.pores[5])
    EXPECT_GE(share_of(s.net, s.flow, one, c.particle), 0.5 * s.flow.shape[5].volume * (1 - 1e-14));
}

}    // namespace
