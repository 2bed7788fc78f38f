// Forces of the far field between two solutions.

#include "hydro_hold.h"
#include "tools.h"

using namespace LAMMPS_NS::Hydro_NS;
using testing_tools::expect_near;
using testing_tools::PI_;
using testing_tools::Random;

namespace {

TEST(HydroHold, DragTowardsTheTargetIsTheHeldForce)
{
  Random rnd(51);
  for (int trial = 0; trial < 10; trial++) {
    const double a = rnd.uniform(0.3, 2.0), eta = rnd.uniform(0.1, 3.0);
    const Hold hold = default_hold(rnd.uniform(0.0, 0.6));
    const auto drag = held_drag(hold, eta, a);
    EXPECT_NEAR(drag.translation, hold.translation * 6.0 * PI_ * eta * a, 1e-12);
    EXPECT_NEAR(drag.rotation, hold.rotation * 8.0 * PI_ * eta * a * a * a, 1e-12);
    const Vec3 flow = rnd.vector(1.0), kept = rnd.vector(1.0), load = rnd.vector(9.0);
    const Vec3 v = rnd.vector(1.0);
    const Vec3 target = held_target(drag.translation, flow, kept, load);
    // on the fluid: F = F_k + Z (v - flow - v_k)
    expect_near(drag.translation * (v - target), load + drag.translation * (v - flow - kept),
                1e-10);
    // at the velocity of the solution it is that of the solution, whatever Z is
    expect_near(drag.translation * (flow + kept - target), load, 1e-10);
  }
}

TEST(HydroHold, NoMoreThanTheSphereItselfWithoutOthers)
{
  EXPECT_EQ(default_hold(0.0).translation, 1.0);
  EXPECT_EQ(default_hold(0.0).rotation, 2.0);
  EXPECT_GT(2.0 * default_hold(0.3).translation, 15.0);
  EXPECT_GT(2.0 * default_hold(0.5).translation, 31.0);
}

// A mode of resistance lambda, in terms of the drag, under a constant force: in slow motion v obeys
// the held force at once, and each solution starts from it. The error is multiplied by
// 1 - lambda/Z: it decays below lambda = 2 Z, and grows above.
TEST(HydroHold, SolutionsConverge)
{
  const double eta = 1.3, a = 0.7, phi = 0.4, force = 2.0;
  const double stokes = 6.0 * PI_ * eta * a;
  const auto drag = held_drag(default_hold(phi), eta, a);
  const double z = drag.translation / stokes;
  for (const double lambda : {0.35, 1.0, 5.0, 20.0, 1.9 * z, 2.1 * z}) {
    double v = 0.0;
    const double exact = force / (lambda * stokes);
    for (int k = 0; k < 400; k++) {
      const double load = lambda * stokes * v;    // the solution for this velocity
      const double target = held_target(drag.translation, {}, {v, 0.0, 0.0}, {load, 0.0, 0.0}).x;
      v = target + force / drag.translation;    // balance of the force and the drag
    }
    if (lambda < 2.0 * z)
      EXPECT_NEAR(v, exact, 1e-3 * exact) << lambda;
    else
      EXPECT_GT(std::fabs(v - exact), 100.0 * exact);
  }
}

}    // namespace
