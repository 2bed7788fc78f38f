// Drag, and the motion that it gives in velocity Verlet and without inertia.

#include "fluid_drag.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace LAMMPS_NS::Fluid_NS;

namespace {

TEST(Drag, OfASphereIsStokes)
{
  const Drag d = drag(Shape::SPHERE, 0.25, 3.0);
  EXPECT_NEAR(d.translation, 14.13716694115407, 1e-12);    // 4.5 pi
  EXPECT_NEAR(d.rotation, 169.6460032938488, 1e-12);       // 54 pi
}

TEST(Drag, OfADiscIsThatOfASphereOverTheDiameter)
{
  for (double radius : {0.25, 0.5, 0.75}) {
    const Drag sphere = drag(Shape::SPHERE, 1.7, radius), disc = drag(Shape::DISC, 1.7, radius);
    EXPECT_NEAR(disc.translation, sphere.translation / (2.0 * radius), 1e-13);
    EXPECT_NEAR(disc.rotation, sphere.rotation / (2.0 * radius), 1e-13);
  }
}

TEST(Drag, TheStressletGivesEinsteinsViscosity)
{
  // n spheres in a volume: a stress of -n S over 2 E is a viscosity of 2.5 phi eta
  const double n = 7.0, volume = 1000.0, radius = 1.3, eta = 0.6;
  const double phi = n * 9.2027720799157 / volume;    // 4/3 pi 1.3^3
  EXPECT_NEAR(-n * straining(eta, radius) / volume / 2.0, 2.5 * phi * eta, 1e-13);
}

TEST(Drag, OneStepIsThatOfVelocityVerlet)
{
  // a step from the half step before it, and from the full step, which is the mean of both
  const double mass = 0.3, c = 2.0, dt = 0.4;
  const Vec3 force{1.0, -2.0, 0.5}, v{0.2, 0.7, -0.4}, fluid{-1.0, 0.3, 0.1};
  const DragStep step = drag_step(false, dt, mass, c, force, v, fluid);
  const double decay = std::exp(-c * dt / mass);
  const Vec3 end = fluid + (1.0 / c) * force;
  const Vec3 next = end + decay * (v - end);
  EXPECT_NEAR(norm(v + (dt / mass) * step.force - next), 0.0, 1e-14);
  EXPECT_NEAR(norm(step.v_full - 0.5 * (v + next)), 0.0, 1e-14);
  const DragStep same = drag_step(true, dt, mass, c, force, step.v_full, fluid);
  EXPECT_NEAR(norm(same.force - step.force), 0.0, 1e-13);
  EXPECT_NEAR(norm(same.v_full - step.v_full), 0.0, 0.0);
}

// velocity Verlet as fix nve/sphere does it, in one dimension, under a force that depends on x
struct Particle {
  double x = 0.0, v = 0.0, f = 0.0;
  double mass = 0.3, coefficient = 0.0, v_fluid = 0.0, dt = 0.1;

