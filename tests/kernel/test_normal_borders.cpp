// Both sides of every border of the normal mode: dry or not, the end of a shifted range, small or
// large changes of the repulsion.

#include "lubcontact_normal.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

NormalCoeffs make_coeffs(double g, double k, double eps)
{
  return {g, k, {k / g, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, false}};
}

}    // namespace

TEST(IsDry, WhereTheFilmRestsWithinATrillionthOfTheStep)
{
  const NormalCoeffs c = make_coeffs(50.0, 50.0, 0.01);
  const double a = 2.0, dt = 0.1, border = dt * 50.0 / (1e12 * a);
  EXPECT_FALSE(is_dry(c, make_film(1.001 * border, 2.0, Range::CUT, 0.6), a, dt));
  EXPECT_TRUE(is_dry(c, make_film(0.999 * border, 2.0, Range::CUT, 0.6), a, dt));
  // just above it the step ends where a dry one does
  for (const double un : {0.3, 0.005, -0.005}) {
    const Film film = make_film(1.001 * border, 2.0, Range::CUT, 0.6);
    const Gap wet = next_gap(c, film, a, {0.02, std::log(0.02)}, un, un, dt);
    EXPECT_NEAR(wet.u_a, elastic_gap_a(c.gap, un), 1e-12) << un;
  }
}

TEST(FilmSteps, ResistanceOfAShiftedRangeEndsAtAMillionth)
{
  const NormalCoeffs c = make_coeffs(50.0, 50.0, 0.0);
  const Film f = make_film(2.0, 0.5, Range::SHIFTED, 0.6);
  const double h = 0.01 * 50.0 / (PI_ * 9.0);
  const struct {
    double u, left;
  } cases[] = {{0.25, 0.5},          {0.5 - 1e-6, 2e-6}, {0.5 - 5.05e-7, 1.01e-6},
               {0.5 - 4.9e-7, 1e-6}, {0.5, 1e-6},        {0.75, 1e-6}};
  for (const auto &k : cases) {    // at rest the gap at mid-step is that of now
    const double steps = film_steps(c, f, 3.0, {k.u, std::log(k.u)}, k.u, k.u, 0.01);
    EXPECT_NEAR(steps * k.left / h, 1.0, 1e-9) << k.u;
  }
}

TEST(FilmSteps, GapAtMidStepIsThatOfAnImplicitHalfStep)
{
  // u1 = u + half (u max(0, r) - u1 (A u + max(0, -r))), half of the step over 1 - u/range
  const Film f = make_film(2.0, 0.5, Range::SHIFTED, 0.6);
  for (const double eps : {0.0, 0.3})
    for (const double un : {-0.2, 0.1, 0.45}) {
      const NormalCoeffs c = make_coeffs(50.0, 100.0, eps);
      const double u = 0.2, h = 0.7 * 50.0 / (PI_ * 9.0), half = 0.5 * h / (1.0 - 0.4);
      const double A = eps > 0.0 ? 3.0 : 1.0, r = un + (eps > 0.0 ? 0.6 : 0.0);
      const double loss = A * u + std::fmax(0.0, -r), gain = std::fmax(0.0, r);
      const double u1 = u * (1.0 + half * gain) / (1.0 + half * loss);
      const double steps = film_steps(c, f, 3.0, {u, std::log(u)}, un - 0.01, un + 0.01, 0.7);
      EXPECT_NEAR(steps, h / (1.0 - u1 / 0.5), 1e-12 * steps) << eps << " " << un;
    }
}

TEST(Repulsion, ChangesLittleWithinAQuarterOfItsLength)
{
  NormalCoeffs c = make_coeffs(50.0, 50.0, 0.01);
  EXPECT_TRUE(is_small_change(c, 2.0, 0.1, 0.9));    // there is none
  c.repulsion = {3.0, 10.0};                         // length 0.1, a = 2
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(is_small_change(c, 2.0, 0.1, 0.1 + sign * 0.01249));
    EXPECT_FALSE(is_small_change(c, 2.0, 0.1, 0.1 + sign * 0.01251));
  }
}

