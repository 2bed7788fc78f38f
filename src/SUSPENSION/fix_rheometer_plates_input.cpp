/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Arguments of fix rheometer/plates.

#include "fix_rheometer_plates.h"

#include "atom.h"
#include "error.h"
#include "group.h"
#include "input.h"
#include "list_keeper.h"
#include "rheometer_plate.h"
#include "suspension_host.h"
#include "suspension_input.h"

#include <cmath>
#include <map>

using namespace LAMMPS_NS;
using Rheometer_NS::LOWER;
using Rheometer_NS::UPPER;

// values of each keyword
static const std::map<std::string, std::string> KEYWORDS = {
    {"rate", "g"},        {"velocity", "v"},
    {"stress", "s"},      {"oscillate", "g0 g1 w"},
    {"iv", "v"},          {"gap", ""},
    {"pressure", "P"},    {"load", "P"},
    {"mass", "m"},        {"damper", "c"},
    {"drag", "c"},        {"gain", "K"},
    {"viscosity", "eta"}, {"lists", "affine|lammps"}};

// where each keyword of one command stands
struct FixRheometerPlates::Places : std::map<std::string, int> {};

/* ----------------------------------------------------------------------
   fix ID group rheometer/plates lower upper keyword value ...
------------------------------------------------------------------------- */

FixRheometerPlates::FixRheometerPlates(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), igroup_plate{0, 0}, bit{0, 0}, drive(RATE), load(GAP), frequency(0.0),
    own_viscosity(false), mass(0.0), damper_x(0.0), damper_y(0.0), gain(1.0),
    keeper(new ListKeeper(lmp, this)), force_on{}, own(lmp), pair_eta(nullptr)
{
  force_reneighbor = 1;
  next_reneighbor = -1;
  Suspension_NS::require_words(FLERR, error, "fix rheometer/plates", narg + 1,
                               "fix ID group rheometer/plates lower upper ...");
  Suspension_NS::require_spheres(lmp, "Fix rheometer/plates");
  for (int plate : {LOWER, UPPER}) {
    plate_name[plate] = arg[3 + plate];
    find_plate(plate, 3 + plate);
  }
  if (igroup_plate[LOWER] == igroup_plate[UPPER])
    error->all(FLERR, 4, "Fix rheometer/plates needs two plates, but both are group {}", arg[4]);
  const int end = parse(narg, arg, 5);
  if (end < narg) error->all(FLERR, end, "Unknown fix rheometer/plates keyword: {}", arg[end]);

  dynamic_group_allow = 1;
  restart_global = 1;
  vector_flag = 1;
  size_vector = Output::MEANS + Rheometer_NS::MEAN_OUTPUTS;
  global_freq = 1;
  extvector = 0;
}

FixRheometerPlates::~FixRheometerPlates() = default;

/* ----------------------------------------------------------------------
   again in each run: a group may have been deleted, or made dynamic
------------------------------------------------------------------------- */

void FixRheometerPlates::find_plate(int plate, int iarg)
{
  const std::string &name = plate_name[plate];
  const int found = group->find(name);
  if (found < 0)
    error->all(FLERR, iarg, "Group {} of the {} plate of fix rheometer/plates does not exist", name,
               PLATE_NAME[plate]);
  if (group->dynamic[found])
    error->all(FLERR, iarg, "Group {} of fix rheometer/plates must not be dynamic", name);
  igroup_plate[plate] = found;
  bit[plate] = group->bitmask[found];
}

/* ----------------------------------------------------------------------
   index for the error message, which underlines words of the whole command
------------------------------------------------------------------------- */

int FixRheometerPlates::place(char **arg, int iarg) const
{
  for (int n = 0; n < input->narg; n++)
    if (input->arg[n] == arg[iarg]) return n;
  return Error::NOLASTLINE;
}

/* ----------------------------------------------------------------------
   keywords from arg[iarg] on; returns the index of the first word that is none
------------------------------------------------------------------------- */

int FixRheometerPlates::parse(int narg, char **arg, int iarg)
{
  Places places;
  while (iarg < narg) {
    const std::string key = arg[iarg];
    const auto known = KEYWORDS.find(key);
    if (known == KEYWORDS.end()) break;
    Suspension_NS::require_words(FLERR, error, "fix rheometer/plates", narg - iarg,
                                 key + " " + known->second);
    if (places.count(key))
      error->all(FLERR, place(arg, iarg), "Fix rheometer/plates {} is given twice", key);
    places[key] = iarg;
    for (int n = 0; n < 5; n++)
      if (key == DRIVE_NAME[n]) parse_drive(n, arg, iarg);
    for (int n = 0; n < 3; n++)
      if (key == LOAD_NAME[n]) parse_load(n, arg, iarg);
    parse_number(key, arg, iarg);
    iarg += 1 + static_cast<int>(utils::count_words(known->second));
  }
  check_combination(places, arg);
  return iarg;
}

