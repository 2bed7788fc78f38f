/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Which effects does a scene need? One table of thresholds with their sources, one line of
// judgement per effect. The manual page suspension_scene quotes the table.

#ifndef SCENE_VERDICT_H
#define SCENE_VERDICT_H

#include "scene_numbers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS::Scene_NS {

enum Limit {
  DRY,
  FILM_SHARE,
  SQUEEZE_INERTIA,
  SQUEEZE_CROWDING,
  FRICTION_GAIN,
  CRITICAL_LOW,
  CRITICAL_HIGH,
  ADHESIVE,
  REPULSIVE,
  FAR_FIELD,
  DILUTE,
  INERTIAL,
  TALL,
  CRUSHED,
  HARD,
  BROWNIAN,
  FLUID_INERTIA,
  STEP,
  SMALL_BOX,
  NUM_LIMITS
};

struct Threshold {
  const char *number;
  double value;
  const char *source;
};

inline constexpr Threshold THRESHOLD[NUM_LIMITS] = {
    {"4 St/9", 500.0, "Joseph et al., J. Fluid Mech. 433, 329 (2001): rebound as if dry above"},
    {"Iv", 0.01, "tests/validation/mu_of_iv: films carry 8 % of the stress there, friction 0.5"},
    {"St", 0.05,
     "benchmarks/accuracy_cost: viscosity without it +5 +- 8 % at 0.05, -19 +- 15 % at 0.5 (phi "
     "0.54), "
     "-31 +- 4 % at 0.5 (phi 0.50)"},
    {"phi/phi_m", 0.94,
     "benchmarks/accuracy_cost: left out at phi 0.54, friction 0.5, not nearer to jamming"},
    {"gain", 0.1, "Chevremont et al., Phys. Rev. Fluids 4, 064302 (2019), eq. 13"},
    {"P a^2/F", 0.03,
     "examples/shear_thickening: 0 to 1 % of the contacts are frictional up to 0.03, 1 to 12 % at "
     "0.05"},
    {"P a^2/F", 3.0,
     "examples/shear_thickening: 91 to 93 % of the contacts are frictional at 1.5 to 1.8, "
     "97 to 98 % above 3"},
    {"F/(P d^2)", 0.3,
     "examples/yield_stress: stress +1 +- 8 % at 0.3, +11 +- 9 % at 0.5, +9 and +37 % at 0.9"},
    {"F/(P d^2)", 0.1,
     "tests/validation/repulsion: friction -1 +- 1 % at 0.1, -4 +- 1 % at 0.3, "
     "-16 +- 2 % at 1"},
    {"phi", 0.45,
     "tests/validation/far_field: films alone 40 % below grid at 0.30, 22 % at 0.40, "
     "12 % at 0.45, where they meet the law"},
    {"phi", 0.15,
     "tests/validation/far_field: level mean 1 % below grid at 0.10, 9 % at 0.20, 13 % "
     "at 0.30"},
    {"4 St", 2.0,
     "examples/shear_rate: no change up to St 0.5, and Tapia et al., Phys. Rev. Lett. 129, "
     "078001 (2022): transition at 10"},
    {"eps", 0.02,
     "examples/shear_rate: no change from 0.003 to 0.02 (accuracy_cost: +11 +- 4 %), viscosity "
     "doubled at "
     "0.05"},
    {"E eps/P", 50.0,
     "examples/shear_rate: no change at 70, viscosity +9 to +26 % at 24, +74 % at 2.4"},
    {"E/P", 1e4,
     "tests/validation/mu_of_iv: laws of hard spheres met, and da Cruz et al., Phys. Rev. E "
     "72, 021309 (2005)"},
    {"Pe", 1e3, "Foss and Brady, J. Fluid Mech. 407, 167 (2000)"},
    {"Re", 0.1, "Picano et al., Phys. Rev. Lett. 111, 098302 (2013)"},
    {"dt/limit", 0.5, "contacts become more numerous than at the start"},
    {"box/d", 8.0, "examples/shear_rate: viscosity +3 % with 500 particles, +12 % with 200"},
};

