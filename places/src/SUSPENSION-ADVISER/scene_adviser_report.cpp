/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene: what it prints, but for the lines of the input script.

#include "scene_adviser.h"

#include "force.h"
#include "modify.h"
#include "scene_bounds.h"
#include "scene_settling.h"
#include "utils.h"

#include <cmath>

using namespace LAMMPS_NS;
using Scene_NS::known;
using Scene_NS::Numbers;
using Scene_NS::show;
using Scene_NS::Verdict;

/* ---------------------------------------------------------------------- */

std::string SceneAdviser::report() const
{
  std::string text;
  if (known(tolerance))
    text = tolerance_lines();
  else if (falls())
    return advice_for_falling();
  else
    text = advice_for_shear();
  if (pair && utils::strmatch(force->pair_style, "^hybrid"))
    text += "  # under pair_style hybrid: keep its other styles, and write lubcontact after the "
            "types of pair_coeff\n";
  if (pair && !overridden.empty())
    text += "  # for the scene with" + overridden + ", which the lines do not set\n";
  return text;
}

/* ---------------------------------------------------------------------- */

static std::string as_lines(const std::vector<std::string> &warnings)
{
  std::string text;
  for (const std::string &warning : warnings) text += "  warning: " + warning + "\n";
  return text;
}

std::string SceneAdviser::advice_for_falling() const
{
  const Scene_NS::Settling fall = Scene_NS::settling(scene);
  return (brief ? "" : describe() + describe_settling(fall)) +
      table(Scene_NS::judge_settling(scene, fall)) +
      as_lines(Scene_NS::settling_warnings(scene, fall)) +
      "No input lines: the system is not sheared, and there are no measurements for other flows\n";
}

std::string SceneAdviser::advice_for_shear() const
{
  const auto verdicts = Scene_NS::judge_at_bounds(scene);
  std::string text = brief ? "" : describe() + describe_numbers();
  text += table(verdicts) + as_lines(Scene_NS::warnings_at_bounds(scene));
  if (!gravity.empty())
    text += "  warning: the numbers are those of the shear; what gravity does (" + gravity +
        ") is in none of them\n";
  return text + advice_on_pores() + doubts_of_pressure() + deck_lines(verdicts);
}

/* ---------------------------------------------------------------------- */

std::string SceneAdviser::table(const std::vector<Verdict> &verdicts) const
{
  std::string text = "Effects that this system needs\n";
  for (const Verdict &v : verdicts)
    text += fmt::format("  {:<18} {:<20} {}\n", Scene_NS::EFFECT_NAME[v.effect],
                        Scene_NS::ANSWER_NAME[v.answer], v.why);
  return text;
}

/* ----------------------------------------------------------------------
   the fluid of a layer between plates must flow when the layer dilates or settles
------------------------------------------------------------------------- */

std::string SceneAdviser::advice_on_pores() const
{
  const double Pi = Scene_NS::numbers(scene).Pi;
  if (!(Pi > Scene_NS::PORES_MATTER)) return "";
  const bool there = !modify->get_fix_by_style("^pore/pressure").empty();
  return fmt::format("  pores: Pi = {}, {}; steady flow does not depend on it\n", show(Pi),
                     there ? "the transients of the volume are those of the fluid in the pores"
                           : "in a transient the volume waits for the fluid in the pores: add fix "
                             "pore/pressure");
}

/* ----------------------------------------------------------------------
   is a measured pressure that of the steady flow?
------------------------------------------------------------------------- */

std::string SceneAdviser::doubts_of_pressure() const
{
  const Scene_NS::Scene &s = scene;
  const double unit = force->nktv2p;
  std::string text;
  if (!measured.used) return text;
  if (measured.strain < 1.0)
    text += fmt::format("  warning: the pressure is a mean over a strain of {} only; a packing "
                        "takes two units to flow steadily\n",
                        show(measured.strain));
  if (Scene_NS::still_changing(s, measured.first, measured.second, measured.strain))
    text += fmt::format("  warning: the pressure is not steady, {} and then {} in the two halves "
                        "of this strain: run on, or give it: pressure P\n",
                        show(measured.first * unit), show(measured.second * unit));
  const Scene_NS::Doubt doubt = Scene_NS::doubt_pressure(s, s.pressure);
  if (doubt.any)
    text += fmt::format("  warning: the measured pressure {} is far from that of steady flow at "
                        "this phi, {} to {}: run until it is steady, or give it: pressure P\n",
                        show(s.pressure * unit), show(doubt.steady.low * unit),
                        show(doubt.steady.high * unit));
  return text;
}

