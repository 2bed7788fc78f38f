/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene tolerance: settings for a tolerance of the viscosity, their error and cost.

#include "scene_adviser.h"

#include "force.h"
#include "pair_lubcontact.h"
#include "scene_accuracy.h"
#include "scene_bounds.h"
#include "scene_words.h"
#include "utils.h"

#include <cmath>

using namespace LAMMPS_NS;
using Scene_NS::known;
using Scene_NS::Numbers;
using Scene_NS::Plan;
using Scene_NS::show;

static constexpr auto MEASURED_RANGE = Lubcontact_NS::Range::CUT;
static constexpr double MEASURED_REACH = 0.5;
static constexpr double WIDE = 1.5;    // bounds of the pressure: the stiffness rests on it

static std::string percent(double x)
{
  return fmt::format("{:.2g} %", 100.0 * x);
}

/* ----------------------------------------------------------------------
   what the plan cannot do without; empty: all there
------------------------------------------------------------------------- */

static std::string missing(const Scene_NS::Scene &s, const Numbers &n, bool has_pair)
{
  if (s.dimension != 3.0) return "measured for spheres only";
  if (!(s.viscosity > 0.0)) return "measured in a fluid only: give its viscosity eta";
  if (!known(s.rate) || s.rate == 0.0) return "give the shear rate: rate g";
  if (!known(n.pressure)) return "give the pressure: pressure P";
  const Scene_NS::Bounds bounds = known(s.pressure) ? Scene_NS::Bounds{}
                                                    : Scene_NS::steady_pressure(s);
  if (bounds.high > WIDE * bounds.low)
    return "the pressure, on which the stiffness rests, is not known before a run: run first, or "
           "give it: pressure P";
  if (!(s.roughness > 0.0)) return "measured for rough particles only: give roughness eps";
  if (!has_pair || !known(s.dt_limit))
    return "the limit of the time step is unknown: define the pair style, and let particles have "
           "inertia "
           "(no fix overdamped/sphere)";
  return "";
}

/* ---------------------------------------------------------------------- */

std::string SceneAdviser::plan_text(const Plan &p) const
{
  const Scene_NS::Scene &s = scene;
  std::string text = fmt::format("  {:<27} {:>10} {:>10}\n", "source of error", "setting", "error");
  const std::string settings[] = {show(p.step), show(p.softness), show(p.St),
                                  fmt::format("{:.0f}", p.particles)};
  static constexpr const char *NAME[] = {"dt/limit", "P/(E eps)", "St", "N"};
  for (int c = 0; c < Scene_NS::NO_TWIST; c++)
    text += fmt::format("  {:<27} {:>10} {:>10}\n",
                        fmt::format("{}, {}", Scene_NS::CAUSE_NAME[c], NAME[c]), settings[c],
                        percent(p.change[c]));
  text += fmt::format("  {:<27} {:>10} {:>10}\n", "twisting film", p.twist ? "on" : "off",
                      percent(p.change[Scene_NS::NO_TWIST]));
  text +=
      fmt::format("  {:<27} {:>10} {:>10}\n", "standard error of the above", "", percent(p.doubt));
  text += fmt::format("  {:<27} {:>10} {:>10}\n", "scatter, strain averaged", show(p.strain),
                      percent(p.scatter));
  text +=
      fmt::format("  error bound: {} (sum of errors + 2 combined standard errors), {} expected\n",
                  percent(p.promised()), percent(std::hypot(p.expected(), p.scatter)));
  const double strain = Scene_NS::SETTLE + p.strain;
  text += fmt::format("  cost: {} CPU seconds of the benchmark's machine = {} per particle and "
                      "unit of strain x N {} x "
                      "strain {} ({} to settle)\n",
                      show(p.cost), show(p.cost / p.particles / strain), p.particles, show(strain),
                      Scene_NS::SETTLE);
  if (s.particles < 0.9 * p.particles)
    text += fmt::format("  more particles are needed: {} instead of {:.0f}\n", p.particles,
                        s.particles);
  return text;
}

/* ----------------------------------------------------------------------
   stiffer by a factor; the stiffnesses rounded, as everything that is proposed
------------------------------------------------------------------------- */

std::string SceneAdviser::stiffer_coeffs(double factor) const
{
  Lubcontact_NS::Law use = law;
  for (auto &c : use.rows) {
    if (!Scene_NS::is_given(c)) continue;
    c = Scene_NS::stiffer(c, factor);
    for (double *stiffness : {&c.g, &c.kt, &c.asperity}) *stiffness = Scene_NS::rounded(*stiffness);
  }
  return Scene_NS::coeff_lines(use);
}

/* ---------------------------------------------------------------------- */

std::string SceneAdviser::tolerance_lines() const
{
  Scene_NS::Scene s = scene;
  if (pair) s.g = Scene_NS::softest(law);    // the limit of the time step is that of the pair style
  const Numbers n = Scene_NS::numbers(s);
  std::string text = fmt::format("Settings for a viscosity within {} of the converged solution of "
                                 "this model\n",
                                 percent(tolerance));
  text += fmt::format(
      "  for {:.0f} particles, phi {}, roughness {}, friction {}, viscosity {}, rate {}, "
      "pressure {}\n",
      s.particles, show(s.phi), show(s.roughness), show(s.friction), show(s.viscosity),
      show(s.rate), describe_pressure());
  text += doubts_of_pressure();
  const std::string lack = missing(s, n, pair != nullptr);
  if (!lack.empty()) return text + "  cannot tell: " + lack + "\n";
  const Plan p = Scene_NS::plan(tolerance, s, n, s.dt_limit);
  if (!p.possible)
    return text +
        fmt::format("  cannot reach this tolerance: the smallest error bound is {}\n",
                    percent(Scene_NS::finest(s, n, s.dt_limit)));
  text += plan_text(p);
  for (const std::string &remark : Scene_NS::remarks(tolerance, s)) text += "  " + remark + "\n";
  const Lubcontact_NS::Settings &given = law.settings;
  if (given.range != MEASURED_RANGE || given.reach_a != MEASURED_REACH)
    text += "  measured with range cut 0.5, which is part of the model: errors and cost are "
            "estimates\n";

  const double stiffer = 1.0 / (p.softness * n.crushing), heavier = p.St / n.St;
  const double dt = p.step * s.dt_limit * std::sqrt(heavier / stiffer);
  text += "Input lines to use\n";
  text += fmt::format("  set group all density {:.4g}\n", heavier * s.density / force->mvv2e);
  text += Scene_NS::style_line(p.twist ? law : without(law, Lubcontact_NS::TWIST),
                               pair->viscosity_word()) +
      stiffer_coeffs(stiffer);
  text += fmt::format("  timestep {:.4g}\n", dt);
  auto steps = [&s, dt](double strain) {
    return std::ceil(strain / std::fabs(s.rate) / dt);
  };
  text += fmt::format("  run {:.0f}    # to settle\n", steps(Scene_NS::SETTLE));
  text += fmt::format("  run {:.0f}    # to average: tools/steady.py\n", steps(p.strain));
  return text;
}
