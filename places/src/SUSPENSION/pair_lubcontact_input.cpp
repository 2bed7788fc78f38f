/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the user types for pair style lubcontact: settings, coefficients, restart and data files.

#include "pair_lubcontact.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "input.h"
#include "lubcontact_materials.h"
#include "lubcontact_type_coeffs.h"
#include "radical_tessellation.h"
#include "restart_seal.h"
#include "suspension_input.h"

#include <cmath>
#include <cstring>
#include <map>

using namespace LAMMPS_NS;
using Lubcontact_NS::EFFECTS;
using Lubcontact_NS::Radius;
using Lubcontact_NS::Range;
using Lubcontact_NS::Settings;
using Suspension_NS::require_words;

// keywords besides the films, and their values
static const std::map<std::string, std::string> KEYWORDS = {
    {"rollcoeff", "c"}, {"radius", "harmonic|mean"}, {"gap", "exponential|euler"}};

/* ----------------------------------------------------------------------
   range: rule and reach, or the word default; returns the place of the next argument
------------------------------------------------------------------------- */

static int parse_range(LAMMPS *lmp, int narg, char **arg, Settings &s)
{
  Error *error = lmp->error;
  const std::string rule = arg[1];
  if (rule == "default") {
    if (narg > 2 && utils::is_double(arg[2]))
      error->all(FLERR, 3,
                 "Pair style lubcontact range default takes no number, but found {}: write cut {}",
                 arg[2], arg[2]);
    return 2;
  }
  bool found = false;
  for (const Range range : {Range::CUT, Range::SHIFTED, Range::VORONOI, Range::RESIDUAL})
    if (rule == Lubcontact_NS::RANGE_NAME[static_cast<int>(range)]) {
      s.range = range;
      found = true;
    }
  if (!found)
    error->all(
        FLERR, 2,
        "Pair style lubcontact range must be default or cut or shifted or voronoi or residual, "
        "but is {}",
        rule);
  if (s.range == Range::VORONOI && !RadicalTessellation::has_library())
    error->all(FLERR, 2, "Pair style lubcontact range voronoi {}", RadicalTessellation::NO_LIBRARY);

  require_words(FLERR, error, "pair_style lubcontact", narg - 1, rule + " hc ...");
  s.reach_a = utils::numeric(FLERR, arg[2], false, lmp);
  if (!(s.reach_a > 0.0))
    error->all(FLERR, 3, "Pair style lubcontact range must be > 0 effective radii, but is {}",
               s.reach_a);
  if (s.range == Range::RESIDUAL && s.reach_a > Lubcontact_NS::RESIDUAL_END_A)
    error->all(FLERR, 3,
               "Pair style lubcontact range residual must be <= {} effective radii, beyond which "
               "nothing is left, but is {}",
               Lubcontact_NS::RESIDUAL_END_A, s.reach_a);
  return 3;
}

/* ----------------------------------------------------------------------
   one keyword that is no film
------------------------------------------------------------------------- */

static void parse_keyword(LAMMPS *lmp, int iarg, const std::string &key, const std::string &value,
                          Settings &s)
{
  Error *error = lmp->error;
  if (key == "gap") {
    if (value != "exponential" && value != "euler")
      error->all(FLERR, iarg + 2,
                 "Pair style lubcontact gap must be exponential or euler, but is {}", value);
    s.euler = value == "euler";
  } else if (key == "radius") {
    if (value != "mean" && value != "harmonic")
      error->all(FLERR, iarg + 2,
                 "Pair style lubcontact radius must be mean or harmonic, but is {}", value);
    s.radius = value == "mean" ? Radius::MEAN : Radius::HARMONIC;
  } else {
    s.roll_coeff = utils::numeric(FLERR, value, false, lmp);
    if (!(s.roll_coeff >= 0.0))
      error->all(FLERR, iarg + 2, "Pair style lubcontact rollcoeff must be >= 0, but is {}",
                 s.roll_coeff);
  }
}

/* ----------------------------------------------------------------------
   pair_style lubcontact eta range args keyword value ...
------------------------------------------------------------------------- */

