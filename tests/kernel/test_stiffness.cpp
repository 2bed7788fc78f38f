// Shows that the bound of the time step holds for pairs of any sizes, and is reached by equal ones.

#include "lubcontact_stiffness.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

// Springs of a pair in one tangential direction, kt = 1: coordinates x_i, x_j, angles of i and j.
struct Springs {
  double slip[4], roll[4];
};

Springs springs_of(const PairGeometry &p)
{
  return {{1.0, -1.0, -p.arm_i, -p.arm_j}, {0.0, 0.0, p.a, -p.a}};
}

// Largest squared frequency of the springs on these inertias, by the power method.
double largest(const Springs &s, const double (&inertia)[4])
{
  double q[4] = {1.0, -0.7, 0.3, 0.9}, rate = 0.0;
  for (int n = 0; n < 400; n++) {
    double slip = 0.0, roll = 0.0, size = 0.0, old = 0.0;
    for (int m = 0; m < 4; m++) {
      slip += s.slip[m] * q[m];
      roll += s.roll[m] * q[m];
      old += inertia[m] * q[m] * q[m];
    }
    for (int m = 0; m < 4; m++) q[m] = (slip * s.slip[m] + roll * s.roll[m]) / inertia[m];
    for (int m = 0; m < 4; m++) size += inertia[m] * q[m] * q[m];
    rate = std::sqrt(size / old);
    for (int m = 0; m < 4; m++) q[m] /= std::sqrt(size);
  }
  return rate;
}

double bound(const PairStiffness &k, double mi, double mj)
{
  return 2.0 * std::fmax(k.i / mi, k.j / mj);
}

}    // namespace

TEST(Stiffness, OfEqualSpheresInTouchIsThatOfSlidingAndSpinning)
{
  const PairGeometry p = pair_geometry({2.0, 0, 0}, {}, 1.0, 1.0, 1.0);
  for (const bool films : {false, true}) {
    const PairStiffness k = pair_stiffness(1.0, 2.0, SPIN_OF_INERTIA, p, 1.0, 1.0, films, films);
    EXPECT_NEAR(k.i, 7.0, 1e-12);
    EXPECT_NEAR(k.j, 7.0, 1e-12);
    EXPECT_NEAR(pair_stiffness(1.0, 2.0, 0.75, p, 1.0, 1.0, films, films).i, 3.5, 1e-12);
  }
  EXPECT_EQ(pair_stiffness(9.0, 2.0, SPIN_OF_INERTIA, p, 1.0, 1.0, true, true).i, 9.0);
  EXPECT_NEAR(largest(springs_of(p), {1.0, 1.0, 0.4, 0.4}), 7.0, 1e-9);
}

TEST(Stiffness, BoundsTheFrequencyOfAnyPairAndNotByMuch)
{
  Random rnd(1);
  double loosest = 0.0;
  for (int trial = 0; trial < 3000; trial++) {
    const double ri = 1.0, rj = rnd.log_uniform(1.0, 50.0), gap = rnd.uniform(-0.3, 1.0);
    const Radius rule = rnd.coin() ? Radius::MEAN : Radius::HARMONIC;
    const double a = effective_radius(rule, ri, rj);
    const PairGeometry p = pair_geometry({ri + rj + gap, 0, 0}, {}, ri, rj, a);
    const double mi = rnd.log_uniform(0.1, 10.0), mj = rj * rj * rj * rnd.log_uniform(0.1, 10.0);
    const double Ji = 0.4 * mi * ri * ri, Jj = 0.4 * mj * rj * rj;

    const PairStiffness all = pair_stiffness(0.0, 1.0, SPIN_OF_INERTIA, p, ri, rj, true, true);
    const double tangential = largest(springs_of(p), {mi, mj, Ji, Jj});
    const double twisting = a * a * (1.0 / Ji + 1.0 / Jj);
    const double most = std::fmax(tangential, twisting);
    ASSERT_GE(bound(all, mi, mj), most * (1.0 - 1e-9)) << rj << " gap " << gap << " mass " << mi;
    loosest = std::fmax(loosest, bound(all, mi, mj) / most);

    // without the rolling and twisting films there is sliding only
    Springs sliding = springs_of(p);
    for (double &r : sliding.roll) r = 0.0;
    const PairStiffness bare = pair_stiffness(0.0, 1.0, SPIN_OF_INERTIA, p, ri, rj, false, false);
    const double slides = largest(sliding, {mi, mj, Ji, Jj});
    ASSERT_GE(bound(bare, mi, mj), slides * (1.0 - 1e-9));
    // and with the twisting film alone sliding and twisting
    const PairStiffness spun = pair_stiffness(0.0, 1.0, SPIN_OF_INERTIA, p, ri, rj, false, true);
    ASSERT_GE(bound(spun, mi, mj), std::fmax(slides, twisting) * (1.0 - 1e-9));
  }
  // a heavy partner moves half as much as the bound allows
  EXPECT_LT(loosest, 2.5);
}

