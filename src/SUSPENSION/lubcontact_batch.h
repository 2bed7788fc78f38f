/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// A step of several pairs at once: the functions of lubcontact_pair.h in a loop that the compiler
// turns into vector instructions. Structure of arrays, one lane per pair.

#ifndef LUBCONTACT_BATCH_H
#define LUBCONTACT_BATCH_H

#include "each_processor.h"
#include "lubcontact_pair.h"

namespace LAMMPS_NS::Lubcontact_NS {

struct Batch {
  static constexpr int WIDTH = 8;    // one vector of AVX-512
  static constexpr int HISTORY = Effects<NUM_COMBINATIONS - 1>::HISTORY_SIZE;
  using Lanes = double[WIDTH];

  // in: i as seen from j, which is at rest in the origin
  Lanes x[3], v[3], omega_i[3], omega_j[3], radius_i, radius_j, a;
  Lanes g, asperity, alpha, eps_a, ln_eps, kt, mu;
  Lanes least, shift, per_ramp;         // THRESHOLD
  Lanes per_plastic;                    // THRESHOLD, where
  bool plastic;                         // some pair has the law of friction brizmer
  Lanes release_a, ln_release;          // ADHESION
  Lanes repulsion, per_screening;       // REPULSION
  Lanes restitution, mass_i, mass_j;    // RESTITUTION
  Lanes column[NUM_LAW_COLUMNS + 1];
  Lanes history[HISTORY];    // in and out

