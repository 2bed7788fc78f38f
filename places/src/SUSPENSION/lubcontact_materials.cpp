/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// pair_coeff * * FILE NAME1 NAME2 ... keyword value ...: named materials, one per atom type. Each
// pair of types becomes the words of an ordinary pair_coeff.

#include "lubcontact_materials.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "input.h"
#include "lubcontact_material_file.h"
#include "lubcontact_type_coeffs.h"
#include "math_const.h"
#include "suspension_host.h"
#include "suspension_input.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

using namespace LAMMPS_NS;
using Lubcontact_NS::Elastic;
using Lubcontact_NS::Material;
using Lubcontact_NS::MaterialFile;
using Lubcontact_NS::UnitScale;
using Lubcontact_NS::Words;

static constexpr double PI43 = MathConst::MY_4PI3;
static constexpr double DENSITY_RATIO = 1.2;    // atoms and file, before it is worth a warning
static constexpr int SHOWN_TYPES = 4;

namespace {

// The types' share in the command, in units of LAMMPS.
struct Type {
  const Material *material = nullptr;    // null: NULL
  Elastic solid{0.0, 0.0, 0.0};
  double density = 0.0;    // mean of its atoms
  double atoms = 0.0;
};

struct Options {
  std::vector<double> radius;    // one, one per type, or none: those of the atoms
  double modulus = 0.0;          // 0: that of the file
  double soften = 1.0;           // divides it
  double load = 0.0;             // 0: springs in series
  UnitScale unit{1.0, 1.0, 1.0};
  std::vector<char *> others;    // words for every pair, those of the input line
};

/* ----------------------------------------------------------------------
   the command, its errors, and what they point to
------------------------------------------------------------------------- */

class MaterialCommand : protected Pointers {
 public:
  MaterialCommand(LAMMPS *lmp, int narg, char **arg) : Pointers(lmp), narg(narg), arg(arg), shift(0)
  {
    // under hybrid the words are those of the input line from the second on
    while (shift < input->narg && input->arg + shift != arg) shift++;
  }

  // place of a word in the input line, if it came from there
  int at(int iarg) const { return shift < input->narg ? iarg + shift : Error::NOPOINTER; }

  std::string read(int iarg) const;
  MaterialFile parse(const std::string &) const;
  void materials(const MaterialFile &, std::vector<Type> &) const;
  Options options(int) const;

 private:
  int narg;
  char **arg;
  int shift;

