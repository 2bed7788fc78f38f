/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Normal mode: squeeze film and asperities, in series with the bulk.
// Model: W. Chevremont, H. Bodiguel, B. Chareyre, Powder Technol. 372, 600 (2020).
//
// Extensions X (bits of lubcontact_effects.h), after W. Chevremont, thesis, Grenoble (2020), sec.
// 5.2.2: ADHESION, asperities that have touched pull until the gap exceeds `release`; REPULSION, in
// parallel with them. Both act on the gap u, behind the spring of the bulk, whose stiffness g
// therefore bounds that of all: neither limits the time step.

#ifndef LUBCONTACT_NORMAL_H
#define LUBCONTACT_NORMAL_H

#include "lubcontact_defs.h"
#include "lubcontact_film.h"
#include "lubcontact_gap.h"
#include "lubcontact_repulsion.h"

#include <type_traits>

namespace LAMMPS_NS::Lubcontact_NS {

struct NormalCoeffs {
  double g;           // bulk stiffness, force/length
  double asperity;    // asperity stiffness k, force/length
  GapLaw gap;
  Repulsion repulsion{};
};

struct NormalForce {
  double contact;            // of the asperities on i along n; negative: adhesion
  double film;               // of the squeeze film on i along n, negative: suction
  double repulsion = 0.0;    // screened repulsion on i along n, >= 0
};

// A smooth pair that overlaps without a past has no film to remember: it gets one this thin.
static constexpr double THINNEST_A = 1e-8;

// Gap of elastic rest, where the film carries nothing: (un + alpha eps)/(1 + alpha) if the
// asperities touch, un otherwise. It is the gap of a pair seen for the first time, of dry contact,
// and of every pair if squeeze is off.
LUBCONTACT_FN inline double elastic_gap_a(const GapLaw &law, double un_a)
{
  const double pressed = (un_a + law.alpha * law.eps_a) / (1.0 + law.alpha);
  const double u_a = un_a < law.eps_a ? pressed : un_a;
  return u_a > 0.0 ? u_a : THINNEST_A;
}

// Repulsion of closed surfaces at the gap u_a, in units of g a.
LUBCONTACT_FN inline double relative_repulsion(const NormalCoeffs &c, double a, double u_a)
{
  return repulsion_force(c.repulsion, a * u_a) / (c.g * a);
}

// Do the asperities touch at elastic rest? With ADHESION also if they have held (bond) and the gap
// at which they would carry the load has not passed `release`. Smooth ones never do.
template <unsigned X = 0>
LUBCONTACT_FN inline bool elastic_contact(const NormalCoeffs &c, double a, double un_a,
                                          [[maybe_unused]] bool bond)
{
  const GapLaw &law = c.gap;
  double at_eps = 0.0;
  if constexpr (X & REPULSION) at_eps = relative_repulsion(c, a, law.eps_a);
  const bool touch = (un_a + at_eps < law.eps_a) & (law.eps_a > 0.0);
  if constexpr (X & ADHESION) {
    double at_release = 0.0;
    if constexpr (X & REPULSION) at_release = relative_repulsion(c, a, law.release_a);
    const double held = (1.0 + law.alpha) * law.release_a - law.alpha * law.eps_a;
    return touch | (bond & (un_a + at_release < held));
  }
  return touch;
}

// Gap of elastic rest for any extension; bond: do the asperities hold? (ADHESION)
template <unsigned X>
LUBCONTACT_FN inline double elastic_gap_a(const NormalCoeffs &c, double a, double un_a, bool bond)
{
  if constexpr (!X) return elastic_gap_a(c.gap, un_a);
  const bool contact = (X & ADHESION) ? bond : elastic_contact<X>(c, a, un_a, false);
  const double r = un_a + (contact ? c.gap.alpha * c.gap.eps_a : 0.0);
  const double A = contact ? 1.0 + c.gap.alpha : 1.0;
  double u_a = r / A;
  if constexpr (X & REPULSION)
    u_a = repelled_gap(r, A, c.repulsion.force / (c.g * a), c.repulsion.per_length * a);
  return u_a > 0.0 ? u_a : THINNEST_A;
}

// The law with the repulsion linearized about the gap u_a, so that its equation stays linear in
// 1/u. The rest is quadratic in the change of u: second order.
template <unsigned X>
LUBCONTACT_FN inline NormalCoeffs linearized(const NormalCoeffs &c, double a, double u_a)
{
  NormalCoeffs law = c;
  if constexpr (X & REPULSION) {
    const double p = relative_repulsion(c, a, u_a);
    law.gap.slope = p * (c.repulsion.per_length * a);
    law.gap.push_a = p + law.gap.slope * u_a;
  }
  return law;
}

// May the repulsion be linearized over this change of the gap?
LUBCONTACT_FN inline bool is_small_change(const NormalCoeffs &c, double a, double u0_a, double u1_a)
{
  return (c.repulsion.force == 0.0) | (std::fabs(u1_a - u0_a) * a * c.repulsion.per_length < 0.25);
}

// The gap expected at mid-step is the old one times rise/fall, half being half of the step:
// linearly implicit, positive, second order.
struct MiddleGap {
  double rise, fall;
};

template <unsigned X>
LUBCONTACT_FN inline MiddleGap middle_gap(const NormalCoeffs &c, const Gap &old, double un_a,
                                          double half)
{
  const bool contact = (X & ADHESION) ? old.bond != 0.0 : old.ln_u < c.gap.ln_eps;
  const double A = gap_stiffness<X>(c.gap, contact);
  const double r = un_a + gap_drive<X>(c.gap, contact);
  return {1.0 + half * larger(0.0, r), 1.0 + half * (A * old.u_a + larger(0.0, -r))};
}

static constexpr double LEAST_FILM = 1e-6;    // of the resistance, so that steps stay finite

// Length of the time step in units of tau = nu a/g. With a shifted range the squeeze resistance is
// nu (1 - u_a/reach_a), frozen at the gap expected at mid-step. From un0_a to un1_a as in
// gap_step().
template <unsigned X = 0>
LUBCONTACT_FN inline double film_steps(const NormalCoeffs &c, const Film &f, double a,
                                       const Gap &old, double un0_a, double un1_a, double dt)
{
  const double steps = dt / squeeze_coeff(f.viscosity) * (c.g * (1.0 / a));    // 1/a is at hand
  if (f.shift == 0.0) return steps;

  const double half = 0.5 * steps / larger(LEAST_FILM, 1.0 - old.u_a * f.shift);
  const MiddleGap m = middle_gap<X>(c, old, 0.5 * (un0_a + un1_a), half);
  const double middle = old.u_a * m.rise / m.fall;
  return steps / larger(LEAST_FILM, 1.0 - middle * f.shift);
}

// RESIDUAL: e = n.E.n at mid-step and delta of lubcontact_residual.h.
struct SqueezeFlow {
  double e, delta;
};
struct NoFlow {};    // any other range

// RESIDUAL: the same of the film nu squeeze(u_a), and what the flow adds to un_a. Both are frozen
// at the gap expected at mid-step, which sees those of the old one.
struct ResidualStep {
  double steps, push_a;
};

template <unsigned X = 0>
LUBCONTACT_FN inline ResidualStep residual_step(const NormalCoeffs &c, const Film &f, double a,
                                                const Gap &old, double un0_a, double un1_a,
                                                double dt, const SqueezeFlow &flow)
{
  const double bare = dt / squeeze_coeff(f.viscosity) * (c.g * (1.0 / a));
  const double push = f.viscosity * a * flow.e / c.g;
  const ResidualPlace p = residual_place(old.u_a, old.ln_u, flow.delta);
  const double half = 0.5 * bare / larger(LEAST_FILM, residual<RESIDUAL_SQUEEZE>(p));
  const double un_a = 0.5 * (un0_a + un1_a) + push * residual<RESIDUAL_PUSH>(p);
  const MiddleGap m = middle_gap<X>(c, old, un_a, half);
  const double ratio = m.rise / m.fall;
  const ResidualPlace middle =
      residual_place(old.u_a * ratio, old.ln_u + logarithm(ratio), flow.delta);
  return {bare / larger(LEAST_FILM, residual<RESIDUAL_SQUEEZE>(middle)),
          push * residual<RESIDUAL_PUSH>(middle)};
}

// No film at all, or one that is at rest within 1e-12 of the step: dry contact.
LUBCONTACT_FN inline bool is_dry(const NormalCoeffs &c, const Film &f, double a, double dt)
{
  return f.viscosity * 1e12 * a <= dt * c.g;
}

// Gap after a step as nearly all are: branch-free, void if usual becomes false.
template <unsigned X = 0, class Flow = NoFlow>
LUBCONTACT_FN inline Gap next_gap_usual(const NormalCoeffs &c, const Film &f, double a,
                                        const Gap &old, double un0_a, double un1_a, double dt,
                                        bool &usual, [[maybe_unused]] const Flow &flow = {})
{
  usual = usual & !is_dry(c, f, a, dt);
  const NormalCoeffs l = linearized<X>(c, a, old.u_a);
  Gap end{};
  if constexpr (std::is_same_v<Flow, NoFlow>) {
    const double steps = film_steps<X>(l, f, a, old, un0_a, un1_a, dt);
    end = gap_step_usual<X>(l.gap, old, un0_a, un1_a, steps, usual);
  } else {
    const ResidualStep s = residual_step<X>(l, f, a, old, un0_a, un1_a, dt, flow);
    end = gap_step_usual<X>(l.gap, old, un0_a + s.push_a, un1_a + s.push_a, s.steps, usual);
  }
  if constexpr (X & REPULSION) usual = usual & is_small_change(c, a, old.u_a, end.u_a);
  return end;
}

// The same for any step.
template <unsigned X = 0, class Flow = NoFlow>
LUBCONTACT_FN inline Gap next_gap_linear(const NormalCoeffs &c, const Film &f, double a,
                                         const Gap &old, double un0_a, double un1_a, double dt,
                                         [[maybe_unused]] const Flow &flow = {})
{
  const NormalCoeffs l = linearized<X>(c, a, old.u_a);
  if constexpr (std::is_same_v<Flow, NoFlow>) {
    return gap_step<X>(l.gap, old, un0_a, un1_a, film_steps<X>(l, f, a, old, un0_a, un1_a, dt));
  } else {
    const ResidualStep s = residual_step<X>(l, f, a, old, un0_a, un1_a, dt, flow);
    return gap_step<X>(l.gap, old, un0_a + s.push_a, un1_a + s.push_a, s.steps);
  }
}

template <unsigned X = 0, class Flow = NoFlow>
LUBCONTACT_FN inline Gap next_gap(const NormalCoeffs &c, const Film &f, double a, const Gap &old,
                                  double un0_a, double un1_a, double dt, const Flow &flow = {})
{
  if (is_dry(c, f, a, dt)) {
    const bool bond = elastic_contact<X>(c, a, un1_a, old.bond != 0.0);
    const double u_a = elastic_gap_a<X>(c, a, un1_a, bond);
    return {u_a, std::log(u_a), bond ? 1.0 : 0.0};
  }
  if constexpr (!(X & REPULSION)) return next_gap_linear<X>(c, f, a, old, un0_a, un1_a, dt, flow);

  // in pieces, halved until the repulsion changes little in each
  static constexpr double SMALLEST = 1.0 / 256;
  Gap gap = old;
  double done = 0.0, piece = 1.0;    // of the step: sums of powers of 2 are exact
  while (done < 1.0) {
    const double from_a = un0_a + done * (un1_a - un0_a);
    const double to_a = un0_a + (done + piece) * (un1_a - un0_a);
    const Gap end = next_gap_linear<X>(c, f, a, gap, from_a, to_a, piece * dt, flow);
    if (piece > SMALLEST && !is_small_change(c, a, gap.u_a, end.u_a)) {
      piece *= 0.5;
      continue;
    }
    gap = end;
    done += piece;
  }
  return gap;
}

// Forces at the separation un and the gap u. Their sum is g (u - un). Without film the asperities
// carry all of it, also where they are crushed flat. bond: do they hold? (ADHESION)
template <unsigned X = 0>
LUBCONTACT_FN inline NormalForce normal_force(const NormalCoeffs &c, double a, double un, double u,
                                              bool film, [[maybe_unused]] bool bond = false)
{
  const double eps = c.gap.eps_a * a, total = c.g * (u - un);
  if constexpr (!X) {
    // at a gap u is un to rounding only: that is no contact
    const bool touch = (un < eps) | (un < 0.0);
    const double dry = touch ? larger(0.0, total) : 0.0;
    const double contact = c.asperity * larger(0.0, eps - u);
    return {film ? contact : dry, film ? total - contact : 0.0};
  }
  const bool touch = (X & ADHESION) ? bond : u < eps;
  const bool crushed = (u <= THINNEST_A * a) & (un < 0.0);
  const double pushed = (X & REPULSION) ? repulsion_force(c.repulsion, u) : 0.0;
  const double dry = (touch | crushed) ? total - pushed : 0.0;
  const double contact = touch ? c.asperity * (eps - u) : 0.0;
  return {film ? contact : dry, film ? total - contact - pushed : 0.0, pushed};
}

// Energy of bulk, asperities and repulsion.
template <unsigned X = 0>
LUBCONTACT_FN inline double normal_energy(const NormalCoeffs &c, double a, double un, double u,
                                          [[maybe_unused]] bool bond = false)
{
  const double flat = c.gap.eps_a * a - u;
  const double held = (X & ADHESION) ? (bond ? flat : 0.0) : larger(0.0, flat);
  double energy = 0.5 * c.g * (u - un) * (u - un) + 0.5 * c.asperity * held * held;
  if constexpr (X & REPULSION) energy += repulsion_energy(c.repulsion, u);
  return energy;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
