/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "plates_targets.h"

#include "error.h"
#include "input.h"
#include "modify.h"
#include "plates_state.h"
#include "suspension_host.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

static constexpr int NUM_DRIVES = 5, NUM_LOADS = 3;
static constexpr const char *DRIVE_NAME[NUM_DRIVES] = {"rate", "velocity", "stress", "oscillate",
                                                       "iv"};
static constexpr const char *LOAD_NAME[NUM_LOADS] = {"gap", "pressure", "load"};

// values of each keyword
static const std::map<std::string, std::string> KEYWORDS = {
    {"rate", "g"},        {"velocity", "v"},
    {"stress", "s"},      {"oscillate", "g0 g1 w"},
    {"iv", "v"},          {"gap", ""},
    {"pressure", "P"},    {"load", "P"},
    {"mass", "m"},        {"damper", "c"},
    {"drag", "c"},        {"gain", "K"},
    {"viscosity", "eta"}, {"lists", "affine|lammps"}};

/* ---------------------------------------------------------------------- */

PlatesTargets::PlatesTargets(LAMMPS *lmp, const char *style_of_fix) :
    Pointers(lmp), style(style_of_fix), kind(RATE), hold(GAP), w(0.0), own_viscosity(false),
    pair_eta(nullptr), plate(0.0), damper{0.0, 0.0}, servo_gain(1.0), affine(true)
{
}

/* ----------------------------------------------------------------------
   index for the error message, which underlines words of the whole command
------------------------------------------------------------------------- */

int PlatesTargets::place(char **arg, int iarg) const
{
  for (int n = 0; n < input->narg; n++)
    if (input->arg[n] == arg[iarg]) return n;
  return Error::NOLASTLINE;
}

/* ---------------------------------------------------------------------- */

PlatesTargets::Parsed PlatesTargets::parse(int narg, char **arg, int iarg)
{
  Places places;
  const Load before = hold;
  while (iarg < narg) {
    const std::string key = arg[iarg];
    const auto known = KEYWORDS.find(key);
    if (known == KEYWORDS.end()) break;
    Suspension_NS::require_words(FLERR, error, "fix rheometer/plates", narg - iarg,
                                 key + " " + known->second);
    if (places.count(key))
      error->all(FLERR, place(arg, iarg), "Fix rheometer/plates {} is given twice", key);
    places[key] = iarg;
    for (int n = 0; n < NUM_DRIVES; n++)
      if (key == DRIVE_NAME[n]) parse_drive(n, arg, iarg);
    for (int n = 0; n < NUM_LOADS; n++)
      if (key == LOAD_NAME[n]) parse_load(n, arg, iarg);
    parse_number(key, arg, iarg);
    iarg += 1 + static_cast<int>(utils::count_words(known->second));
  }
  check_combination(places, arg);

  auto any_of = [&](const auto &names) {
    for (const char *name : names)
      if (places.count(name)) return true;
    return false;
  };
  return {iarg, any_of(DRIVE_NAME), any_of(LOAD_NAME), hold == before};
}

/* ---------------------------------------------------------------------- */

void PlatesTargets::parse_drive(int n, char **arg, int iarg)
{
  kind = static_cast<Drive>(n);
  number[ALONG_X] = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
  if (kind == IV && number[ALONG_X].is_number() && number[ALONG_X].value < 0.0)
    error->all(FLERR, place(arg, iarg + 1), "Fix rheometer/plates iv must be >= 0, but is {}",
               arg[iarg + 1]);
  if (kind != OSCILLATE) return;
  number[AMPLITUDE] = Suspension_NS::InputNumber(lmp, arg[iarg + 2]);
  w = utils::numeric(FLERR, arg[iarg + 3], false, lmp);
  if (w <= 0.0)
    error->all(FLERR, place(arg, iarg + 3),
               "Fix rheometer/plates oscillate needs a frequency > 0, but it is {}", arg[iarg + 3]);
}

/* ---------------------------------------------------------------------- */

void PlatesTargets::parse_load(int n, char **arg, int iarg)
{
  hold = static_cast<Load>(n);
  if (hold == GAP) return;
  number[PRESSED] = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
  if (hold == PRESSURE && number[PRESSED].is_number() && number[PRESSED].value <= 0.0)
    error->all(FLERR, place(arg, iarg + 1), "Fix rheometer/plates pressure must be > 0, but is {}",
               arg[iarg + 1]);
}

/* ---------------------------------------------------------------------- */