  double number(int iarg, const char *name) const
  {
    const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
    if (!(value > 0.0) || !std::isfinite(value))
      error->all(FLERR, at(iarg), "Pair style lubcontact {} must be > 0, but is {}", name,
                 arg[iarg]);
    return value;
  }
  bool unit_scale(UnitScale &) const;
};

// Keywords of this form of the command, and how they are written; all others are those of an
// ordinary pair_coeff.
const std::map<std::string, std::string> OPTIONS = {{"radius", "radius R ..."},
                                                    {"modulus", "modulus E"},
                                                    {"soften", "soften f"},
                                                    {"load", "load F"},
                                                    {"scale", "scale M L T"}};

bool is_option(const std::string &word)
{
  return OPTIONS.count(word) != 0;
}

/* ----------------------------------------------------------------------
   the whole file, on all ranks; LAMMPS' search path
------------------------------------------------------------------------- */

std::string MaterialCommand::read(int iarg) const
{
  std::string text;
  int length = -1;
  if (comm->me == 0) {
    const std::string path = utils::get_potential_file_path(arg[iarg]);
    FILE *fp = path.empty() ? nullptr : fopen(path.c_str(), "r");
    if (fp) {
      char buffer[4096];
      while (const std::size_t n = fread(buffer, 1, sizeof(buffer), fp)) text.append(buffer, n);
      fclose(fp);
      length = static_cast<int>(text.size());
    }
  }
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  if (length < 0)
    error->all(FLERR, at(iarg),
               "Cannot open {}: neither a number (stiffness g of pair style lubcontact) nor a "
               "materials file in the current folder or in LAMMPS_POTENTIALS",
               arg[iarg]);
  text.resize(length);
  MPI_Bcast(&text[0], length, MPI_CHAR, 0, world);
  return text;
}

/* ---------------------------------------------------------------------- */

MaterialFile MaterialCommand::parse(const std::string &text) const
{
  const std::string header = text.substr(0, text.find('\n'));
  auto tag = [&header](const char *name) {
    const auto words = utils::split_words(header);
    const auto found = std::find(words.begin(), words.end(), name);
    return found == words.end() || found + 1 == words.end() ? std::string() : *(found + 1);
  };
  if (tag("UNITS:") != "si")
    error->all(FLERR, at(2), "Materials file {} must have UNITS: si in its first line, but has {}",
               arg[2], tag("UNITS:").empty() ? "none" : tag("UNITS:"));
  const MaterialFile file = Lubcontact_NS::MaterialParser::parse(text);
  if (!file.error.empty())
    error->all(FLERR, at(2), "Materials file {}, line {}: {}", arg[2], file.line, file.error);
  const std::string date = tag("DATE:");
  if (comm->me == 0)
    utils::logmesg(lmp, "Reading materials file {}{}\n", arg[2],
                   date.empty() ? "" : " with DATE: " + date);
  return file;
}

/* ---------------------------------------------------------------------- */

void MaterialCommand::materials(const MaterialFile &file, std::vector<Type> &types) const
{
  const int ntypes = static_cast<int>(types.size()) - 1;
  auto known = [&file](const std::string &name) {
    return name == "NULL" || file.find(name);
  };
  int given = 0;
  while (3 + given < narg && known(arg[3 + given])) given++;
  // a word where a name must be, and which nobody knows, is a misspelt name
  const bool ends = 3 + given >= narg || is_option(arg[3 + given]) || given > ntypes;
  if (given < ntypes && !ends)
    error->all(FLERR, at(3 + given), "There is no material {} in {}, which has: {}", arg[3 + given],
               arg[2], file.names());
  if (given != ntypes)
    error->all(FLERR, at(MIN(2 + given, 3 + ntypes)),
               "Pair_coeff needs one material or NULL for each of the {} atom types, but has {}",
               ntypes, given);
  for (int i = 1; i <= ntypes; i++) types[i].material = file.find(arg[2 + i]);
  if (std::none_of(types.begin(), types.end(), [](const Type &t) {
        return t.material;
      }))
    error->all(FLERR, at(3), "Pair_coeff sets no coefficients: NULL stands for all {} atom types",
               ntypes);
}

/* ----------------------------------------------------------------------
   SI values of LAMMPS' units; false: units without any
------------------------------------------------------------------------- */

bool MaterialCommand::unit_scale(UnitScale &unit) const
{
  const std::string style = update->unit_style;
  if (style == "si")
    unit = {1.0, 1.0, 1.0};
  else if (style == "cgs")
    unit = {1e-3, 1e-2, 1.0};
  else if (style == "micro")
    unit = {1e-15, 1e-6, 1e-6};
  else if (style == "nano")
    unit = {1e-21, 1e-9, 1e-9};
  else if (style != "lj")
    error->all(FLERR,
               "Materials are for units si, cgs, micro, nano, or lj with scale, not for units {}",
               style);
  return style != "lj";
}

/* ----------------------------------------------------------------------
   radius modulus soften load scale, in any order, then the words of an ordinary pair_coeff
------------------------------------------------------------------------- */

Options MaterialCommand::options(int first) const
{
  Options o;
  const bool real = unit_scale(o.unit);
  bool scaled = real;
  int iarg = first;
  while (iarg < narg && is_option(arg[iarg])) {
    const std::string key = arg[iarg];
    Suspension_NS::require_words(FLERR, error, "pair_coeff", narg - iarg, OPTIONS.at(key));
    if (key == "radius") {
      o.radius.assign(1, number(iarg + 1, "radius"));
      for (iarg += 2; iarg < narg && utils::is_double(arg[iarg]); iarg++)
        o.radius.push_back(number(iarg, "radius"));
      const int n = static_cast<int>(o.radius.size());
      if (n != 1 && n != atom->ntypes)
        error->all(FLERR, at(iarg - 1),
                   "Pair_coeff radius needs one number or one for each of the {} atom types, but "
                   "has {}",
                   atom->ntypes, n);
    } else if (key == "scale") {
      if (real)
        error->all(FLERR, at(iarg), "Pair_coeff scale is for units lj only, not for units {}",
                   update->unit_style);
      o.unit = {number(iarg + 1, "scale"), number(iarg + 2, "scale"), number(iarg + 3, "scale")};
      scaled = true;
      iarg += 4;
    } else {
      const double value = number(iarg + 1, key.c_str());
      if (key == "soften" && value < 1.0)
        error->all(FLERR, at(iarg + 1),
                   "Pair style lubcontact soften divides the moduli and must be >= 1, but is {}",
                   arg[iarg + 1]);
      (key == "modulus" ? o.modulus : key == "soften" ? o.soften : o.load) = value;
      iarg += 2;
    }
  }
  if (!scaled)
    error->all(
        FLERR, at(2),
        "Materials have SI units: under units lj add scale M L T, the SI values of the units "
        "of mass, length and time");
  for (; iarg < narg; iarg++) {
    if (is_option(arg[iarg]))
      error->all(FLERR, at(iarg), "Pair_coeff {} must come before {}", arg[iarg], o.others[0]);
    o.others.push_back(arg[iarg]);
  }
  return o;
}

/* ---------------------------------------------------------------------- */

// Radius and density of each type: the means of its atoms.
void average_atoms(LAMMPS *lmp, std::vector<Type> &types)
{
  const Atom *atom = lmp->atom;
  Suspension_NS::require_spheres(lmp, "Pair style lubcontact");
  const std::size_t n = types.size();
  std::vector<double> mine(3 * n, 0.0), all(3 * n);
  for (int i = 0; i < atom->nlocal; i++) {
    double *sums = &mine[3 * atom->type[i]];
    const double r = atom->radius[i];
    sums[0] += 1.0;
    sums[1] += r;
    if (r > 0.0) sums[2] += atom->rmass[i] / (PI43 * r * r * r);
  }
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(3 * n), MPI_DOUBLE, MPI_SUM, lmp->world);
  for (std::size_t t = 1; t < n; t++) {
    types[t].atoms = all[3 * t];
    if (all[3 * t] == 0.0) continue;
    types[t].solid.radius = all[3 * t + 1] / all[3 * t];
    types[t].density = all[3 * t + 2] / all[3 * t];
  }
}

