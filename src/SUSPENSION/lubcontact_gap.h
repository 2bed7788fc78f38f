/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Evolution of the gap u between the deformed surfaces of a pair, over one time step.
//
// Film, asperities (stiffness k) and bulk (stiffness g) in series. In this file every length is
// over a, in formulas without the suffix: u is u_a, eps is eps_a. Times are over
// tau = (3/2) pi eta a/g, that of a step is `steps`:
//     du/dt = u (r - A u),   no contact (u >= eps): r = un, A = 1
//                            contact    (u <  eps): r = un + alpha eps, A = 1 + alpha, alpha = k/g
// Model: W. Chevremont, H. Bodiguel, B. Chareyre, Powder Technol. 372, 600 (2020), with the time
// scale corrected. In w = 1/u it is linear, dw/dt = A - r w, hence no iteration. The state is
// y = ln u, which neither underflows nor changes sign.
//
// Two extensions, chosen at compile time (template argument X, bits of lubcontact_effects.h): with
// ADHESION a contact, once made below eps, holds up to the gap `release` > eps, so that its springs
// pull there; with REPULSION a further force, linear in u within the step, adds push - slope u to
// r.

#ifndef LUBCONTACT_GAP_H
#define LUBCONTACT_GAP_H

#include "lubcontact_defs.h"
#include "lubcontact_effects.h"
#include "lubcontact_polynomial.h"

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

// Gap of the deformed surfaces and its logarithm: u_a may underflow where ln_u does not, and is
// kept beside it so that a step need not take the exponential of its own logarithm.
struct Gap {
  double u_a;
  double ln_u;
  double bond = 0.0;    // ADHESION: the asperities hold
};

// phi(z) = integral_0^1 exp(-z s) ds and the mean of s^2 under the weight exp(-z s), z > -300.
struct ExponentialMean {
  double phi;
  double mean_s2;
  double exp_minus_z;
};

struct LogExponentialMean {
  double ln_phi;
  double mean_s2;
};

// integral_0^1 exp(-z s) ds = sum (-z)^n/(n+1)!
struct PhiSeries {
  static constexpr int SIZE = 12;
  static constexpr double at(int n) { return 1.0 / factorial(n + 1); }
};

// integral_0^1 s^2 exp(-z s) ds = sum (-z)^n/(n! (n+3))
struct PsiSeries {
  static constexpr int SIZE = 9;
  static constexpr double at(int n) { return 1.0 / (factorial(n) * (n + 3)); }
};

LUBCONTACT_FN inline ExponentialMean exponential_mean(double z)
{
  static constexpr double NEAR = 0.3;    // the series to rounding; its mean to 2e-11
  const bool series = std::fabs(z) < NEAR;
  // compilers divide by both sides of a choice: the closed form is never taken where it is 0/0
  const double far = std::copysign(larger(std::fabs(z), NEAR), z);
  const double e = exponential(larger(-far, -300.0)), lost = 1.0 - e;
  const double phi = polynomial<PhiSeries>(-z), psi = polynomial<PsiSeries>(-z);
  const double inverse = 1.0 / (series ? phi : far * far * lost);    // one division for all
  const double closed = far * lost * lost * inverse;
  return {series ? phi : closed, inverse * (series ? psi : 2.0 - e * (far * far + 2.0 * far + 2.0)),
          series ? 1.0 - z * phi : e};
}

// ln phi(z) instead of phi(z), for any z.
LUBCONTACT_FN inline LogExponentialMean log_exponential_mean(double z)
{
  if (std::fabs(z) < 30.0) {
    const ExponentialMean m = exponential_mean(z);
    return {std::log(m.phi), m.mean_s2};
  }
  if (z > 0.0) return {-std::log(z), 2.0 / (z * z)};
  const double i = -1.0 / z;
  return {-z + std::log(i), 1.0 - 2.0 * i + 2.0 * i * i};
}

LUBCONTACT_FN inline double log_add_exp(double a, double b)
{
  return larger(a, b) + std::log1p(std::exp(-std::fabs(a - b)));
}

// sqrt(pi) x exp(x^2) erfc(x) = sum (-1)^n (2n-1)!! (2 x^2)^-n, asymptotically
struct ErfcxSeries {
  static constexpr int SIZE = 7;
  static constexpr double at(int n) { return n > 0 ? (1 - 2 * n) * at(n - 1) : 1.0; }
};

