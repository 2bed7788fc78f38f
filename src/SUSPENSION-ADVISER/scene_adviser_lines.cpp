/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene: the lines for the input script. They follow the verdicts: what is needed is on,
// what is not needed is left out, and said so; what is undecided stays as it is.

#include "scene_adviser.h"

#include "fix.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "scene_bounds.h"
#include "scene_words.h"
#include "suspension_host.h"

#include <cmath>

using namespace LAMMPS_NS;
using Scene_NS::known;
using Scene_NS::show;
using Scene_NS::Verdict;

/* ----------------------------------------------------------------------
   a fluid far from the contacts, if there is none yet: with the drag of isolated particles in it
------------------------------------------------------------------------- */

std::string SceneAdviser::fluid_line(const std::vector<Verdict> &verdicts) const
{
  if (!modify->get_fix_by_style("^hydro").empty()) return "";
  const bool walls = !modify->get_fix_by_style("^rheometer/plates").empty();
  if (verdicts[Scene_NS::FAR_HYDRODYNAMICS].answer != Scene_NS::NEEDED || walls || overdamped())
    return verdicts[Scene_NS::DRAG].answer == Scene_NS::NEEDED ? drag_line() : "";
  const auto drags = modify->get_fix_by_style("^drag/background");
  const std::string viscosity = viscosity_word();
  return fmt::format("  fix far all hydro mean{}{}\n",
                     viscosity == "pair" ? "" : " viscosity " + viscosity,
                     drags.empty() ? "" : fmt::format("  # instead of fix {}", drags[0]->id));
}

std::string SceneAdviser::viscosity_word() const
{
  return !pair || Suspension_NS::viscosity_of_pair(lmp) ? "pair" : pair->viscosity_word();
}

/* ----------------------------------------------------------------------
   a drag towards what moves the particles, if there is none yet
------------------------------------------------------------------------- */

std::string SceneAdviser::drag_line() const
{
  for (const char *there : {"^drag/background", "^overdamped"})
    if (!modify->get_fix_by_style(there).empty()) return "";
  const auto plates = modify->get_fix_by_style("^rheometer/plates");
  if (!plates.empty())
    return fmt::format("  fix drag {} drag/background pair plates {}\n",
                       group->names[plates.front()->igroup], plates.front()->id);
  return fmt::format("  fix drag all drag/background {} cell\n", viscosity_word());
}

/* ----------------------------------------------------------------------
   words of pair_coeff for the laws that are needed, but not in the pair style
------------------------------------------------------------------------- */

std::string SceneAdviser::law_words(const std::vector<Verdict> &verdicts) const
{
  const unsigned lacks = ~Scene_NS::used_effects(law);
  const unsigned needs = lacks & Scene_NS::with_answer(verdicts, Scene_NS::NEEDED);
  std::string words;
  const bool rubs =
      verdicts[Scene_NS::FRICTION_LAW].answer != Scene_NS::NOT_NEEDED && known(scene.friction);
  if (rubs && (needs & Lubcontact_NS::THRESHOLD))
    words += fmt::format(" friction clm step {} {}", scene.friction, scene.critical);
  else if (rubs && (lacks & Lubcontact_NS::FRICTION))
    words += fmt::format(" friction coulomb {}", scene.friction);
  const bool given = law.types > 0 && Scene_NS::is_given(law.of(1, 1));
  const double k = given ? law.of(1, 1).asperity : scene.g;
  if ((needs & Lubcontact_NS::ADHESION) && known(k))
    words += fmt::format(" adhesion {}", scene.adhesion / (k * scene.radius));
  if ((needs & Lubcontact_NS::REPULSION) && known(screening))
    words += fmt::format(" repulsion {} {}", scene.repulsion, screening);
  return words;
}

/* ----------------------------------------------------------------------
   heavier particles take longer steps; without squeeze film they shall not collide
------------------------------------------------------------------------- */

std::string SceneAdviser::room_for_inertia(bool squeeze) const
{
  const double St = Scene_NS::numbers(scene).St;
  const double limit = squeeze ? Scene_NS::THRESHOLD[Scene_NS::INERTIAL].value / 4.0
                               : Scene_NS::THRESHOLD[Scene_NS::SQUEEZE_INERTIA].value;
  const double room = limit / St;
  if (!(room > 1.5) || overdamped()) return "";
  return fmt::format("  # inertia does not show: density {} allows a step {} times larger\n",
                     show(room * scene.density / force->mvv2e), show(sqrt(room)));
}

/* ----------------------------------------------------------------------
   films that are needed are on, whatever the deck has
------------------------------------------------------------------------- */

std::string SceneAdviser::deck_lines(const std::vector<Verdict> &verdicts) const
{
  const Scene_NS::Scene &s = scene;
  if (!known(s.rate) && !known(s.pressure))
    return "No input lines: what may be left out was measured in shear; define the flow before "
           "this command, or give rate g\n";

  unsigned idle = Scene_NS::with_answer(verdicts, Scene_NS::NOT_NEEDED);
  if (law.settings.range == Lubcontact_NS::Range::RESIDUAL)    // films and far field are one
    idle &= ~Lubcontact_NS::all_films();
  const unsigned films = Lubcontact_NS::all_films() & ~law.settings.films &
      Scene_NS::with_answer(verdicts, Scene_NS::NEEDED);
  Lubcontact_NS::Law use = without(law, idle);
  use.settings.films |= films;

  std::string text = "Input lines to use\n";
  if (pair || known(s.viscosity))
    text +=
        Scene_NS::style_line(use, pair ? pair->viscosity_word() : fmt::format("{}", s.viscosity));
  if (films) text += "  # needed, but off so far: " + Scene_NS::effect_names(films, " ") + "\n";
  const std::string more = law_words(verdicts);
  if (pair)
    text +=
        Scene_NS::coeff_lines(use) + (more.empty() ? "" : "  # add to pair_coeff:" + more + "\n");
  else if (known(s.g) && known(s.roughness))
    text += fmt::format("  pair_coeff * * {0} {0} roughness {1}{2}\n", s.g, s.roughness, more);

  const unsigned gone = pair ? idle & Scene_NS::used_effects(law) : 0;
  if (gone)
    text +=
        "  # left out, not needed by the table above: " + Scene_NS::effect_names(gone, ", ") + "\n";

  text += fluid_line(verdicts);
  if (s.dt / s.dt_limit > Scene_NS::THRESHOLD[Scene_NS::STEP].value)
    text += fmt::format("  timestep {}\n", show(0.4 * s.dt_limit));
  if (verdicts[Scene_NS::INERTIA].answer == Scene_NS::NOT_NEEDED)
    text += room_for_inertia(use.settings.films & Lubcontact_NS::SQUEEZE);
  return text;
}
