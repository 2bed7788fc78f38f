/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix pore/pressure is told, and what it needs of its surroundings.

#include "fix_pore_pressure.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_pore_pressure_settings.h"
#include "fix_rheometer_plates.h"
#include "modify.h"
#include "suspension_host.h"
#include "suspension_input.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

using namespace LAMMPS_NS;
using Pore_NS::Closure;
using Pore_NS::Wall;
using Suspension_NS::InputNumber;
using Suspension_NS::require_words;

// values of each keyword
static const std::map<std::string, std::string> KEYWORDS = {
    {"solver", "grid|cg|network|mean"},
    {"alpha", "auto|a"},
    {"spacing", "h"},
    {"grid", "nx ny nz"},
    {"permeability", "beetstra|kozeny|constant ..."},
    {"factor", "f"},
    {"phi_min", "f"},
    {"plates", "fix-ID lower drained|impermeable upper drained|impermeable"},
    {"cell", ""},
    {"pressure", "p"},
    {"storage", "S"},
    {"mean", "drained|undrained|layer ..."},
    {"gradient", "gx gy gz"},
    {"coupling", "implicit|explicit|off"},
    {"tolerance", "t"},
    {"every", "n"}};

/* ---------------------------------------------------------------------- */

void FixPorePressure::parse(int narg, char **arg)
{
  require_words(FLERR, error, "fix pore/pressure", narg + 1,
                "fix ID group pore/pressure eta|pair ...");
  words = utils::join_words(std::vector<std::string>(arg + 3, arg + narg), " ");
  settings->viscosity_of_pair = strcmp(arg[3], "pair") == 0;
  if (!settings->viscosity_of_pair) settings->viscosity = InputNumber(lmp, arg[3]);
  if (!settings->viscosity_of_pair && settings->viscosity.is_number() &&
      !(settings->viscosity.value > 0.0))
    error->all(FLERR, 3, "Fix pore/pressure viscosity must be > 0, but is {}", arg[3]);
  std::map<std::string, int> given;
  for (int iarg = 4; iarg < narg;) {
    const std::string key = arg[iarg];
    if (KEYWORDS.find(key) == KEYWORDS.end())
      error->all(FLERR, iarg, "Unknown fix pore/pressure keyword: {}", key);
    if (given.count(key)) error->all(FLERR, iarg, "Fix pore/pressure {} is given twice", key);
    given[key] = iarg;
    require_words(FLERR, error, "fix pore/pressure", narg - iarg, key + " " + KEYWORDS.at(key));
    iarg += parse_keyword(iarg, narg, arg);
  }
  if (given.count("plates") && given.count("cell"))
    error->all(FLERR, given["cell"], "Fix pore/pressure has plates already: cell cannot act");
  if (given.count("spacing") && given.count("grid"))
    error->all(FLERR, given["spacing"], "Fix pore/pressure has a grid already: spacing cannot act");
  const bool drained = settings->lower == Wall::DRAINED || settings->upper == Wall::DRAINED;
  if (given.count("pressure") && !drained)
    error->all(FLERR, given["pressure"],
               "Fix pore/pressure pressure is that at drained plates, but there are none");
  if (given.count("mean") && given.count("plates"))
    error->all(FLERR, given["mean"],
               "Fix pore/pressure mean is that of a periodic cell: it cannot act between plates, "
               "whose kinds decide; remove mean, or for the mean alone use solver mean");
  if (settings->mean == PoreSettings::UNDRAINED && !(settings->storage > 0.0))
    error->all(
        FLERR, given["mean"],
        "Fix pore/pressure mean undrained needs a fluid that can be compressed; add: storage "
        "S");
  make_solver(given);
  if (settings->even) check_even(given);
}

/* ---------------------------------------------------------------------- */

std::string FixPorePressure::settings_text() const
{
  std::string text;
  for (const std::string &word : utils::split_words(words)) {
    if (!text.empty()) text += " ";
    const auto numbers = settings->numbers();
    const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const auto *number) {
      return !number->is_number() && "v_" + number->variable == word;
    });
    if (found != numbers.end() && !evaluated)
      error->all(FLERR,
                 "Suspension_scene measure cannot copy fix {}: variable {} has no value before the "
                 "first run; add run 0",
                 id, (*found)->variable);
    text += found == numbers.end() ? word : fmt::format("{}", (*found)->value);
  }
  return text;
}

/* ----------------------------------------------------------------------
   returns the number of words
------------------------------------------------------------------------- */