// ln( exp(x^2) erfc(x) ) for x >= 0.
LUBCONTACT_FN inline double log_erfcx(double x)
{
  static constexpr double LN_ROOT_PI = 0.57236494292470009;
  if (x < 20.0) return x * x + std::log(std::erfc(x));
  return std::log(polynomial<ErfcxSeries>(0.5 / (x * x)) / x) - LN_ROOT_PI;    // to rounding
}

// ln of integral_0^1 exp(-z s + D s^2) ds for D < 0, exact: a Gaussian cut at both ends.
LUBCONTACT_FN inline double log_gaussian_integral(double z, double D)
{
  static constexpr double HALF_ROOT_PI = 0.88622692545275801;
  const double root = std::sqrt(-D), a = 0.5 * z / root, b = a + root;
  const double scale = std::log(HALF_ROOT_PI / root);
  if (a > 0.0)
    return scale + log_erfcx(a) + std::log1p(-std::exp(D - z + log_erfcx(b) - log_erfcx(a)));
  if (b < 0.0)
    return scale + D - z + log_erfcx(-b) +
        std::log1p(-std::exp(z - D + log_erfcx(-a) - log_erfcx(-b)));
  return scale + a * a + std::log(std::erf(b) - std::erf(a));
}

// One step with r going linearly from r0 to r1. Second order, exact for constant r, positive by
// construction, right in both stiff limits. Returns ln u.
LUBCONTACT_FN inline double gap_exponential_any(double y0, double r0, double r1, double A,
                                                double steps)
{
  const double D = 0.5 * steps * (r1 - r0);
  const LogExponentialMean m = log_exponential_mean(steps * r1);
  // the mean bounds the integral from below only, so that it must not be asked for a large fall
  const double ln_I = D < -0.5 ? log_gaussian_integral(steps * r1, D) : m.ln_phi + D * m.mean_s2;
  return -log_add_exp(-0.5 * steps * (r0 + r1) - y0, std::log(A * steps) + ln_I);
}

// How far D may be from 0 in the usual case. A film that relaxes within the step, as between
// spheres far from each other, sees only its end, where s is about 1/x.
LUBCONTACT_FN inline double largest_change(double x)
{
  return x > 30.0 ? smaller(1e-4 * x * x, 0.5) : 1e-2;
}

// The same where nothing can overflow, which is the usual case: u0/u1 = exp(-x) + A steps I u0.
// Branch-free; the result is void if usual becomes false, and nothing overflows on the way to it.
LUBCONTACT_FN inline Gap gap_exponential_usual(const Gap &old, double r0, double r1, double A,
                                               double steps, bool &usual)
{
  const double x = 0.5 * steps * (r0 + r1);
  const double change = 0.5 * steps * (r1 - r0);
  const double thinnest = x > 30.0 ? -20.0 : -300.0;    // beyond, exp(-x) counts to the last
  usual = usual & (x > -30.0) & (x < 1e8) & (std::fabs(change) < largest_change(x)) &
      (old.ln_u > thinnest) & (old.ln_u < 300.0);
  const double D = usual ? change : 0.0;
  const ExponentialMean m = exponential_mean(usual ? x + D : 0.0);
  const double q = D * m.mean_s2;
  const double exp_q = 1.0 + q * (1.0 + q * (1.0 / 2 + q / 6));    // to 4e-10 at |q| < 1e-2
  const double exp_D = polynomial<ExpSeries<6>>(D);    // where D is larger exp(-x) counts no more
  const double ratio = m.exp_minus_z * exp_D + A * steps * m.phi * exp_q * old.u_a;
  return {old.u_a / ratio, old.ln_u - logarithm(ratio)};
}

LUBCONTACT_FN inline Gap gap_exponential(const Gap &old, double r0, double r1, double A,
                                         double steps)
{
  bool usual = true;
  const Gap gap = gap_exponential_usual(old, r0, r1, A, steps, usual);
  if (usual) return gap;
  const double y1 = gap_exponential_any(old.ln_u, r0, r1, A, steps);
  return {std::exp(y1), y1};
}

