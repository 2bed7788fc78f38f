// Conjugate gradients.

#include "pore_cg.h"
#include "tools.h"

#include <gtest/gtest.h>

using namespace LAMMPS_NS::Pore_NS;
using Vector = std::vector<double>;

namespace {

double same(double value)
{
  return value;
}

void copy(const Vector &r, Vector &z)
{
  z = r;
}

// second differences with a varying coefficient; free ends: singular
struct Chain {
  Vector k;
  bool fixed;
  void operator()(const Vector &p, Vector &y) const
  {
    y.assign(p.size(), 0.0);
    for (std::size_t n = 0; n + 1 < p.size(); n++) {
      const double flux = k[n] * (p[n + 1] - p[n]);
      y[n] -= flux;
      y[n + 1] += flux;
    }
    if (fixed) y[0] += k.back() * p[0];
  }
};

Chain random_chain(testing_tools::Random &rnd, std::size_t n, bool fixed)
{
  Chain c{Vector(n), fixed};
  for (double &k : c.k) k = rnd.log_uniform(0.1, 10.0);
  return c;
}

TEST(PoreCg, SolvesInAboutAsManyIterationsAsThereAreUnknowns)
{
  testing_tools::Random rnd(41);
  const Chain a = random_chain(rnd, 12, true);
  Vector exact(12), rhs, p(12, 0.0);
  for (double &x : exact) x = rnd.uniform(-1.0, 1.0);
  a(exact, rhs);
  const Convergence found = conjugate_gradients(a, copy, same, rhs, 1e-11, 100, p);
  EXPECT_LE(found.iterations, 24);
  EXPECT_LE(found.residual, 1e-11);
  for (std::size_t n = 0; n < 12; n++) EXPECT_NEAR(p[n], exact[n], 1e-9);
}

TEST(PoreCg, ExactPreconditionerNeedsOneIteration)
{
  testing_tools::Random rnd(42);
  Vector diagonal(20), rhs(20), p(20, 0.0);
  for (double &d : diagonal) d = rnd.log_uniform(1e-4, 1e4);
  for (double &r : rhs) r = rnd.uniform(-1.0, 1.0);
  const auto apply = [&](const Vector &x, Vector &y) {
    y = x;
    for (std::size_t n = 0; n < 20; n++) y[n] *= diagonal[n];
  };
  const auto precondition = [&](const Vector &r, Vector &z) {
    z = r;
    for (std::size_t n = 0; n < 20; n++) z[n] /= 7.0 * diagonal[n];    // of any size
  };
  const Convergence found = conjugate_gradients(apply, precondition, same, rhs, 1e-12, 100, p);
  EXPECT_EQ(found.iterations, 1);
  for (std::size_t n = 0; n < 20; n++) EXPECT_NEAR(p[n] * diagonal[n], rhs[n], 1e-13);
}

TEST(PoreCg, ContinuesFromWhatIsGiven)
{
  testing_tools::Random rnd(43);
  const Chain a = random_chain(rnd, 30, true);
  Vector rhs(30), p(30, 0.0);
  for (double &r : rhs) r = rnd.uniform(-1.0, 1.0);
  conjugate_gradients(a, copy, same, rhs, 1e-10, 200, p);
  EXPECT_EQ(conjugate_gradients(a, copy, same, rhs, 1e-9, 200, p).iterations, 0);
}

TEST(PoreCg, SingularSystemsThatHaveASolution)
{
  testing_tools::Random rnd(44);
  const Chain a = random_chain(rnd, 15, false);
  Vector exact(15), rhs, p(15, 0.0), y;
  for (double &x : exact) x = rnd.uniform(-1.0, 1.0);
  a(exact, rhs);
  conjugate_gradients(a, copy, same, rhs, 1e-11, 100, p);
  a(p, y);
  for (std::size_t n = 0; n < 15; n++) EXPECT_NEAR(y[n], rhs[n], 1e-9);
}

TEST(PoreCg, NothingToDo)
{
  testing_tools::Random rnd(45);
  const Chain a = random_chain(rnd, 5, true);
  Vector p(5, 3.0);
  EXPECT_EQ(conjugate_gradients(a, copy, same, Vector(5, 0.0), 1e-9, 100, p).iterations, 0);
  EXPECT_EQ(p, Vector(5, 0.0));
  Vector q(5, 0.0);
  const auto zero = [](const Vector &x, Vector &y) {
    y.assign(x.size(), 0.0);
  };
  conjugate_gradients(zero, copy, same, Vector(5, 1.0), 1e-9, 100, q);
  for (double x : q) EXPECT_EQ(x, 0.0);    // a matrix of zeros has no solution
}

// with an exact preconditioner it is the error, measured by the matrix
TEST(PoreCg, ResidualInThePreconditionerIsTheError)
{
  const double diagonal[4] = {1.0, 4.0, 9.0, 100.0};
  const auto apply = [&](const Vector &p, Vector &y) {
    y.resize(4);
    for (int n = 0; n < 4; n++) y[n] = diagonal[n] * p[n];
  };
  const auto exact = [&](const Vector &r, Vector &z) {
    z.resize(4);
    for (int n = 0; n < 4; n++) z[n] = r[n] / diagonal[n];
  };
  const Vector rhs = {1.0, 4.0, 9.0, 100.0};
  Vector p = {1.0, 1.0, 1.0, 1.01};
  const auto found =
      solve_by_products(apply, exact, scalar_product, rhs, 0.05, 9, p, Measure::PRECONDITIONED);
  EXPECT_EQ(found.iterations, 0);
  EXPECT_NEAR(found.residual, std::sqrt(100.0 * 1e-4 / 114.0), 1e-12);
}

TEST(PoreCg, SaysThatThePreconditionerIsNotPositive)
{
  testing_tools::Random rnd(45);
  const Chain a = random_chain(rnd, 12, true);
  const auto negative = [](const Vector &r, Vector &z) {
    z = r;
    z[3] *= -50.0;
  };
  Vector rhs(12), p(12, 0.0);
  rhs[3] = 1.0;
  for (const auto measure : {Measure::RESIDUAL, Measure::PRECONDITIONED})
    EXPECT_FALSE(
        solve_by_products(a, negative, scalar_product, rhs, 1e-9, 50, p, measure).positive);
}

TEST(PoreCg, StopsWhereTheOtherRanksStop)
{
  testing_tools::Random rnd(46);
  const Chain a = random_chain(rnd, 30, true);
  Vector rhs(30, 1.0), p(30, 0.0);
  int asked = 0;
  const auto others = [&](double value) {
    return ++asked < 8 ? value : 0.0;
  };
  EXPECT_LT(conjugate_gradients(a, copy, others, rhs, 1e-12, 100, p).iterations, 8);
  EXPECT_EQ(conjugate_gradients(a, copy, same, rhs, 1e-12, 3, p).iterations, 3);
}

}    // namespace