int FixPorePressure::parse_keyword(int iarg, int narg, char **arg)
{
  PoreSettings &s = *settings;
  const std::string key = arg[iarg];
  auto positive = [this, arg, &key](int at) {
    const double value = utils::numeric(FLERR, arg[at], false, lmp);
    if (!(value > 0.0))
      error->all(FLERR, at, "Fix pore/pressure {} must be > 0, but is {}", key, arg[at]);
    return value;
  };
  auto choose = [this, arg, &key](int at, const std::vector<std::string> &words) {
    for (std::size_t n = 0; n < words.size(); n++)
      if (words[n] == arg[at]) return static_cast<int>(n);
    error->all(FLERR, at, "Fix pore/pressure {} must be one of {}, but is {}", key,
               utils::join_words(words, " "), arg[at]);
  };
  if (key == "solver") {
    const int which = choose(iarg + 1, {"grid", "cg", "network", "mean"});
    s.iterate = which == 1;
    s.network = which == 2;
    s.even = which == 3;
  } else if (key == "alpha") {
    if (strcmp(arg[iarg + 1], "auto") != 0) s.alpha = positive(iarg + 1);
  } else if (key == "spacing") {
    s.spacing = positive(iarg + 1);
  } else if (key == "grid") {
    for (int d = 0; d < 3; d++) {
      s.elements[d] = utils::inumeric(FLERR, arg[iarg + 1 + d], false, lmp);
      if (s.elements[d] < 1)
        error->all(FLERR, iarg + 1 + d, "Fix pore/pressure grid must be > 0, but is {}",
                   arg[iarg + 1 + d]);
    }
    return 4;
  } else if (key == "permeability") {
    const int which = choose(iarg + 1, {"beetstra", "kozeny", "constant"});
    s.law.closure = which == 0 ? Closure::BEETSTRA
        : which == 1           ? Closure::KOZENY
                               : Closure::CONSTANT;
    if (which < 2) return 2;
    require_words(FLERR, error, "fix pore/pressure", narg - iarg, "permeability constant k");
    s.law.constant = positive(iarg + 2);
    return 3;
  } else if (key == "factor") {
    s.law.factor = positive(iarg + 1);
  } else if (key == "phi_min") {
    s.law.phi_min = positive(iarg + 1);
    if (s.law.phi_min >= 0.5)
      error->all(FLERR, iarg + 1, "Fix pore/pressure phi_min must be < 0.5, but is {}",
                 arg[iarg + 1]);
  } else if (key == "plates") {
    s.plates = arg[iarg + 1];
    for (int plate : {0, 1}) {
      const int at = iarg + 2 + 2 * plate;
      const char *name = plate ? "upper" : "lower";
      if (strcmp(arg[at], name) != 0)
        error->all(FLERR, at, "Fix pore/pressure plates: expected {}, but found {}", name, arg[at]);
      const int kind = choose(at + 1, {"impermeable", "drained"});
      (plate ? s.upper : s.lower) = kind ? Wall::DRAINED : Wall::IMPERMEABLE;
    }
    return 6;
  } else if (key == "cell") {
    return 1;
  } else if (key == "pressure") {
    s.drained = InputNumber(lmp, arg[iarg + 1]);
  } else if (key == "storage") {
    s.storage = positive(iarg + 1);
  } else if (key == "mean") {
    s.mean = static_cast<PoreSettings::Mean>(choose(iarg + 1, {"drained", "undrained", "layer"}));
    if (s.mean != PoreSettings::LAYER) return 2;
    require_words(FLERR, error, "fix pore/pressure", narg - iarg, "mean layer H");
    s.layer = utils::numeric(FLERR, arg[iarg + 2], false, lmp);
    if (!(s.layer > 0.0))
      error->all(FLERR, iarg + 2, "Fix pore/pressure mean layer must be > 0, but is {}",
                 arg[iarg + 2]);
    return 3;
  } else if (key == "gradient") {
    for (int d = 0; d < 3; d++) s.gradient[d] = InputNumber(lmp, arg[iarg + 1 + d]);
    return 4;
  } else if (key == "coupling") {
    using Coupling = PoreSolver::Coupling;
    const int which = choose(iarg + 1, {"implicit", "explicit", "off"});
    s.coupling = which == 0 ? Coupling::IMPLICIT : which == 1 ? Coupling::EXPLICIT : Coupling::OFF;
  } else if (key == "every") {
    s.every = utils::inumeric(FLERR, arg[iarg + 1], false, lmp);
    if (s.every < 1)
      error->all(FLERR, iarg + 1, "Fix pore/pressure every must be > 0, but is {}", arg[iarg + 1]);
  } else {
    s.tolerance = positive(iarg + 1);
  }
  return 2;
}

/* ---------------------------------------------------------------------- */

