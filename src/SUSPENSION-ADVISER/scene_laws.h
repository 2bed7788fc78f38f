/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The pair law under the eyes of the adviser: what it is made of, all of it switched on, forces of
// its surfaces. Pure functions of the struct that holds what a user gives.

#ifndef SCENE_LAWS_H
#define SCENE_LAWS_H

#include "lubcontact_law.h"
#include "scene_numbers.h"
#include "scene_verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace LAMMPS_NS::Scene_NS {

// effects of the verdicts that are some of the pair law; one without a verdict stays as it is:
// restitution, which is a property of grains and not of the scene
struct OfPair {
  Effect effect;
  unsigned bit;
};
inline constexpr OfPair OF_PAIR[] = {
    {SQUEEZE_FILM, Lubcontact_NS::SQUEEZE},  {SHEAR_FILM, Lubcontact_NS::SHEAR},
    {ROLLING_FILM, Lubcontact_NS::ROLL},     {TWISTING_FILM, Lubcontact_NS::TWIST},
    {FRICTION_LAW, Lubcontact_NS::FRICTION}, {CRITICAL_LOAD, Lubcontact_NS::THRESHOLD},
    {ADHESION, Lubcontact_NS::ADHESION},     {REPULSION, Lubcontact_NS::REPULSION}};

// bits of the effects with this answer
inline unsigned with_answer(const std::vector<Verdict> &verdicts, Answer answer)
{
  unsigned mask = 0;
  for (const OfPair &one : OF_PAIR)
    if (verdicts[one.effect].answer == answer) mask |= one.bit;
  return mask;
}

inline std::string effect_names(unsigned mask, const std::string &separator)
{
  std::string names;
  for (const auto &row : Lubcontact_NS::EFFECTS)
    if (mask & row.bit) names += (names.empty() ? "" : separator) + row.name;
  return names;
}

// bits of the effects that make a difference
inline unsigned used_effects(const Lubcontact_NS::Law &law)
{
  unsigned mask = 0;
  for (const auto &row : Lubcontact_NS::EFFECTS)
    if (uses(law, row.bit)) mask |= row.bit;
  return mask;
}

// ---- pairs of types i <= j

inline bool is_given(const Lubcontact_NS::TypeCoeffs &c)
{
  return c.g > 0.0;
}

// calls f(i, j, coefficients) for those that have some
template <class F> void each_pair(const Lubcontact_NS::Law &law, F &&f)
{
  for (int i = 1; i <= law.types; i++)
    for (int j = i; j <= law.types; j++)
      if (is_given(law.of(i, j))) f(i, j, law.of(i, j));
}

inline bool same_law(const Lubcontact_NS::Law &one, const Lubcontact_NS::Law &other)
{
  using Lubcontact_NS::TypeCoeffs;
  auto same = [](const TypeCoeffs &a, const TypeCoeffs &b) {
    return a.law == b.law &&
        std::all_of(std::begin(Lubcontact_NS::COLUMNS), std::end(Lubcontact_NS::COLUMNS),
                    [&](const auto &column) {
                      return a.*column.value == b.*column.value;
                    });
  };
  const auto &s = one.settings, &t = other.settings;
  return s.viscosity == t.viscosity && s.reach_a == t.reach_a && s.range == t.range &&
      s.radius == t.radius && s.euler == t.euler && s.films == t.films &&
      s.roll_coeff == t.roll_coeff &&
      std::equal(one.rows.begin(), one.rows.end(), other.rows.begin(), other.rows.end(), same);
}

// given ones, or those that follow from the like pairs
inline Lubcontact_NS::TypeCoeffs coeffs_between(const Lubcontact_NS::Law &law, int i, int j)
{
  return is_given(law.of(i, j)) ? law.of(i, j) : mixed(law.of(i, i), law.of(j, j));
}

// ---- laws of the surfaces by their numbers; NaN: as they are

struct SurfaceLaws {
  double friction = UNKNOWN;                          // coefficient
  double critical = UNKNOWN;                          // load that a contact needs for it, force
  double pull_off = UNKNOWN;                          // force that asperities hold
  double repulsion = UNKNOWN, screening = UNKNOWN;    // force at closed gap; its length
};

