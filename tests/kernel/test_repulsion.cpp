// Shows force and energy of the screened repulsion, Lambert's W, and the gap at which it is
// balanced.

#include "lubcontact_repulsion.h"
#include "reference/laws_reference.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Repulsion, IsExponentialInTheGap)
{
  Random rnd(1);
  for (int trial = 0; trial < 10000; trial++) {
    const double F0 = rnd.log_uniform(1e-6, 1e6), length = rnd.log_uniform(1e-6, 1.0);
    const double u = length * rnd.uniform(0.0, 600.0);
    const double exact = F0 * std::exp(-u / length);
    EXPECT_NEAR(repulsion_force({F0, 1.0 / length}, u), exact, 1e-12 * exact);
  }
  EXPECT_EQ(repulsion_force({3.0, 100.0}, 0.0), 3.0);
  EXPECT_LT(repulsion_force({1.0, 1e6}, 1.0), 1e-290);    // far out nothing underflows or overflows
  EXPECT_GE(repulsion_force({1.0, 1e6}, 1e9), 0.0);
}

TEST(Repulsion, IsMinusTheSlopeOfItsEnergy)
{
  Random rnd(2);
  for (int trial = 0; trial < 1000; trial++) {
    const Repulsion p{rnd.log_uniform(1e-3, 1e3), rnd.log_uniform(1.0, 1e4)};
    const double u = rnd.uniform(0.1, 20.0) / p.per_length, d = 1e-4 / p.per_length;
    const double slope = (repulsion_energy(p, u + d) - repulsion_energy(p, u - d)) / (2.0 * d);
    EXPECT_NEAR(-slope, repulsion_force(p, u), 1e-7 * repulsion_force(p, u));
  }
  EXPECT_LT(repulsion_energy({5.0, 100.0}, 10.0), 1e-290);    // zero far apart
  EXPECT_EQ(repulsion_energy(Repulsion{}, 0.1), 0.0);
  EXPECT_EQ(repulsion_force(Repulsion{}, 0.1), 0.0);
}

TEST(Lambert, AgreesWithSciPy)
{
  for (const LambertCase &c : LAMBERT_CASES)
    EXPECT_NEAR(lambert_of_exponential(c.L), c.W, 1e-14 * c.W) << "L = " << c.L;
}

TEST(Lambert, SolvesItsEquation)
{
  Random rnd(3);
  auto check = [](double L) {
    const double y = lambert_of_exponential(L);
    EXPECT_NEAR(y + std::log(y), L, 1e-13 * (1.0 + std::fabs(L))) << "L = " << L;
  };
  for (int trial = 0; trial < 20000; trial++) check(rnd.uniform(-600.0, 600.0));
  for (int trial = 0; trial < 20000; trial++) check(rnd.uniform(-3.0, 5.0));
  for (int trial = 0; trial < 20000; trial++) check(rnd.log_uniform(1.0, 1e5));
  for (const double L : {-600.0, -1e-300, 0.0, 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 1e5}) check(L);
  EXPECT_EQ(lambert_of_exponential(-601.0), 0.0);
  EXPECT_EQ(lambert_of_exponential(-1e300), 0.0);
}

TEST(RepelledGap, SolvesItsEquation)
{
  Random rnd(4);
  for (int trial = 0; trial < 50000; trial++) {
    const double A = rnd.uniform(1.0, 30.0), k = rnd.log_uniform(1.0, 1e5);
    const double p = rnd.log_uniform(1e-10, 10.0);
    const double r = A * rnd.log_uniform(1e-6, 1.0) * (rnd.coin() ? 1.0 : -1.0);
    const double u = repelled_gap(r, A, p, k), pushed = p * std::exp(-k * u);
    // u is known to a rounding of itself and of 1/k
    const double rounding = std::fabs(r) / A + 1.0 / k;
    EXPECT_NEAR(A * u, r + pushed, 1e-12 * (A + k * pushed) * rounding);
    EXPECT_GT(u, r / A - 1e-14 * std::fabs(r));
  }
}

TEST(RepelledGap, WithoutRepulsionIsTheGapWithoutItBitForBit)
{
  Random rnd(5);
  for (int trial = 0; trial < 10000; trial++) {
    const double A = rnd.uniform(1.0, 30.0), r = rnd.log_uniform(1e-6, 1.0);
    EXPECT_EQ(repelled_gap(r, A, 0.0, rnd.log_uniform(1.0, 1e5)), r / A);
  }
}
