/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "suspension_scene.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "group.h"
#include "missing_argument.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "scene_verdict.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using scene::known;
using scene::Numbers;
using scene::show;
using scene::UNKNOWN;
using scene::Verdict;

/* ---------------------------------------------------------------------- */

SuspensionScene::SuspensionScene(LAMMPS *lmp) :
    Command(lmp), scene(new scene::Scene()), pair(nullptr), walls(false), limit_known(false),
    measured(false), total_mass(0.0), screening(UNKNOWN), tolerance(UNKNOWN)
{
}

SuspensionScene::~SuspensionScene() = default;

/* ----------------------------------------------------------------------
   suspension_scene keyword value ... | suspension_scene measure N keyword value ...
------------------------------------------------------------------------- */

void SuspensionScene::command(int narg, char **arg)
{
  if (!domain->box_exist || atom->natoms == 0)
    error->all(FLERR, "Suspension_scene needs particles: use it after they are created");
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR, "Suspension_scene needs finite-size spheres; use: atom_style sphere");
  if (narg > 0 && strcmp(arg[0], "measure") == 0) {
    measure(narg, arg);
    return;
  }
  read_particles();
  read_box();
  read_pair();
  read_flow();
  read_plates();
  parse(narg, arg);
  if (comm->me == 0) report();
}

/* ----------------------------------------------------------------------
   what the script says overrides what is found
------------------------------------------------------------------------- */

void SuspensionScene::parse(int narg, char **arg)
{
  const double stress = 1.0 / force->nktv2p;    // LAMMPS' pressure to force/area
  struct Keyword {
    const char *name;
    double *value, unit;
    bool zero;
  };
  const Keyword keywords[] = {
      {"viscosity", &scene->viscosity, 1.0, true},
      {"rate", &scene->rate, 1.0, false},
      {"pressure", &scene->pressure, stress, false},
      {"stiffness", &scene->g, 1.0, false},
      {"roughness", &scene->roughness, 1.0, true},
      {"friction", &scene->friction, 1.0, true},
      {"adhesion", &scene->adhesion, 1.0, true},
      {"repulsion", &scene->repulsion, 1.0, true},
      {"critical", &scene->critical, 1.0, true},
      {"temperature", &scene->thermal, force->boltz, true},
      {"fluid_density", &scene->fluid_density, force->mvv2e, true},
      {"tolerance", &tolerance, 1.0, false},
  };
  auto number = [&](int iarg, const char *name, bool zero) {
    const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
    if (!(value >= 0.0) || (value == 0.0 && !zero))
      error->all(FLERR, iarg, "Suspension_scene {} must be {} 0, but is {}", name,
                 zero ? ">=" : ">", arg[iarg]);
    return value;
  };
  for (int iarg = 0; iarg < narg; iarg += 2) {
    const Keyword *found = nullptr;
    for (const Keyword &keyword : keywords)
      if (strcmp(arg[iarg], keyword.name) == 0) found = &keyword;
    if (!found) {
      std::string names = "measure";
      for (const Keyword &keyword : keywords) names += std::string(", ") + keyword.name;
      error->all(FLERR, iarg, "Unknown suspension_scene keyword: {}; those that exist: {}",
                 arg[iarg], names);
    }
    require_words(FLERR, error, "suspension_scene", narg - iarg, std::string(arg[iarg]) + " value");
    const double value = number(iarg + 1, found->name, found->zero) * found->unit;
    const auto place = found - keywords;
    if (pair && (place == 0 || (place >= 3 && place <= 5)) && value != *found->value)
      overridden += fmt::format(" {} {}", found->name, arg[iarg + 1]);
    if (found->value == &scene->pressure) measured = false;
    if (found->value == &tolerance && value >= 1.0)
      error->all(FLERR, iarg + 1,
                 "Suspension_scene tolerance is a relative error and must be < 1, but is {}",
                 arg[iarg + 1]);
    *found->value = value;
    const bool length = strcmp(found->name, "repulsion") == 0 && iarg + 2 < narg;
    if (length && utils::is_double(arg[iarg + 2])) {
      screening = number(iarg + 2, "length of the repulsion", false);
      iarg++;
    }
  }
}

