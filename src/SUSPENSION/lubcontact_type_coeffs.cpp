/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "lubcontact_type_coeffs.h"

#include "atom.h"
#include "error.h"
#include "input.h"
#include "memory.h"
#include "restart_seal.h"
#include "suspension_input.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using Lubcontact_NS::Column;
using Lubcontact_NS::COLUMNS;
using Lubcontact_NS::FRICTION_NAME;
using Lubcontact_NS::FrictionLaw;
using Lubcontact_NS::Law;
using Lubcontact_NS::NUM_COLUMNS;
using Lubcontact_NS::Settings;
using Lubcontact_NS::TypeCoeffs;

/* ---------------------------------------------------------------------- */

LubcontactTypeCoeffs::LubcontactTypeCoeffs(LAMMPS *lmp) :
    Pointers(lmp), set_by_user(nullptr), friction_law(nullptr), columns(), ntypes(0)
{
}

LubcontactTypeCoeffs::~LubcontactTypeCoeffs()
{
  memory->destroy(set_by_user);
  memory->destroy(friction_law);
  for (double **&column : columns) memory->destroy(column);
}

/* ---------------------------------------------------------------------- */

void LubcontactTypeCoeffs::create()
{
  if (set_by_user) return;
  ntypes = atom->ntypes;
  const int n = ntypes + 1;
  memory->create(set_by_user, n, n, "pair:setflag");
  memory->create(friction_law, n, n, "pair:law");
  for (double **&column : columns) memory->create(column, n, n, "pair:column");
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      set_by_user[i][j] = 0;
      put(i, j, {});    // no coefficients: another style's pair under hybrid
    }
}

/* ---------------------------------------------------------------------- */

double **LubcontactTypeCoeffs::column(const char *name) const
{
  for (std::size_t m = 0; m < NUM_COLUMNS; m++)
    if (strcmp(name, COLUMNS[m].name) == 0) return columns[m];
  return nullptr;
}

TypeCoeffs LubcontactTypeCoeffs::of(int i, int j) const
{
  TypeCoeffs c;
  for (std::size_t m = 0; m < NUM_COLUMNS; m++) c.*COLUMNS[m].value = columns[m][i][j];
  c.law = static_cast<FrictionLaw>(friction_law[i][j]);
  return c;
}

void LubcontactTypeCoeffs::put(int i, int j, const TypeCoeffs &c)
{
  for (std::size_t m = 0; m < NUM_COLUMNS; m++)
    columns[m][i][j] = columns[m][j][i] = c.*COLUMNS[m].value;
  friction_law[i][j] = friction_law[j][i] = static_cast<int>(c.law);
}

/* ---------------------------------------------------------------------- */

int LAMMPS_NS::place_of(Input *input, const char *word)
{
  for (int n = 0; n < input->narg; n++)
    if (input->arg[n] == word) return n;
  return Error::NOPOINTER;
}

/* ----------------------------------------------------------------------
   g kt keyword value ...
------------------------------------------------------------------------- */

namespace {

class CoeffParser : protected Pointers {
 public:
  CoeffParser(LAMMPS *lmp, int narg, char **arg, const std::string &origin) :
      Pointers(lmp), narg(narg), arg(arg), origin(origin)
  {
  }

  TypeCoeffs parse(double reach) const;

 private:
  int narg;
  char **arg;
  const std::string origin;    // of words that are not in the input line; appended to messages

