// Shows that a file of materials is read as written, that each error has its line, and how two mix.

#include "lubcontact_material_file.h"

#include <gtest/gtest.h>

using namespace LAMMPS_NS::Lubcontact_NS;

namespace {

const std::string GLASS = "# comment\nmaterial Glass\nmodulus 7e10\npoisson 0.25 # source\n";
constexpr UnitScale SI{1.0, 1.0, 1.0};

MaterialFile read(const std::string &text)
{
  return MaterialParser::parse(text);
}

void expect_error(const std::string &text, const std::string &message, int line)
{
  const MaterialFile file = read(text);
  EXPECT_EQ(file.error, message);
  EXPECT_EQ(file.line, line) << message;
}

std::string joined(const std::vector<Words> &all)
{
  std::string text;
  for (const auto &words : all)
    for (const auto &word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

}    // namespace

TEST(MaterialFile, PropertiesAreThoseWritten)
{
  const MaterialFile file = read(GLASS +
                                 "density 2500\nroughness 1e-7\nfriction coulomb 0.25\n\n"
                                 "material Oil\npoisson -0.5\nmodulus 1e3\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.names(), "Glass Oil");
  const Material *glass = file.find("Glass");
  EXPECT_EQ(glass->modulus, 7e10);
  EXPECT_EQ(glass->poisson, 0.25);
  EXPECT_EQ(glass->density, 2500.0);
  EXPECT_EQ(glass->surface.roughness, 1e-7);
  EXPECT_EQ(glass->surface.friction.mu, 0.25);
  EXPECT_EQ(file.find("Oil")->poisson, -0.5);
  EXPECT_LT(file.find("Oil")->surface.roughness, 0.0);
  EXPECT_EQ(file.find("oil"), nullptr);
}

TEST(MaterialFile, EachErrorHasItsLine)
{
  expect_error("", "there is no material", 0);
  expect_error("modulus 3\n", "expected material NAME, but found modulus", 1);
  expect_error("material Dry Ice\n", "expected one name: material NAME", 1);
  expect_error("material NULL\n", "NULL cannot be the name of a material", 1);
  expect_error(GLASS + "\nmaterial Glass\n", "material Glass is already in line 2", 6);
  expect_error("material A\npoisson 0.3\nmaterial B\n", "material A above has no modulus", 3);
  expect_error("material A\nmodulus 1\n", "material A above has no poisson", 2);
  expect_error("material A\nmodulus 7e\n", "modulus must be a number, but is 7e", 2);
  expect_error("material A\nmodulus inf\n", "modulus must be a number, but is inf", 2);
  expect_error("material A\nmodulus\n", "modulus needs a number", 2);
  expect_error("material A\nmodulus -1\n", "modulus must be > 0, but is -1", 2);
  expect_error(GLASS + "modulus 1\n", "modulus is there twice", 5);
  expect_error(GLASS + "poisson 0.1\n", "poisson is there twice", 5);
  expect_error("material A\npoisson 0.6\n", "poisson must be above -1 and at most 0.5, but is 0.6",
               2);
  expect_error(GLASS + "density 1 2\n", "unexpected 2 after density", 5);
  expect_error(GLASS + "hardness 5\n", "unknown property hardness", 5);
  expect_error(GLASS + "roughness -1\n", "roughness must be >= 0, but is -1", 5);
  expect_error(GLASS + "repulsion 1e-3\n", "repulsion needs a number", 5);
  expect_error(GLASS + "friction\n",
               "friction must be none, coulomb, clm or brizmer, but is missing", 5);
  expect_error(GLASS + "friction 0.3\n",
               "friction must be none, coulomb, clm or brizmer, but is 0.3", 5);
  expect_error(GLASS + "friction clm up 1 2\n",
               "friction clm must be step, shift or ramp, but is up", 5);
  expect_error(GLASS + "friction clm step 1\n", "critical load needs a number", 5);
  expect_error(GLASS + "friction none\nfriction none\n", "friction is there twice", 6);
}

TEST(MaterialFile, ErrorsOfPairsHaveTheirLineToo)
{
  const std::string two = GLASS + "material B\nmodulus 1\npoisson 0\n";
  expect_error(two + "pair Glass B\n", "expected pair NAME NAME and their special values", 8);
  expect_error(two + "pair Glass C friction none\n", "there is no material C above", 8);
  expect_error(two + "pair B B friction none\n", "pair needs two different materials", 8);
  expect_error(two + "pair Glass B modulus 3\n", "unknown property modulus", 8);
  expect_error(two + "pair Glass B friction none\npair B Glass friction none\n",
               "pair B Glass is there twice", 9);
  expect_error(two + "pair Glass B friction none\npair Glass B roughness 1\n",
               "pair Glass B is there twice", 9);
  const std::string three = two + "material C\nmodulus 1\npoisson 0\n";
  EXPECT_EQ(read(three + "pair Glass B roughness 1\npair Glass C roughness 1\n" +
                 "pair C B roughness 1\n")
                .error,
            "");
}

TEST(MaterialFile, LimitsOfPoissonsRatioAndOfZero)
{
  for (const std::string poisson : {"-0.999999", "0.5"})
    EXPECT_EQ(read("material A\nmodulus 1\npoisson " + poisson + "\n").error, "");
  for (const std::string poisson : {"-1", "-1.000001", "0.5000001"})
    expect_error("material A\npoisson " + poisson + "\n",
                 "poisson must be above -1 and at most 0.5, but is " + poisson, 2);
  expect_error(GLASS + "density 0\n", "density must be > 0, but is 0", 5);
  EXPECT_EQ(read(GLASS + "roughness 0\nadhesion 0\n").error, "");
  EXPECT_EQ(joined(surface_words(read(GLASS + "roughness 0\nadhesion 0\n").materials[0].surface,
                                 1.0, SI)),
            "roughness 0 adhesion 0");
}

TEST(MaterialFile, WordsAreThoseOfPairCoeffInUnitsOfLammps)
{
  const MaterialFile file = read(GLASS +
                                 "roughness 1e-6\nadhesion 2e-6\nrepulsion 8 2e-6\n"
                                 "friction clm shift 0.5 4e-9\n");
  const UnitScale unit{0x1p-50, 0x1p-20, 0x1p-20};    // near micro, and exact
  const Surface &s = file.materials[0].surface;
  Surface exact = s;
  exact.roughness = 0x1p-19;        // 2 lengths
  exact.adhesion = 0x1p-20;         // 1
  exact.screening = 0x1p-18;        // 4
  exact.friction.load = 0x1p-30;    // 1 force
  exact.repulsion = 0x1p-10;        // force/length
  EXPECT_EQ(joined(surface_words(exact, 4.0, unit)),
            "roughness 0.5 adhesion 0.25 repulsion 4 4 friction clm shift 0.5 1");
  EXPECT_EQ(s.screening, 2e-6);
  EXPECT_EQ(s.friction.load, 4e-9);
}

TEST(MaterialFile, FrictionBrizmerHasACoefficient)
{
  const MaterialFile file = read(GLASS + "friction brizmer 0.25 4e-9\n");
  EXPECT_EQ(joined(surface_words(file.materials[0].surface, 1.0, {1.0, 4e-9, 1.0})),
            "friction brizmer 0.25 1");
  expect_error(GLASS + "friction brizmer 0 1\n", "coefficient of friction must be > 0, but is 0",
               5);
}

TEST(MaterialFile, UnknownPropertiesHaveNoWords)
{
  EXPECT_EQ(joined(surface_words(Surface(), 1.0, SI)), "");
}

TEST(MaterialFile, UnlikeSurfacesMix)
{
  Surface a, b;
  a.roughness = 2.0;
  b.roughness = 4.0;
  a.friction = {SolidFriction::COULOMB, {}, 0.2, 0.0};
  b.friction = {SolidFriction::COULOMB, {}, 0.8, 0.0};
  a.repulsion = 1.0;
  a.screening = 1.0;
  EXPECT_EQ(joined(surface_words(mix(a, b), 1.0, SI)),
            "roughness 3 friction coulomb 0.40000000000000002");

  b.repulsion = 4.0;
  b.screening = 2.0;
  b.friction = {SolidFriction::BY_LOAD, {"clm", "ramp"}, 0.2, 4.0};
  a.friction.mu = 0.2;
  EXPECT_EQ(joined(surface_words(mix(a, b), 1.0, SI)),
            "roughness 3 repulsion 2 1.5 friction clm ramp 0.20000000000000001 4");
  a.friction = {SolidFriction::BY_LOAD, {"clm", "ramp"}, 0.2, 16.0};
  EXPECT_EQ(mix(a, b).friction.load, 8.0);
  for (const Words &other : {Words{"clm", "step"}, Words{"brizmer"}}) {
    a.friction.words = other;
    EXPECT_EQ(mix(a, b).friction.law, SolidFriction::UNKNOWN);
  }
  a.friction.law = SolidFriction::NONE;
  EXPECT_EQ(mix(a, b).friction.law, SolidFriction::NONE);
  a.friction.law = SolidFriction::UNKNOWN;
  EXPECT_EQ(mix(b, a).friction.law, SolidFriction::UNKNOWN);
}

TEST(MaterialFile, WhatAPairLineSaysWins)
{
  const MaterialFile file = read(GLASS + "roughness 1e-6\nfriction coulomb 0.25\n" +
                                 "material B\nmodulus 1\npoisson 0\nroughness 3e-6\n" +
                                 "pair B Glass friction coulomb 0.5 repulsion 2 3\n");
  const Surface s = pair_surface(file, file.materials[0], file.materials[1]);
  EXPECT_EQ(s.friction.mu, 0.5);
  EXPECT_EQ(s.repulsion, 2.0);
  EXPECT_EQ(s.screening, 3.0);
  EXPECT_NEAR(s.roughness, 2e-6, 1e-20);
  EXPECT_EQ(pair_surface(file, file.materials[0], file.materials[0]).friction.mu, 0.25);
}

TEST(MaterialFile, APairLineSaysOnlyWhatItSaysOfItsOwnPair)
{
  const MaterialFile file =
      read(GLASS + "adhesion 1\nmaterial B\nmodulus 1\npoisson 0\nadhesion 3\n" +
           "material C\nmodulus 1\npoisson 0\nadhesion 5\n" +
           "pair Glass B adhesion 7\npair C Glass roughness 0\n");
  auto adhesion = [&](std::size_t m, std::size_t n) {
    return pair_surface(file, file.materials[m], file.materials[n]).adhesion;
  };
  EXPECT_EQ(adhesion(0, 1), 7.0);
  EXPECT_EQ(adhesion(1, 0), 7.0);
  EXPECT_EQ(adhesion(0, 2), 3.0);
  EXPECT_EQ(adhesion(1, 2), 4.0);
  EXPECT_EQ(pair_surface(file, file.materials[0], file.materials[2]).roughness, 0.0);
}