void warn_density(LAMMPS *lmp, int itype, const Type &type, const UnitScale &unit)
{
  if (type.atoms == 0.0 || type.material->density < 0.0 || lmp->comm->me) return;
  const double expected = type.material->density / unit.density();
  const double ratio = type.density / expected;
  if (ratio > DENSITY_RATIO || ratio < 1.0 / DENSITY_RATIO)
    lmp->error->warning(FLERR,
                        "Mean density {:.6g} of the atoms of type {} differs from that of {}, "
                        "{:.6g}: materials do not set masses",
                        type.density, itype, type.material->name, expected);
}

// Words of pair_coeff behind the types: springs, then what file and command say of the surfaces.
// Words of the command are those of the input line, so that an error in them is shown there.
struct PairWords {
  Words made;
  std::vector<char *> all;

  void finish(const std::vector<char *> &others)
  {
    for (auto &word : made) all.push_back(&word[0]);
    all.insert(all.end(), others.begin(), others.end());
  }
  bool has(const char *word) const
  {
    return std::any_of(all.begin(), all.end(), [word](const char *one) {
      return strcmp(one, word) == 0;
    });
  }
};

PairWords pair_words(const MaterialFile &file, const Type &one, const Type &other, double a,
                     const Options &options)
{
  const Lubcontact_NS::Springs k = Lubcontact_NS::springs(one.solid, other.solid, options.load);
  PairWords words;
  words.made = {Lubcontact_NS::to_word(k.g), Lubcontact_NS::to_word(k.kt)};
  const auto &others = options.others;
  const auto surface = Lubcontact_NS::pair_surface(file, *one.material, *other.material);
  for (const auto &property : Lubcontact_NS::surface_words(surface, a, options.unit))
    if (std::none_of(others.begin(), others.end(), [&property](const char *word) {
          return property[0] == word;
        }))
      words.made.insert(words.made.end(), property.begin(), property.end());
  words.finish(others);
  return words;
}