  // out; all void in a lane that is not usual (0)
  Lanes usual, force[3], torque_i[3], torque_j[3];
  Lanes stresslet[6];    // RESIDUAL: xx yy zz xy xz yz, by stresslets_together() alone
};

// Two spheres at rest that just touch, in every lane: one that no pair fills computes with these,
// and does not divide by zero.
inline Batch idle_batch()
{
  Batch b{};
  for (int l = 0; l < Batch::WIDTH; l++) {
    b.x[0][l] = 2.0;
    b.radius_i[l] = b.radius_j[l] = b.a[l] = 1.0;
    b.g[l] = b.asperity[l] = b.alpha[l] = b.kt[l] = 1.0;
    b.per_screening[l] = b.mass_i[l] = b.mass_j[l] = 1.0;
  }
  return b;
}

// Columns that the effects E read, from one place to another: copy(n) for each.
template <class E, class Copy, std::size_t... N>
inline void copy_columns(std::index_sequence<N...>, const Copy &copy)
{
  ((E::mask & effects_of_law_column(N) ? copy(N) : void()), ...);
}
template <class E, class Copy> inline void copy_columns(const Copy &copy)
{
  copy_columns<E>(std::make_index_sequence<NUM_LAW_COLUMNS>(), copy);
}

inline Vec3 get_lane(const Batch::Lanes *from, int l)
{
  return {from[0][l], from[1][l], from[2][l]};
}

inline void put_lane(const Vec3 &a, Batch::Lanes *to, int l)
{
  to[0][l] = a.x;
  to[1][l] = a.y;
  to[2][l] = a.z;
}

template <class E> inline PairCoeffs coeffs_of_lane(const Batch &b, int l)
{
  PairCoeffs c{
      {b.g[l], b.asperity[l], {b.alpha[l], b.eps_a[l], b.ln_eps[l], false}}, b.kt[l], b.mu[l]};
  if constexpr (E::threshold) c.threshold = {b.least[l], b.shift[l], b.per_ramp[l]};
  if constexpr (E::adhesion) c.normal.gap.release_a = b.release_a[l];
  if constexpr (E::adhesion) c.normal.gap.ln_release = b.ln_release[l];
  if constexpr (E::repulsion) c.normal.repulsion = {b.repulsion[l], b.per_screening[l]};
  if constexpr (E::restitution) c.restitution = b.restitution[l];
  copy_columns<E>([&](std::size_t n) { c.column[n] = b.column[n][l]; });
  return c;
}

template <class E> inline void step_lane(Batch &b, int l, const Film &f, double dt)
{
  Body i{get_lane(b.x, l), get_lane(b.v, l), get_lane(b.omega_i, l), b.radius_i[l]};
  Body j{{}, {}, get_lane(b.omega_j, l), b.radius_j[l]};
  if constexpr (E::restitution) {
    i.mass = b.mass_i[l];
    j.mass = b.mass_j[l];
  }
  const PairGeometry g = pair_geometry(i.x, j.x, i.radius, j.radius, b.a[l]);
  const PairCoeffs c = coeffs_of_lane<E>(b, l);
  double history[E::HISTORY_SIZE + 1];
  for (int m = 0; m < E::HISTORY_SIZE; m++) history[m] = b.history[m][l];
  const bool usual = next_history_usual<E>(c, f, g, i, j, dt, history, history);
  for (int m = 0; m < E::HISTORY_SIZE; m++) b.history[m][l] = history[m];

  const Load load = pair_load<E>(c, f, g, history);
  b.usual[l] = usual ? 1.0 : 0.0;
  put_lane(force_on_i(load, g), b.force, l);
  if constexpr (E::turns || E::twist) {
    put_lane(torque_on_i(load, g), b.torque_i, l);
    put_lane(torque_on_j(load, g), b.torque_j, l);
  }
}

// The lanes of a loop do not depend on each other.
#if defined(__clang__)
#define LUBCONTACT_INDEPENDENT_LANES _Pragma("clang loop vectorize(assume_safety)")
#else
#define LUBCONTACT_INDEPENDENT_LANES _Pragma("GCC ivdep")
#endif

// Film by value: no store to the batch can change it.
template <class E> inline void step_lanes(Batch &b, const Film f, double dt)
{
  LUBCONTACT_INDEPENDENT_LANES
  for (int l = 0; l < Batch::WIDTH; l++) step_lane<E>(b, l, f, dt);
}

template <class E> inline void step_usual(Batch &b, const Film &f, double dt)
{
  if (E::squeeze && f.viscosity == 0.0) {    // dry, all of them
    for (double &usual : b.usual) usual = 0.0;
    return;
  }
  if constexpr (E::residual) return step_lanes<E>(b, f, dt);
  // the constant of CUT saves three divisions
  if (E::squeeze && f.shift == 0.0)
    step_lanes<E>(
        b, {f.viscosity, f.reach_a, 0.0, f.shear_end, f.roll_end, f.twist_end, f.roll_coeff}, dt);
  else
    step_lanes<E>(b, f, dt);
}

// Does the present gap leave room for friction?
template <class E> inline bool may_rub(const Batch &b, int l)
{
  if constexpr (E::gap_history) return b.history[E::GAP_SLOT][l] < b.eps_a[l];
  return true;
}

// Not for backward Euler. A step is not usual if a contact rubs by the law brizmer: in the vectors
// it would cost those who have another law, or take instances of its own.
template <class E> inline void step_batch(Batch &b, const Film &f, double dt)
{
  const bool plastic = E::threshold && b.plastic;
  bool rubs[Batch::WIDTH] = {};
  if (plastic)
    for (int l = 0; l < Batch::WIDTH; l++) rubs[l] = b.per_plastic[l] > 0.0 && may_rub<E>(b, l);
  step_usual<WithoutPlastic<E>>(b, f, dt);
  if (plastic)
    for (int l = 0; l < Batch::WIDTH; l++)
      if (rubs[l] || (b.per_plastic[l] > 0.0 && may_rub<E>(b, l))) b.usual[l] = 0.0;
}

template <class E>
[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline]] static void
step_together(Batch &batch, const Film &film, double dt)
{
  step_batch<E>(batch, film, dt);
}

// RESIDUAL: of the present histories.
template <class E> inline void stresslet_lane(Batch &b, int l, const Film &f)
{
  const PairGeometry g = pair_geometry(get_lane(b.x, l), {}, b.radius_i[l], b.radius_j[l], b.a[l]);
  const PairCoeffs c = coeffs_of_lane<E>(b, l);
  double history[E::HISTORY_SIZE];
  for (int m = 0; m < E::HISTORY_SIZE; m++) history[m] = b.history[m][l];
  using Vectors = WithoutPlastic<E>;    // whether it rubs, not how much
  const FilmStresslet both =
      present_stresslet<Vectors>(c, f, g, pair_load<Vectors>(c, f, g, history), history);
  const SymmetricTensor s = both.normal + both.tangential;
  b.stresslet[0][l] = s.xx;
  b.stresslet[1][l] = s.yy;
  b.stresslet[2][l] = s.zz;
  b.stresslet[3][l] = s.xy;
  b.stresslet[4][l] = s.xz;
  b.stresslet[5][l] = s.yz;
}

template <class E>
[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline]] static void
stresslets_together(Batch &batch, const Film film)
{
  for (int l = 0; l < Batch::WIDTH; l++) stresslet_lane<E>(batch, l, film);
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