/* ---------------------------------------------------------------------- */

void SuspensionScene::report() const
{
  const Numbers n = scene::numbers(*scene);
  const std::vector<Verdict> verdicts = scene::judge(*scene, n);
  std::string text = describe(n) + "Which effects this scene calls for\n";
  for (const Verdict &v : verdicts)
    text += fmt::format("  {:<18} {:<20} {}\n", scene::EFFECT_NAME[v.effect],
                        scene::ANSWER_NAME[v.answer], v.why);
  for (const std::string &warning : scene::warnings(*scene, n))
    text += "  warning: " + warning + "\n";
  text += transient_warning();
  text += known(tolerance) ? tolerance_lines() : deck_lines(n, verdicts);
  if (pair && utils::strmatch(force->pair_style, "^hybrid"))
    text += "  # under pair_style hybrid: keep its other styles, and write lubcontact after the "
            "types of "
            "pair_coeff\n";
  if (pair && !overridden.empty())
    text += "  # for the scene with" + overridden + ", which the lines do not set\n";
  utils::logmesg(lmp, text);
}

/* ----------------------------------------------------------------------
   a measured pressure that is far from that of the steady flow is one of the start
------------------------------------------------------------------------- */

std::string SuspensionScene::transient_warning() const
{
  static constexpr double FAR = 3.0;
  if (!measured) return "";
  scene::Scene steady = *scene;
  steady.pressure = UNKNOWN;
  const double ratio = scene->pressure / scene::numbers(steady).pressure;
  if (!known(ratio) || (ratio < FAR && ratio > 1.0 / FAR)) return "";
  return fmt::format(
      "  warning: the measured pressure is {} times that of steady flow at this phi: run until it "
      "is steady, or give it: pressure P\n",
      show(ratio));
}

/* ---------------------------------------------------------------------- */

bool SuspensionScene::overdamped() const
{
  return !modify->get_fix_by_style("^overdamped").empty();
}

/* ---------------------------------------------------------------------- */

std::string SuspensionScene::describe(const Numbers &n) const
{
  const scene::Scene &s = *scene;
  const double unit = force->nktv2p;
  std::string text = "Suspension scene: what is there\n";
  text += fmt::format("  particles       {:.0f} {}, radius {} ({} to {}, spread {}), density {}\n",
                      s.particles, s.dimension == 2.0 ? "discs" : "spheres", show(s.radius),
                      show(s.radius_min), show(s.radius_max), show(s.spread),
                      show(s.density / force->mvv2e));
  text +=
      fmt::format("  box             phi {}, N {:.0f}, smallest periodic height {} diameters{}\n",
                  show(s.phi), s.particles, show(n.box), walls ? ", walls" : "");
  text += fmt::format("  material        stiffness {}, roughness {}, friction {}\n", show(s.g),
                      show(s.roughness), show(s.friction));
  text += fmt::format("  flow            viscosity {}, rate {}, pressure {}{}\n", show(s.viscosity),
                      show(s.rate), show(n.pressure * unit),
                      n.estimated ? " (estimated from phi)" : "");
  text += fmt::format("  time step       {}, {} of the stability limit {}{}\n", show(s.dt),
                      show(n.step), show(s.dt_limit),
                      !pair || limit_known ? ""
                          : overdamped()   ? " (fix overdamped/sphere has its own)"
                                           : " (estimated for 12 neighbors)");
  text += "Dimensionless numbers\n";
  const std::pair<const char *, double> table[] = {
      {"St = rho a^2 rate/eta", n.St},   {"Iv = eta rate/P", n.Iv},
      {"I = d rate sqrt(rho/P)", n.I},   {"Iv + I^2/10", n.K},
      {"Ca = eta rate/E", n.Ca},         {"E/P, E = g/a", n.stiffness},
      {"E eps/P", n.crushing},           {"Pe = 6 pi eta a^3 rate/kT", n.Pe},
      {"Re = rho_f a^2 rate/eta", n.Re}, {"phi/phi_m of the friction", s.phi / n.phi_jam}};
  for (const auto &row : table) text += fmt::format("  {:<26} {}\n", row.first, show(row.second));
  return text;
}

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
  const scene::Scene &s = *scene;
  auto lacks = [&](const char *effect) {
    return !pair || !pair->uses(effect);
  };
  auto needs = [&](scene::Effect law, const char *effect) {
    return verdicts[law].answer == scene::NEEDED && lacks(effect);
  };
  std::string words;
  const bool rubs = verdicts[scene::FRICTION_LAW].answer != scene::NOT_NEEDED && known(s.friction);
  if (rubs && needs(scene::CRITICAL_LOAD, "critical load"))
    words += fmt::format(" friction clm step {} {}", s.friction, s.critical);
  else if (rubs && lacks("friction"))
    words += fmt::format(" friction coulomb {}", s.friction);
  double k = s.g;
  if (pair && pair->setflag && pair->setflag[1][1]) {
    int dim;
    k = static_cast<double **>(pair->extract("asperity", dim))[1][1];
  }
  if (needs(scene::ADHESION, "adhesion") && known(k))
    words += fmt::format(" adhesion {}", s.adhesion / (k * s.radius));
  if (needs(scene::REPULSION, "repulsion") && known(screening))
    words += fmt::format(" repulsion {} {}", s.repulsion, screening);
  return words;
}

