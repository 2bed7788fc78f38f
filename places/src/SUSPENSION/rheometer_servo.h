/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The two servos of a rheometer: a piston with mass and dashpot holds the particle pressure P by
// the dilation e = d ln V/dt, a drive with mass holds the shear stress s by the rate g.
//
//   I de/dt + C e = p - P,              C^2 = (P/(K w))^2 + 8 I0 P,   I = lag P/(K w1^2) + I0,
//   I dg/dt + (T eta + D) g = s - s_p,  I = lag |s|/(g^2 + |g|/t + (floor/t)^2) + I0,   |e| <= P/C
//
// with w^2 = g^2 + (floor/t)^2, w1 = w but larger at rest, t = eta/P + d sqrt(rho/P) the time that
// a particle needs for its own size under the stress: per strain while it flows, per t when it does
// not, so nothing has to be tuned to the material. The mean of p is P because C is a constant of a
// steady flow; under an oscillation it is the mean weighted by |g|, within 3 % for amplitudes of
// 0.1 and 1 % from 1 on. Pressure and stress pass through a lag of 0.02 strain, which is long
// against contacts and films and short against the structure: the loop is stable although the films
// answer at once (needs I > eta_compression dt and I > stiffness dt^2, both far away). Where the
// rate is slow in units of 1/t the lag is shorter: the drive starts within t, and a piston at rest
// does not run into the jammed packing with its mass. I0 is the inertia of what moves; 8 I0 P keeps
// a heavy piston from swinging on the softest suspension, dp/d ln V = -2 P. D stops the drive from
// ringing on a jammed packing; it takes at most 0.1 % of the stress, at the rate below which a flow
// counts as jammed. Each step is solved exactly for constant p.
//
// Fluid that a layer takes in as it dilates must flow through its pores: the mean pressure of the
// fluid is -L e, see layer_drainage() in pore_layer.h. If P is that of particles and fluid,
//
//   I de/dt + (C + L) e = p - P
//
// with p that of the particles: a dashpot more, however large, makes no loop less stable. The limit
// of e stays P/C, one of the motion of the cell: the suction may be many P.

#ifndef LMP_RHEOMETER_SERVO_H
#define LMP_RHEOMETER_SERVO_H

#include <algorithm>
#include <cmath>

namespace LAMMPS_NS::Rheometer_NS {

static constexpr double LAG = 0.02;               // in strain
static constexpr double PRESSURE_FLOOR = 1e-4;    // of the servos' rate, over 1/t
static constexpr double STRESS_FLOOR = 1e-2;
static constexpr double REST = 100.0;      // how much faster the lag of a piston at rest passes
static constexpr double JAMMED = 1e-2;     // rate of a jammed packing, over that of the floor
static constexpr double DAMPING = 2e-3;    // of the drive: 2 D g/|s| at that rate

// what sets the times of the servos
struct Material {
  double eta = 0.0;         // viscosity of the fluid, pressure*time
  double density = 0.0;     // of the particles, mass/volume
  double diameter = 0.0;    // mean
  double inertia = 0.0;     // I0: pressure*time^2
};

// 1/t, zero without stress
inline double rearrangement_rate(const Material &m, double stress)
{
  const double s = std::fabs(stress);
  if (s == 0.0) return 0.0;
  return 1.0 / (m.eta / s + m.diameter * std::sqrt(m.density / s));
}

inline double servo_rate(const Material &m, double rate, double stress, double floor)
{
  return std::hypot(rate, floor * rearrangement_rate(m, stress));
}

// (1 - exp(-x))/x
inline double decay_mean(double x)
{
  return x < 1e-8 ? 1.0 - 0.5 * x : -std::expm1(-x) / x;
}

// C of the piston, with w of the present rate
inline double piston_dashpot(const Material &m, double target, double w, double gain)
{
  return std::hypot(target / (gain * w), std::sqrt(8.0 * m.inertia * target));
}

// largest |dilation| that the servo gives, with or without a layer that drains
inline double dilation_limit(const Material &m, double target, double rate, double gain)
{
  const double w = servo_rate(m, rate, target, PRESSURE_FLOOR);
  return w == 0.0 ? 0.0 : target / piston_dashpot(m, target, w, gain);
}

// dilation for the next step; pressure: of the particles, measured, compression positive; target >
// 0; gain: K; drainage: L
inline double next_dilation(const Material &m, double dilation, double pressure, double target,
                            double rate, double gain, double dt, double drainage = 0.0)
{
  const double still = PRESSURE_FLOOR * rearrangement_rate(m, target);
  const double w = std::hypot(rate, still);
  if (w == 0.0) return 0.0;
  const double dashpot = piston_dashpot(m, target, w, gain);
  const double rest = still * still / (w * w), quick = REST * still * rest * rest;
  const double inertia = LAG * target / (gain * (w * w + quick * quick)) + m.inertia;
  const double x = (dashpot + drainage) / inertia * dt;
  const double next = dilation * std::exp(-x) + (pressure - target) * dt / inertia * decay_mean(x);
  return std::clamp(next, -target / dashpot, target / dashpot);
}

// rate for the next step; stress: of the particles alone, target: with the fluid's trouton*eta*rate
inline double next_rate(const Material &m, double rate, double stress, double target,
                        double trouton, double dt)
{
  // near a target of zero the stress itself sets the time; not elsewhere, where it is noisy
  const double total = stress + trouton * m.eta * rate;
  const double scale = std::max(std::fabs(target), 0.5 * std::fabs(total));
  const double per_t = rearrangement_rate(m, scale), floor = STRESS_FLOOR * per_t;
  const double w2 = rate * rate + std::fabs(rate) * per_t + floor * floor;
  if (w2 == 0.0) return 0.0;
  const double inertia = LAG * scale / w2 + m.inertia;
  const double slow = JAMMED * floor;
  const double damper = slow > 0.0 ? DAMPING * scale * slow / (rate * rate + slow * slow) : 0.0;
  const double x = (trouton * m.eta + damper) / inertia * dt;
  return rate * std::exp(-x) + (target - stress) * dt / inertia * decay_mean(x);
}

enum State { IDLE, FOLLOWING, LIMITED, UNREACHABLE };

// watches one target: running mean of the relative deviation, of which more than 1 counts as 1 so
// that a step of the target is soon forgotten
struct Watch {
  double deviation = 0.0;    // (measured - target)/target
  double age = 0.0;          // strain since the target was set, with the floor of the servo
};

static constexpr double MEMORY = 5.0;       // strain of the running mean
static constexpr double PATIENCE = 10.0;    // strain before a target counts as unreachable

inline Watch watch(const Watch &before, double deviation, double w, double dt)
{
  const double age = before.age + w * dt;
  const double share = age > 0.0 ? std::min(1.0, w * dt / std::min(age, MEMORY)) : 0.0;
  const double now = std::clamp(deviation, -1.0, 1.0);
  return {before.deviation + share * (now - before.deviation), age};
}

inline bool unreachable(const Watch &w)
{
  return w.age > PATIENCE && std::fabs(w.deviation) > 0.5;
}

// a Watch of |rate| over the floor of the servo
inline bool jammed(const Watch &w)
{
  return w.age > PATIENCE && w.deviation < JAMMED;
}

}    // namespace LAMMPS_NS::Rheometer_NS

#endif