// One step of backward Euler (Chevremont's eq. 18), rationalized so that nothing cancels.
LUBCONTACT_FN inline Gap gap_euler(const Gap &old, double r1, double A, double steps)
{
  const double b = r1 - 1.0 / steps;
  const double d = std::sqrt(b * b + 4.0 * A * old.u_a / steps);
  double y1;
  if (d == 0.0)
    y1 = 0.5 * (old.ln_u - std::log(A * steps));    // b = 0 and u below the smallest number
  else if (b <= 0.0)
    y1 = old.ln_u + std::log(2.0 / (steps * (d - b)));
  else
    y1 = std::log((b + d) / (2.0 * A));
  return {std::exp(y1), y1};
}

// The history of a gap, u_a and ln_u, after a has changed: factor is the old a over the new one.
LUBCONTACT_FN inline void rescale_gap(double factor, double *gap)
{
  gap[0] *= factor;
  gap[1] += std::log(factor);
}

struct GapLaw {
  double alpha;     // k/g
  double eps_a;     // roughness: height of the asperities; 0: smooth
  double ln_eps;    // ln(eps_a), -HUGE_VAL if smooth
  bool euler;       // backward Euler instead of the exponential scheme

  double release_a = 0.0, ln_release = 0.0;    // ADHESION: gap at which a contact breaks
  double push_a = 0.0, slope = 0.0;            // REPULSION: force over g is push - slope u
};

// The coefficients of du/dt = u (un + drive - stiffness u), contact or not.
template <unsigned X = 0> LUBCONTACT_FN inline double gap_stiffness(const GapLaw &law, bool contact)
{
  const double A = contact ? 1.0 + law.alpha : 1.0;
  if constexpr (X & REPULSION) return A + law.slope;
  return A;
}

template <unsigned X = 0> LUBCONTACT_FN inline double gap_drive(const GapLaw &law, bool contact)
{
  const double add = contact ? law.alpha * law.eps_a : 0.0;
  if constexpr (X & REPULSION) return add + law.push_a;
  return add;
}

// The gap at which a contact ends, or one begins.
struct Border {
  double u_a, ln_u;
};

template <unsigned X = 0> LUBCONTACT_FN inline Border gap_border(const GapLaw &law, bool contact)
{
  if constexpr (X & ADHESION)
    if (contact) return {law.release_a, law.ln_release};
  return {law.eps_a, law.ln_eps};
}

// Step in one branch of the law, contact or not.
template <unsigned X = 0>
LUBCONTACT_FN inline Gap gap_branch(const GapLaw &law, bool contact, const Gap &old, double un0_a,
                                    double un1_a, double steps)
{
  const double A = gap_stiffness<X>(law, contact);
  const double add = gap_drive<X>(law, contact);
  Gap end = law.euler ? gap_euler(old, un1_a + add, A, steps)
                      : gap_exponential(old, un0_a + add, un1_a + add, A, steps);
  end.bond = contact ? 1.0 : 0.0;
  return end;
}

// Fraction of the step at which ln_u reaches the border, end being beyond it: Illinois, with a
// bisection every third time for flat cases.
template <unsigned X = 0>
LUBCONTACT_FN inline double gap_crossing(const GapLaw &law, bool contact, const Gap &old,
                                         const Gap &end, double un0_a, double un1_a, double steps)
{
  const double border = gap_border<X>(law, contact).ln_u;
  double lo = 0.0, f_lo = old.ln_u - border;
  double hi = 1.0, f_hi = end.ln_u - border;
  double t = 0.5;
  int kept = 0;    // end kept by the last evaluation: 1 high, -1 low
  for (int n = 0; n < 100 && hi - lo > 1e-12; n++) {
    t = (lo * f_hi - hi * f_lo) / (f_hi - f_lo);
    if (n % 3 == 2 || !(t > lo && t < hi)) t = 0.5 * (lo + hi);
    const Gap there =
        gap_branch<X>(law, contact, old, un0_a, un0_a + t * (un1_a - un0_a), t * steps);
    const double f = there.ln_u - border;
    if (std::fabs(f) < 1e-13) break;
    if (contact ? f <= 0.0 : f >= 0.0) {    // not of f_lo, which may be 0
      lo = t;
      f_lo = f;
      if (kept == 1) f_hi *= 0.5;    // an end kept twice must move
      kept = 1;
    } else {
      hi = t;
      f_hi = f;
      if (kept == -1) f_lo *= 0.5;
      kept = -1;
    }
  }
  return t;
}