void FixPorePressure::init()
{
  Suspension_NS::require_spheres(lmp, "Fix pore/pressure");
  Suspension_NS::require_verlet(lmp, "Fix pore/pressure");
  if (settings->viscosity_of_pair && !Suspension_NS::viscosity_of_pair(lmp))
    error->all(FLERR, "Fix pore/pressure pair: {}; give the viscosity instead of pair",
               Suspension_NS::why_no_viscosity(lmp));
  settings->viscosity.check(lmp, style, "viscosity");
  settings->drained.check(lmp, style, "pressure");
  for (const InputNumber &slope : settings->gradient) slope.check(lmp, style, "gradient");
  if (domain->dimension == 2 && settings->law.closure != Closure::CONSTANT)
    error->all(FLERR,
               "Fix pore/pressure in 2d has no law of permeability for discs; use: permeability "
               "constant k");
  check_others();
  if (!settings->even) check_order();
  find_flow();
  field->init();

  plates = nullptr;
  if (!settings->plates.empty()) {
    plates = dynamic_cast<FixRheometerPlates *>(modify->get_fix_by_id(settings->plates));
    if (!plates)
      error->all(FLERR, "Fix pore/pressure plates: {} is not the ID of a fix rheometer/plates",
                 settings->plates);
    check_plates();
  } else
    for (int d = 0; d < domain->dimension; d++)
      if (!domain->periodicity[d])
        error->all(FLERR,
                   "Fix pore/pressure needs a periodic cell, or along y the plates of a fix "
                   "rheometer/plates: add plates fix-ID lower drained upper drained");
}

/* ----------------------------------------------------------------------
   a fluid that is incompressible needs a way out, and a servo time to see what its motion does
------------------------------------------------------------------------- */

void FixPorePressure::check_plates() const
{
  const bool acts = settings->coupling != PoreSolver::Coupling::OFF;
  if (!acts || settings->storage > 0.0 || settings->upper != Wall::IMPERMEABLE) return;
  if (settings->lower == Wall::IMPERMEABLE && !plates->has_gap())
    error->all(FLERR,
               "Fix pore/pressure: the fluid has no way out between two impermeable plates that "
               "approach: use drained for one of them, gap in fix {}{}",
               settings->plates, settings->even ? "" : ", or storage S");
  if (plates->has_servo() && !settings->even)
    error->all(FLERR,
               "Fix pore/pressure: the pressure on an impermeable plate answers to its motion at "
               "once, which the servo of fix {} cannot follow: use load instead of pressure there, "
               "or upper drained",
               settings->plates);
}

/* ----------------------------------------------------------------------
   P of one solution a step bounds how fast the pressure moves the plate, and the more the lighter
   it is: the pressure then is late, and the plate bounces on it
------------------------------------------------------------------------- */

void FixPorePressure::warn_of_lag()
{
  static constexpr double LAG = 2.0;
  const double lag = field->report().plate_lag;
  if (warned || settings->iterate || lag < LAG) return;
  warned = true;
  if (comm->me == 0)
    error->warning(FLERR,
                   "Fix pore/pressure: the impermeable upper plate is so light that solver grid "
                   "lets the pressure lag by about {:.3g} steps, and the plate bounces on it: use "
                   "solver cg, or increase the mass in fix {}",
                   lag, settings->plates);
}

/* ----------------------------------------------------------------------
   the drag of the pores is in here; particles without mass cannot be pushed
------------------------------------------------------------------------- */

void FixPorePressure::check_others() const
{
  if (modify->get_fix_by_style("^pore/pressure").size() > 1)
    error->all(FLERR, "More than one fix pore/pressure: the pressure of the pores is only one");
  if (settings->even) return;    // which pushes no particle
  for (const char *other : {"^drag/background", "^overdamped/sphere", "^hydro"})
    for (const auto &fix : modify->get_fix_by_style(other))
      if (settings->coupling != PoreSolver::Coupling::OFF)
        error->all(FLERR,
                   "Fix pore/pressure has the drag of the fluid between the particles already: "
                   "remove fix {} {}, or use coupling off",
                   fix->id, fix->style);
}

/* ----------------------------------------------------------------------
   it must know all other forces; plates sum up its own
------------------------------------------------------------------------- */

void FixPorePressure::check_order() const
{
  if (settings->coupling == PoreSolver::Coupling::OFF) return;
  bool later = false;
  for (const auto &fix : modify->get_fix_list()) {
    const bool is_plates = utils::strmatch(fix->style, "^rheometer/plates");
    if (fix == this)
      later = true;
    else if (is_plates && !later)
      error->all(
          FLERR,
          "Fix {} rheometer/plates must come after fix pore/pressure, whose forces its plates "
          "carry, too",
          fix->id);
    else if (later && !is_plates && (modify->get_fix_mask(fix) & FixConst::POST_FORCE) &&
             strcmp(fix->style, "enforce2d") != 0 && strcmp(fix->style, "store/force") != 0)
      error->all(FLERR,
                 "Fix {} {} may add forces after fix pore/pressure, which needs all other forces: "
                 "move it before fix pore/pressure",
                 fix->id, fix->style);
  }
}

/* ---------------------------------------------------------------------- */

double FixPorePressure::mean_diameter() const
{
  double mine[2] = {}, all[2];
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) {
      mine[0] += 2.0 * atom->radius[i];
      mine[1] += 1.0;
    }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (all[1] == 0.0) error->all(FLERR, "Fix pore/pressure has no particles in its group");
  return all[0] / all[1];
}
