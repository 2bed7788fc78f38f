/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Arguments of the fixes that have a background fluid.

#include "background_fluid.h"

#include "domain.h"
#include "error.h"
#include "fix.h"
#include "input.h"
#include "suspension_input.h"
#include "variable.h"

#include <cstring>
#include <map>

using namespace LAMMPS_NS;

static constexpr int FEW_PARTNERS = 3;

// values of each keyword; isolated may have one
static const std::map<std::string, std::string> KEYWORDS = {
    {"shear", "rate"},
    {"cell", ""},
    {"plates", "fix-ID"},
    {"couette", "y_low v_low y_high v_high"},
    {"poiseuille", "y_low y_high v_most"},
    {"velocity", "vx vy vz"},
    {"spin", "wx wy wz"},
    {"shape", "sphere|disc"},
    {"hindrance", "none|mean|phi|factor"},
    {"isolated", ""}};

/* ---------------------------------------------------------------------- */

BackgroundFluid::BackgroundFluid(LAMMPS *lmp, Fix *owner, int narg, char **arg) :
    Pointers(lmp), solid(0.0), own(lmp), fix(owner), style(owner->style), evaluated(false),
    eta_of_pair(false), profile(REST), plates(nullptr), body(Lubcontact_NS::Shape::SPHERE),
    rule(CONSTANT), isolated(0), viscosity(0.0),
    factor(1.0), couette{0.0, 0.0, 0.0, 0.0}, poiseuille{0.0, 0.0, 0.0}
{
  Suspension_NS::require_words(FLERR, error, "fix " + style, narg + 1,
                               "fix ID group " + style + " eta ...");
  hindered.value = 1.0;
  words = utils::join_words(std::vector<std::string>(arg + 3, arg + narg), " ");
  if (strcmp(arg[3], "pair") == 0)
    eta_of_pair = true;
  else
    eta = Suspension_NS::InputNumber(lmp, arg[3]);
  if (!eta_of_pair && eta.is_number() && !(eta.value >= 0.0))
    error->all(FLERR, 3, "Fix {} viscosity must be >= 0, but is {}", style, arg[3]);
  parse(narg, arg);
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::parse(int narg, char **arg)
{
  static const std::map<std::string, Profile> PROFILES = {
      {"shear", SHEAR},           {"cell", CELL},        {"plates", PLATES}, {"couette", COUETTE},
      {"poiseuille", POISEUILLE}, {"velocity", VELOCITY}};
  std::map<std::string, int> places;
  std::string found;
  for (int iarg = 4; iarg < narg;) {
    const std::string key = arg[iarg];
    const auto known = KEYWORDS.find(key);
    if (known == KEYWORDS.end())
      error->all(FLERR, iarg, "Unknown fix {} keyword: {}", style, arg[iarg]);
    Suspension_NS::require_words(FLERR, error, "fix " + style, narg - iarg,
                                 key + " " + known->second);
    if (places.count(key)) error->all(FLERR, iarg, "Fix {} {} is given twice", style, key);
    places[key] = iarg;
    const auto flow = PROFILES.find(key);
    if (flow != PROFILES.end()) {
      parse_profile(flow->second, arg, iarg, found);
    } else if (key == "spin") {
      parse_components(arg, iarg, 3);
      iarg += 4;
    } else if (key == "shape") {
      if (strcmp(arg[iarg + 1], "disc") == 0)
        body = Lubcontact_NS::Shape::DISC;
      else if (strcmp(arg[iarg + 1], "sphere") != 0)
        error->all(FLERR, iarg + 1, "Fix {} shape must be sphere or disc, but is {}", style,
                   arg[iarg + 1]);
      if (body == Lubcontact_NS::Shape::DISC && domain->dimension != 2)
        error->all(FLERR, iarg + 1, "Fix {} shape disc needs a 2d simulation; use: dimension 2",
                   style);
      iarg += 2;
    } else if (key == "hindrance") {
      parse_hindrance(narg, arg, iarg);
    } else {
      isolated = FEW_PARTNERS;
      iarg++;
      if (iarg < narg && utils::is_integer(arg[iarg])) {
        isolated = utils::inumeric(FLERR, arg[iarg], false, lmp);
        if (isolated < 1)
          error->all(FLERR, iarg, "Fix {} isolated must be > 0, but is {}", style, arg[iarg]);
        iarg++;
      }
    }
  }
  if (places.count("spin") && profile != VELOCITY)
    error->all(FLERR, places["spin"], "Fix {} spin cannot act without velocity", style);
}

/* ----------------------------------------------------------------------
   one flow only
------------------------------------------------------------------------- */

void BackgroundFluid::parse_profile(Profile which, char **arg, int &iarg, std::string &found)
{
  if (!found.empty())
    error->all(FLERR, iarg, "Fix {} has the flow {} already: {} cannot act", style, found,
               arg[iarg]);
  found = arg[iarg];
  profile = which;
  const int values = static_cast<int>(utils::count_words(KEYWORDS.at(found)));
  if (profile == PLATES)
    plates_id = arg[iarg + 1];
  else if (profile == VELOCITY)
    parse_components(arg, iarg, 0);
  else
    for (int n = 0; n < values; n++) number[n] = Suspension_NS::InputNumber(lmp, arg[iarg + 1 + n]);

  auto above = [&](int high, int low) {
    const bool numbers = number[low].is_number() && number[high].is_number();
    if (numbers && !(number[high].value > number[low].value))
      error->all(FLERR, iarg + 1 + high,
                 "Fix {} {}: the upper wall must be above the lower one at y = {}, but is at {}",
                 style, found, arg[iarg + 1 + low], arg[iarg + 1 + high]);
  };
  if (profile == COUETTE) above(2, 0);
  if (profile == POISEUILLE) above(1, 0);
  iarg += 1 + values;
}

/* ----------------------------------------------------------------------
   three components of velocity (from 0) or spin (from 3)
------------------------------------------------------------------------- */

void BackgroundFluid::parse_components(char **arg, int iarg, int first)
{
  for (int n = 0; n < 3; n++)
    component[first + n].target = Suspension_NS::InputNumber(lmp, arg[iarg + 1 + n]);
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::parse_hindrance(int narg, char **arg, int &iarg)
{
  const char *word = arg[iarg + 1];
  iarg += 2;
  if (strcmp(word, "none") == 0) return;
  if (strcmp(word, "mean") == 0) {
    rule = MEASURED;
    return;
  }
  int place = iarg - 1;
  if (strcmp(word, "phi") == 0) {
    Suspension_NS::require_words(FLERR, error, "fix " + style, narg - iarg + 2, "hindrance phi f");
    rule = FRACTION;
    place = iarg++;
  }
  hindered = Suspension_NS::InputNumber(lmp, arg[place]);
  if (!hindered.is_number()) return;
  if (rule == FRACTION && !(hindered.value >= 0.0 && hindered.value < 1.0))
    error->all(FLERR, place, "Fix {} hindrance phi must be >= 0 and < 1, but is {}", style,
               arg[place]);
  if (rule == CONSTANT && !(hindered.value >= 0.0))
    error->all(FLERR, place, "Fix {} hindrance must be >= 0, but is {}", style, arg[place]);
}