  double number(int iarg, const Column &, bool zero) const;
  int parse_friction(int iarg, TypeCoeffs &) const;
  int parse_keyword(int iarg, std::size_t column, TypeCoeffs &) const;
};

double CoeffParser::number(int iarg, const Column &column, bool zero) const
{
  const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
  if (!(value > 0.0 || (zero && value == 0.0)) || !std::isfinite(value))
    error->all(FLERR, place_of(input, arg[iarg]),
               "Pair style lubcontact {} must be {} 0, but is {}", column.what, zero ? ">=" : ">",
               arg[iarg]);
  if (value > column.most)
    error->all(FLERR, place_of(input, arg[iarg]),
               "Pair style lubcontact {} must be <= {}, but is {}", column.what, column.most,
               arg[iarg]);
  return value;
}

const Column &column_at(double TypeCoeffs::*value)
{
  return COLUMNS[Lubcontact_NS::column_of(value)];
}

/* ----------------------------------------------------------------------
   none, coulomb mu, clm step|shift|ramp mu F, or brizmer mu F; returns the number of words
------------------------------------------------------------------------- */

int CoeffParser::parse_friction(int iarg, TypeCoeffs &c) const
{
  Suspension_NS::require_words(FLERR, error, "pair_coeff", narg - iarg,
                               "friction none|coulomb|clm|brizmer");
  std::string name = arg[iarg + 1];
  int word = iarg + 1;
  if (name == "clm" && iarg + 2 < narg) name += std::string(" ") + arg[++word];
  int law = 0;
  while (law < static_cast<int>(FrictionLaw::NUM_LAWS) && name != FRICTION_NAME[law]) law++;
  if (law == static_cast<int>(FrictionLaw::NUM_LAWS))
    error->all(
        FLERR, place_of(input, arg[word]),
        "Pair style lubcontact friction must be none, coulomb mu, or clm step, clm shift, clm ramp "
        "or brizmer with mu and the critical load, but is {}{}",
        name, origin);
  c.law = static_cast<FrictionLaw>(law);
  c.friction = c.critical = 0.0;
  const bool has_mu = c.law != FrictionLaw::NONE, has_load = Lubcontact_NS::has_load(c.law);
  const std::string usage = "friction " + name + (has_mu ? " mu" : "") + (has_load ? " F" : "");
  Suspension_NS::require_words(FLERR, error, "pair_coeff", narg - iarg, usage);
  if (has_mu)
    c.friction = number(++word, column_at(&TypeCoeffs::friction), c.law != FrictionLaw::BRIZMER);
  if (has_load) c.critical = number(++word, column_at(&TypeCoeffs::critical), true);
  return word + 1 - iarg;
}

/* ---------------------------------------------------------------------- */

int CoeffParser::parse_keyword(int iarg, std::size_t first, TypeCoeffs &c) const
{
  const std::string values = COLUMNS[first].keyword;
  Suspension_NS::require_words(FLERR, error, "pair_coeff", narg - iarg,
                               std::string(COLUMNS[first].name) + " " + values);
  const int number_of_values = static_cast<int>(utils::count_words(values));
  for (int n = 0; n < number_of_values; n++) {
    const Column &column = COLUMNS[first + n];
    const bool zero = column.zero && column.mixing != Lubcontact_NS::Mixing::WITH_LAST;
    c.*column.value = number(iarg + 1 + n, column, zero);
  }
  return 1 + number_of_values;
}

TypeCoeffs CoeffParser::parse(double reach) const
{
  TypeCoeffs c;
  c.g = number(0, column_at(&TypeCoeffs::g), false);
  c.kt = number(1, column_at(&TypeCoeffs::kt), false);
  c.asperity = c.g;
  const char *adhesion_word = nullptr;
  for (int iarg = 2; iarg < narg;) {
    const std::string key = arg[iarg];
    if (key == "friction") {
      iarg += parse_friction(iarg, c);
      continue;
    }
    std::size_t found = 0;
    while (found < NUM_COLUMNS && !(COLUMNS[found].keyword && key == COLUMNS[found].name)) found++;
    if (found == NUM_COLUMNS)
      error->all(FLERR, place_of(input, arg[iarg]), "Unknown pair_coeff lubcontact keyword: {}{}",
                 key, origin);
    const int words = parse_keyword(iarg, found, c);
    if (COLUMNS[found].value == &TypeCoeffs::roughness_a && c.roughness_a >= reach)
      error->all(FLERR, place_of(input, arg[iarg + 1]),
                 "Pair style lubcontact roughness must be below the range {}, but is {}{}", reach,
                 c.roughness_a, origin);
    if (COLUMNS[found].value == &TypeCoeffs::adhesion_a) adhesion_word = arg[iarg + 1];
    iarg += words;
  }
  if (c.adhesion_a > 0.0 && c.roughness_a == 0.0)
    error->all(FLERR, place_of(input, adhesion_word),
               "Pair style lubcontact adhesion acts between asperities, but these types have none: "
               "give them a roughness > 0{}",
               origin);
  return c;
}

}    // namespace

TypeCoeffs LubcontactTypeCoeffs::parse(int narg, char **arg, double reach,
                                       const std::string &origin) const
{
  return CoeffParser(lmp, narg, arg, origin).parse(reach);
}

/* ---------------------------------------------------------------------- */

void LubcontactTypeCoeffs::mix(int i, int j)
{
  const TypeCoeffs one = of(i, i), other = of(j, j);
  if (!laws_agree(one, other))
    error->all(FLERR,
               "Types {} and {} of pair style lubcontact have different laws of friction, {} and "
               "{}: choose one with pair_coeff {} {}",
               i, j, FRICTION_NAME[friction_law[i][i]], FRICTION_NAME[friction_law[j][j]], i, j);
  put(i, j, mixed(one, other));
}

/* ---------------------------------------------------------------------- */

