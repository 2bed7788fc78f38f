// Permeability of arrays of spheres.

#include "pore_closure.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace LAMMPS_NS::Pore_NS;

namespace {

constexpr double DILUTE = 0.0;         // phi_min
constexpr double ROUNDING = 0.0051;    // of the table

TEST(PoreClosure, DragFunctionsAreThoseOfTheTable)
{
  // columns kozeny_carman and beetstra of the permeability table, phi .125 to .61
  const double table[][3] = {
      {0.125, 1.87, 3.20},    {0.216, 4.48, 5.81},    {0.343, 12.09, 13.33},   {0.45, 27.05, 28.15},
      {0.5236, 48.43, 49.42}, {0.61, 102.83, 103.68}, {0.6802, 207.97, 208.69}};
  for (const auto &row : table) {
    EXPECT_NEAR(drag_function(Closure::KOZENY, row[0]), row[1], ROUNDING) << row[0];
    EXPECT_NEAR(drag_function(Closure::BEETSTRA, row[0]), row[2], ROUNDING) << row[0];
  }
}

TEST(PoreClosure, KozenyIsTheFormWithTheConstant180)
{
  const Permeability law{Closure::KOZENY, 0.0, 1.0, DILUTE};
  for (double phi : {0.2, 0.45, 0.58, 0.64}) {
    const double d = 1.4, pores = 1.0 - phi;
    const double k = d * d * pores * pores * pores / (180.0 * phi * phi);
    EXPECT_NEAR(permeability(law, phi, 0.5 * d), k, 1e-14 * k);
  }
}

TEST(PoreClosure, SpheresFarApartHaveTheDragOfStokes)
{
  // force per volume phi/V 6 pi eta a U = eta U/k
  const Permeability law{Closure::BEETSTRA, 0.0, 1.0, DILUTE};
  const double phi = 1e-9, a = 0.7;
  const double k = 1.0 / (phi / (4.0 / 3.0 * a * a * a) * 6.0 * a);
  EXPECT_NEAR(permeability(law, phi, a) / k, 1.0, 1e-4);
}

TEST(PoreClosure, LimitsKeepItPositiveAndFinite)
{
  for (Closure closure : {Closure::BEETSTRA, Closure::KOZENY}) {
    const Permeability law{closure, 0.0, 1.0, 0.1};
    EXPECT_EQ(permeability(law, 0.0, 1.0), permeability(law, 0.1, 1.0));
    EXPECT_GT(permeability(law, 0.09, 1.0), permeability(law, 0.11, 1.0));
    EXPECT_EQ(permeability(law, 1.3, 1.0), permeability(law, PHI_MAX, 1.0));
    EXPECT_GT(permeability(law, 1.3, 1.0), 0.0);
  }
}

TEST(PoreClosure, FactorAndConstant)
{
  const Permeability constant{Closure::CONSTANT, 0.3, 100.0, 0.1};
  EXPECT_DOUBLE_EQ(permeability(constant, 0.5, 1.0), 30.0);
  EXPECT_DOUBLE_EQ(permeability(constant, 0.0, 0.0), 30.0);
  const Permeability law{Closure::BEETSTRA, 0.3, 100.0, 0.1}, one{Closure::BEETSTRA, 0.0, 1.0, 0.1};
  EXPECT_DOUBLE_EQ(permeability(law, 0.5, 1.0), 100.0 * permeability(one, 0.5, 1.0));
}

TEST(PoreClosure, RadiusOfAMixtureIsSauters)
{
  // one of radius 2, three of radius 1: 11/7
  EXPECT_NEAR(sauter_radius(4.0 / 3.0 * PI * 11.0, 7.0), 11.0 / 7.0, 1e-15);
  EXPECT_EQ(sauter_radius(0.0, 0.0), 0.0);
}

}    // namespace
