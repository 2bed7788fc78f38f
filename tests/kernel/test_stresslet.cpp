// Shows the stresslet of residual films at given forces; test_pair_residual.cpp has it along
// the way of a pair.

#include "lubcontact_stresslet.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

constexpr double ETA = 0.7;
const Strain STRAIN{0.3, 0.1, -0.4, 0.5, -0.2, 0.25};

Film make_residual(double eta, double reach_a, const Strain &strain)
{
  Film f = make_film(eta, reach_a, Range::RESIDUAL, 0.6);
  f.strain = strain;
  return f;
}

}    // namespace

TEST(Stresslet, IsThatOfTheFormAtTheRatesOfItsForces)
{
  const double ri = 0.6, rj = 1.2, a = effective_radius(Radius::HARMONIC, ri, rj);
  const PairGeometry g = pair_geometry((ri + rj + 0.4 * a) * Vec3{0.6, 0.0, 0.8}, {}, ri, rj, a);
  Film f = make_residual(ETA, 2.0, STRAIN);
  const PairStrain flow = pair_strain(STRAIN, g.n);
  const double delta = size_difference(g);
  const ResidualPlace p = residual_place(0.4, std::log(0.4), delta);
  // at the force F = 0 of each film the rates are part e, slide e_t, turn e_t: dPhi/dw = 0, ...
  const FlowResponse r = flow_response(f, g, 0.4, std::log(0.4), false);
  const double A = squeeze_coeff(ETA) * a / 0.4 * residual<RESIDUAL_SQUEEZE>(p);
  const double push = ETA * a * a * residual<RESIDUAL_PUSH>(p);
  EXPECT_NEAR(A * r.part, push, 1e-14);
  const double C = ETA * a * a * a * residual<RESIDUAL_STRETCH>(p);
  EXPECT_NEAR(r.stretch, C - push * push / A, 1e-14);
  // a rubbing contact keeps its place and all of the heat of slip
  const FlowResponse rubs = flow_response(f, g, 0.4, std::log(0.4), true);
  EXPECT_EQ(rubs.slide, 0.0);
  const TangentialResidual t = residual_films(f, a, delta, p);
  EXPECT_NEAR(rubs.extend - r.extend, t.shear * t.slide * t.slide, 1e-14);
  // sizes: e and e_t of the flow, traceless
  const FilmStresslet s = film_stresslet(r, STRAIN, g.n, 0.3, {0.8, 1.0, -0.6}, {0.0, 2.0, 0.0});
  EXPECT_NEAR(s.normal.xx + s.normal.yy + s.normal.zz, 0.0, 1e-15);
  EXPECT_NEAR(s.tangential.xx + s.tangential.yy + s.tangential.zz, 0.0, 1e-15);
  const Vec3 of_n = strained(s.normal, g.n);
  EXPECT_NEAR(dot(of_n, g.n), 2.0 / 3.0 * (r.part * 0.3 + r.stretch * flow.along), 1e-14);
}

// Without a film there is nothing of it, in the flow either.
TEST(Stresslet, HasNothingOfFilmsThatAreOff)
{
  const double ri = 0.6, rj = 1.2, a = effective_radius(Radius::HARMONIC, ri, rj);
  const PairGeometry g = pair_geometry({2.3, 0.0, 0.0}, {}, ri, rj, a);
  const Film all = make_residual(ETA, 2.0, STRAIN);
  const double delta = size_difference(g), u_a = 0.2, ln_u = std::log(u_a);
  const ResidualPlace p = residual_place(u_a, ln_u, delta);
  const TangentialResidual off =
      residual_films(without_films(all, false, false, false), a, delta, p);
  EXPECT_EQ(off.shear, 0.0);
  EXPECT_EQ(off.roll, 0.0);
  EXPECT_EQ(off.twist, 0.0);
  const TangentialResidual on = residual_films(without_films(all, true, true, true), a, delta, p);
  EXPECT_GT(on.shear, 0.0);
  EXPECT_GT(on.roll, 0.0);
  EXPECT_GT(on.twist, 0.0);
  EXPECT_EQ(flow_response(without_films(all, false, true, true), g, u_a, ln_u, false).extend, 0.0);
  EXPECT_NE(flow_response(all, g, u_a, ln_u, false).extend, 0.0);
}