enum Answer { NEEDED, NOT_NEEDED, LIMITED, BEYOND, CANNOT_TELL };
inline constexpr const char *ANSWER_NAME[] = {"needed", "not needed", "accuracy limited",
                                              "beyond this package", "cannot tell"};

enum Effect {
  SQUEEZE_FILM,
  SHEAR_FILM,
  ROLLING_FILM,
  TWISTING_FILM,
  FRICTION_LAW,
  CRITICAL_LOAD,
  ADHESION,
  REPULSION,
  DRAG,
  INERTIA,
  ROUGHNESS,
  COMPLIANCE,
  BROWNIAN_MOTION,
  FAR_HYDRODYNAMICS,
  FLUID_INERTIA_EFFECT,
  NUM_EFFECTS
};
inline constexpr const char *EFFECT_NAME[NUM_EFFECTS] = {
    "squeeze film",     "shear film",        "rolling film",
    "twisting film",    "friction",          "critical load",
    "adhesion",         "repulsion",         "drag",
    "particle inertia", "roughness",         "elastic compliance",
    "Brownian motion",  "far hydrodynamics", "fluid inertia"};

struct Verdict {
  Effect effect;
  Answer answer;
  std::string why;
};

// "Iv = 0.02 > 0.01 [source]"
inline std::string compare(double x, Limit limit)
{
  const Threshold &t = THRESHOLD[limit];
  return std::string(t.number) + " = " + show(x) + (x > t.value ? " > " : " <= ") + show(t.value) +
      " [" + t.source + "]";
}

inline Verdict above(Effect e, double x, Limit limit, Answer if_above, Answer otherwise)
{
  return {e, x > THRESHOLD[limit].value ? if_above : otherwise, compare(x, limit)};
}

// the four films share what makes them idle
inline bool films_idle(const Scene &s, const Numbers &n, Effect e, std::vector<Verdict> &out)
{
  if (!known(s.viscosity))
    out.push_back({e, CANNOT_TELL, "give the viscosity of the fluid: viscosity eta"});
  else if (s.viscosity == 0.0)
    out.push_back({e, NOT_NEEDED, "dry: the viscosity is 0"});
  else if (4.0 / 9.0 * n.St > THRESHOLD[DRY].value)
    out.push_back({e, NOT_NEEDED, compare(4.0 / 9.0 * n.St, DRY)});
  else
    return false;
  return true;
}

inline bool all_slip(const Scene &s, const Numbers &n);
static constexpr double LEAST_FRICTION = 0.3;    // for which measurements with 0.5 stand

// Where films carry little, contacts take over what the squeeze film carried, but collisions are
// no longer damped: left out only where that was measured to change nothing.
inline Verdict judge_squeeze(const Scene &s, const Numbers &n)
{
  static constexpr Effect E = SQUEEZE_FILM;
  if (!known(n.Iv) || !known(n.St)) return {E, CANNOT_TELL, "Iv unknown: give rate and pressure"};
  if (n.Iv > THRESHOLD[FILM_SHARE].value) return {E, NEEDED, compare(n.Iv, FILM_SHARE)};
  if (s.dimension != 3.0 || !(s.friction >= LEAST_FRICTION) || all_slip(s, n))
    return {E, NEEDED, "leaving it out was measured for spheres with friction 0.5 only"};
  if (n.St > THRESHOLD[SQUEEZE_INERTIA].value) return {E, NEEDED, compare(n.St, SQUEEZE_INERTIA)};
  const double crowding =
      std::fmax(n.crowding, 1.0 / (1.0 + std::sqrt(n.Iv)));    // at rest, in flow
  if (!(crowding <= THRESHOLD[SQUEEZE_CROWDING].value))
    return {E, NEEDED, compare(crowding, SQUEEZE_CROWDING)};
  return {E, NOT_NEEDED, compare(n.Iv, FILM_SHARE) + "; " + compare(n.St, SQUEEZE_INERTIA)};
}

