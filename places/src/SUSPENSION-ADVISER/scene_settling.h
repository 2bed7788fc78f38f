/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// A scene without shear, in which particles fall: what is known of it. The laws of sheared
// suspensions say nothing here.

#ifndef SCENE_SETTLING_H
#define SCENE_SETTLING_H

#include "scene_verdict.h"

#include <string>
#include <vector>

namespace LAMMPS_NS::Scene_NS {

// of a sphere of the mean radius; weight: mass times gravity, as it acts in LAMMPS
struct Settling {
  double weight = UNKNOWN, velocity = UNKNOWN;       // Stokes' velocity, alone in the fluid
  double buoyant = UNKNOWN;                          // (1 - fluid over particle density)
  double time = UNKNOWN;                             // in which it comes to its velocity
  double St = UNKNOWN, Re = UNKNOWN;                 // rho a v/eta, rho_f a v/eta
  double Pe = UNKNOWN;                               // weight a/kT
  double stiffness = UNKNOWN, crushing = UNKNOWN;    // E/P, E eps/P under the whole weight
};

inline Settling settling(const Scene &s)
{
  static constexpr double PI = 3.14159265358979324;
  Settling n;
  const double a = s.radius;
  n.stiffness = s.g / (a * s.bottom);
  n.crushing = n.stiffness * s.roughness;
  n.buoyant = 1.0 - s.fluid_density / s.density;
  if (s.dimension != 3.0) return n;
  n.weight = 4.0 / 3.0 * PI * a * a * a * s.density * s.gravity;
  n.Pe = n.weight * a / s.thermal;
  if (!(s.viscosity > 0.0)) return n;
  n.velocity = n.weight / (6.0 * PI * s.viscosity * a);
  n.time = n.velocity / s.gravity;
  n.St = s.density * a * n.velocity / s.viscosity;
  n.Re = s.fluid_density * a * n.velocity / s.viscosity;
  return n;
}

inline Verdict judge_falling_film(const Scene &s, const Settling &n, Effect e)
{
  if (!known(s.viscosity))
    return {e, CANNOT_TELL, "give the viscosity of the fluid: viscosity eta"};
  if (s.viscosity == 0.0) return {e, NOT_NEEDED, "dry: the viscosity is 0"};
  if (e == SQUEEZE_FILM && known(n.St))
    return {e, 4.0 / 9.0 * n.St > THRESHOLD[DRY].value ? NOT_NEEDED : NEEDED,
            "impacts at Stokes' velocity: " + compare(4.0 / 9.0 * n.St, DRY)};
  return {e, CANNOT_TELL, "measured in shear only: keep it"};
}

inline Verdict judge_falling_force(Effect e, double force, const Settling &n, const char *keyword)
{
  if (!known(force))
    return {e, CANNOT_TELL, std::string("give the force of the surfaces: ") + keyword + " F"};
  if (force == 0.0) return {e, NOT_NEEDED, "the force is 0"};
  return {e, CANNOT_TELL,
          "measured in shear only: keep it; force over weight = " + show(force / n.weight)};
}

inline Verdict judge_falling_drag(const Scene &s)
{
  if (!known(s.viscosity))
    return {DRAG, CANNOT_TELL, "give the viscosity of the fluid: viscosity eta"};
  if (s.viscosity == 0.0) return {DRAG, NOT_NEEDED, "dry: the viscosity is 0"};
  return {DRAG, NEEDED, "without it particles fall freely: films act between neighbors only"};
}

inline Verdict judge_falling_far(const Scene &s)
{
  static constexpr Effect E = FAR_HYDRODYNAMICS;
  if (s.viscosity == 0.0) return {E, NOT_NEEDED, "dry: the viscosity is 0"};
  if (!known(s.viscosity))
    return {E, CANNOT_TELL, "give the viscosity of the fluid: viscosity eta"};
  return {
      E, LIMITED,
      "the fluid that flows back hinders settling: here only by hindrance of fix drag/background"};
}

inline Verdict judge_falling_motion(const Scene &s, const Settling &n, Effect e)
{
  const double scale = e == BROWNIAN_MOTION ? s.thermal : s.fluid_density;
  if (e == BROWNIAN_MOTION && s.thermal == 0.0) return {e, NOT_NEEDED, "the temperature is 0"};
  if (e == FLUID_INERTIA_EFFECT && s.viscosity == 0.0)
    return {e, NOT_NEEDED, "dry: the viscosity is 0"};
  if (!known(scale))
    return {e, CANNOT_TELL,
            e == BROWNIAN_MOTION ? "give the temperature T"
                                 : "give the density of the fluid: fluid_density rho"};
  const double x = e == BROWNIAN_MOTION ? n.Pe : n.Re;
  if (!known(x))
    return {e, CANNOT_TELL, "Stokes' velocity unknown: give the viscosity of the fluid"};
  if (e == BROWNIAN_MOTION) return above(e, x, BROWNIAN, NOT_NEEDED, BEYOND);
  return above(e, x, FLUID_INERTIA, BEYOND, NOT_NEEDED);
}

// one verdict per effect, in the order of Effect
inline std::vector<Verdict> judge_settling(const Scene &s, const Settling &n)
{
  std::vector<Verdict> out;
  for (Effect e : {SQUEEZE_FILM, SHEAR_FILM, ROLLING_FILM, TWISTING_FILM})
    out.push_back(judge_falling_film(s, n, e));
  if (s.friction == 0.0)
    out.push_back({FRICTION_LAW, NOT_NEEDED, "the coefficient is 0"});
  else
    out.push_back({FRICTION_LAW, CANNOT_TELL,
                   known(s.friction) ? "measured in shear only: keep it"
                                     : "give the coefficient: friction mu"});
  out.push_back(judge_falling_force(CRITICAL_LOAD, s.critical, n, "critical"));
  out.push_back(judge_falling_force(ADHESION, s.adhesion, n, "adhesion"));
  out.push_back(judge_falling_force(REPULSION, s.repulsion, n, "repulsion"));
  out.push_back(judge_falling_drag(s));
  out.push_back({INERTIA, CANNOT_TELL, "measured in shear only: keep it; St = " + show(n.St)});
  out.push_back(judge_roughness(s));
  if (known(n.stiffness))
    out.push_back(above(COMPLIANCE, n.stiffness, HARD, NOT_NEEDED, NEEDED));
  else
    out.push_back(
        {COMPLIANCE, CANNOT_TELL, "E/P unknown: no wall or plane below that carries all"});
  out.push_back(judge_falling_motion(s, n, BROWNIAN_MOTION));
  out.push_back(judge_falling_far(s));
  out.push_back(judge_falling_motion(s, n, FLUID_INERTIA_EFFECT));
  return out;
}

// what spoils the scene whatever effects are on
inline std::vector<std::string> settling_warnings(const Scene &s, const Settling &n)
{
  std::vector<std::string> out;
  if (s.viscosity > 0.0 && s.roughness > 0.0 && n.crushing < THRESHOLD[CRUSHED].value)
    out.push_back("asperities are crushed flat under the whole weight: " +
                  compare(n.crushing, CRUSHED) + "; raise the stiffness");
  if (s.viscosity > 0.0 && s.roughness > THRESHOLD[TALL].value)
    out.push_back("asperities make the particles larger: " + compare(s.roughness, TALL));
  warn_time_step(s.dt / s.dt_limit, out);
  return out;
}

}    // namespace LAMMPS_NS::Scene_NS

#endif
