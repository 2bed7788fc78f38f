/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Coefficients of a pair of types as a user gives them: one row of the table COLUMNS per
// coefficient. What reads, mixes, checks, stores or prints them is a loop over the table.

#ifndef LUBCONTACT_COEFFS_H
#define LUBCONTACT_COEFFS_H

#include "lubcontact_friction.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace LAMMPS_NS::Lubcontact_NS {

struct TypeCoeffs {
  double g = 0.0;              // stiffness of the bulk, force/length; 0: pair of another style
  double kt = 0.0;             // tangential stiffness, force/length
  double asperity = 0.0;       // stiffness of the asperities, force/length
  double roughness_a = 0.0;    // height of the asperities over the effective radius
  double friction = 0.0;       // coefficient of friction
  double critical = 0.0;       // critical load of the law of friction, force
  double adhesion_a = 0.0;     // stretch that asperities hold, over the effective radius
  double repulsion = 0.0;      // force at closed gap
  double screening = 0.0;      // its length, length; 0: no repulsion
  double restitution = 1.0;    // coefficient of restitution of dry contacts; 1: elastic
  FrictionLaw law = FrictionLaw::NONE;
};

// of two unlike types, from their like pairs
enum class Mixing {
  SERIES,    // springs in series
  MEAN,
  GEOMETRIC,
  WITH_LAST    // mean, but 0 where the column before is 0
};

struct Column {
  double TypeCoeffs::*value;
  const char *name;    // for fix adapt, and the keyword of pair_coeff
  const char *what;    // in messages
  const char
      *keyword;    // how the values behind the keyword are written, those of the columns that
                   // follow included; null: none
  bool zero;       // may be 0
  Mixing mixing;
  unsigned effects;    // whose law reads it as PairCoeffs::column; 0: it is there in another form
  double most = HUGE_VAL;
};

inline constexpr Column COLUMNS[] = {
    {&TypeCoeffs::g, "g", "stiffness g", nullptr, false, Mixing::SERIES, 0},
    {&TypeCoeffs::kt, "kt", "stiffness kt", nullptr, false, Mixing::SERIES, 0},
    {&TypeCoeffs::asperity, "asperity", "asperity stiffness", "k", false, Mixing::SERIES, 0},
    {&TypeCoeffs::roughness_a, "roughness", "roughness", "eps", true, Mixing::MEAN, 0},
    {&TypeCoeffs::friction, "friction", "coefficient of friction", nullptr, true, Mixing::GEOMETRIC,
     0},
    {&TypeCoeffs::critical, "critical", "critical load", nullptr, true, Mixing::GEOMETRIC, 0},
    {&TypeCoeffs::adhesion_a, "adhesion", "adhesion", "delta", true, Mixing::GEOMETRIC, 0},
    {&TypeCoeffs::repulsion, "repulsion", "repulsion", "F0 lambda", true, Mixing::GEOMETRIC, 0},
    {&TypeCoeffs::screening, "screening", "screening length", nullptr, true, Mixing::WITH_LAST, 0},
    {&TypeCoeffs::restitution, "restitution", "coefficient of restitution", "e", false,
     Mixing::GEOMETRIC, 0, 1.0}};
inline constexpr std::size_t NUM_COLUMNS = sizeof(COLUMNS) / sizeof(Column);

constexpr std::size_t column_of(double TypeCoeffs::*value)
{
  for (std::size_t m = 0; m < NUM_COLUMNS; m++)
    if (COLUMNS[m].value == value) return m;
  return NUM_COLUMNS;
}

// Place of a column among those that laws read as they are.
constexpr std::size_t law_column(std::size_t column)
{
  std::size_t n = 0;
  for (std::size_t m = 0; m < column; m++)
    if (COLUMNS[m].effects) n++;
  return n;
}
inline constexpr std::size_t NUM_LAW_COLUMNS = law_column(NUM_COLUMNS);

constexpr std::size_t law_column(double TypeCoeffs::*value)
{
  return law_column(column_of(value));
}

// Effects that read place n.
constexpr unsigned effects_of_law_column(std::size_t n)
{
  for (std::size_t m = 0; m < NUM_COLUMNS; m++)
    if (COLUMNS[m].effects && law_column(m) == n) return COLUMNS[m].effects;
  return 0;
}

// A value that a user may give.
inline bool is_allowed(const Column &column, double value)
{
  return std::isfinite(value) && (value > 0.0 || (column.zero && value == 0.0)) &&
      value <= column.most;
}

inline double mixed(Mixing rule, double one, double other)
{
  if (rule == Mixing::SERIES) return 2.0 * one * other / (one + other);
  if (rule == Mixing::GEOMETRIC) return std::sqrt(one * other);
  return 0.5 * (one + other);
}

// Of two types, from their like pairs. Surfaces without friction have none with others; two other
// laws must be the same: check laws_agree() before.
inline bool laws_agree(const TypeCoeffs &one, const TypeCoeffs &other)
{
  return one.law == other.law || one.law == FrictionLaw::NONE || other.law == FrictionLaw::NONE;
}

inline TypeCoeffs mixed(const TypeCoeffs &one, const TypeCoeffs &other)
{
  TypeCoeffs both;
  double last = 0.0;
  for (const Column &column : COLUMNS) {
    const bool none = column.mixing == Mixing::WITH_LAST && last == 0.0;
    last = none ? 0.0 : mixed(column.mixing, one.*column.value, other.*column.value);
    both.*column.value = last;
  }
  both.law = one.law == FrictionLaw::NONE ? FrictionLaw::NONE : other.law;
  return both;
}

// Does a law have a load besides its coefficient?
inline bool has_load(FrictionLaw law)
{
  return law > FrictionLaw::COULOMB;
}

// What is wrong with coefficients that a user or fix adapt has set, and the cure; empty: nothing.
inline std::string complaint(const TypeCoeffs &c)
{
  if (c.adhesion_a > 0.0 && c.roughness_a == 0.0)
    return "adhesion acts between asperities, but their roughness is 0: give them one > 0";
  if (c.law == FrictionLaw::NONE && c.friction > 0.0)
    return "there is no friction that could be changed: give pair_coeff friction coulomb 0 first";
  if (!has_load(c.law) && c.critical > 0.0)
    return "there is no critical load that could be changed: give pair_coeff friction clm first";
  if (c.law == FrictionLaw::BRIZMER && c.friction == 0.0)
    return "the coefficient of friction brizmer must be > 0, because small ones do not make a "
           "contact frictionless: give pair_coeff friction none";
  if (c.screening == 0.0 && c.repulsion > 0.0)
    return "there is no repulsion that could be changed: give pair_coeff repulsion 0 with a "
           "screening length first";
  return "";
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
