/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Coefficient of restitution: a dashpot in parallel with the springs of a dry contact,
//     F = k delta + zeta d(delta)/dt,  zeta = 2 beta sqrt(m k),
// delta being the overlap, k the stiffness of bulk and asperities together and m the reduced mass.
// F is never attractive, so that two spheres part where it vanishes and not where delta does, at
// the time (pi - 2 arcsin beta)/sqrt(1 - beta^2) in units of sqrt(m/k), with the share
//     e = exp(-2 beta arccos(beta)/sqrt(1 - beta^2)),  beta < 1
//     e = exp(-2 beta arcosh(beta)/sqrt(beta^2 - 1)),  beta > 1
// of their relative velocity: T. Schwager, T. Poschel, Granular Matter 9, 465 (2007), in one
// formula. With attraction to the end of the overlap it is exp(-pi beta/sqrt(1 - beta^2)), less.

#ifndef LUBCONTACT_RESTITUTION_H
#define LUBCONTACT_RESTITUTION_H

#include "lubcontact_defs.h"

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

// -ln e of a contact with the damping ratio beta >= 0.
LUBCONTACT_FN inline double restitution_exponent(double beta)
{
  if (beta == 1.0) return 2.0;
  const double root = std::sqrt(std::fabs(1.0 - beta) * (1.0 + beta));
  return 2.0 * beta * (beta < 1.0 ? std::acos(beta) : std::acosh(beta)) / root;
}

// The damping ratio of a contact with the restitution e, 0 < e <= 1: by bisection, once for a pair
// of types.
LUBCONTACT_FN inline double damping_ratio(double e)
{
  const double wanted = -std::log(e);
  double low = 0.0, high = 1.0;
  while (restitution_exponent(high) < wanted) high *= 2.0;
  for (int n = 0; n < 200; n++) {
    const double middle = 0.5 * (low + high);
    if (restitution_exponent(middle) < wanted)
      low = middle;
    else
      high = middle;
  }
  return e < 1.0 ? high : 0.0;
}

// Stiffness of the whole dry contact: bulk g and asperities k in series, the bulk alone if smooth.
LUBCONTACT_FN inline double dry_stiffness(double g, double asperity, double roughness_a)
{
  return roughness_a > 0.0 ? g * asperity / (g + asperity) : g;
}

// zeta/sqrt(m)
LUBCONTACT_FN inline double restitution_coeff(double e, double stiffness)
{
  return 2.0 * damping_ratio(e) * std::sqrt(stiffness);
}

// Resistance in steps of length dt. The rate of the overlap is that of mid-step, half a step late,
// which takes zeta dt/2 off the inertia: with this resistance the damping ratio is right to second
// order.
LUBCONTACT_FN inline double step_resistance(double coeff, double mass, double dt)
{
  const double zeta = coeff * std::sqrt(mass), c = zeta * dt / mass;
  return zeta / (std::sqrt(1.0 + c * c / 16.0) + 0.25 * c);
}

// Stiffness of a spring that limits the step as the dashpot does: in the fastest motion, to and fro
// in two steps, both have the same force.
LUBCONTACT_FN inline double dashpot_stiffness(double coeff, double mass, double dt)
{
  return 2.0 * smaller(step_resistance(coeff, mass, dt), mass / dt) / dt;
}

// Force of the dashpot after a step in which the surfaces went from un0 to un1, positive as they
// approach. Where the overlap begins in the step, half a step more makes up for the half step by
// which the force is late. In long steps it takes all of the relative velocity, and no more, so
// that it never drives. Branch-free.
LUBCONTACT_FN inline double dashpot_force(double coeff, double mass, double eps, double un0,
                                          double un1, double dt)
{
  const double before = larger(0.0, eps - un0), after = larger(0.0, eps - un1);
  const bool begins = (un0 >= eps) & (un1 < eps);
  const double moved = after - before + (begins ? 0.5 * (un0 - un1) : 0.0);
  const double most = mass / dt * std::fabs(un1 - un0);
  return larger(-most, smaller(most, step_resistance(coeff, mass, dt) * moved)) / dt;
}

// Springs and dashpot together: no attraction by the dashpot, and no dashpot without a load.
LUBCONTACT_FN inline double damped_contact(double springs, double dashpot)
{
  return springs > 0.0 ? larger(0.0, springs + dashpot) : springs;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
