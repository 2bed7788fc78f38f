/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Compile-time switches: an effect that is off leaves no code, no branch and no history slot.

#ifndef LUBCONTACT_EFFECTS_H
#define LUBCONTACT_EFFECTS_H

#include <utility>

namespace LAMMPS_NS::Lubcontact_NS {

enum : unsigned {    // bits of a mask
  SQUEEZE = 1,       // squeeze film in the normal direction
  SHEAR = 2,         // tangential film
  FRICTION = 4,      // Coulomb friction of the asperities
  ROLL = 8,          // rolling torque of the film
  TWIST = 16,        // twisting torque of the film
  THRESHOLD = 32,    // load that a contact needs for friction; nothing without FRICTION
  // extensions of the normal mode: whoever leaves one out has instances of the loop without it
  ADHESION = 64,        // contacts that hold under tension
  REPULSION = 128,      // screened repulsion of the surfaces
  RESTITUTION = 256,    // dashpot of the contact
  NUM_COMBINATIONS = 512
};

inline constexpr unsigned EXTENSIONS = (NUM_COMBINATIONS - 1) & ~(ADHESION - 1);
inline constexpr unsigned NUM_EXTENDED = NUM_COMBINATIONS / ADHESION;    // sets of extensions

// The same effects without the bits that do nothing.
constexpr unsigned canonical(unsigned mask)
{
  return mask & FRICTION ? mask : mask & ~THRESHOLD;
}

// The loop is compiled for some combinations only. This is the one that has all effects of a mask;
// those that it has besides do nothing: films by ends of infinity (without_films()), a critical
// load by its coefficients. What a deck often leaves out is exact, so that it costs nothing.
constexpr unsigned covering(unsigned mask)
{
  const unsigned extensions = mask & EXTENSIONS;
  unsigned films = mask & (SHEAR | ROLL | TWIST);
  // one film of the spins alone is rare, and so are extensions without some film
  if (films & (ROLL | TWIST)) {
    if (extensions) films = SHEAR | ROLL | TWIST;
    if (films == ROLL || films == TWIST) films = ROLL | TWIST;
  }
  // a dashpot is for dry grains: beside some film it has all of them
  if ((extensions & RESTITUTION) && (films || mask & SQUEEZE)) films = SHEAR | ROLL | TWIST;
  const unsigned threshold = extensions ? THRESHOLD : mask & THRESHOLD;
  const unsigned friction = mask & FRICTION ? FRICTION | threshold : 0;
  return (mask & SQUEEZE) | extensions | films | friction;
}

// All masks that cover some, with the extensions X of the normal mode; without any X the two sets
// of friction are one.
template <unsigned X, unsigned... MASK>
constexpr auto with_extensions(std::integer_sequence<unsigned, MASK...>)
{
  return std::integer_sequence<unsigned, covering(X | MASK)...>();
}

template <unsigned X> constexpr auto instances()
{
  constexpr unsigned S = SQUEEZE, F = FRICTION, T = FRICTION | THRESHOLD;
  constexpr unsigned film = SHEAR, films = SHEAR | ROLL | TWIST, no_roll = SHEAR | TWIST,
                     no_twist = SHEAR | ROLL, no_shear = ROLL | TWIST;
  if constexpr (X == 0)
    return std::integer_sequence<unsigned, 0, F, T, film, film | F, film | T, no_roll, no_roll | F,
                                 no_roll | T, no_twist, no_twist | F, no_twist | T, no_shear,
                                 no_shear | F, no_shear | T, films, films | F, films | T, S, S | F,
                                 S | T, S | film, S | film | F, S | film | T, S | no_roll,
                                 S | no_roll | F, S | no_roll | T, S | no_twist, S | no_twist | F,
                                 S | no_twist | T, S | no_shear, S | no_shear | F, S | no_shear | T,
                                 S | films, S | films | F, S | films | T>();
  else if constexpr (X & RESTITUTION)
    return with_extensions<X>(
        std::integer_sequence<unsigned, 0, F, films, films | F, S | films, S | films | F>());
  else
    return with_extensions<X>(
        std::integer_sequence<unsigned, 0, F, film, film | F, films, films | F, S, S | F, S | film,
                              S | film | F, S | films, S | films | F>());
}

// History of a pair (i,j): doubles kept from step to step. Frame: laboratory.
//   slot    size  meaning                               dimension  new pair        i <-> j
//   GAP     2     u/a and ln(u/a), u gap of the surfaces  1          elastic_gap()   even
//   SURFACE 1     un = |r| - R_i - R_j at the last step length     present value   even
//   SHEAR   3     elastic shear displacement            length     0               odd
//   ROLL    3     elastic part of the relative rolling  1          0               odd
//   TWIST   1     elastic part of the relative twist    1          0               even
//   BOND    1     1 while the asperities hold, else 0   1          elastic_contact()  even
//   DASHPOT 1     force of the dashpot, > 0 in approach force      0               even
template <unsigned MASK> struct Effects {
  static constexpr unsigned mask = MASK;
  static constexpr bool squeeze = MASK & SQUEEZE;
  static constexpr bool shear = MASK & SHEAR;
  static constexpr bool friction = MASK & FRICTION;
  static constexpr bool roll = MASK & ROLL;
  static constexpr bool twist = MASK & TWIST;
  static constexpr bool threshold = friction && (MASK & THRESHOLD);
  static constexpr bool plastic = threshold;    // see WithoutPlastic
  static constexpr bool residual = false;       // see WithResidual
  static constexpr bool adhesion = MASK & ADHESION;
  static constexpr bool repulsion = MASK & REPULSION;
  static constexpr bool restitution = MASK & RESTITUTION;
  static constexpr unsigned normal = MASK & (ADHESION | REPULSION);    // extends the normal mode
  static constexpr bool tangential = shear || friction;
  static constexpr bool films = shear || roll || twist;    // some film besides the squeeze film
  static constexpr bool turns = tangential || roll;        // some history vector co-rotates

  // without squeeze the gap is quasi-static: no history
  static constexpr bool gap_history = squeeze;
  static constexpr bool reads_gap = tangential || roll || twist;
  static constexpr bool surface_history = squeeze || turns || twist || restitution;

  static constexpr int GAP_SLOT = 0;
  static constexpr int SURFACE_SLOT = GAP_SLOT + (gap_history ? 2 : 0);
  static constexpr int SHEAR_SLOT = SURFACE_SLOT + (surface_history ? 1 : 0);
  static constexpr int ROLL_SLOT = SHEAR_SLOT + (tangential ? 3 : 0);
  static constexpr int TWIST_SLOT = ROLL_SLOT + (roll ? 3 : 0);
  static constexpr int BOND_SLOT = TWIST_SLOT + (twist ? 1 : 0);
  static constexpr int DASHPOT_SLOT = BOND_SLOT + (adhesion ? 1 : 0);
  static constexpr int HISTORY_SIZE = DASHPOT_SLOT + (restitution ? 1 : 0);

  // which parts there are, in one number
  static constexpr int LAYOUT = (gap_history ? 1 : 0) + (surface_history ? 2 : 0) +
      (tangential ? 4 : 0) + (roll ? 8 : 0) + (twist ? 16 : 0) + (adhesion ? 32 : 0) +
      (restitution ? 64 : 0);
};

// The same with residual films (range residual), which is no bit: few have it, all with every film.
template <class E> struct WithResidual : E {
  static constexpr bool residual = true;
};

// The same without the law brizmer, for vectors of pairs: contacts that have it go alone.
template <class E> struct WithoutPlastic : E {
  static constexpr bool plastic = false;
};

constexpr unsigned covering_residual(unsigned mask)
{
  return covering(mask | SQUEEZE | SHEAR | ROLL | TWIST);
}

template <unsigned X> constexpr auto residual_instances()
{
  constexpr unsigned films = SQUEEZE | SHEAR | ROLL | TWIST, F = FRICTION, T = FRICTION | THRESHOLD;
  if constexpr (X & RESTITUTION)
    return std::integer_sequence<unsigned>();    // refused: it is for dry grains
  else if constexpr (X == 0)
    return std::integer_sequence<unsigned, films, films | F, films | T>();
  else
    return with_extensions<X>(std::integer_sequence<unsigned, films, films | F>());
}

// The one way from a mask at run time to compiled effects: calls f(Effects<instance>()) if the
// instance is one of those listed.
template <class F, unsigned... MASK>
void with_one_of(std::integer_sequence<unsigned, MASK...>, unsigned instance, F &&f)
{
  ((MASK == instance ? f(Effects<MASK>()) : void()), ...);
}

// Among the instances with these sets of extensions, each given as its number.
template <class F, unsigned... SET>
void with_sets(std::integer_sequence<unsigned, SET...>, unsigned instance, F &&f)
{
  ((SET * ADHESION == (instance & EXTENSIONS)
        ? with_one_of(instances<SET * ADHESION>(), instance, f)
        : void()),
   ...);
}

// Among all that covering() may give.
template <class F> void with_effects(unsigned instance, F &&f)
{
  with_sets(std::make_integer_sequence<unsigned, NUM_EXTENDED>(), instance, f);
}

// Among all that covering_residual() may give.
template <class F, unsigned... SET>
void with_residual_sets(std::integer_sequence<unsigned, SET...>, unsigned instance, F &&f)
{
  auto add = [&f](auto effects) {
    f(WithResidual<decltype(effects)>());
  };
  ((SET * ADHESION == (instance & EXTENSIONS)
        ? with_one_of(residual_instances<SET * ADHESION>(), instance, add)
        : void()),
   ...);
}

template <class F> void with_residual_effects(unsigned instance, F &&f)
{
  with_residual_sets(std::make_integer_sequence<unsigned, NUM_EXTENDED>(), instance, f);
}

// Among a share of them: files that share the work of compiling them have numbers 0 to 3.
inline constexpr unsigned NUM_SHARES = 4;

template <unsigned SHARE, unsigned... N>
constexpr auto sets_of_share(std::integer_sequence<unsigned, N...>)
{
  return std::integer_sequence<unsigned, (NUM_SHARES * N + SHARE)...>();
}

template <unsigned SHARE, class F> void with_share_of_effects(unsigned instance, F &&f)
{
  constexpr unsigned sets = (NUM_EXTENDED - SHARE + NUM_SHARES - 1) / NUM_SHARES;
  with_sets(sets_of_share<SHARE>(std::make_integer_sequence<unsigned, sets>()), instance, f);
}

// History of (j,i) from that of (i,j).
template <class E> inline void exchange_history(const double *source, double *target)
{
  for (int m = 0; m < E::HISTORY_SIZE; m++) {
    const bool odd = m >= E::SHEAR_SLOT && m < E::TWIST_SLOT;
    target[m] = odd ? -source[m] : source[m];
  }
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