inline void judge_films(const Scene &s, const Numbers &n, std::vector<Verdict> &out)
{
  if (!films_idle(s, n, SQUEEZE_FILM, out)) out.push_back(judge_squeeze(s, n));
  if (!films_idle(s, n, SHEAR_FILM, out))
    out.push_back(
        {SHEAR_FILM, NEEDED, "viscosity 10 instead of 34 without, phi 0.5 [examples/shear_rate]"});
  if (!films_idle(s, n, ROLLING_FILM, out))
    out.push_back({ROLLING_FILM, NEEDED,
                   "viscosity 21 instead of 34 without, phi 0.5 [examples/shear_rate]"});
  if (!films_idle(s, n, TWISTING_FILM, out))
    out.push_back({TWISTING_FILM, NOT_NEEDED,
                   "viscosity 34 with and without, phi 0.5 [examples/shear_rate]"});
}

// no contact reaches its critical load
inline bool all_slip(const Scene &s, const Numbers &n)
{
  return s.critical > 0.0 && !s.rubs_always && s.critical_law != RAMP_LAW &&
      n.critical < THRESHOLD[CRITICAL_LOW].value;
}

inline Verdict judge_friction(const Scene &s, const Numbers &n)
{
  if (!known(s.friction)) return {FRICTION_LAW, CANNOT_TELL, "give the coefficient: friction mu"};
  if (s.friction == 0.0) return {FRICTION_LAW, NOT_NEEDED, "the coefficient is 0"};
  if (s.viscosity > 0.0 && s.roughness == 0.0)
    return {FRICTION_LAW, NOT_NEEDED, "smooth particles in a fluid never touch: roughness is 0"};
  if (all_slip(s, n))
    return {FRICTION_LAW, NOT_NEEDED,
            "no contact reaches its critical load: " + compare(n.critical, CRITICAL_LOW)};
  if (s.dimension != 3.0)
    return {FRICTION_LAW, NEEDED,
            "no law for discs is known that decides whether it can be left out"};
  return above(FRICTION_LAW, n.friction_gain, FRICTION_GAIN, NEEDED, NOT_NEEDED);
}

inline Verdict judge_critical(const Scene &s, const Numbers &n)
{
  if (!known(s.critical))
    return {CRITICAL_LOAD, CANNOT_TELL,
            "give the load below which contacts have no friction: critical F"};
  if (s.critical == 0.0) return {CRITICAL_LOAD, NOT_NEEDED, "the critical load is 0"};
  if (s.friction == 0.0) return {CRITICAL_LOAD, NOT_NEEDED, "without friction it cannot act"};
  if (!known(n.critical))
    return {CRITICAL_LOAD, CANNOT_TELL, "pressure unknown: give it or rate and viscosity"};
  if (all_slip(s, n))
    return {CRITICAL_LOAD, NOT_NEEDED,
            "no contact is frictional, use friction none: " + compare(n.critical, CRITICAL_LOW)};
  if (judge_friction(s, n).answer == NOT_NEEDED)
    return {CRITICAL_LOAD, NOT_NEEDED, "friction is not needed either"};
  if (s.critical_law != STEP_LAW)
    return {CRITICAL_LOAD, NEEDED,
            "P a^2/F = " + show(n.critical_min) +
                "; the laws shift, ramp and brizmer act at every load, where step does not"};
  return above(CRITICAL_LOAD, n.critical_min, CRITICAL_HIGH, NOT_NEEDED, NEEDED);
}

inline Verdict judge_force(Effect e, double force, double number, Limit limit, const char *keyword)
{
  if (!known(force))
    return {e, CANNOT_TELL, std::string("give the force of the surfaces: ") + keyword + " F"};
  if (force == 0.0) return {e, NOT_NEEDED, "the force is 0"};
  if (!known(number)) return {e, CANNOT_TELL, "pressure unknown: give it or rate and viscosity"};
  return above(e, number, limit, NEEDED, NOT_NEEDED);
}

