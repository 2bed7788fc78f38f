/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The dimensionless numbers of a scene. Unknown input gives unknown numbers.

#ifndef SCENE_NUMBERS_H
#define SCENE_NUMBERS_H

#include "pore_closure.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace LAMMPS_NS::Scene_NS {

static constexpr double UNKNOWN = std::numeric_limits<double>::quiet_NaN();
inline bool known(double x)
{
  return !std::isnan(x);
}

// to four digits
inline double rounded(double x)
{
  const double power = std::floor(std::log10(std::fabs(x))) - 3.0;
  const double unit = std::pow(10.0, std::fabs(power));
  return x == 0.0 ? 0.0 : power < 0.0 ? std::round(x * unit) / unit : std::round(x / unit) * unit;
}

// laws of friction with a load, by how much of the friction they keep below it
enum CriticalLaw { STEP_LAW, SHIFT_LAW, RAMP_LAW, PLASTIC_LAW };

// What is known of a scene, in one consistent system of units. Pressure: of the particles.
struct Scene {
  double particles = 0.0, dimension = 3.0;
  double phi = 0.0;    // volume fraction, area fraction in 2d
  double radius = 1.0, radius_min = 1.0, radius_max = 1.0;
  double spread = 0.0, skew = 0.0;    // of the radius: std/mean, third moment/std^3
  double density = 1.0;               // of the particles
  double viscosity = UNKNOWN, rate = UNKNOWN, pressure = UNKNOWN;
  double g = UNKNOWN, roughness = UNKNOWN, friction = UNKNOWN;    // softest, smoothest, roughest
  double repulsion = UNKNOWN, adhesion = UNKNOWN, critical = UNKNOWN;    // forces of the surfaces
  double critical_max = UNKNOWN;    // of pairs of types with several; unknown: the same
  CriticalLaw critical_law = STEP_LAW;
  bool rubs_always = false;          // pairs of types with friction at any load
  double thermal = UNKNOWN;          // kT
  double fluid_density = UNKNOWN;    // mass/volume
  double dt = UNKNOWN, dt_limit = UNKNOWN;
  double box = UNKNOWN;        // smallest periodic height
  double gravity = UNKNOWN;    // acceleration
  double bottom = UNKNOWN;     // pressure of all particles on what carries them
  double height = UNKNOWN;     // of the layer whose fluid must flow: gap of plates
};

// Dimensionless, but for the first two
struct Numbers {
  double diameter = 1.0;
  double pressure = UNKNOWN;    // given or estimated
  bool estimated = false;
  double St = UNKNOWN;               // rho a^2 rate/eta
  double Iv = UNKNOWN;               // eta rate/P
  double I = UNKNOWN;                // d rate sqrt(rho/P)
  double K = UNKNOWN;                // Iv + I^2/10
  double Ca = UNKNOWN;               // eta rate a/g
  double stiffness = UNKNOWN;        // E/P, E = g/a
  double crushing = UNKNOWN;         // E eps/P
  double Pe = UNKNOWN;               // 6 pi eta a^3 rate/kT
  double Re = UNKNOWN;               // rho_f a^2 rate/eta
  double step = UNKNOWN;             // dt over its limit
  double box = UNKNOWN;              // in mean diameters
  double phi_jam = UNKNOWN;          // where friction jams it
  double crowding = UNKNOWN;         // phi over that
  double Pi = UNKNOWN;               // Iv H^2/k: time of drainage over 1/rate, times P/E = 1
  double friction_gain = UNKNOWN;    // viscosity with over viscosity without friction, less 1
  double repulsion = UNKNOWN, adhesion = UNKNOWN;    // force/(P d^2)
  double critical = UNKNOWN;                         // P a^2 over the critical load, the smallest
  double critical_min = UNKNOWN;                     // over the largest
};

// Chevremont, Chareyre, Bodiguel, Phys. Rev. Fluids 4, 064302 (2019), eq. 13
inline double jamming_fraction(double friction)
{
  return 0.6301 - 0.0794 * (1.0 - std::exp(-friction / 0.4032));
}

// Iv of a volume fraction at rest with its flow: phi = phi_m/(1 + sqrt(Iv)), same article, eq. 15
inline double viscous_number(double phi, double phi_jam)
{
  const double root = phi_jam / phi - 1.0;
  return root > 0.0 ? root * root : UNKNOWN;
}

// viscosity ~ (1 - phi/phi_m)^-2: Maron and Pierce, J. Colloid Sci. 11, 80 (1956)
inline double friction_gain(double phi, double friction)
{
  const double with = 1.0 - phi / jamming_fraction(friction);
  const double without = 1.0 - phi / jamming_fraction(0.0);
  if (with <= 0.0) return HUGE_VAL;
  return without * without / (with * with) - 1.0;
}

