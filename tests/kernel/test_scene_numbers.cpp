#include "scene_numbers.h"

#include <gtest/gtest.h>

using LAMMPS_NS::Scene_NS::known;
using LAMMPS_NS::Scene_NS::Numbers;
using LAMMPS_NS::Scene_NS::Scene;

// corn-starch sized glass beads in water, SI: a = 50 um, rho = 2500, eta = 1e-3, rate 10, P = 1
static Scene beads()
{
  Scene s;
  s.phi = 0.5;
  s.radius = 5e-5;
  s.density = 2500.0;
  s.viscosity = 1e-3;
  s.rate = 10.0;
  s.pressure = 1.0;
  s.g = 0.5;
  s.roughness = 0.01;
  s.friction = 0.5;
  s.thermal = 1.380649e-23 * 300.0;
  s.fluid_density = 1000.0;
  s.dt = 1e-6;
  s.dt_limit = 4e-6;
  s.box = 1e-3;
  s.adhesion = 1e-8;
  s.repulsion = 2e-9;
  s.critical = 2.5e-9;
  return s;
}

TEST(SceneNumbers, OfBeadsInWater)
{
  const Numbers n = LAMMPS_NS::Scene_NS::numbers(beads());
  EXPECT_NEAR(n.St, 0.0625, 1e-12);
  EXPECT_NEAR(n.Re, 0.025, 1e-12);
  EXPECT_NEAR(n.Iv, 0.01, 1e-14);
  EXPECT_NEAR(n.I, 0.05, 1e-12);
  EXPECT_NEAR(n.K, 0.01025, 1e-12);
  EXPECT_NEAR(n.Ca, 1e-6, 1e-18);
  EXPECT_NEAR(n.stiffness, 1e4, 1e-8);
  EXPECT_NEAR(n.crushing, 100.0, 1e-10);
  EXPECT_NEAR(n.Pe, 5.688e6, 1e3);
  EXPECT_NEAR(n.step, 0.25, 1e-14);
  EXPECT_NEAR(n.box, 10.0, 1e-12);
  EXPECT_NEAR(n.adhesion, 1.0, 1e-12);
  EXPECT_NEAR(n.repulsion, 0.2, 1e-12);
  EXPECT_NEAR(n.critical, 1.0, 1e-12);
  EXPECT_NEAR(n.phi_jam, 0.5737, 1e-3);
  EXPECT_FALSE(n.estimated);
}

TEST(SceneNumbers, DrainageOfALayer)
{
  Scene s = beads();
  EXPECT_FALSE(known(LAMMPS_NS::Scene_NS::numbers(s).Pi));
  s.height = 1e-3;
  // k = 2 a^2/(9 phi K), K = 10 phi/(1-phi)^3 + (1-phi)(1 + 1.5 sqrt phi) = 41.030330
  EXPECT_NEAR(LAMMPS_NS::Scene_NS::numbers(s).Pi, 0.01 * 1e-6 / (2 * 2.5e-9 / (4.5 * 41.030330)),
              1e-4);
}

TEST(SceneNumbers, InertiaOverViscosityIsTheStokesNumberOfTheDiameter)
{
  const Numbers n = LAMMPS_NS::Scene_NS::numbers(beads());
  EXPECT_NEAR(n.I * n.I / n.Iv, 4.0 * n.St, 1e-12);
  EXPECT_NEAR(n.Ca * n.stiffness, n.Iv, 1e-14);
}

TEST(SceneNumbers, DoNotDependOnTheSignOfTheRate)
{
  Scene s = beads();
  s.rate = -s.rate;
  const Numbers n = LAMMPS_NS::Scene_NS::numbers(s);
  EXPECT_NEAR(n.Iv, 0.01, 1e-14);
  EXPECT_NEAR(n.St, 0.0625, 1e-12);
}

TEST(SceneNumbers, UnknownInputGivesUnknownNumbers)
{
  Scene s = beads();
  s.rate = s.thermal = s.fluid_density = s.dt_limit = LAMMPS_NS::Scene_NS::UNKNOWN;
  const Numbers n = LAMMPS_NS::Scene_NS::numbers(s);
  EXPECT_FALSE(known(n.St) || known(n.Iv) || known(n.I) || known(n.Pe) || known(n.Re));
  EXPECT_FALSE(known(n.step));
  EXPECT_TRUE(known(n.stiffness));    // the pressure is given
  EXPECT_EQ(LAMMPS_NS::Scene_NS::show(n.St), "?");
}