// Measured in tests/validation/far_field with friction 0.5: by how much the viscosity is low at phi
// with films alone, as a fraction of that with the whole far field; the last value above
inline double missing_viscosity(double phi)
{
  static constexpr int NUM = 7;
  static constexpr double PHI[NUM] = {0.05, 0.1, 0.2, 0.3, 0.35, 0.4, 0.45};
  static constexpr double LOW[NUM] = {0.12, 0.23, 0.38, 0.40, 0.33, 0.22, 0.12};
  if (phi <= PHI[0]) return LOW[0] * phi / PHI[0];
  for (int m = 1; m < NUM; m++)
    if (phi <= PHI[m])
      return LOW[m - 1] + (LOW[m] - LOW[m - 1]) * (phi - PHI[m - 1]) / (PHI[m] - PHI[m - 1]);
  return LOW[NUM - 1];
}

// what the fluid does far from the contacts: decided without its volume fraction?
inline bool fluid_idle(const Scene &s, Effect e, Verdict &out)
{
  if (!known(s.viscosity))
    out = {e, CANNOT_TELL, "give the viscosity of the fluid: viscosity eta"};
  else if (s.viscosity == 0.0)
    out = {e, NOT_NEEDED, "dry: the viscosity is 0"};
  else if (s.dimension != 3.0)
    out = {e, CANNOT_TELL, "no measurement for discs; spheres need it below phi = 0.45"};
  else
    return false;
  return true;
}

inline Verdict judge_drag(const Scene &s)
{
  Verdict out;
  if (fluid_idle(s, DRAG, out)) return out;
  return {DRAG, s.phi < THRESHOLD[FAR_FIELD].value ? NEEDED : NOT_NEEDED,
          compare(s.phi, FAR_FIELD)};
}

inline Verdict judge_far(const Scene &s)
{
  static constexpr Effect E = FAR_HYDRODYNAMICS;
  Verdict out;
  if (fluid_idle(s, E, out)) return out;
  if (s.phi >= THRESHOLD[FAR_FIELD].value) return {E, NOT_NEEDED, compare(s.phi, FAR_FIELD)};
  return {E, NEEDED,
          "viscosity about " + show(100.0 * missing_viscosity(s.phi)) +
              " % low with films alone: " + compare(s.phi, FAR_FIELD) + "; fix hydro, level mean" +
              (s.phi < THRESHOLD[DILUTE].value ? "" : " or grid") + ": " + compare(s.phi, DILUTE)};
}

inline Verdict judge_inertia(const Scene &s, const Numbers &n)
{
  if (s.viscosity == 0.0) return {INERTIA, NEEDED, "dry: nothing else limits the motion"};
  if (!known(n.St)) return {INERTIA, CANNOT_TELL, "St unknown: give rate and viscosity"};
  return above(INERTIA, 4.0 * n.St, INERTIAL, NEEDED, NOT_NEEDED);
}

inline Verdict judge_roughness(const Scene &s)
{
  if (!known(s.viscosity) || !known(s.roughness))
    return {ROUGHNESS, CANNOT_TELL, "give viscosity eta and roughness eps"};
  if (s.viscosity == 0.0) return {ROUGHNESS, NOT_NEEDED, "dry: surfaces touch without asperities"};
  if (s.friction == 0.0)
    return {ROUGHNESS, NEEDED, "it sets the smallest gap, also without friction"};
  return {ROUGHNESS, NEEDED,
          "without asperities surfaces in a fluid never touch and have no friction"};
}

inline Verdict judge_compliance(const Numbers &n)
{
  if (!known(n.stiffness))
    return {COMPLIANCE, CANNOT_TELL, "E/P unknown: give stiffness and pressure, or rate"};
  return above(COMPLIANCE, n.stiffness, HARD, NOT_NEEDED, NEEDED);
}