// Contact during a step? On the border the drive decides: the gap closes if it is below eps. An
// adhesive contact holds until it breaks.
template <unsigned X = 0>
LUBCONTACT_FN inline bool in_contact(const GapLaw &law, const Gap &gap, double un0_a, double un1_a)
{
  if constexpr (X & ADHESION) return gap.bond != 0.0;
  const double drive = gap_drive<X>(law, false), stiffness = gap_stiffness<X>(law, false);
  return (gap.ln_u < law.ln_eps) |
      ((gap.ln_u == law.ln_eps) & (un0_a + un1_a < 2.0 * (stiffness * law.eps_a - drive)));
}

template <unsigned X = 0>
LUBCONTACT_FN inline bool crosses(const GapLaw &law, bool contact, double end)
{
  const bool opens = end > gap_border<X>(law, true).ln_u;
  const bool closes = end < gap_border<X>(law, false).ln_u;
  return (contact & opens) | (!contact & closes);
}

// The rest of a step that crosses the border, branch by branch. At u = eps both branches have the
// same rate, and an adhesive contact breaks elsewhere than it forms: no chatter; four is a guard.
template <unsigned X = 0>
LUBCONTACT_FN inline Gap gap_cross(const GapLaw &law, bool contact, Gap gap, Gap end, double un0_a,
                                   double un1_a, double steps)
{
  for (int n = 0; n < 4 && crosses<X>(law, contact, end.ln_u); n++) {
    const double t = gap_crossing<X>(law, contact, gap, end, un0_a, un1_a, steps);
    const Border border = gap_border<X>(law, contact);
    un0_a += t * (un1_a - un0_a);
    steps *= 1.0 - t;
    contact = !contact;
    gap = {border.u_a, border.ln_u, contact ? 1.0 : 0.0};
    if (!(steps > 0.0)) return gap;
    end = gap_branch<X>(law, contact, gap, un0_a, un1_a, steps);
  }
  return end;
}

// Step with the transitions between contact and no contact resolved inside it.
template <unsigned X = 0>
LUBCONTACT_FN inline Gap gap_piece(const GapLaw &law, const Gap &old, double un0_a, double un1_a,
                                   double steps)
{
  const bool contact = in_contact<X>(law, old, un0_a, un1_a);
  const Gap end = gap_branch<X>(law, contact, old, un0_a, un1_a, steps);
  if (crosses<X>(law, contact, end.ln_u))
    return gap_cross<X>(law, contact, old, end, un0_a, un1_a, steps);
  return end;
}

// A step in one branch of the law where nothing can overflow. Branch-free; the result is void if
// usual becomes false.
template <unsigned X = 0>
LUBCONTACT_FN inline Gap gap_step_usual(const GapLaw &law, const Gap &old, double un0_a,
                                        double un1_a, double steps, bool &usual)
{
  const bool contact = in_contact<X>(law, old, un0_a, un1_a);
  const double A = gap_stiffness<X>(law, contact);
  const double add = gap_drive<X>(law, contact);
  Gap end = gap_exponential_usual(old, un0_a + add, un1_a + add, A, steps, usual);
  end.bond = old.bond;    // no border is crossed
  usual = usual & !crosses<X>(law, contact, end.ln_u) & !law.euler;
  return end;
}

// Gap after a step of length steps = dt/tau during which un_a goes from un0_a to un1_a.
// Where the surfaces move far in a film that relaxes fast the step is cut: 2 D <= 1 in each piece.
template <unsigned X = 0>
LUBCONTACT_FN inline Gap gap_step(const GapLaw &law, const Gap &old, double un0_a, double un1_a,
                                  double steps)
{
  bool usual = true;
  const Gap end = gap_step_usual<X>(law, old, un0_a, un1_a, steps, usual);
  if (usual) return end;

  static constexpr int MAX_PIECES = 16;    // beyond, the film is quasi-static within a piece
  const double D = 0.5 * steps * std::fabs(un1_a - un0_a);
  if (D <= 0.5 || law.euler) return gap_piece<X>(law, old, un0_a, un1_a, steps);
  const int pieces = static_cast<int>(smaller(std::ceil(std::sqrt(2.0 * D)), MAX_PIECES));
  const double piece = steps / pieces, dun_a = (un1_a - un0_a) / pieces;
  Gap gap = old;
  for (int n = 0; n < pieces; n++)
    gap = gap_piece<X>(law, gap, un0_a + n * dun_a, un0_a + (n + 1) * dun_a, piece);
  return gap;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