void PlatesTargets::parse_number(const std::string &key, char **arg, int iarg)
{
  if (key == "viscosity") {
    number[ETA] = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
    own_viscosity = true;
    if (number[ETA].value < 0.0)
      error->all(FLERR, place(arg, iarg + 1),
                 "Fix rheometer/plates viscosity must be >= 0, but is {}", arg[iarg + 1]);
    return;
  }
  if (key == "lists") {
    const std::string word = arg[iarg + 1];
    if (word != "affine" && word != "lammps")
      error->all(FLERR, place(arg, iarg + 1),
                 "Fix rheometer/plates lists must be affine or lammps, but is {}", word);
    affine = word == "affine";
    return;
  }
  double *to = nullptr;
  if (key == "mass") to = &plate;
  if (key == "gain") to = &servo_gain;
  if (key == "damper") to = &damper[1];
  if (key == "drag") to = &damper[0];
  if (!to) return;
  *to = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
  const bool zero = key == "damper" || key == "drag";
  if (*to < 0.0 || (*to == 0.0 && !zero))
    error->all(FLERR, place(arg, iarg + 1), "Fix rheometer/plates {} must be {} 0, but is {}", key,
               zero ? ">=" : ">", arg[iarg + 1]);
}

/* ----------------------------------------------------------------------
   keywords that exclude each other, or that cannot act
------------------------------------------------------------------------- */

void PlatesTargets::check_combination(const Places &places, char **arg) const
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
  need("mass", kind == STRESS || hold == LOAD, "stress or load");
  need("damper", hold == LOAD, "load");
  need("drag", kind == STRESS, "stress");
  need("gain", hold == PRESSURE, "pressure");
  need("viscosity", kind == STRESS || kind == IV || hold != GAP, "iv, pressure, load or stress");
  need("iv", hold != GAP, "pressure or load");
  need("gap", kind != IV, "another drive than iv, which needs pressure or load");
}

/* ---------------------------------------------------------------------- */

void PlatesTargets::check()
{
  check_viscosity();
  number[ALONG_X].check(lmp, style.c_str(), DRIVE_NAME[kind]);
  if (kind == OSCILLATE) number[AMPLITUDE].check(lmp, style.c_str(), "oscillate");
  if (hold != GAP) number[PRESSED].check(lmp, style.c_str(), LOAD_NAME[hold]);
}

/* ----------------------------------------------------------------------
   of the fluid: given here, or that of pair style lubcontact
------------------------------------------------------------------------- */

void PlatesTargets::check_viscosity()
{
  pair_eta = nullptr;
  if (own_viscosity) {
    number[ETA].check(lmp, style.c_str(), "viscosity");
    return;
  }
  pair_eta = Suspension_NS::viscosity_of_pair(lmp);
  const bool films = !Suspension_NS::all_lubcontact(lmp).empty();
  if (!pair_eta && (kind == IV || (films && hold != GAP)))
    error->all(
        FLERR,
        "Fix rheometer/plates does not find the viscosity of the fluid in the pair style: {}; "
        "add: viscosity eta",
        Suspension_NS::why_no_viscosity(lmp));
}

/* ---------------------------------------------------------------------- */

void PlatesTargets::evaluate()
{
  modify->clearstep_compute();
  bool any = false;
  for (Suspension_NS::InputNumber &target : number)
    if (target.evaluate(lmp)) any = true;
  if (any) modify->addstep_compute(update->ntimestep + 1);
  if (!own_viscosity) number[ETA].value = pair_eta ? *pair_eta : 0.0;
  check_values();
}

/* ---------------------------------------------------------------------- */

void PlatesTargets::check_values() const
{
  auto bad = [this](const char *keyword, const char *limit, double found) {
    error->all(FLERR, "Fix rheometer/plates {} must be {}, but is {} at step {}", keyword, limit,
               found, update->ntimestep);
  };
  if (!std::isfinite(number[ALONG_X].value)) bad(DRIVE_NAME[kind], "finite", number[ALONG_X].value);
  if (!std::isfinite(number[AMPLITUDE].value)) bad("oscillate", "finite", number[AMPLITUDE].value);
  if (hold != GAP && !std::isfinite(number[PRESSED].value))
    bad(LOAD_NAME[hold], "finite", number[PRESSED].value);
  if (hold == PRESSURE && number[PRESSED].value <= 0.0)
    bad("pressure", "> 0", number[PRESSED].value);
  if (!(number[ETA].value >= 0.0)) bad("viscosity", ">= 0", number[ETA].value);
  if (kind == IV && number[ETA].value == 0.0) bad("viscosity", "> 0 with iv", 0.0);
}

/* ---------------------------------------------------------------------- */

bool PlatesTargets::turned_from(const PlatesState &state) const
{
  const bool other_wave = number[AMPLITUDE].is_number() && state.amplitude != amplitude();
  return state.drive != kind || (kind == OSCILLATE && (other_wave || state.frequency != w));
}
