// Normal mode: squeeze film, asperities and bulk in series.
// Model: W. Chevremont, H. Bodiguel, B. Chareyre, Powder Technol. 372, 600 (2020).

#ifndef LUBCONTACT_NORMAL_H
#define LUBCONTACT_NORMAL_H

#include "lubcontact_film.h"
#include "lubcontact_gap.h"

namespace lubcontact {

struct NormalCoeffs {
  double g;           // bulk stiffness, force/length
  double asperity;    // asperity stiffness k, force/length
  GapLaw gap;
};

struct NormalForce {
  double contact;    // of the asperities on i along n, repulsive: >= 0
  double film;       // of the squeeze film on i along n, negative: suction
};

// A smooth pair that overlaps without a past has no film to remember: it gets one this thin.
static constexpr double THINNEST = 1e-8;    // over a

// Gap of elastic rest, where the film carries nothing: (un + alpha eps)/(1 + alpha) if the
// asperities touch, un otherwise; all over a. It is the gap of a pair seen for the first time, of
// dry contact, and of every pair if squeeze is off.
inline double elastic_gap(const GapLaw &law, double un)
{
  const double pressed = (un + law.alpha * law.eps) / (1.0 + law.alpha);
  const double u = un < law.eps ? pressed : un;
  return u > 0.0 ? u : THINNEST;
}

// Length of the time step in units of tau = nu a/g. With a shifted range the squeeze resistance is
// nu (1 - u/range), frozen at the gap expected at mid-step (linearly implicit: positive, second
// order); un/a at the beginning and end.
inline double film_steps(const NormalCoeffs &c, const Film &f, double a, const Gap &old, double un0,
                         double un1, double dt)
{
  const double h = dt / squeeze_coeff(f.viscosity) * (c.g * (1.0 / a));    // 1/a is at hand
  if (f.shift == 0.0) return h;

  const bool contact = old.ln_u < c.gap.ln_eps;
  const double A = contact ? 1.0 + c.gap.alpha : 1.0;
  const double r = 0.5 * (un0 + un1) + (contact ? c.gap.alpha * c.gap.eps : 0.0);
  static constexpr double LEAST = 1e-6;    // of the resistance, so that h stays finite
  const double half = 0.5 * h / larger(LEAST, 1.0 - old.u * f.shift);
  const double middle =
      old.u * (1.0 + half * larger(0.0, r)) / (1.0 + half * (A * old.u + larger(0.0, -r)));
  return h / larger(LEAST, 1.0 - middle * f.shift);
}

// No film at all, or one that is at rest within 1e-12 of the step: dry contact.
inline bool is_dry(const NormalCoeffs &c, const Film &f, double a, double dt)
{
  return f.viscosity * 1e12 * a <= dt * c.g;
}

// Gap after a step as nearly all are: branch-free, void if usual becomes false; un in units of a.
inline Gap next_gap_usual(const NormalCoeffs &c, const Film &f, double a, const Gap &old,
                          double un0, double un1, double dt, bool &usual)
{
  usual = usual & !is_dry(c, f, a, dt);
  return gap_step_usual(c.gap, old, un0, un1, film_steps(c, f, a, old, un0, un1, dt), usual);
}

// The same for any step.
inline Gap next_gap(const NormalCoeffs &c, const Film &f, double a, const Gap &old, double un0,
                    double un1, double dt)
{
  if (is_dry(c, f, a, dt)) {
    const double u = elastic_gap(c.gap, un1);
    return {u, std::log(u)};
  }
  return gap_step(c.gap, old, un0, un1, film_steps(c, f, a, old, un0, un1, dt));
}

// Forces at surface separation un and gap u, lengths. Their sum is g (u - un). Without film the
// asperities carry all of it, also where they are crushed flat.
inline NormalForce normal_force(const NormalCoeffs &c, double a, double un, double u, bool film)
{
  const double total = c.g * (u - un);
  // at a gap u is un to rounding only: that is no contact
  const bool touch = (un < c.gap.eps * a) | (un < 0.0);
  const double dry = touch ? larger(0.0, total) : 0.0;
  const double contact = c.asperity * larger(0.0, c.gap.eps * a - u);
  return {film ? contact : dry, film ? total - contact : 0.0};
}

// Elastic energy of bulk and asperities.
inline double normal_energy(const NormalCoeffs &c, double a, double un, double u)
{
  const double flat = larger(0.0, c.gap.eps * a - u);
  return 0.5 * c.g * (u - un) * (u - un) + 0.5 * c.asperity * flat * flat;
}

}    // namespace lubcontact

#endif
