// The dimensionless numbers of a scene. Unknown input gives unknown numbers.

#ifndef SCENE_NUMBERS_H
#define SCENE_NUMBERS_H

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace scene {

static constexpr double UNKNOWN = std::numeric_limits<double>::quiet_NaN();
inline bool known(double x)
{
  return !std::isnan(x);
}

// What is known of a scene, in one consistent system of units. Pressure: of the particles.
struct Scene {
  double particles = 0.0, dimension = 3.0;
  double phi = 0.0;    // volume fraction, area fraction in 2d
  double radius = 1.0, radius_min = 1.0, radius_max = 1.0, spread = 0.0;    // spread: std/mean
  double density = 1.0;                                                     // of the particles
  double viscosity = UNKNOWN, rate = UNKNOWN, pressure = UNKNOWN;
  double g = UNKNOWN, roughness = UNKNOWN, friction = UNKNOWN;    // softest, smoothest, roughest
  double repulsion = UNKNOWN, adhesion = UNKNOWN, critical = UNKNOWN;    // forces of the surfaces
  double thermal = UNKNOWN;                                              // kT
  double fluid_density = UNKNOWN;                                        // mass/volume
  double dt = UNKNOWN, dt_limit = UNKNOWN;
  double box = UNKNOWN;    // smallest periodic height
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
  double friction_gain = UNKNOWN;    // viscosity with over viscosity without friction, less 1
  double repulsion = UNKNOWN, adhesion = UNKNOWN;    // force/(P d^2)
  double critical = UNKNOWN;                         // P a^2 over the critical load
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

static constexpr double VISCOUS_TO_INERTIAL = 10.0;    // I^2/Iv, Tapia et al. 2022

inline Numbers numbers(const Scene &s)
{
  Numbers n;
  const double a = s.radius, d = 2.0 * a;
  // the laws of spheres: discs jam elsewhere
  if (s.dimension == 3.0 && known(s.friction)) {
    n.phi_jam = jamming_fraction(s.friction);
    n.friction_gain = friction_gain(s.phi, s.friction);
  }

  const double rate = std::fabs(s.rate), viscous = s.viscosity * rate;
  n.pressure = s.pressure;
  if (!known(n.pressure) && viscous > 0.0 && known(n.phi_jam)) {
    n.pressure = viscous / viscous_number(s.phi, n.phi_jam);
    n.estimated = known(n.pressure);
  }
  const double P = n.pressure > 0.0 ? n.pressure : UNKNOWN;

  if (s.viscosity > 0.0) {
    n.St = s.density * a * a * rate / s.viscosity;
    n.Re = s.fluid_density * a * a * rate / s.viscosity;
  }
  n.Iv = viscous / P;
  n.I = d * rate * std::sqrt(s.density / P);
  n.K = n.Iv + n.I * n.I / VISCOUS_TO_INERTIAL;
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

}    // namespace scene

#endif