TEST(Repulsion, ALongStepIsTakenInPiecesOfSmallChanges)
{
  // onto a repulsion whose length is a hundredth of the way; oracle: dy/dt = un + p exp(-k u) - u
  // by the rule of Runge and Kutta
  NormalCoeffs c = make_coeffs(1000.0, 1000.0, 0.0);
  c.repulsion = {20.0, 1000.0};
  const double viscosity = 1.0, dt = 0.5, speed = 0.3, p = 0.02, k = 1000.0;
  const double tau = 1.5 * PI_ * viscosity / 1000.0, h = dt / tau;
  const int steps = 100000;
  auto rate = [=](double t, double y) {
    const double u = std::exp(y);
    return h * (0.1 - speed * t + p * std::exp(-k * u) - u);
  };
  double y = std::log(0.1);
  for (int n = 0; n < steps; n++) {
    const double d = 1.0 / steps, t = n * d;
    const double k1 = rate(t, y), k2 = rate(t + 0.5 * d, y + 0.5 * d * k1);
    const double k3 = rate(t + 0.5 * d, y + 0.5 * d * k2), k4 = rate(t + d, y + d * k3);
    y += d / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  const Film f = make_film(viscosity, 2.0, Range::CUT, 0.6);
  const double end =
      next_gap<REPULSION>(c, f, 1.0, {0.1, std::log(0.1)}, 0.1, 0.1 - speed, dt).ln_u;
  EXPECT_NEAR(end, y, 3e-3);
}

TEST(ElasticContact, BeginsAtTheRoughnessAndEndsWhereItsLoadWouldPassTheRelease)
{
  NormalCoeffs c = make_coeffs(100.0, 300.0, 0.02);
  c.gap.release_a = 0.03;
  const double ends = 0.02 + 4.0 * 0.01, e = 1e-9;    // eps + (1 + alpha) delta
  for (const bool bond : {false, true}) {
    EXPECT_TRUE(elastic_contact<ADHESION>(c, 1.0, 0.02 - e, bond));
    EXPECT_EQ(elastic_contact<ADHESION>(c, 1.0, 0.02 + e, bond), bond);
    EXPECT_EQ(elastic_contact<ADHESION>(c, 1.0, ends - e, bond), bond);
    EXPECT_FALSE(elastic_contact<ADHESION>(c, 1.0, ends + e, bond));
  }
  EXPECT_TRUE(elastic_contact<0>(c, 1.0, 0.02 - e, false));
  EXPECT_FALSE(elastic_contact<0>(c, 1.0, 0.02, false));
  EXPECT_FALSE(elastic_contact<0>(make_coeffs(100.0, 300.0, 0.0), 1.0, -0.1, false));
  // repelled by F exp(-u/length)/(g a): the surfaces must be closer by as much
  c.repulsion = {0.5, 1.0 / 0.04};
  const double a = 2.0, at_eps = 0.5 * std::exp(-1.0) / 200.0,
               at_end = 0.5 * std::exp(-1.5) / 200.0;
  constexpr unsigned BOTH = ADHESION | REPULSION;
  EXPECT_TRUE(elastic_contact<REPULSION>(c, a, 0.02 - at_eps - e, false));
  EXPECT_FALSE(elastic_contact<REPULSION>(c, a, 0.02 - at_eps + e, false));
  EXPECT_TRUE(elastic_contact<BOTH>(c, a, ends - at_end - e, true));
  EXPECT_FALSE(elastic_contact<BOTH>(c, a, ends - at_end + e, true));
}

TEST(NormalForce, BelongsToTheAsperitiesBelowTheirHeightOnly)
{
  const NormalCoeffs c = make_coeffs(100.0, 50.0, 0.02);
  const double a = 2.0, e = 1e-9;
  EXPECT_NEAR(normal_force(c, a, 0.01, 0.04 - e, true).contact, 50.0 * e, 1e-14);
  EXPECT_EQ(normal_force(c, a, 0.01, 0.04 + e, true).contact, 0.0);
  // dry: un below the asperities, or an overlap of smooth surfaces
  EXPECT_NEAR(normal_force(c, a, 0.04 - e, 0.041, false).contact, 100.0 * (0.001 + e), 1e-12);
  EXPECT_EQ(normal_force(c, a, 0.04 + e, 0.041, false).contact, 0.0);
  const NormalCoeffs smooth = make_coeffs(100.0, 50.0, 0.0);
  EXPECT_GT(normal_force(smooth, a, -e, 2e-8, false).contact, 0.0);
  EXPECT_EQ(normal_force(smooth, a, e, 2e-8, false).contact, 0.0);
  // with extensions: crushed flat below the thinnest film of an overlap
  EXPECT_GT(normal_force<REPULSION>(smooth, a, -0.1, a * 1e-8, false).contact, 0.0);
  EXPECT_EQ(normal_force<REPULSION>(smooth, a, -0.1, a * 1.01e-8, false).contact, 0.0);
  EXPECT_EQ(normal_force<REPULSION>(smooth, a, 0.1, a * 1e-8, false).contact, 0.0);
}

TEST(NormalForce, AndEnergyOfAsperitiesThatDoNotHoldAreTheBulks)
{
  NormalCoeffs c = make_coeffs(100.0, 50.0, 0.02);
  const double a = 2.0, un = 0.01, u = 0.05, bulk = 0.5 * 100.0 * 0.04 * 0.04;
  const NormalForce open = normal_force<ADHESION>(c, a, un, u, true, false);
  EXPECT_EQ(open.contact, 0.0);
  EXPECT_NEAR(open.film, 4.0, 1e-14);
  EXPECT_EQ(open.repulsion, 0.0);
  EXPECT_EQ(normal_force<ADHESION>(c, a, un, u, false, false).film, 0.0);
  const NormalForce held = normal_force<ADHESION>(c, a, un, u, true, true);
  EXPECT_NEAR(held.contact, -0.5, 1e-14);    // k (eps a - u)
  EXPECT_NEAR(held.film, 4.5, 1e-14);
  EXPECT_NEAR(normal_energy<ADHESION>(c, a, un, u, false), bulk, 1e-16);
  EXPECT_NEAR(normal_energy<ADHESION>(c, a, un, u, true), bulk + 0.5 * 50.0 * 1e-4, 1e-16);
  EXPECT_NEAR(normal_energy(c, a, un, u), bulk, 1e-16);
  c.repulsion = {3.0, 20.0};
  EXPECT_NEAR(normal_energy<REPULSION>(c, a, un, u), bulk + 3.0 / 20.0 * std::exp(-1.0), 1e-15);
  EXPECT_NEAR(normal_force<REPULSION>(c, a, un, u, true).film, 4.0 - 3.0 * std::exp(-1.0), 1e-14);
  EXPECT_EQ(normal_force<REPULSION>(c, a, un, u, true).contact, 0.0);
}

TEST(ElasticGap, OfEveryExtensionBalancesItsSprings)
{
  // A u = un + alpha eps + p exp(-k u) if the asperities hold, else u = un + p exp(-k u)
  NormalCoeffs c = make_coeffs(100.0, 300.0, 0.02);
  const double a = 2.0;
  EXPECT_NEAR(elastic_gap_a<ADHESION>(c, a, 0.04, true), 0.025, 1e-16);
  EXPECT_EQ(elastic_gap_a<ADHESION>(c, a, 0.04, false), 0.04);
  for (const bool bond : {false, true})
    EXPECT_EQ(elastic_gap_a<ADHESION>(c, a, -0.1, bond), 1e-8) << "crushed";
  c.repulsion = {0.5, 25.0};
  const double p = 0.5 / 200.0, k = 50.0;
  for (const double un : {0.01, 0.0195, 0.04}) {
    const double free = elastic_gap_a<ADHESION | REPULSION>(c, a, un, false);
    const double held = elastic_gap_a<ADHESION | REPULSION>(c, a, un, true);
    EXPECT_NEAR(free, un + p * std::exp(-k * free), 1e-15);
    EXPECT_NEAR(4.0 * held, un + 0.06 + p * std::exp(-k * held), 1e-15);
    EXPECT_EQ(elastic_gap_a<REPULSION>(c, a, un, false), un < 0.0195 ? held : free) << un;
  }
}

TEST(Adhesion, TheBondDecidesNotTheGap)
{
  NormalCoeffs c = make_coeffs(50.0, 100.0, 0.02);
  c.gap.release_a = 0.03;
  c.gap.ln_release = std::log(0.03);
  const Film shifted = make_film(2.0, 0.5, Range::SHIFTED, 0.6);
  const double u = 0.025, h = 0.7 * 50.0 / (PI_ * 9.0), half = 0.5 * h / (1.0 - u / 0.5);
  for (const double bond : {0.0, 1.0}) {
    const double A = 1.0 + 2.0 * bond, r = 0.1 + 0.04 * bond;
    const double middle = u * (1.0 + half * r) / (1.0 + half * A * u);
    EXPECT_NEAR(film_steps<ADHESION>(c, shifted, 3.0, {u, std::log(u), bond}, 0.1, 0.1, 0.7),
                h / (1.0 - middle / 0.5), 1e-12);
    // dry: held up to eps + (1 + alpha) delta = 0.05
    const Film none = make_film(0.0, 2.0, Range::CUT, 0.6);
    const Gap held = next_gap<ADHESION>(c, none, 3.0, {u, std::log(u), bond}, 0.04, 0.04, 0.1);
    EXPECT_EQ(held.bond, bond);
    EXPECT_EQ(next_gap<ADHESION>(c, none, 3.0, held, 0.04, 0.051, 0.1).bond, 0.0);
    EXPECT_EQ(next_gap<ADHESION>(c, none, 3.0, held, 0.04, 0.019, 0.1).bond, 1.0);
  }
}
