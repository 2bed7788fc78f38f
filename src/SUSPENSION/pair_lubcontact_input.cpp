/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the user types for pair style lubcontact: settings, coefficients, restart, data files.

#include "pair_lubcontact.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "input.h"
#include "lubcontact_pair.h"
#include "memory.h"
#include "modify.h"
#include "suspension_input.h"
#include "update.h"
#include "variable.h"

#include <cmath>
#include <cstring>
#include <map>

using namespace LAMMPS_NS;
using Lubcontact_NS::FRICTION_NAME;
using Lubcontact_NS::FrictionLaw;

static constexpr const char *MODE_NAME[4] = {"squeeze", "shear", "roll", "twist"};

// keywords and their values
static const std::map<std::string, std::string> SETTINGS = {
    {"squeeze", "yes|no"},       {"shear", "yes|no"}, {"roll", "yes|no"},
    {"twist", "yes|no"},         {"rollcoeff", "c"},  {"radius", "harmonic|mean"},
    {"gap", "exponential|euler"}};
static const std::map<std::string, std::string> COEFFICIENTS = {{"roughness", "eps"},
                                                                {"asperity", "k"},
                                                                {"friction", "none|coulomb|clm"},
                                                                {"adhesion", "delta"},
                                                                {"repulsion", "F0 lambda"}};

// Where this word is in the command, for the mark under it: hybrid shifts words, a data file has no command.
static int place(const Input *input, const char *word)
{
  for (int n = 0; n < input->narg; n++)
    if (input->arg[n] == word) return n;
  return Error::NOPOINTER;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::allocate()
{
  allocated = 1;
  const int n = atom->ntypes + 1;

  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  memory->create(g, n, n, "pair:g");
  memory->create(kt, n, n, "pair:kt");
  memory->create(asperity, n, n, "pair:asperity");
  memory->create(roughness, n, n, "pair:roughness");
  memory->create(friction, n, n, "pair:friction");
  memory->create(law, n, n, "pair:law");
  memory->create(critical, n, n, "pair:critical");
  memory->create(adhesion, n, n, "pair:adhesion");
  memory->create(repulsion, n, n, "pair:repulsion");
  memory->create(screening, n, n, "pair:screening");
  memory->create(coeffs, n, n, "pair:coeffs");
  memory->create(reach, n, n, "pair:reach");
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      setflag[i][j] = law[i][j] = 0;
      g[i][j] = 0.0;    // no coefficients: another style's pair under hybrid
    }
  max_radius = new double[n]();
}

/* ----------------------------------------------------------------------
   range: rule and reach, or the word default; returns the place of the next argument
------------------------------------------------------------------------- */

int PairLubcontact::set_range(int narg, char **arg)
{
  const std::string rule = arg[1];
  if (rule == "default") {
    range_rule = static_cast<int>(Lubcontact_NS::DEFAULT_RANGE);
    hc = Lubcontact_NS::DEFAULT_REACH;
    if (narg > 2 && utils::is_double(arg[2]))
      error->all(FLERR, 3,
                 "Pair style lubcontact range default takes no number, but found {}: write cut {}",
                 arg[2], arg[2]);
    return 2;
  }
  if (rule == "cut")
    range_rule = static_cast<int>(Lubcontact_NS::Range::CUT);
  else if (rule == "shifted")
    range_rule = static_cast<int>(Lubcontact_NS::Range::SHIFTED);
  else if (rule == "voronoi")
    range_rule = static_cast<int>(Lubcontact_NS::Range::VORONOI);
  else
    error->all(
        FLERR, 2,
        "Pair style lubcontact range must be default or cut or shifted or voronoi, but is {}",
        rule);
  if (range_rule == static_cast<int>(Lubcontact_NS::Range::VORONOI)) require_voronoi(2);

  Suspension_NS::require_words(FLERR, error, "pair_style lubcontact", narg - 1, rule + " hc ...");
  hc = utils::numeric(FLERR, arg[2], false, lmp);
  if (!(hc > 0.0))
    error->all(FLERR, 3, "Pair style lubcontact range must be > 0 effective radii, but is {}", hc);
  return 3;
}

/* ----------------------------------------------------------------------
   pair_style lubcontact eta range args keyword value ...
------------------------------------------------------------------------- */

