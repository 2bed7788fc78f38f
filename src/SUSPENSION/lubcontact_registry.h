/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The effects of the pair law, one row each: how they are called, when a pair of types has them,
// where they show in stress and power. What lists effects is a loop over these rows; what is
// compiled for each of them is in lubcontact_effects.h.

#ifndef LUBCONTACT_REGISTRY_H
#define LUBCONTACT_REGISTRY_H

#include "lubcontact_channels.h"
#include "lubcontact_coeffs.h"
#include "lubcontact_effects.h"
#include "lubcontact_power.h"

#include <cstddef>

namespace LAMMPS_NS::Lubcontact_NS {

struct EffectRow {
  unsigned bit;
  const char *name;     // in commands and advice
  const char *label;    // in the table of a run; null: shown with its law
  int channel;          // row of the stress by origin, NUM_CHANNELS: none of its own
  int origin;           // row of the power by origin, NUM_ORIGINS: none of its own

  // Films are switched by keywords of pair_style and have none of these; other effects are what the
  // coefficients of some pair of types ask for.
  bool (*is_present)(const TypeCoeffs &);    // is it compiled in, so that its numbers may change?
  bool (*acts)(const TypeCoeffs &);          // do its numbers make a difference?
  void (*remove)(TypeCoeffs &);

  constexpr bool is_film() const { return is_present == nullptr; }
};

inline constexpr EffectRow EFFECTS[] = {
    {SQUEEZE, "squeeze", "squeeze film", LUBRICATION_NORMAL, SQUEEZE_FILM, nullptr, nullptr,
     nullptr},
    {SHEAR, "shear", "shear film", LUBRICATION_TANGENTIAL, SHEAR_FILM, nullptr, nullptr, nullptr},
    {ROLL, "roll", "rolling film", NUM_CHANNELS, ROLL_FILM, nullptr, nullptr, nullptr},
    {TWIST, "twist", "twisting film", NUM_CHANNELS, TWIST_FILM, nullptr, nullptr, nullptr},
    {FRICTION, "friction", "friction", CONTACT_TANGENTIAL, FRICTION_CONTACT,
     [](const TypeCoeffs &c) {
       return c.law != FrictionLaw::NONE;
     },
     [](const TypeCoeffs &c) {
       return c.law != FrictionLaw::NONE && c.friction > 0.0;
     },
     [](TypeCoeffs &c) {
       c.law = FrictionLaw::NONE;
       c.friction = c.critical = 0.0;
     }},
    {THRESHOLD, "critical load", nullptr, NUM_CHANNELS, NUM_ORIGINS,
     [](const TypeCoeffs &c) {
       return has_load(c.law);
     },
     [](const TypeCoeffs &c) {
       return has_load(c.law) && c.critical > 0.0;
     },
     [](TypeCoeffs &c) {
       if (has_load(c.law)) c.law = FrictionLaw::COULOMB;
       c.critical = 0.0;
     }},
    {ADHESION, "adhesion", "adhesion", NUM_CHANNELS, NORMAL_CONTACT,
     [](const TypeCoeffs &c) {
       return c.adhesion_a > 0.0;
     },
     [](const TypeCoeffs &c) {
       return c.adhesion_a > 0.0;
     },
     [](TypeCoeffs &c) {
       c.adhesion_a = 0.0;
     }},
    {REPULSION, "repulsion", "repulsion", SCREENED_REPULSION, REPULSIVE_FORCE,
     [](const TypeCoeffs &c) {
       return c.screening > 0.0;
     },
     [](const TypeCoeffs &c) {
       return c.repulsion > 0.0;
     },
     [](TypeCoeffs &c) {
       c.repulsion = c.screening = 0.0;
     }},
    {RESTITUTION, "restitution", "restitution", NUM_CHANNELS, NORMAL_CONTACT,
     [](const TypeCoeffs &c) {
       return c.restitution < 1.0;
     },
     [](const TypeCoeffs &c) {
       return c.restitution < 1.0;
     },
     [](TypeCoeffs &c) {
       c.restitution = 1.0;
     }}};

constexpr unsigned all_effects()
{
  unsigned mask = 0;
  for (const EffectRow &row : EFFECTS) mask |= row.bit;
  return mask;
}
static_assert(all_effects() == NUM_COMBINATIONS - 1, "each effect has one row");

constexpr unsigned all_films()
{
  unsigned mask = 0;
  for (const EffectRow &row : EFFECTS)
    if (row.is_film()) mask |= row.bit;
  return mask;
}

inline const EffectRow &effect_row(unsigned bit)
{
  std::size_t n = 0;
  while (EFFECTS[n].bit != bit) n++;
  return EFFECTS[n];
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