/* ---------------------------------------------------------------------- */

std::string SceneAdviser::describe_pressure() const
{
  const auto numbers = Scene_NS::numbers_at_bounds(scene);
  const double unit = force->nktv2p, low = numbers.front().pressure, high = numbers.back().pressure;
  std::string text = show(low * unit);
  if (low < high)
    text += fmt::format(" to {} (estimated from phi; run to obtain the value)", show(high * unit));
  else if (numbers.front().estimated)
    text += " (estimated from phi)";
  else if (measured.used)
    text += fmt::format(" (mean over a strain of {}; single values scatter by {})",
                        show(measured.strain), show(measured.deviation * unit));
  if (!measured.used && measured.strain > 0.0 && numbers.front().estimated)
    text +=
        fmt::format("; measured over a strain of {}, too short for a mean", show(measured.strain));
  return text;
}

/* ---------------------------------------------------------------------- */

std::string SceneAdviser::describe() const
{
  const Scene_NS::Scene &s = scene;
  std::string text = "Suspension scene: what is there\n";
  text += fmt::format("  particles       {:.0f} {}, radius {} ({} to {}, spread {}), density {}\n",
                      s.particles, s.dimension == 2.0 ? "discs" : "spheres", show(s.radius),
                      show(s.radius_min), show(s.radius_max), show(s.spread),
                      show(s.density / force->mvv2e));
  text += fmt::format("  box             phi {}{}, N {:.0f}, smallest periodic height {} "
                      "diameters{}\n",
                      show(s.phi), falls() ? " of the whole box" : "", s.particles,
                      show(s.box / (2.0 * s.radius)), walls ? ", walls" : "");
  text += fmt::format("  material        stiffness {}, roughness {}, friction {}\n", show(s.g),
                      show(s.roughness), show(s.friction));
  if (falls())
    text += fmt::format("  no flow         viscosity {}, gravity {} ({})\n", show(s.viscosity),
                        show(s.gravity), gravity);
  else
    text += fmt::format("  flow            viscosity {}, rate {}, pressure {}\n", show(s.viscosity),
                        show(s.rate), describe_pressure());
  text += fmt::format("  time step       {}, {} of the stability limit {}{}\n", show(s.dt),
                      show(s.dt / s.dt_limit), show(s.dt_limit),
                      !pair || limit_known ? ""
                          : overdamped()   ? " (fix overdamped/sphere has its own)"
                                           : " (estimated for 12 neighbors)");
  return text;
}

/* ---------------------------------------------------------------------- */

std::string SceneAdviser::describe_numbers() const
{
  const auto n = Scene_NS::numbers_at_bounds(scene);
  const std::pair<const char *, double Numbers::*> rows[] = {
      {"St = rho a^2 rate/eta", &Numbers::St},   {"Iv = eta rate/P", &Numbers::Iv},
      {"I = d rate sqrt(rho/P)", &Numbers::I},   {"Iv + I^2/10", &Numbers::K},
      {"Ca = eta rate/E", &Numbers::Ca},         {"E/P, E = g/a", &Numbers::stiffness},
      {"E eps/P", &Numbers::crushing},           {"Pe = 6 pi eta a^3 rate/kT", &Numbers::Pe},
      {"Re = rho_f a^2 rate/eta", &Numbers::Re}, {"phi/phi_m of the friction", &Numbers::crowding}};
  std::string text = "Dimensionless numbers\n";
  for (const auto &row : rows)
    text += fmt::format("  {:<26} {}\n", row.first, Scene_NS::show(n, row.second));
  if (known(scene.height))
    text += fmt::format("  {:<26} {}\n", "Pi = Iv H^2/k", Scene_NS::show(n, &Numbers::Pi));
  return text;
}

/* ---------------------------------------------------------------------- */

std::string SceneAdviser::describe_settling(const Scene_NS::Settling &n) const
{
  std::string text = "A sphere of the mean radius that falls\n";
  const std::pair<const char *, double> rows[] = {
      {"Stokes' velocity m g/6 pi eta a", n.velocity},
      {"with buoyancy in the fluid", n.velocity * n.buoyant},
      {"time until then m/6 pi eta a", n.time},
      {"St = rho a v/eta", n.St},
      {"Re = rho_f a v/eta", n.Re},
      {"Pe = m g a/kT", n.Pe},
      {"E/P under the whole weight", n.stiffness},
      {"E eps/P", n.crushing}};
  for (const auto &row : rows) text += fmt::format("  {:<31} {}\n", row.first, show(row.second));
  return text;
}