void PairLubcontact::settings(int narg, char **arg)
{
  Suspension_NS::require_words(FLERR, error, "pair_style lubcontact", narg + 2,
                               "pair_style lubcontact eta default|cut|shifted|voronoi ...");

  dt_limit = 0.0;
  delete[] eta_name;
  eta_name = nullptr;
  if (utils::strmatch(arg[0], "^v_")) {
    eta_name = utils::strdup(arg[0] + 2);
    eta = NAN;    // until a run evaluates it
  } else {
    eta = utils::numeric(FLERR, arg[0], false, lmp);
    if (!(eta >= 0.0))
      error->all(FLERR, 1, "Pair style lubcontact viscosity must be >= 0, but is {}", eta);
  }

  const int first = set_range(narg, arg);

  euler = 0;
  radius_rule = static_cast<int>(Lubcontact_NS::Radius::HARMONIC);
  for (int &m : mode) m = 1;
  roll_coeff = 0.6;
  reported = false;
  bool roll_coeff_given = false, gap_given = false;

  for (int iarg = first; iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    const auto known = SETTINGS.find(key);
    if (known == SETTINGS.end())
      error->all(FLERR, iarg + 1, "Unknown pair_style lubcontact keyword: {}", key);
    Suspension_NS::require_words(FLERR, error, "pair_style lubcontact", narg - iarg,
                                 key + " " + known->second);
    const std::string value = arg[iarg + 1];
    int which = -1;
    for (int m = 0; m < 4; m++)
      if (key == MODE_NAME[m]) which = m;

    if (which >= 0) {
      mode[which] = utils::logical(FLERR, value, false, lmp);
    } else if (key == "gap") {
      if (value != "exponential" && value != "euler")
        error->all(FLERR, iarg + 2,
                   "Pair style lubcontact gap must be exponential or euler, but is {}", value);
      euler = value == "euler";
      gap_given = true;
    } else if (key == "radius") {
      if (value != "mean" && value != "harmonic")
        error->all(FLERR, iarg + 2,
                   "Pair style lubcontact radius must be mean or harmonic, but is {}", value);
      radius_rule = static_cast<int>(value == "mean" ? Lubcontact_NS::Radius::MEAN
                                                     : Lubcontact_NS::Radius::HARMONIC);
    } else {
      roll_coeff = utils::numeric(FLERR, value, false, lmp);
      roll_coeff_given = true;
      if (!(roll_coeff >= 0.0))
        error->all(FLERR, iarg + 2, "Pair style lubcontact rollcoeff must be >= 0, but is {}",
                   roll_coeff);
    }
  }

  if (!mode[ROLL] && roll_coeff_given)
    error->all(FLERR,
               "Pair style lubcontact rollcoeff cannot act with roll no: remove one of them");
  if (!mode[SQUEEZE] && gap_given)
    error->all(FLERR, "Pair style lubcontact gap cannot act with squeeze no: remove one of them");
}

/* ----------------------------------------------------------------------
   the word, or two words, after friction
------------------------------------------------------------------------- */

FrictionLaw PairLubcontact::friction_law(int iarg, int narg, char **arg) const
{
  std::string name = arg[iarg + 1];
  int word = iarg + 1;
  if (name == "clm" && iarg + 2 < narg) name += std::string(" ") + arg[++word];
  for (int m = 0; m < static_cast<int>(FrictionLaw::NUM_LAWS); m++)
    if (name == FRICTION_NAME[m]) return static_cast<FrictionLaw>(m);
  error->all(
      FLERR, place(input, arg[word]),
      "Pair style lubcontact friction must be none, coulomb mu, or clm step, clm shift or clm "
      "ramp with mu and the critical load, but is {}",
      name);
}

/* ----------------------------------------------------------------------
   pair_coeff I J g kt keyword value ..., or pair_coeff * * FILE NAME1 NAME2 ...
------------------------------------------------------------------------- */