/* ----------------------------------------------------------------------
   new targets: nothing of the old ones is held against them
------------------------------------------------------------------------- */

void FixRheometerPlates::start_drive()
{
  state.clock = 0.0;    // of the oscillation
  state.means = {};
  state.deviation_x = state.age_x = state.warned_x = 0.0;
}

void FixRheometerPlates::start_load(bool same)
{
  // the servo goes on with the motion that the plate has
  if (load == PRESSURE && !same) state.dilation = state.gap == 0.0 ? 0.0 : state.vy / state.gap;
  state.deviation_y = state.age_y = state.warned_y = 0.0;
  state.means = {};
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::parse_drive(int n, char **arg, int iarg)
{
  drive = static_cast<Drive>(n);
  target_x = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
  start_drive();
  if (drive == IV && target_x.is_number() && target_x.value < 0.0)
    error->all(FLERR, place(arg, iarg + 1), "Fix rheometer/plates iv must be >= 0, but is {}",
               arg[iarg + 1]);
  if (drive != OSCILLATE) return;
  amplitude = Suspension_NS::InputNumber(lmp, arg[iarg + 2]);
  frequency = utils::numeric(FLERR, arg[iarg + 3], false, lmp);
  if (frequency <= 0.0)
    error->all(FLERR, place(arg, iarg + 3),
               "Fix rheometer/plates oscillate needs a frequency > 0, but it is {}", arg[iarg + 3]);
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::parse_load(int n, char **arg, int iarg)
{
  const bool same = load == n;
  load = static_cast<Load>(n);
  start_load(same);
  if (load == GAP) return;
  target_y = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
  if (load == PRESSURE && target_y.is_number() && target_y.value <= 0.0)
    error->all(FLERR, place(arg, iarg + 1), "Fix rheometer/plates pressure must be > 0, but is {}",
               arg[iarg + 1]);
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::parse_number(const std::string &key, char **arg, int iarg)
{
  if (key == "viscosity") {
    viscosity = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
    own_viscosity = true;
    if (viscosity.value < 0.0)
      error->all(FLERR, place(arg, iarg + 1),
                 "Fix rheometer/plates viscosity must be >= 0, but is {}", arg[iarg + 1]);
    return;
  }
  if (key == "lists") {
    const std::string word = arg[iarg + 1];
    if (word != "affine" && word != "lammps")
      error->all(FLERR, place(arg, iarg + 1),
                 "Fix rheometer/plates lists must be affine or lammps, but is {}", word);
    keeper->on = word == "affine";
    return;
  }
  double *number = nullptr;
  if (key == "mass") number = &mass;
  if (key == "gain") number = &gain;
  if (key == "damper") number = &damper_y;
  if (key == "drag") number = &damper_x;
  if (!number) return;
  *number = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
  const bool zero = key == "damper" || key == "drag";
  if (*number < 0.0 || (*number == 0.0 && !zero))
    error->all(FLERR, place(arg, iarg + 1), "Fix rheometer/plates {} must be {} 0, but is {}", key,
               zero ? ">=" : ">", arg[iarg + 1]);
}

/* ----------------------------------------------------------------------
   keywords that exclude each other, or that cannot act
------------------------------------------------------------------------- */

void FixRheometerPlates::check_combination(const Places &places, char **arg) const
{
  auto only_one = [&](const auto &names, const char *direction) {
    std::string first;
    for (const char *name : names) {
      if (!places.count(name)) continue;
      if (!first.empty())
        error->all(FLERR, place(arg, places.at(name)),
                   "Fix rheometer/plates: {} and {} both set the motion along {}; choose one",
                   first, name, direction);
      first = name;
    }
  };
  only_one(DRIVE_NAME, "x");
  only_one(LOAD_NAME, "y");

  auto need = [&](const char *name, bool acts, const char *what) {
    if (places.count(name) && !acts)
      error->all(FLERR, place(arg, places.at(name)),
                 "Fix rheometer/plates {} cannot act without {}", name, what);
  };
  need("mass", drive == STRESS || load == LOAD, "stress or load");
  need("damper", load == LOAD, "load");
  need("drag", drive == STRESS, "stress");
  need("gain", load == PRESSURE, "pressure");
  need("viscosity", drive == STRESS || drive == IV || load != GAP, "iv, pressure, load or stress");
  need("iv", load != GAP, "pressure or load");
  need("gap", drive != IV, "another drive than iv, which needs pressure or load");
}

/* ---------------------------------------------------------------------- */

int FixRheometerPlates::modify_param(int narg, char **arg)
{
  return parse(narg, arg, 0);
}
