/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene: the lines for the input script. They follow the verdicts: what is needed is on,
// what is not needed is left out, and said so; what is undecided stays as it is.

#include "suspension_scene.h"

#include "fix.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "scene_bounds.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using Scene_NS::known;
using Scene_NS::show;
using Scene_NS::Verdict;

namespace {

// effects as PairLubcontact calls them, in the order of its list: four films, four laws
constexpr Scene_NS::Effect OF_PAIR[] = {Scene_NS::SQUEEZE_FILM, Scene_NS::SHEAR_FILM,
                                        Scene_NS::ROLLING_FILM, Scene_NS::TWISTING_FILM,
                                        Scene_NS::FRICTION_LAW, Scene_NS::CRITICAL_LOAD,
                                        Scene_NS::ADHESION,     Scene_NS::REPULSION};
constexpr int FILMS = 4;

std::vector<std::string> with_answer(const std::vector<Verdict> &verdicts, Scene_NS::Answer answer)
{
  std::vector<std::string> names;
  for (std::size_t m = 0; m < std::size(OF_PAIR); m++)
    if (verdicts[OF_PAIR[m]].answer == answer) names.push_back(PairLubcontact::EFFECTS[m]);
  return names;
}

bool is_film(const std::string &name)
{
  const auto &all = PairLubcontact::EFFECTS;
  return std::find(all.begin(), all.begin() + FILMS, name) != all.begin() + FILMS;
}

}    // namespace

/* ----------------------------------------------------------------------
   a drag towards what moves the particles, if there is none yet
------------------------------------------------------------------------- */

std::string SuspensionScene::drag_line() const
{
  for (const char *there : {"^drag/background", "^overdamped"})
    if (!modify->get_fix_by_style(there).empty()) return "";
  const auto plates = modify->get_fix_by_style("^rheometer/plates");
  if (!plates.empty())
    return fmt::format("  fix drag {} drag/background pair plates {}\n",
                       group->names[plates.front()->igroup], plates.front()->id);
  std::string viscosity = "pair";
  if (pair) {    // a variable must be named
    const std::string settings = pair->settings_text({});
    const auto v = settings.find(" v_");
    if (v != std::string::npos)
      viscosity = settings.substr(v + 1, settings.find(' ', v + 1) - v - 1);
  }
  return fmt::format("  fix drag all drag/background {} cell\n", viscosity);
}

/* ----------------------------------------------------------------------
   words of pair_coeff for the laws that are needed, but not in the pair style
------------------------------------------------------------------------- */

std::string SuspensionScene::law_words(const std::vector<Verdict> &verdicts) const
{
  const Scene_NS::Scene &s = *scene;
  auto lacks = [&](const char *effect) {
    return !pair || !pair->uses(effect);
  };
  auto needs = [&](Scene_NS::Effect law, const char *effect) {
    return verdicts[law].answer == Scene_NS::NEEDED && lacks(effect);
  };
  std::string words;
  const bool rubs =
      verdicts[Scene_NS::FRICTION_LAW].answer != Scene_NS::NOT_NEEDED && known(s.friction);
  if (rubs && needs(Scene_NS::CRITICAL_LOAD, "critical load"))
    words += fmt::format(" friction clm step {} {}", s.friction, s.critical);
  else if (rubs && lacks("friction"))
    words += fmt::format(" friction coulomb {}", s.friction);
  double k = s.g;
  if (pair && pair->setflag && pair->setflag[1][1]) {
    int dim;
    k = static_cast<double **>(pair->extract("asperity", dim))[1][1];
  }
  if (needs(Scene_NS::ADHESION, "adhesion") && known(k))
    words += fmt::format(" adhesion {}", s.adhesion / (k * s.radius));
  if (needs(Scene_NS::REPULSION, "repulsion") && known(screening))
    words += fmt::format(" repulsion {} {}", s.repulsion, screening);
  return words;
}

/* ----------------------------------------------------------------------
   films that are needed are on, whatever the deck has
------------------------------------------------------------------------- */

std::string SuspensionScene::pair_line(const std::vector<Verdict> &verdicts,
                                       const std::vector<std::string> &idle) const
{
  std::string text, on;
  if (pair) {
    text = pair->settings_text(idle);
    for (const auto &name : with_answer(verdicts, Scene_NS::NEEDED)) {
      const std::string off = " " + name + " no";
      const auto place = text.find(off);
      if (!is_film(name) || place == std::string::npos) continue;
      text.erase(place, off.size());
      on += " " + name;
    }
  } else {
    text = fmt::format("lubcontact {} cut 0.5", scene->viscosity);
    for (const auto &name : idle)
      if (is_film(name)) text += " " + name + " no";
  }
  if (!on.empty()) on = "  # needed, but off so far:" + on + "\n";
  return "  pair_style " + text + "\n" + on;
}

/* ----------------------------------------------------------------------
   heavier particles take longer steps; without squeeze film they shall not collide
------------------------------------------------------------------------- */

std::string SuspensionScene::room_for_inertia(bool squeeze) const
{
  const double St = Scene_NS::numbers(*scene).St;
  const double limit = squeeze ? Scene_NS::THRESHOLD[Scene_NS::INERTIAL].value / 4.0
                               : Scene_NS::THRESHOLD[Scene_NS::SQUEEZE_INERTIA].value;
  const double room = limit / St;
  if (!(room > 1.5) || overdamped()) return "";
  return fmt::format("  # inertia does not show: density {} allows a step {} times larger\n",
                     show(room * scene->density / force->mvv2e), show(sqrt(room)));
}

/* ---------------------------------------------------------------------- */

std::string SuspensionScene::deck_lines(const std::vector<Verdict> &verdicts) const
{
  const Scene_NS::Scene &s = *scene;
  if (!known(s.rate) && !known(s.pressure))
    return "No deck lines: what may be left out was measured in shear; define the flow before "
           "this command, or give rate g\n";

  const std::vector<std::string> idle = with_answer(verdicts, Scene_NS::NOT_NEEDED);
  std::string text = "Deck lines to use\n", line;
  if (pair || known(s.viscosity)) line = pair_line(verdicts, idle);
  text += line;
  const std::string more = law_words(verdicts);
  if (pair)
    text += pair->coeff_lines(idle) + (more.empty() ? "" : "  # add to pair_coeff:" + more + "\n");
  else if (known(s.g) && known(s.roughness))
    text += fmt::format("  pair_coeff * * {0} {0} roughness {1}{2}\n", s.g, s.roughness, more);

  std::string gone;
  for (const auto &name : idle)
    if (pair && pair->uses(name)) gone += (gone.empty() ? " " : ", ") + name;
  if (!gone.empty()) text += "  # left out, not needed by the table above:" + gone + "\n";

  if (verdicts[Scene_NS::DRAG].answer == Scene_NS::NEEDED) text += drag_line();
  if (s.dt / s.dt_limit > Scene_NS::THRESHOLD[Scene_NS::STEP].value)
    text += fmt::format("  timestep {}\n", show(0.4 * s.dt_limit));
  if (verdicts[Scene_NS::INERTIA].answer == Scene_NS::NOT_NEEDED)
    text += room_for_inertia(line.find(" squeeze no") == std::string::npos);
  return text;
}