inline Verdict judge_brownian(const Scene &s, const Numbers &n)
{
  if (s.thermal == 0.0) return {BROWNIAN_MOTION, NOT_NEEDED, "the temperature is 0"};
  if (!known(s.thermal)) return {BROWNIAN_MOTION, CANNOT_TELL, "give the temperature T"};
  if (s.viscosity == 0.0) return {BROWNIAN_MOTION, NOT_NEEDED, "dry: the viscosity is 0"};
  if (!known(n.Pe)) return {BROWNIAN_MOTION, CANNOT_TELL, "Pe unknown: give rate and viscosity"};
  return above(BROWNIAN_MOTION, n.Pe, BROWNIAN, NOT_NEEDED, BEYOND);
}

inline Verdict judge_fluid_inertia(const Scene &s, const Numbers &n)
{
  if (s.viscosity == 0.0) return {FLUID_INERTIA_EFFECT, NOT_NEEDED, "dry: the viscosity is 0"};
  if (!known(s.fluid_density))
    return {FLUID_INERTIA_EFFECT, CANNOT_TELL, "give the density of the fluid: fluid_density rho"};
  if (!known(n.Re))
    return {FLUID_INERTIA_EFFECT, CANNOT_TELL, "Re unknown: give rate and viscosity"};
  return above(FLUID_INERTIA_EFFECT, n.Re, FLUID_INERTIA, BEYOND, NOT_NEEDED);
}

// one verdict per effect, in the order of Effect
inline std::vector<Verdict> judge(const Scene &s, const Numbers &n)
{
  std::vector<Verdict> out;
  judge_films(s, n, out);
  out.push_back(judge_friction(s, n));
  out.push_back(judge_critical(s, n));
  out.push_back(judge_force(ADHESION, s.adhesion, n.adhesion, ADHESIVE, "adhesion"));
  out.push_back(judge_force(REPULSION, s.repulsion, n.repulsion, REPULSIVE, "repulsion"));
  out.push_back(judge_drag(s));
  out.push_back(judge_inertia(s, n));
  out.push_back(judge_roughness(s));
  out.push_back(judge_compliance(n));
  out.push_back(judge_brownian(s, n));
  out.push_back(judge_far(s));
  out.push_back(judge_fluid_inertia(s, n));
  return out;
}

inline void warn_time_step(double step, std::vector<std::string> &out)
{
  if (step > 1.0)
    out.push_back("the time step exceeds the stability limit: dt/limit = " + show(step));
  else if (step > THRESHOLD[STEP].value)
    out.push_back("the time step is near the stability limit: " + compare(step, STEP));
}

// what spoils the scene whatever effects are on
inline std::vector<std::string> warnings(const Scene &s, const Numbers &n)
{
  std::vector<std::string> out;
  if (s.viscosity > 0.0 && s.roughness > 0.0 && n.crushing < THRESHOLD[CRUSHED].value)
    out.push_back("asperities are crushed flat: " + compare(n.crushing, CRUSHED) +
                  "; raise the stiffness");
  if (s.viscosity > 0.0 && s.roughness > THRESHOLD[TALL].value)
    out.push_back("asperities make the particles larger: " + compare(s.roughness, TALL));
  warn_time_step(n.step, out);
  if (n.box < THRESHOLD[SMALL_BOX].value)
    out.push_back("the box is small: " + compare(n.box, SMALL_BOX));
  if (s.phi >= n.phi_jam)
    out.push_back("phi = " + show(s.phi) + " is above jamming at " + show(n.phi_jam) + " [" +
                  THRESHOLD[FRICTION_GAIN].source + "]: " +
                  (s.phi >= loosest_jamming(s)
                       ? "only soft particles flow"
                       : "it flows only if contacts slip or sizes pack densely"));
  return out;
}

}    // namespace LAMMPS_NS::Scene_NS

#endif