// Transients of the volume wait for the fluid of the pores beyond this Iv H^2/k; steady flow does
// not.
static constexpr double PORES_MATTER = 1.0;
inline constexpr Pore_NS::Permeability PORES{Pore_NS::Closure::BEETSTRA, 0.0, 1.0,
                                             0.0};    // at any phi

static constexpr double VISCOUS_TO_INERTIAL = 10.0;    // I^2/Iv, Tapia et al. 2022

// Random close packing of spheres of several sizes over that of equal ones: Desmond and Weeks,
// Phys. Rev. E 90, 022204 (2014). The laws here are those of spheres up to this spread.
static constexpr double NARROW = 0.1;
inline double packing_gain(double spread, double skew)
{
  if (spread <= NARROW) return 1.0;
  return 1.0 +
      (0.0658 * (spread - NARROW) + 0.0857 * std::fmax(skew, 0.0) * spread * spread) / 0.634;
}

// the law brizmer has no largest coefficient
inline double largest_friction(const Scene &s)
{
  return s.critical_law == PLASTIC_LAW ? HUGE_VAL : s.friction;
}

// where the scene jams for certain: no contact that has a critical load is frictional,
// sizes pack well
inline double loosest_jamming(const Scene &s)
{
  const bool may_slip = s.critical > 0.0 && !s.rubs_always;
  return jamming_fraction(may_slip ? 0.0 : s.friction) * packing_gain(s.spread, s.skew);
}

// Pressure of the steady flow by the volume fraction, from where it is least to where it is
// largest: no contact that has a critical load is frictional, sizes pack as well as they can; all
// contacts are frictional, sizes pack as equal ones. Infinite: jammed. Unknown without rate,
// viscosity and friction.
struct Bounds {
  double low = UNKNOWN, high = UNKNOWN;
  bool one() const { return !(high > 1.1 * low); }    // as far as the law is good
};

inline Bounds steady_pressure(const Scene &s)
{
  const double viscous = s.viscosity * std::fabs(s.rate);
  if (s.dimension != 3.0 || !known(s.friction) || !(viscous > 0.0)) return {};
  auto pressure = [&](double phi_jam) {
    const double Iv = viscous_number(s.phi, phi_jam);
    return known(Iv) ? viscous / Iv : HUGE_VAL;
  };
  const double high = pressure(jamming_fraction(largest_friction(s)));
  const double low = pressure(loosest_jamming(s));
  return std::isinf(low) ? Bounds{} : Bounds{low, high};
}

inline Numbers numbers(const Scene &s)
{
  Numbers n;
  const double a = s.radius, d = 2.0 * a;
  // the laws of spheres: discs jam elsewhere
  if (s.dimension == 3.0 && known(s.friction)) {
    n.phi_jam = jamming_fraction(largest_friction(s));
    n.crowding = s.phi / n.phi_jam;
    n.friction_gain = friction_gain(s.phi, largest_friction(s));
  }

  const double rate = std::fabs(s.rate), viscous = s.viscosity * rate;
  n.pressure = s.pressure;
  if (!known(n.pressure)) {
    const double most = steady_pressure(s).high;
    n.estimated = std::isfinite(most);
    if (n.estimated) n.pressure = most;
  }
  const double P = n.pressure > 0.0 ? n.pressure : UNKNOWN;

  if (s.viscosity > 0.0) {
    n.St = s.density * a * a * rate / s.viscosity;
    n.Re = s.fluid_density * a * a * rate / s.viscosity;
  }
  n.Iv = viscous / P;
  n.I = d * rate * std::sqrt(s.density / P);
  n.K = n.Iv + n.I * n.I / VISCOUS_TO_INERTIAL;
  if (s.dimension == 3.0 && s.phi > 0.0)
    n.Pi = n.Iv * s.height * s.height / Pore_NS::permeability(PORES, s.phi, a);
  n.Ca = viscous * a / s.g;
  n.stiffness = s.g / (a * P);
  n.crushing = n.stiffness * s.roughness;
  n.Pe = 6.0 * 3.14159265358979324 * a * a * a * viscous / s.thermal;
  n.step = s.dt / s.dt_limit;
  n.diameter = d;
  n.box = s.box / d;
  n.repulsion = s.repulsion / (P * d * d);
  n.adhesion = s.adhesion / (P * d * d);
  n.critical = P * a * a / s.critical;
  n.critical_min = known(s.critical_max) ? P * a * a / s.critical_max : n.critical;
  return n;
}

// in %g, or a question mark
inline std::string show(double x)
{
  if (!known(x)) return "?";
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", x);
  return text;
}

}    // namespace LAMMPS_NS::Scene_NS

#endif
