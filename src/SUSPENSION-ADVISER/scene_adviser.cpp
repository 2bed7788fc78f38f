/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "scene_adviser.h"

#include "error.h"
#include "force.h"
#include "modify.h"
#include "suspension_input.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using Scene_NS::known;
using Scene_NS::UNKNOWN;

/* ---------------------------------------------------------------------- */

SceneAdviser::SceneAdviser(LAMMPS *lmp) : Pointers(lmp) {}

std::string SceneAdviser::advice(int narg, char **arg)
{
  read_particles();
  read_box();
  read_pair();
  read_flow();
  read_plates();
  read_gravity();
  parse(narg, arg);
  return report();
}

/* ---------------------------------------------------------------------- */

static constexpr unsigned EVERY_PAIR_STYLE = ~0U;

// own: effect without which the pair style does not have it, 0 for what is not of the pair style
struct SceneAdviser::Keyword {
  const char *name;
  double *value, unit;
  bool zero;
  unsigned own;
};

std::vector<SceneAdviser::Keyword> SceneAdviser::keywords()
{
  const double stress = 1.0 / force->nktv2p;    // LAMMPS' pressure to force/area
  return {{"viscosity", &scene.viscosity, 1.0, true, EVERY_PAIR_STYLE},
          {"rate", &scene.rate, 1.0, false, 0},
          {"pressure", &scene.pressure, stress, false, 0},
          {"stiffness", &scene.g, 1.0, false, EVERY_PAIR_STYLE},
          {"roughness", &scene.roughness, 1.0, true, EVERY_PAIR_STYLE},
          {"friction", &scene.friction, 1.0, true, EVERY_PAIR_STYLE},
          {"adhesion", &scene.adhesion, 1.0, true, Lubcontact_NS::ADHESION},
          {"repulsion", &scene.repulsion, 1.0, true, Lubcontact_NS::REPULSION},
          {"critical", &scene.critical, 1.0, true, Lubcontact_NS::THRESHOLD},
          {"temperature", &scene.thermal, force->boltz, true, 0},
          {"fluid_density", &scene.fluid_density, force->mvv2e, true, 0},
          {"tolerance", &tolerance, 1.0, false, 0}};
}

double SceneAdviser::number(char **arg, int iarg, const char *name, bool zero) const
{
  const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
  if (!(value >= 0.0) || (value == 0.0 && !zero))
    error->all(FLERR, iarg, "Suspension_scene {} must be {} 0, but is {}", name, zero ? ">=" : ">",
               arg[iarg]);
  return value;
}

/* ----------------------------------------------------------------------
   what the script says overrides what is found
------------------------------------------------------------------------- */

void SceneAdviser::take(const Keyword &keyword, int iarg, char **arg)
{
  const double value = number(arg, iarg + 1, keyword.name, keyword.zero) * keyword.unit;
  const bool has = pair && keyword.own &&
      (keyword.own == EVERY_PAIR_STYLE || (Scene_NS::used_effects(law) & keyword.own));
  if (has && value != *keyword.value)
    overridden += fmt::format(" {} {}", keyword.name, arg[iarg + 1]);
  *keyword.value = value;
  if (keyword.value == &scene.pressure) measured.used = false;
  if (keyword.value == &scene.critical) {    // of all contacts
    scene.critical_max = value;
    scene.rubs_always = scene.critical_law == Scene_NS::PLASTIC_LAW;
  }
  if (keyword.value == &tolerance && value >= 1.0)
    error->all(FLERR, iarg + 1,
               "Suspension_scene tolerance is a relative error and must be < 1, but is {}",
               arg[iarg + 1]);
}

void SceneAdviser::parse(int narg, char **arg)
{
  const std::vector<Keyword> all = keywords();
  for (int iarg = 0; iarg < narg; iarg += 2) {
    if (strcmp(arg[iarg], "brief") == 0) {
      brief = true;
      iarg--;
      continue;
    }
    const auto found = std::find_if(all.begin(), all.end(), [&](const Keyword &keyword) {
      return strcmp(arg[iarg], keyword.name) == 0;
    });
    if (found == all.end()) {
      std::string names = "measure, brief";
      for (const Keyword &keyword : all) names += std::string(", ") + keyword.name;
      error->all(FLERR, iarg, "Unknown suspension_scene keyword: {}; those that exist: {}",
                 arg[iarg], names);
    }
    Suspension_NS::require_words(FLERR, error, "suspension_scene", narg - iarg,
                                 std::string(arg[iarg]) + " value");
    take(*found, iarg, arg);
    const bool length = strcmp(found->name, "repulsion") == 0 && iarg + 2 < narg;
    if (length && utils::is_double(arg[iarg + 2])) {
      screening = number(arg, iarg + 2, "length of the repulsion", false);
      iarg++;
    }
  }
  if (brief && known(tolerance))
    error->all(FLERR,
               "Suspension_scene brief cannot act with tolerance, which prints its settings only: "
               "remove one of them");
}

/* ---------------------------------------------------------------------- */

bool SceneAdviser::overdamped() const
{
  return !modify->get_fix_by_style("^overdamped").empty();
}

/* ----------------------------------------------------------------------
   gravity and no shear: the laws of shear say nothing
------------------------------------------------------------------------- */

bool SceneAdviser::falls() const
{
  return !gravity.empty() && !known(scene.rate);
}