  double ratio() const { return coefficient * dt / mass; }
  void feel(double mean, double force)
  {
    f = damped(mean, coefficient, {force, 0.0, 0.0}, {v, 0.0, 0.0}, {v_fluid, 0.0, 0.0}).x;
  }
  template <class F> void set_up(F force) { feel(mean_drag_full(ratio()), force(x)); }
  template <class F> void step(F force)
  {
    v += 0.5 * dt / mass * f;
    x += dt * v;
    feel(mean_drag(ratio()), force(x));
    v += 0.5 * dt / mass * f;
  }
};

TEST(DragInVerlet, VelocityRelaxesExactlyAtAnyStep)
{
  const auto none = [](double) {
    return 0.0;
  };
  for (double x : {1e-9, 1e-3, 0.1, 1.0, 3.0, 20.0}) {
    Particle p;
    p.v = 2.0;
    p.v_fluid = -0.5;
    p.coefficient = x * p.mass / p.dt;
    p.set_up(none);
    for (int n = 1; n <= 20; n++) {
      p.step(none);
      EXPECT_NEAR(p.v, -0.5 + 2.5 * std::exp(-n * x), 1e-13) << x;
    }
  }
}

TEST(DragInVerlet, TerminalVelocityIsExactUpToAnyStrengthOfTheDrag)
{
  const double weight = 0.7;
  const auto constant = [=](double) {
    return weight;
  };
  for (double x : {0.5, 1.0, 50.0, 1e4, 1e8}) {
    Particle p;
    p.v_fluid = 0.2;
    p.coefficient = x * p.mass / p.dt;
    p.set_up(constant);
    for (int n = 0; n < 200; n++) p.step(constant);
    EXPECT_NEAR(p.v, 0.2 + weight / p.coefficient, 1e-14) << x;
    const double from = p.x;
    p.step(constant);
    EXPECT_NEAR(p.x - from, p.dt * (0.2 + weight / p.coefficient), 1e-13) << x;
  }
}

TEST(DragInVerlet, ARestartFromTheVelocityOfTheFullStepGoesOnAsBefore)
{
  const auto spring = [](double x) {
    return -x;
  };
  for (double x : {1e-3, 0.3, 2.0, 12.0}) {
    Particle p;
    p.x = 1.0;
    p.coefficient = x * p.mass / p.dt;
    p.set_up(spring);
    for (int n = 0; n < 10; n++) p.step(spring);
    Particle q = p;
    q.f = 0.0;
    q.set_up(spring);
    for (int n = 0; n < 10; n++) {
      p.step(spring);
      q.step(spring);
      EXPECT_NEAR(q.x, p.x, 1e-11) << x;
    }
  }
}

// damped oscillator, exact: x = exp(-b t) (cos w t + b/w sin w t)
TEST(DragInVerlet, IsOfSecondOrder)
{
  double error[2];
  for (int fine : {0, 1}) {
    Particle p;
    p.mass = 1.0;
    p.coefficient = 0.8;
    p.dt = fine ? 0.01 : 0.02;
    p.x = 1.0;
    const auto spring = [](double x) {
      return -4.0 * x;
    };
    p.set_up(spring);
    for (int n = 0; n < (fine ? 300 : 150); n++) p.step(spring);
    const double b = 0.4, w = std::sqrt(4.0 - b * b), t = 3.0;
    error[fine] = std::fabs(p.x - std::exp(-b * t) * (std::cos(w * t) + b / w * std::sin(w * t)));
  }
  EXPECT_NEAR(error[0] / error[1], 4.0, 0.05);
}

TEST(DragInVerlet, IsStableUpToTheLimitOfTheSpringWhateverTheDrag)
{
  for (double x : {1e-6, 0.1, 0.5, 1.0, 2.0, 5.0, 30.0, 1e4, 1e8}) {
    Particle p;
    p.x = 1.0;
    p.coefficient = x * p.mass / p.dt;
    const double k = 0.999 * 4.0 * p.mass / (p.dt * p.dt);
    const auto spring = [=](double at) {
      return -k * at;
    };
    p.set_up(spring);
    for (int n = 0; n < 3000; n++) p.step(spring);
    EXPECT_LT(std::fabs(p.x), 50.0) << x;
  }
}

TEST(DragInVerlet, MeansAreExactOnBothSidesOfTheBorderOfTheirSeries)
{
  // next terms: x^2/6 - x^3/24, and -x^2/12 + x^4/120
  for (const double x : {1e-12, 9e-9, 9.99e-9, 1.001e-8, 2e-8, 9e-8, 1e-6, 1e-4}) {
    const long double y = x;
    const long double mean = 1.0L - y / 2.0L + y * y / 6.0L - y * y * y / 24.0L;
    EXPECT_NEAR(mean_drag(x), static_cast<double>(mean), 2.3e-16) << x;
    const long double full = 1.0L - y * y / 12.0L;
    EXPECT_NEAR(mean_drag_full(x), static_cast<double>(full), 2.3e-16) << x;
  }
}

// two particles on a spring, Euler steps: relative displacement d
double after(double dt, double stiffness, double coefficient)
{
  double d = 1.0;
  for (int n = 0; n < 2000; n++) {
    const Vec3 v = overdamped(coefficient, {-stiffness * d, 0.0, 0.0}, {});
    d += dt * (v.x - (-v.x));
  }
  return std::fabs(d);
}

TEST(Overdamped, MovesWithTheFluidAndTheForceOverTheDrag)
{
  const Vec3 v = overdamped(4.0, {2.0, -4.0, 8.0}, {1.0, 0.0, -1.0});
  EXPECT_DOUBLE_EQ(v.x, 1.5);
  EXPECT_DOUBLE_EQ(v.y, -1.0);
  EXPECT_DOUBLE_EQ(v.z, 1.0);
}

TEST(Overdamped, StepLimitIsThatOfAPair)
{
  const double k = 50.0, c = 3.0, limit = overdamped_step_limit(k, c);
  EXPECT_LT(after(0.99 * limit, k, c), 1e-8);
  EXPECT_GT(after(1.01 * limit, k, c), 1e8);
}

// sliding of equal particles on a tangential spring q' = 2 v + 2 R w, force -kt q on i
TEST(Overdamped, SlidingWeighsTheSpinOfBothShapes)
{
  for (Shape shape : {Shape::SPHERE, Shape::DISC}) {
    const double R = 0.6, kt = 2.0;
    const Drag d = drag(shape, 0.3, R);
    const double rate = 2.0 * kt / d.translation + 2.0 * R * R * kt / d.rotation;
    EXPECT_NEAR(rate, 2.0 / overdamped_step_limit((1.0 + SPIN_OF_DRAG) * kt, d.translation), 1e-12);
  }
}

TEST(Drag, MeanHindrance)
{
  EXPECT_EQ(mean_hindrance(0.0), 1.0);
  EXPECT_NEAR(mean_hindrance(0.6), 2.5, 1e-15);
}

}    // namespace