// phi = phi_m/(1 + sqrt(Iv)): at Iv = 0.01 of friction 0.5, 0.5737/1.1 = 0.5216
TEST(SceneNumbers, PressureIsEstimatedFromTheVolumeFraction)
{
  Scene s = beads();
  s.pressure = LAMMPS_NS::Scene_NS::UNKNOWN;
  s.phi = LAMMPS_NS::Scene_NS::jamming_fraction(0.5) / 1.1;
  const Numbers n = LAMMPS_NS::Scene_NS::numbers(s);
  EXPECT_TRUE(n.estimated);
  EXPECT_NEAR(n.Iv, 0.01, 1e-12);
  EXPECT_NEAR(n.pressure, 1.0, 1e-10);
  s.phi = 0.6;    // jammed
  EXPECT_FALSE(known(LAMMPS_NS::Scene_NS::numbers(s).pressure));
  s.phi = 0.4;
  s.dimension = 2.0;    // no such law
  EXPECT_FALSE(known(LAMMPS_NS::Scene_NS::numbers(s).pressure));
}

TEST(SceneNumbers, DryGrainsHaveNoStokesNumber)
{
  Scene s = beads();
  s.viscosity = 0.0;
  const Numbers n = LAMMPS_NS::Scene_NS::numbers(s);
  EXPECT_FALSE(known(n.St) || known(n.Re));
  EXPECT_EQ(n.Iv, 0.0);
  EXPECT_NEAR(n.K, 0.1 * n.I * n.I, 1e-15);
}

// printed values of the law: 0.6301 without friction, 0.574 at 0.5, 0.5507 at infinity
TEST(SceneNumbers, FrictionMovesJamming)
{
  EXPECT_NEAR(LAMMPS_NS::Scene_NS::jamming_fraction(0.0), 0.6301, 1e-12);
  EXPECT_NEAR(LAMMPS_NS::Scene_NS::jamming_fraction(0.5), 0.574, 5e-4);
  EXPECT_NEAR(LAMMPS_NS::Scene_NS::jamming_fraction(1e9), 0.5507, 1e-12);
}

// measured in examples/shear_rate at phi 0.5: 34 with friction 0.5, 11 without
TEST(SceneNumbers, GainOfFriction)
{
  EXPECT_NEAR(LAMMPS_NS::Scene_NS::friction_gain(0.5, 0.5), 1.58, 0.05);
  EXPECT_NEAR(LAMMPS_NS::Scene_NS::friction_gain(0.5, 0.0), 0.0, 1e-14);
  EXPECT_LT(LAMMPS_NS::Scene_NS::friction_gain(0.05, 0.5), 0.05);
  EXPECT_TRUE(std::isinf(LAMMPS_NS::Scene_NS::friction_gain(0.6, 0.5)));
}

// to the digits of the laws: 0.6301 - 0.0794 (1 - 1/e), and 6 pi eta a^3 rate/kT
TEST(SceneNumbers, CoefficientsOfTheLaws)
{
  EXPECT_NEAR(LAMMPS_NS::Scene_NS::jamming_fraction(0.4032), 0.57990962762900, 1e-12);
  const double kT = 1.380649e-23 * 300.0;
  EXPECT_NEAR(LAMMPS_NS::Scene_NS::numbers(beads()).Pe * kT / (1e-2 * 1.25e-13), 18.849555921538759,
              1e-12);
}

TEST(SceneNumbers, NothingIsEstimatedAtTheBorders)
{
  EXPECT_FALSE(known(LAMMPS_NS::Scene_NS::viscous_number(0.55, 0.55)));
  EXPECT_TRUE(known(LAMMPS_NS::Scene_NS::viscous_number(0.55, 0.5500001)));
  Scene s = beads();
  s.pressure = 0.0;
  EXPECT_FALSE(known(LAMMPS_NS::Scene_NS::numbers(s).Iv));
}