// Their elastic constants and sizes; a table of them.
std::string complete_types(LAMMPS *lmp, const MaterialCommand &command, const Options &options,
                           std::vector<Type> &types)
{
  average_atoms(lmp, types);
  std::string text;
  for (int i = 1; i < static_cast<int>(types.size()); i++) {
    Type &type = types[i];
    if (!type.material) continue;
    if (!options.radius.empty())
      type.solid.radius = options.radius[options.radius.size() == 1 ? 0 : i - 1];
    if (!(type.solid.radius > 0.0))
      lmp->error->all(FLERR, command.at(2 + i),
                      "There are no atoms of type {} whose radius would give the stiffness of {}: "
                      "create them first, or add radius R",
                      i, type.material->name);
    const double measured = type.material->modulus / options.unit.pressure();
    type.solid.modulus = (options.modulus > 0.0 ? options.modulus : measured) / options.soften;
    type.solid.poisson = type.material->poisson;
    warn_density(lmp, i, type, options.unit);
    text += fmt::format("  type {}         {}: modulus {:.6g}, measured {:.6g}, poisson {:.6g}, "
                        "radius {:.6g}{}\n",
                        i, type.material->name, type.solid.modulus, measured, type.solid.poisson,
                        type.solid.radius, options.radius.empty() ? ", mean of the atoms" : "");
  }
  return text;
}

// Numbers as short as they are in a table.
std::string short_number(const std::string &word)
{
  return utils::is_double(word) ? fmt::format("{:.6g}", std::stod(word)) : word;
}

std::string joined(const std::vector<char *> &words, std::size_t first)
{
  std::string text;
  for (std::size_t m = first; m < words.size(); m++)
    text += (m > first ? " " : "") + short_number(words[m]);
  return text;
}

}    // namespace

/* ----------------------------------------------------------------------
   pair_coeff * * FILE NAME1 NAME2 ... keyword value ...
------------------------------------------------------------------------- */

std::vector<TypePair> LAMMPS_NS::read_materials(LAMMPS *lmp, int narg, char **arg,
                                                const LubcontactTypeCoeffs &coeffs,
                                                const Lubcontact_NS::Settings &settings)
{
  Error *error = lmp->error;
  const MaterialCommand command(lmp, narg, arg);
  const MaterialFile file = command.parse(command.read(2));
  for (int m = 0; m < 2; m++)
    if (strcmp(arg[m], "*") != 0)
      error->all(FLERR, command.at(m), "Materials need pair_coeff * *, but found {}", arg[m]);

  const int ntypes = lmp->atom->ntypes;
  std::vector<Type> types(ntypes + 1);
  command.materials(file, types);
  const Options options = command.options(3 + ntypes);
  std::string text =
      fmt::format("Materials of pair style lubcontact, in units {}\n", lmp->update->unit_style) +
      complete_types(lmp, command, options, types);

  std::vector<TypePair> pairs;
  for (int i = 1; i <= ntypes; i++)
    for (int j = i; j <= ntypes; j++) {
      const Type &one = types[i], &other = types[j];
      if (!one.material || !other.material) continue;
      const double a =
          Lubcontact_NS::effective_radius(settings.radius, one.solid.radius, other.solid.radius);
      PairWords words = pair_words(file, one, other, a, options);
      for (const char *needed : {"roughness", "friction"})
        if (!words.has(needed))
          error->all(FLERR, command.at(2 + j),
                     "Materials file {} has no {} for {} with {}: add {} to the command", arg[2],
                     needed, one.material->name, other.material->name, needed);
      if (j <= SHOWN_TYPES)
        text += fmt::format("  types {} {}      g {} kt {}\n", i, j, short_number(words.all[0]),
                            joined(words.all, 1));
      std::string made = fmt::format("pair_coeff {} {}", i, j);
      for (const char *word : words.all) made += std::string(" ") + word;
      const int number = static_cast<int>(words.all.size());
      pairs.push_back({i, j,
                       coeffs.parse(number, words.all.data(), settings.reach_a,
                                    fmt::format("; in what {} makes of {} and {}: {}", arg[2],
                                                one.material->name, other.material->name, made))});
    }
  text +=
      fmt::format("  stiffness      {}; hard spheres need P a/(g roughness) << 1 at pressure P\n",
                  options.load > 0.0 ? fmt::format("Hertz' secant at force {:.6g}", options.load)
                                     : "modulus times effective radius");
  if (lmp->comm->me == 0) utils::logmesg(lmp, text);
  return pairs;
}