void LubcontactTypeCoeffs::check(int i, int j, const Settings &s) const
{
  const TypeCoeffs c = of(i, j);
  bool allowed = c.roughness_a < s.reach_a;
  std::string values;
  for (const Column &column : COLUMNS) {
    allowed = allowed && is_allowed(column, c.*column.value);
    values += fmt::format(" {} {}", column.name, c.*column.value);
  }
  if (!allowed)
    error->all(FLERR, "Pair style lubcontact coefficients of types {} {} are out of range:{}", i, j,
               values);
  const std::string wrong = complaint(c);
  if (!wrong.empty()) error->all(FLERR, "Pair style lubcontact types {} {}: {}", i, j, wrong);

  const double contact = touching_gap_a(pair_coeffs(s, c));
  if (c.adhesion_a > 0.0 && contact >= s.reach_a && (s.films || c.screening > 0.0))
    error->all(FLERR,
               "Adhesive contacts of types {} {} break at {:.6g} effective radii, beyond the range "
               "{} of pair style lubcontact: reduce the adhesion or extend the range",
               i, j, contact, s.reach_a);
}

/* ---------------------------------------------------------------------- */

Law LubcontactTypeCoeffs::law(const Settings &settings, bool mixed) const
{
  Law law(settings, ntypes);
  for (int i = 1; i <= ntypes; i++)
    for (int j = i; j <= ntypes; j++)
      if (mixed || set_by_user[i][j]) law.of(i, j) = law.of(j, i) = of(i, j);
  return law;
}

void LubcontactTypeCoeffs::adopt(const Law &law)
{
  create();
  for (int i = 1; i <= ntypes; i++)
    for (int j = i; j <= ntypes; j++) {
      set_by_user[i][j] = law.of(i, j).g > 0.0;
      put(i, j, law.of(i, j));
    }
}

/* ---------------------------------------------------------------------- */

void LubcontactTypeCoeffs::append(std::string &bytes) const
{
  using Suspension_NS::append_bytes;
  for (int i = 1; i <= ntypes; i++)
    for (int j = i; j <= ntypes; j++) {
      append_bytes(bytes, set_by_user[i][j]);
      append_bytes(bytes, friction_law[i][j]);
      if (!set_by_user[i][j]) continue;
      for (double **column : columns) append_bytes(bytes, column[i][j]);
    }
}

void LubcontactTypeCoeffs::take(std::string &bytes)
{
  using Suspension_NS::take_bytes;
  create();
  for (int i = 1; i <= ntypes; i++)
    for (int j = i; j <= ntypes; j++) {
      take_bytes(bytes, set_by_user[i][j]);
      take_bytes(bytes, friction_law[i][j]);
      if (!set_by_user[i][j]) continue;
      for (double **column : columns) take_bytes(bytes, column[i][j]);
    }
}

/* ---------------------------------------------------------------------- */

double LubcontactTypeCoeffs::memory_usage() const
{
  return (ntypes + 1.0) * (ntypes + 1.0) * (NUM_COLUMNS * sizeof(double) + 2 * sizeof(int));
}

/* ---------------------------------------------------------------------- */

std::string LAMMPS_NS::surface_words(const TypeCoeffs &c)
{
  std::string words = fmt::format("asperity {} roughness {} friction {}", c.asperity, c.roughness_a,
                                  FRICTION_NAME[static_cast<int>(c.law)]);
  if (c.law != FrictionLaw::NONE) words += fmt::format(" {}", c.friction);
  if (Lubcontact_NS::has_load(c.law)) words += fmt::format(" {}", c.critical);
  for (std::size_t m = Lubcontact_NS::column_of(&TypeCoeffs::adhesion_a); m < NUM_COLUMNS; m++) {
    const bool follows = m + 1 < NUM_COLUMNS && !COLUMNS[m + 1].keyword;
    const double decides = c.*COLUMNS[follows ? m + 1 : m].value;    // repulsion 0 has a length
    // as if not given
    if (!COLUMNS[m].keyword || decides == TypeCoeffs().*COLUMNS[follows ? m + 1 : m].value)
      continue;
    words += fmt::format(" {} {}", COLUMNS[m].name, c.*COLUMNS[m].value);
    if (follows) words += fmt::format(" {}", decides);
  }
  return words;
}

std::string LAMMPS_NS::coeff_words(const TypeCoeffs &c)
{
  return fmt::format("{} {} {}", c.g, c.kt, surface_words(c));
}

std::string LAMMPS_NS::style_words(const Settings &s, const std::string &viscosity)
{
  std::string text = fmt::format("{} {} {}", viscosity,
                                 Lubcontact_NS::RANGE_NAME[static_cast<int>(s.range)], s.reach_a);
  if (s.radius == Lubcontact_NS::Radius::MEAN) text += " radius mean";
  for (const auto &row : Lubcontact_NS::EFFECTS)
    if (row.is_film() && !(s.films & row.bit)) text += std::string(" ") + row.name + " no";
  if ((s.films & Lubcontact_NS::SQUEEZE) && s.euler) text += " gap euler";
  if ((s.films & Lubcontact_NS::ROLL) && s.roll_coeff != Settings().roll_coeff)
    text += fmt::format(" rollcoeff {}", s.roll_coeff);
  return text;
}