/* ---------------------------------------------------------------------- */

std::string SuspensionScene::deck_lines(const Numbers &n,
                                        const std::vector<Verdict> &verdicts) const
{
  const scene::Scene &s = *scene;
  auto answer = [&verdicts](scene::Effect effect) {
    return verdicts[effect].answer;
  };
  std::vector<std::string> idle;
  for (int m = scene::SQUEEZE_FILM; m <= scene::TWISTING_FILM; m++)
    if (answer(static_cast<scene::Effect>(m)) == scene::NOT_NEEDED)
      idle.push_back(PairLubcontact::EFFECTS[m]);

  std::string text = "Deck lines to use\n";
  if (pair)
    text += "  pair_style " + pair->settings_text(idle) + "\n";
  else if (known(s.viscosity)) {
    text += fmt::format("  pair_style lubcontact {} cut 0.5", s.viscosity);
    for (const auto &mode : idle) text += " " + mode + " no";
    text += "\n";
  }
  static constexpr scene::Effect LAWS[] = {scene::FRICTION_LAW, scene::CRITICAL_LOAD,
                                           scene::ADHESION, scene::REPULSION};
  std::vector<std::string> no_law;
  for (int m = 0; m < 4; m++)
    if (answer(LAWS[m]) == scene::NOT_NEEDED)
      no_law.push_back(PairLubcontact::EFFECTS[PairLubcontact::EFFECTS.size() - 4 + m]);
  const std::string more = law_words(verdicts);
  if (pair)
    text +=
        pair->coeff_lines(no_law) + (more.empty() ? "" : "  # add to pair_coeff:" + more + "\n");
  else if (known(s.g) && known(s.roughness))
    text += fmt::format("  pair_coeff * * {0} {0} roughness {1}{2}\n", s.g, s.roughness, more);
  if (answer(scene::DRAG) == scene::NEEDED) text += drag_line();
  if (n.step > scene::THRESHOLD[scene::STEP].value)
    text += fmt::format("  timestep {}\n", show(0.4 * s.dt_limit));
  if (answer(scene::INERTIA) == scene::NOT_NEEDED && known(n.St)) {
    const double room = 0.25 * scene::THRESHOLD[scene::INERTIAL].value / n.St;
    if (room > 1.5 && !overdamped())
      text += fmt::format("  # inertia does not show: density {} allows a step {} times larger\n",
                          show(room * s.density / force->mvv2e), show(sqrt(room)));
  }
  return text;
}