// Films that do without a far field: residual ones are the rest of it.
inline Lubcontact_NS::Law films_alone(Lubcontact_NS::Law law)
{
  if (law.settings.range != Lubcontact_NS::Range::RESIDUAL) return law;
  law.settings.range = Lubcontact_NS::DEFAULT_RANGE;
  law.settings.reach_a = Lubcontact_NS::DEFAULT_REACH_A;
  return law;
}

// All films, and these laws. The pull-off force is that of the effective radius a; a critical load
// without a law is of the law step.
inline Lubcontact_NS::Law switched_on(Lubcontact_NS::Law law, const SurfaceLaws &laws, double a)
{
  using Lubcontact_NS::FrictionLaw;
  law.settings.films = Lubcontact_NS::all_films();
  for (auto &c : law.rows) {
    if (!is_given(c)) continue;
    if (known(laws.friction)) {
      if (c.law == FrictionLaw::NONE) c.law = FrictionLaw::COULOMB;
      c.friction = laws.friction;
    }
    if (known(laws.critical) && c.law != FrictionLaw::NONE) {
      if (c.law == FrictionLaw::COULOMB) c.law = FrictionLaw::STEP;
      c.critical = laws.critical;
    }
    if (known(laws.pull_off)) c.adhesion_a = laws.pull_off / (c.asperity * a);
    if (known(laws.repulsion)) {
      c.repulsion = laws.repulsion;
      c.screening = laws.screening;
    }
  }
  return law;
}

// at the effective radius a; 0: none
struct SurfaceForces {
  double critical, pull_off, repulsion;
};

inline SurfaceForces surface_forces(const Lubcontact_NS::TypeCoeffs &c, double a)
{
  return {c.critical, c.asperity * c.adhesion_a * a, c.repulsion};
}

// stiffer by a factor: all springs alike
inline Lubcontact_NS::TypeCoeffs stiffer(Lubcontact_NS::TypeCoeffs c, double factor)
{
  c.g *= factor;
  c.kt *= factor;
  c.asperity *= factor;
  return c;
}

inline double smaller(double a, double b)
{
  return !known(a) || b < a ? b : a;
}

inline double softest(const Lubcontact_NS::Law &law)
{
  double least = UNKNOWN;
  each_pair(law, [&](int, int, const auto &c) {
    least = smaller(least, c.g);
  });
  return least;
}

inline CriticalLaw critical_law(Lubcontact_NS::FrictionLaw law)
{
  using Lubcontact_NS::FrictionLaw;
  if (law == FrictionLaw::BRIZMER) return PLASTIC_LAW;
  if (law == FrictionLaw::RAMP) return RAMP_LAW;
  return law == FrictionLaw::SHIFT ? SHIFT_LAW : STEP_LAW;
}

// Of several types the softest, the smoothest and the roughest, and the strongest forces; of
// critical loads both ends. The radius of the scene must be known.
inline void describe_law(const Lubcontact_NS::Law &law, Scene &s)
{
  using Lubcontact_NS::FrictionLaw;
  auto larger = [](double a, double b) {
    return -smaller(-a, -b);
  };
  s.g = softest(law);
  each_pair(law, [&](int, int, const auto &c) {
    s.roughness = smaller(s.roughness, c.roughness_a);
    s.friction = larger(s.friction, c.friction);
    const SurfaceForces forces = surface_forces(c, s.radius);
    if (forces.critical > 0.0) {
      s.critical = smaller(s.critical, forces.critical);
      s.critical_max = larger(s.critical_max, forces.critical);
      s.critical_law = std::max(s.critical_law, critical_law(c.law));
      s.rubs_always = s.rubs_always || c.law == FrictionLaw::BRIZMER;
    } else if (c.friction > 0.0) {
      s.rubs_always = true;
    }
    if (forces.pull_off > 0.0) s.adhesion = larger(s.adhesion, forces.pull_off);
    if (forces.repulsion > 0.0) s.repulsion = larger(s.repulsion, forces.repulsion);
  });
}

}    // namespace LAMMPS_NS::Scene_NS

#endif
