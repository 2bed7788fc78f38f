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
#include "fix_deform_rheometer.h"
#include "force.h"
#include "group.h"
#include "math_const.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "rheometer_target.h"
#include "scene_instance.h"
#include "scene_verdict.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using MathConst::MY_PI;
using scene::known;
using scene::Numbers;
using scene::show;
using scene::UNKNOWN;
using scene::Verdict;

static constexpr double MANY = 12.0;       // neighbors of a crowded particle
static constexpr double AT_REST = 1e-3;    // of viscosity*rate: less is no flow

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
    if (iarg + 1 >= narg)
      utils::missing_cmd_args(FLERR, fmt::format("suspension_scene {}", arg[iarg]), error);
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

void SuspensionScene::read_particles()
{
  const bool discs = domain->dimension == 2;
  double mine[6] = {}, sum[6];    // number, radii, their squares, volume, area or volume, mass
  double mine_max[2] = {-HUGE_VAL, -HUGE_VAL}, max[2];
  for (int i = 0; i < atom->nlocal; i++) {
    const double r = atom->radius[i];
    if (r == 0.0) continue;
    const double volume = 4.0 / 3.0 * MY_PI * r * r * r;
    const double values[6] = {1.0,           r, r * r, volume, discs ? MY_PI * r * r : volume,
                              atom->rmass[i]};
    for (int n = 0; n < 6; n++) mine[n] += values[n];
    mine_max[0] = MAX(mine_max[0], r);
    mine_max[1] = MAX(mine_max[1], -r);
  }
  MPI_Allreduce(mine, sum, 6, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(mine_max, max, 2, MPI_DOUBLE, MPI_MAX, world);
  if (sum[0] == 0.0) error->all(FLERR, "Suspension_scene: no particle has a radius");

  scene->particles = sum[0];
  scene->dimension = domain->dimension;
  scene->radius = sum[1] / sum[0];
  scene->radius_max = max[0];
  scene->radius_min = -max[1];
  const double square = sum[2] / sum[0] - scene->radius * scene->radius;
  scene->spread = sqrt(MAX(square, 0.0)) / scene->radius;
  scene->density = sum[5] / sum[3] * force->mvv2e;
  total_mass = sum[5];
  scene->phi = sum[4] / (domain->xprd * domain->yprd * (discs ? 1.0 : domain->zprd));
  scene->dt = update->dt;
}

/* ---------------------------------------------------------------------- */

void SuspensionScene::read_box()
{
  const double *hi = domain->h_inv;
  const double height[3] = {1.0 / sqrt(hi[0] * hi[0] + hi[5] * hi[5] + hi[4] * hi[4]),
                            1.0 / sqrt(hi[1] * hi[1] + hi[3] * hi[3]), 1.0 / hi[2]};
  for (int d = 0; d < domain->dimension; d++) {
    if (domain->periodicity[d])
      scene->box = known(scene->box) ? MIN(scene->box, height[d]) : height[d];
    else
      walls = true;
  }
}

/* ----------------------------------------------------------------------
   of several types the softest, the smoothest and the roughest
------------------------------------------------------------------------- */

void SuspensionScene::read_pair()
{
  pair = dynamic_cast<PairLubcontact *>(find_lubcontact(lmp));
  if (!pair) return;
  scene->viscosity = pair->viscosity();
  int dim;
  const auto *const *g = static_cast<double **>(pair->extract("g", dim));
  const auto *const *kt = static_cast<double **>(pair->extract("kt", dim));
  const auto *const *roughness = static_cast<double **>(pair->extract("roughness", dim));
  const auto *const *friction = static_cast<double **>(pair->extract("friction", dim));
  double stiffest = 0.0;
  auto less = [](double a, double b) {
    return !known(a) || b < a ? b : a;
  };
  for (int i = 1; g && i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!pair->setflag[i][j]) continue;
      scene->g = less(scene->g, g[i][j]);
      scene->roughness = less(scene->roughness, roughness[i][j]);
      scene->friction = -less(-scene->friction, -friction[i][j]);
      stiffest = MAX(stiffest, MAX(g[i][j], 3.5 * kt[i][j]));
      const auto forces = pair->surface_forces(i, j, scene->radius);
      if (forces.critical > 0.0) scene->critical = less(scene->critical, forces.critical);
      if (forces.pull_off > 0.0) scene->adhesion = -less(-scene->adhesion, -forces.pull_off);
      if (forces.repulsion > 0.0) scene->repulsion = -less(-scene->repulsion, -forces.repulsion);
    }
  limit_known = pair->dt_limit > 0.0 && std::isfinite(pair->dt_limit);
  if (limit_known) {    // masses may have changed since
    scene->dt_limit = pair->dt_limit * sqrt(total_mass / pair->dt_limit_mass);
  } else if (overdamped()) {
    scene->dt_limit = UNKNOWN;
  } else if (stiffest > 0.0) {
    const double r = scene->radius_min;
    const double mass = 4.0 / 3.0 * MY_PI * r * r * r * scene->density;
    scene->dt_limit = 2.0 / sqrt(2.0 * MANY * stiffest / mass);
  }
}

/* ---------------------------------------------------------------------- */

void SuspensionScene::read_flow()
{
  const double stress = 1.0 / force->nktv2p;
  for (const auto &fix : modify->get_fix_by_style("^deform/rheometer$")) {
    const auto *rheometer = dynamic_cast<FixDeformRheometer *>(fix);
    const auto now = rheometer->imposed();
    scene->pressure = now.pressure * stress;
    measured = rheometer->settings_text().find(" pressure ") == std::string::npos;
    scene->rate = known(now.rate) ? now.rate : now.iv * scene->pressure / scene->viscosity;
    // particles at rest that just touch: this is not the pressure of the flow
    if (scene->pressure < AT_REST * scene->viscosity * fabs(scene->rate)) scene->pressure = UNKNOWN;
    return;
  }
  const double rate = SceneInstance::deform_rate(lmp);
  if (rate != 0.0) scene->rate = rate;
}

/* ----------------------------------------------------------------------
   values of the last run
------------------------------------------------------------------------- */

void SuspensionScene::read_plates()
{
  enum { RATE = 1, PHI = 5, LOWER = 6, UPPER = 7, TARGET = 13 };
  const double stress = 1.0 / force->nktv2p;
  for (const auto &fix : modify->get_fix_by_style("^rheometer/plates$")) {
    walls = true;
    if (fix->compute_vector(PHI) > 0.0) scene->phi = fix->compute_vector(PHI);
    if (fix->compute_vector(RATE) != 0.0) scene->rate = fix->compute_vector(RATE);
    const double measured = 0.5 * (fix->compute_vector(LOWER) + fix->compute_vector(UPPER));
    const double target = fix->compute_vector(TARGET);
    const double p = target > 0.0 ? target : measured;
    if (p > 0.0) scene->pressure = p * stress;
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
