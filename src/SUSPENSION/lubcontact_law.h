/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// All that a user gives to the pair law, in one plain struct: the arguments of pair_style, and the
// coefficients of each pair of types.

#ifndef LUBCONTACT_LAW_H
#define LUBCONTACT_LAW_H

#include "lubcontact_coeffs.h"
#include "lubcontact_film.h"
#include "lubcontact_geometry.h"
#include "lubcontact_pair.h"
#include "lubcontact_registry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {

struct Settings {
  double viscosity = 0.0;              // pressure*time; NaN: not known yet
  double reach_a = DEFAULT_REACH_A;    // range of the films over the effective radius
  Range range = DEFAULT_RANGE;
  Radius radius = Radius::HARMONIC;
  bool euler = false;    // integrator of the gap
  unsigned films = all_films();
  double roll_coeff = 0.6;
};

struct Law {
  Settings settings;
  int types = 0;
  std::vector<TypeCoeffs> rows;    // of types 0..types, both orders of a pair

  Law() = default;
  Law(const Settings &given, int ntypes) :
      settings(given), types(ntypes), rows((ntypes + 1) * (ntypes + 1))
  {
  }
  TypeCoeffs &of(int i, int j) { return rows[i * (types + 1) + j]; }
  const TypeCoeffs &of(int i, int j) const { return rows[i * (types + 1) + j]; }
};

// Effects that the coefficients of some pair of types have, and the films.
inline unsigned present_effects(const Law &law)
{
  unsigned mask = law.settings.films;
  for (const EffectRow &row : EFFECTS)
    if (!row.is_film() && std::any_of(law.rows.begin(), law.rows.end(), row.is_present))
      mask |= row.bit;
  return mask;
}

// Does it make a difference? Films do by being on.
inline bool uses(const Law &law, unsigned bit)
{
  const EffectRow &row = effect_row(bit);
  if (row.is_film()) return law.settings.films & bit;
  return std::any_of(law.rows.begin(), law.rows.end(), row.acts);
}

inline Law without(Law law, unsigned mask)
{
  law.settings.films &= ~mask;
  for (const EffectRow &row : EFFECTS)
    if (!row.is_film() && (mask & row.bit))
      std::for_each(law.rows.begin(), law.rows.end(), row.remove);
  return law;
}

// What the loop over the pairs needs of a pair of types.
inline PairCoeffs pair_coeffs(const Settings &s, const TypeCoeffs &k)
{
  const double release = k.roughness_a + k.adhesion_a;
  GapLaw gap{k.asperity / k.g, k.roughness_a,
             k.roughness_a > 0.0 ? std::log(k.roughness_a) : -HUGE_VAL, s.euler};
  gap.release_a = release;
  gap.ln_release = k.adhesion_a > 0.0 ? std::log(release) : gap.ln_eps;
  PairCoeffs c{{k.g, k.asperity, gap}, k.kt, k.friction};
  c.threshold = make_threshold(k.law, k.critical, k.friction);
  for (std::size_t m = 0; m < NUM_COLUMNS; m++)
    if (COLUMNS[m].effects) c.column[law_column(m)] = k.*COLUMNS[m].value;
  c.restitution = restitution_coeff(k.restitution, dry_stiffness(k.g, k.asperity, k.roughness_a));
  if (k.screening > 0.0) c.normal.repulsion = {k.repulsion, 1.0 / k.screening};
  return c;
}

// Largest gap that acts, over the effective radius: without films and repulsion that of a contact.
inline double reach_a_of(const Settings &s, const TypeCoeffs &k)
{
  return s.films || k.screening > 0.0 ? s.reach_a : touching_gap_a(pair_coeffs(s, k));
}

inline Film film_of(const Settings &s)
{
  return without_films(make_film(s.viscosity, s.reach_a, s.range, s.roll_coeff), s.films & SHEAR,
                       s.films & ROLL, s.films & TWIST);
}

// Can the surfaces touch? Smooth ones do not through a squeeze film.
inline bool can_touch(const Settings &s, const TypeCoeffs &k)
{
  return k.roughness_a > 0.0 || !(s.films & SQUEEZE) || !(s.viscosity > 0.0);
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