void PairLubcontact::settings(int narg, char **arg)
{
  require_words(FLERR, error, "pair_style lubcontact", narg + 2,
                "pair_style lubcontact eta default|cut|shifted|voronoi|residual ...");
  const Suspension_NS::InputNumber eta(lmp, arg[0]);
  Settings s;
  s.viscosity = eta.is_number() ? eta.value : NAN;    // until a run evaluates it
  if (eta.is_number() && !(eta.value >= 0.0))
    error->all(FLERR, 1, "Pair style lubcontact viscosity must be >= 0, but is {}", eta.value);

  bool roll_coeff_given = false, gap_given = false;
  for (int iarg = parse_range(lmp, narg, arg, s); iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    unsigned film_bit = 0;
    for (const auto &row : EFFECTS)
      if (row.is_film() && key == row.name) film_bit = row.bit;
    const auto known = KEYWORDS.find(key);
    if (!film_bit && known == KEYWORDS.end())
      error->all(FLERR, iarg + 1, "Unknown pair_style lubcontact keyword: {}", key);
    require_words(FLERR, error, "pair_style lubcontact", narg - iarg,
                  key + " " + (film_bit ? "yes|no" : known->second));
    if (!film_bit)
      parse_keyword(lmp, iarg, key, arg[iarg + 1], s);
    else if (utils::logical(FLERR, arg[iarg + 1], false, lmp))
      s.films |= film_bit;
    else
      s.films &= ~film_bit;
    if (key == "rollcoeff") roll_coeff_given = true;
    if (key == "gap") gap_given = true;
  }
  if (!(s.films & Lubcontact_NS::ROLL) && roll_coeff_given)
    error->all(FLERR,
               "Pair style lubcontact rollcoeff cannot act with roll no: remove one of them");
  if (!(s.films & Lubcontact_NS::SQUEEZE) && gap_given)
    error->all(FLERR, "Pair style lubcontact gap cannot act with squeeze no: remove one of them");
  if (s.range == Range::RESIDUAL) {
    if (s.radius != Radius::HARMONIC)
      error->all(FLERR, "Pair style lubcontact range residual needs radius harmonic");
    if (roll_coeff_given)
      error->all(FLERR,
                 "Pair style lubcontact rollcoeff cannot act with range residual, which has the "
                 "torque of two spheres: remove one of them");
    if (!(s.films & Lubcontact_NS::SQUEEZE))
      error->all(FLERR,
                 "Pair style lubcontact range residual needs the squeeze film: without films use "
                 "range cut");
  }

  *given = s;
  viscosity_variable = eta.variable;
  dt_limit = 0.0;
  reported = false;
}

/* ----------------------------------------------------------------------
   pair_coeff I J g kt keyword value ..., or pair_coeff * * FILE NAME1 NAME2 ...
------------------------------------------------------------------------- */

void PairLubcontact::coeff(int narg, char **arg)
{
  const bool by_name = narg > 2 && !utils::is_double(arg[2]);
  require_words(FLERR, error, "pair_coeff", narg + 1,
                by_name ? "pair_coeff * * file name1 ..." : "pair_coeff I J g kt ...");
  allocate();
  dt_limit = 0.0;
  reported = false;
  if (by_name) {
    for (const auto &pair : read_materials(lmp, narg, arg, *coeffs, *given)) {
      coeffs->put(pair.i, pair.j, pair.coeffs);
      setflag[pair.i][pair.j] = 1;
    }
    return;
  }

  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  const auto typed = coeffs->parse(narg - 2, arg + 2, given->reach_a);
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) {
      coeffs->put(i, j, typed);
      setflag[i][j] = 1;
      count++;
    }
  if (count == 0)
    error->all(FLERR, "No pair of atom types I <= J in pair_coeff {} {}", arg[0], arg[1]);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::write_restart_settings(FILE *fp)
{
  using Suspension_NS::append_bytes;
  std::string bytes;
  append_bytes(bytes, given->viscosity);
  append_bytes(bytes, given->reach_a);
  append_bytes(bytes, given->roll_coeff);
  append_bytes(bytes, given->range);
  append_bytes(bytes, given->radius);
  append_bytes(bytes, static_cast<int>(given->euler));
  for (const auto &row : EFFECTS)
    if (row.is_film()) append_bytes(bytes, static_cast<int>((given->films & row.bit) != 0));
  bytes += viscosity_variable;
  Suspension_NS::write_bytes(fp, bytes);
}

// the first rank reads; all get the bytes
static std::string read_bytes(FILE *fp, LAMMPS *lmp)
{
  std::string bytes;
  int length = 0;
  if (lmp->comm->me == 0)
    length = Suspension_NS::read_bytes(fp, bytes) ? static_cast<int>(bytes.size()) : -1;
  MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
  if (length < 0)
    lmp->error->all(FLERR,
                    "The part of pair style lubcontact in the restart file is damaged, or was "
                    "written by another version of the package: use another restart file");
  bytes.resize(length);
  MPI_Bcast(&bytes[0], length, MPI_CHAR, 0, lmp->world);
  return bytes;
}

void PairLubcontact::read_restart_settings(FILE *fp)
{
  using Suspension_NS::take_bytes;
  std::string bytes = read_bytes(fp, lmp);
  int euler;
  take_bytes(bytes, given->viscosity);
  take_bytes(bytes, given->reach_a);
  take_bytes(bytes, given->roll_coeff);
  take_bytes(bytes, given->range);
  take_bytes(bytes, given->radius);
  take_bytes(bytes, euler);
  given->films = 0;
  for (const auto &row : EFFECTS)
    if (row.is_film()) {
      int on;
      take_bytes(bytes, on);
      if (on) given->films |= row.bit;
    }
  given->euler = euler != 0;
  viscosity_variable = bytes;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  std::string bytes;
  coeffs->append(bytes);
  Suspension_NS::write_bytes(fp, bytes);
}

void PairLubcontact::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  std::string bytes = read_bytes(fp, lmp);
  coeffs->take(bytes);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::write_data(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++)
    fmt::print(fp, "{} {}\n", i, coeff_words(coeffs->of(i, i)));
}

void PairLubcontact::write_data_all(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      fmt::print(fp, "{} {} {}\n", i, j, coeff_words(coeffs->of(i, j)));
}