TEST(Stiffness, OfTheSphereThatSpinsMoreEasilyIsThatOfASphereOfItsOwn)
{
  // without rolling and twisting sliding and spinning balance at t = 1/q: k = kt (1 + q)
  for (const double gap : {0.0, 0.3})
    for (const double rj : {2.0, 50.0}) {
      const double a = effective_radius(Radius::HARMONIC, 1.0, rj);
      const PairGeometry p = pair_geometry({1.0 + rj + gap, 0, 0}, {}, 1.0, rj, a);
      const PairGeometry o = pair_geometry({1.0 + rj + gap, 0, 0}, {}, rj, 1.0, a);
      const double q = 2.5 * (1.0 + 0.5 * gap) * (1.0 + 0.5 * gap);
      EXPECT_NEAR(pair_stiffness(0.0, 3.0, 2.5, p, 1.0, rj, false, false).i, 3.0 * (1.0 + q),
                  1e-12);
      EXPECT_NEAR(pair_stiffness(0.0, 3.0, 2.5, o, rj, 1.0, false, false).j, 3.0 * (1.0 + q),
                  1e-12);
      // beside a large sphere twisting is stiffer: q (b^2 + b_i b_j)/2
      const double bi = a / p.arm_i, bj = a / p.arm_j;
      const double twisting = 0.5 * q * (bi * bi + bi * bj);
      EXPECT_NEAR(pair_stiffness(0.0, 3.0, 2.5, p, 1.0, rj, false, true).i,
                  3.0 * std::fmax(1.0 + q, twisting), 1e-12);
    }
}

TEST(Stiffness, OfResidualFilmsIsThatOfTheirArms)
{
  Random rnd(3);
  for (int trial = 0; trial < 1000; trial++) {
    const double rj = rnd.log_uniform(0.25, 4.0), a = effective_radius(Radius::HARMONIC, 1.0, rj);
    const double gap = a * rnd.uniform(-0.02, 1.0);
    const PairGeometry p = pair_geometry({1.0 + rj + gap, 0, 0}, {}, 1.0, rj, a);
    const PairGeometry off = with_lever(p);
    EXPECT_NEAR(off.arm_i + off.arm_j, p.r, 1e-14 * p.r);
    const double u_a = std::fmax(1e-6, p.un_a), delta = size_difference(p);
    const TangentialResidual t =
        tangential_residual(1.0, a, delta, residual_place(u_a, std::log(u_a), delta));
    EXPECT_NEAR(p.arm_i - off.arm_i, t.lever, 1e-13);
    const PairStiffness k =
        larger_stiffness(pair_stiffness(0.0, 1.0, SPIN_OF_INERTIA, p, 1.0, rj, true, true),
                         pair_stiffness(0.0, 1.0, SPIN_OF_INERTIA, off, 1.0, rj, true, true));
    const double mj = rj * rj * rj;
    for (const PairGeometry &arms : {p, off})
      EXPECT_GE(bound(k, 1.0, mj),
                largest(springs_of(arms), {1.0, mj, 0.4, 0.4 * mj * rj * rj}) * (1.0 - 1e-9));
  }
}