void PairLubcontact::coeff(int narg, char **arg)
{
  const bool by_name = narg > 2 && !utils::is_double(arg[2]);
  Suspension_NS::require_words(FLERR, error, "pair_coeff", narg + 1,
                               by_name ? "pair_coeff * * file name1 ..."
                                       : "pair_coeff I J g kt ...");
  if (!allocated) allocate();
  dt_limit = 0.0;
  if (by_name) return materials(narg, arg);

  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);

  auto number = [this, arg](int iarg, const char *name, bool zero_allowed) {
    const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
    if (!(value > 0.0 || (zero_allowed && value == 0.0)) || !std::isfinite(value))
      error->all(FLERR, place(input, arg[iarg]), "Pair style lubcontact {} must be {} 0, but is {}",
                 name, zero_allowed ? ">=" : ">", arg[iarg]);
    return value;
  };

  const double g_one = number(2, "stiffness g", false);
  const double kt_one = number(3, "stiffness kt", false);
  double asperity_one = g_one, roughness_one = 0.0, friction_one = 0.0, critical_one = 0.0;
  double adhesion_one = 0.0, repulsion_one = 0.0, screening_one = 0.0;
  auto law_one = FrictionLaw::NONE;
  int adhesion_word = 0;

  for (int iarg = 4; iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    const auto known = COEFFICIENTS.find(key);
    if (known == COEFFICIENTS.end())
      error->all(FLERR, place(input, arg[iarg]), "Unknown pair_coeff lubcontact keyword: {}", key);
    Suspension_NS::require_words(FLERR, error, "pair_coeff", narg - iarg,
                                 key + " " + known->second);
    if (key == "roughness") {
      roughness_one = number(iarg + 1, "roughness", true);
      if (roughness_one >= hc)
        error->all(FLERR, place(input, arg[iarg + 1]),
                   "Pair style lubcontact roughness must be below the range {}, but is {}", hc,
                   roughness_one);
    } else if (key == "asperity") {
      asperity_one = number(iarg + 1, "asperity stiffness", false);
    } else if (key == "friction") {
      law_one = friction_law(iarg, narg, arg);
      const int words = law_one == FrictionLaw::NONE ? 0 : law_one == FrictionLaw::COULOMB ? 1 : 3;
      const char *values[] = {"", " mu", "", " mu F"};
      Suspension_NS::require_words(
          FLERR, error, "pair_coeff", narg - iarg,
          fmt::format("friction {}{}", FRICTION_NAME[static_cast<int>(law_one)], values[words]));
      friction_one = critical_one = 0.0;
      if (words == 1) friction_one = number(iarg + 2, "coefficient of friction", true);
      if (words == 3) {
        friction_one = number(iarg + 3, "coefficient of friction", true);
        critical_one = number(iarg + 4, "critical load", true);
      }
      iarg += words;
    } else if (key == "adhesion") {
      adhesion_word = iarg + 1;
      adhesion_one = number(adhesion_word, "adhesion", true);
    } else {
      repulsion_one = number(iarg + 1, "repulsion", true);
      screening_one = number(iarg + 2, "screening length", false);
      iarg++;
    }
  }

  if (adhesion_one > 0.0 && roughness_one == 0.0)
    error->all(FLERR, place(input, arg[adhesion_word]),
               "Pair style lubcontact adhesion is of asperities, but these types have none: give "
               "them a roughness > 0");

  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) {
      g[i][j] = g_one;
      kt[i][j] = kt_one;
      asperity[i][j] = asperity_one;
      roughness[i][j] = roughness_one;
      friction[i][j] = friction_one;
      law[i][j] = static_cast<int>(law_one);
      critical[i][j] = critical_one;
      adhesion[i][j] = adhesion_one;
      repulsion[i][j] = repulsion_one;
      screening[i][j] = screening_one;
      setflag[i][j] = 1;
      count++;
    }
  if (count == 0)
    error->all(FLERR, "No pair of atom types I <= J in pair_coeff {} {}", arg[0], arg[1]);
  reported = false;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::check_variable()
{
  if (!eta_name) return;
  eta_var = input->variable->find(eta_name);
  if (eta_var < 0)
    error->all(FLERR, "Variable {} for the viscosity of pair style lubcontact does not exist",
               eta_name);
  if (!input->variable->equalstyle(eta_var))
    error->all(FLERR, "Variable {} for the viscosity of pair style lubcontact is not equal-style",
               eta_name);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::update_viscosity()
{
  if (eta_name) {
    modify->clearstep_compute();
    eta = input->variable->compute_equal(eta_var);
    modify->addstep_compute(update->ntimestep + 1);
    if (!(eta >= 0.0))
      error->all(FLERR, "Viscosity of pair style lubcontact must be >= 0, but variable {} is {}",
                 eta_name, eta);
  }
  *film = Lubcontact_NS::without_films(
      Lubcontact_NS::make_film(eta, hc, static_cast<Lubcontact_NS::Range>(range_rule), roll_coeff),
      mode[SHEAR], mode[ROLL], mode[TWIST]);
}

/* ---------------------------------------------------------------------- */

void *PairLubcontact::extract(const char *name, int &dim)
{
  dim = 0;
  if (strcmp(name, "eta") == 0) return eta_name ? nullptr : &eta;
  if (strcmp(name, "rollcoeff") == 0) return &roll_coeff;
  // range voronoi: which pairs share a face, as long as a list lives
  if (strcmp(name, "faces") == 0) return faces.empty() ? nullptr : faces.data();
  dim = 2;
  if (strcmp(name, "g") == 0) return g;
  if (strcmp(name, "kt") == 0) return kt;
  if (strcmp(name, "asperity") == 0) return asperity;
  if (strcmp(name, "roughness") == 0) return roughness;
  if (strcmp(name, "friction") == 0) return friction;
  if (strcmp(name, "critical") == 0) return critical;
  if (strcmp(name, "repulsion") == 0) return repulsion;
  return nullptr;
}
