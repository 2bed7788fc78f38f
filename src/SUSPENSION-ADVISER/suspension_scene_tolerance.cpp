/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene tolerance: settings for a tolerance of the viscosity, their error and cost.

#include "suspension_scene.h"

#include "atom.h"
#include "force.h"
#include "pair_lubcontact.h"
#include "scene_accuracy.h"
#include "scene_bounds.h"
#include "utils.h"

#include <cmath>

using namespace LAMMPS_NS;
using Scene_NS::known;
using Scene_NS::Numbers;
using Scene_NS::Plan;
using Scene_NS::show;

static constexpr double WIDE = 1.5;    // bounds of the pressure: the stiffness rests on it

static std::string percent(double x)
{
  return fmt::format("{:.2g} %", 100.0 * x);
}

/* ----------------------------------------------------------------------
   what the plan cannot do without; empty: all there
------------------------------------------------------------------------- */

static std::string missing(const Scene_NS::Scene &s, const Numbers &n, const Pair *pair)
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
  if (!pair || !known(s.dt_limit))
    return "the limit of the time step is unknown: define the pair style, and let particles have "
           "inertia "
           "(no fix overdamped/sphere)";
  return "";
}

/* ---------------------------------------------------------------------- */

std::string SuspensionScene::plan_text(const Plan &p) const
{
  const Scene_NS::Scene &s = *scene;
  std::string text = fmt::format("  {:<26} {:>10} {:>10}\n", "source of error", "setting", "error");
  const std::string settings[] = {show(p.step), show(p.softness), show(p.St),
                                  fmt::format("{:.0f}", p.particles)};
  static constexpr const char *NAME[] = {"dt/limit", "P/(E eps)", "St", "N"};
  for (int c = 0; c < Scene_NS::NO_TWIST; c++)
    text += fmt::format("  {:<26} {:>10} {:>10}\n",
                        fmt::format("{}, {}", Scene_NS::CAUSE_NAME[c], NAME[c]), settings[c],
                        percent(p.change[c]));
  text += fmt::format("  {:<26} {:>10} {:>10}\n", "twisting film", p.twist ? "on" : "off",
                      percent(p.change[Scene_NS::NO_TWIST]));
  text += fmt::format("  {:<26} {:>10} {:>10}\n", "doubt of the above", "", percent(p.doubt));
  text += fmt::format("  {:<26} {:>10} {:>10}\n", "scatter, strain averaged", show(p.strain),
                      percent(p.scatter));
  text += fmt::format("  promised: {} (sum of the errors, twice doubt and scatter), {} expected\n",
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

static double softest(Pair *pair, int ntypes)
{
  int dim;
  const auto *const *g = static_cast<double **>(pair->extract("g", dim));
  double least = Scene_NS::UNKNOWN;
  for (int i = 1; i <= ntypes; i++)
    for (int j = i; j <= ntypes; j++)
      if (pair->setflag[i][j]) least = known(least) ? MIN(least, g[i][j]) : g[i][j];
  return least;
}

/* ----------------------------------------------------------------------
   stiffer by a factor: all springs alike
------------------------------------------------------------------------- */

std::string SuspensionScene::stiffer_coeffs(double factor) const
{
  int dim;
  const auto *const *g = static_cast<double **>(pair->extract("g", dim));
  const auto *const *kt = static_cast<double **>(pair->extract("kt", dim));
  const auto *const *k = static_cast<double **>(pair->extract("asperity", dim));
  std::string text;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!pair->setflag[i][j]) continue;
      const std::string words = pair->coeff_words(i, j, {});
      text +=
          fmt::format("  pair_coeff {} {:.4g} {:.4g} asperity {:.4g} {}\n",
                      atom->ntypes > 1 ? fmt::format("{} {}", i, j) : "* *", factor * g[i][j],
                      factor * kt[i][j], factor * k[i][j], words.substr(words.find("roughness")));
    }
  return text;
}

/* ---------------------------------------------------------------------- */

std::string SuspensionScene::tolerance_lines() const
{
  Scene_NS::Scene s = *scene;
  if (pair)
    s.g = softest(pair, atom->ntypes);    // the limit of the time step is that of the pair style
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
  const std::string lack = missing(s, n, pair);
  if (!lack.empty()) return text + "  cannot tell: " + lack + "\n";
  const Plan p = Scene_NS::plan(tolerance, s, n, s.dt_limit);
  if (!p.possible)
    return text +
        fmt::format("  cannot promise it: what was measured is good for {} at best\n",
                    percent(Scene_NS::finest(s, n, s.dt_limit)));
  text += plan_text(p);
  for (const std::string &remark : Scene_NS::remarks(tolerance, s)) text += "  " + remark + "\n";
  if ((pair->settings_text({}) + " ").find(" cut 0.5 ") == std::string::npos)
    text += "  measured with range cut 0.5, which is part of the model: errors and cost are "
            "estimates\n";

  const double stiffer = 1.0 / (p.softness * n.crushing), heavier = p.St / n.St;
  const double dt = p.step * s.dt_limit * std::sqrt(heavier / stiffer);
  text += "Deck lines to use\n";
  text += fmt::format("  set group all density {:.4g}\n", heavier * s.density / force->mvv2e);
  std::vector<std::string> without;
  if (!p.twist) without.push_back("twist");
  text += "  pair_style " + pair->settings_text(without) + "\n" + stiffer_coeffs(stiffer);
  text += fmt::format("  timestep {:.4g}\n", dt);
  auto steps = [&s, dt](double strain) {
    return std::ceil(strain / std::fabs(s.rate) / dt);
  };
  text += fmt::format("  run {:.0f}    # to settle\n", steps(Scene_NS::SETTLE));
  text += fmt::format("  run {:.0f}    # to average: tools/steady.py\n", steps(p.strain));
  return text;
}
