/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Files of materials: text in, materials out, and the words of pair_coeff that say the same.
// All numbers are in SI units and do not depend on the size of a particle.

#ifndef LUBCONTACT_MATERIAL_FILE_H
#define LUBCONTACT_MATERIAL_FILE_H

#include "lubcontact_material.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {

struct SolidFriction {
  enum Law { UNKNOWN, NONE, COULOMB, BY_LOAD } law = UNKNOWN;
  std::vector<std::string> words;    // BY_LOAD: clm step, clm shift, clm ramp, brizmer
  double mu = 0.0;
  double load = 0.0;    // BY_LOAD: critical load, force
};

// What two surfaces do to each other; negative: not known.
struct Surface {
  double roughness = -1.0;    // height of the asperities, length
  double adhesion = -1.0;     // length over which a contact in tension holds
  double repulsion = -1.0;    // force over effective radius, at contact
  double screening = -1.0;    // its decay length
  SolidFriction friction;
};

struct Material {
  std::string name;
  int line = 0;
  double modulus = -1.0, poisson = NAN, density = -1.0;
  Surface surface;
};

struct MaterialPair {
  std::string first, second;
  Surface surface;    // replaces what is known here
};

struct MaterialFile {
  std::vector<Material> materials;
  std::vector<MaterialPair> pairs;
  std::string error;    // empty: all is well
  int line = 0;         // of the error

  const Material *find(const std::string &name) const
  {
    for (const auto &material : materials)
      if (material.name == name) return &material;
    return nullptr;
  }

  std::string names() const
  {
    std::string all;
    for (const auto &material : materials) all += (all.empty() ? "" : " ") + material.name;
    return all;
  }
};

using Words = std::vector<std::string>;

// Reads one file; stops at the first error.
class MaterialParser {
 public:
  static MaterialFile parse(const std::string &text)
  {
    MaterialParser parser;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line) && parser.good();) {
      parser.file.line++;
      std::istringstream stream(line.substr(0, line.find('#')));
      Words words;
      for (std::string word; stream >> word;) words.push_back(word);
      if (!words.empty()) parser.statement(words);
    }
    if (parser.good()) parser.complete();
    return parser.file;
  }

 private:
  MaterialFile file;

  bool good() const { return file.error.empty(); }
  void fail(const std::string &what)
  {
    if (good()) file.error = what;
  }

  void statement(const Words &words)
  {
    if (words[0] == "material") {
      start(words);
    } else if (words[0] == "pair") {
      pair(words);
    } else if (file.materials.empty()) {
      fail("expected material NAME, but found " + words[0]);
    } else {
      Material &now = file.materials.back();
      std::size_t at = 0;
      if (words[0] == "modulus")
        once(now.modulus, words, at, false);
      else if (words[0] == "poisson")
        poisson(now.poisson, words, at);
      else if (words[0] == "density")
        once(now.density, words, at, false);
      else
        surface(now.surface, words, at);
      if (good() && at < words.size()) fail("unexpected " + words[at] + " after " + words[0]);
    }
  }

  void start(const Words &words)
  {
    if (words.size() != 2) return fail("expected one name: material NAME");
    if (words[1] == "NULL") return fail("NULL cannot be the name of a material");
    if (const Material *old = file.find(words[1]))
      return fail("material " + words[1] + " is already in line " + std::to_string(old->line));
    if (!file.materials.empty()) complete();
    if (!good()) return;
    Material next;
    next.name = words[1];
    next.line = file.line;
    file.materials.push_back(next);
  }

  void complete()    // the material that ends here
  {
    if (file.materials.empty()) return fail("there is no material");
    const Material &last = file.materials.back();
    if (last.modulus < 0.0) fail("material " + last.name + " above has no modulus");
    if (std::isnan(last.poisson)) fail("material " + last.name + " above has no poisson");
  }

  void pair(const Words &words)
  {
    if (words.size() < 4) return fail("expected pair NAME NAME and their special values");
    for (std::size_t m = 1; m < 3; m++)
      if (!file.find(words[m])) return fail("there is no material " + words[m] + " above");
    if (words[1] == words[2]) return fail("pair needs two different materials");
    for (const auto &other : file.pairs)
      if ((other.first == words[1] && other.second == words[2]) ||
          (other.first == words[2] && other.second == words[1]))
        return fail("pair " + words[1] + " " + words[2] + " is there twice");
    MaterialPair next{words[1], words[2], {}};
    for (std::size_t at = 3; good() && at < words.size();) surface(next.surface, words, at);
    file.pairs.push_back(next);
  }

  // at: the keyword; on return the word behind its values
  void surface(Surface &s, const Words &words, std::size_t &at)
  {
    const std::string key = words[at];
    if (key == "roughness") {
      once(s.roughness, words, at, true);
    } else if (key == "adhesion") {
      once(s.adhesion, words, at, true);
    } else if (key == "repulsion") {
      once(s.repulsion, words, at, true);
      at--;
      if (good()) s.screening = value(words, at, key, false);
    } else if (key == "friction") {
      if (s.friction.law != SolidFriction::UNKNOWN) return fail("friction is there twice");
      friction(s.friction, words, at);
    } else {
      fail("unknown property " + key);
    }
  }

  void friction(SolidFriction &f, const Words &words, std::size_t &at)
  {
    const std::string law = at + 1 < words.size() ? words[at + 1] : "missing";
    at++;
    if (law == "none") {
      f.law = SolidFriction::NONE;
      at++;
    } else if (law == "coulomb") {
      f.law = SolidFriction::COULOMB;
      f.mu = value(words, at, "coefficient of friction", true);
    } else if (law == "clm") {
      const std::string mode = at + 1 < words.size() ? words[at + 1] : "missing";
      if (mode != "step" && mode != "shift" && mode != "ramp")
        return fail("friction clm must be step, shift or ramp, but is " + mode);
      at++;
      by_load(f, {law, mode}, words, at, true);
    } else if (law == "brizmer") {
      by_load(f, {law}, words, at, false);
    } else {
      fail("friction must be none, coulomb, clm or brizmer, but is " + law);
    }
  }

  void by_load(SolidFriction &f, const Words &name, const Words &words, std::size_t &at,
               bool zero_allowed)
  {
    f.law = SolidFriction::BY_LOAD;
    f.words = name;
    f.mu = value(words, at, "coefficient of friction", zero_allowed);
    at--;
    f.load = value(words, at, "critical load", true);
  }

  void once(double &target, const Words &words, std::size_t &at, bool zero_allowed)
  {
    const std::string key = words[at];
    if (target >= 0.0) return fail(key + " is there twice");
    target = value(words, at, key, zero_allowed);
  }

  void poisson(double &target, const Words &words, std::size_t &at)
  {
    if (!std::isnan(target)) return fail("poisson is there twice");
    target = number(words, at, "poisson");
    if (good() && !(target > -1.0 && target <= 0.5))
      fail("poisson must be above -1 and at most 0.5, but is " + words[1]);
  }

  double value(const Words &words, std::size_t &at, const std::string &name, bool zero_allowed)
  {
    const double x = number(words, at, name);
    if (good() && !(x > 0.0 || (zero_allowed && x == 0.0)))
      fail(name + " must be " + (zero_allowed ? ">=" : ">") + " 0, but is " + words[at - 1]);
    return x;
  }

  // the word behind at; at moves behind it
  double number(const Words &words, std::size_t &at, const std::string &name)
  {
    if (++at >= words.size()) {
      fail(name + " needs a number");
      return 0.0;
    }
    const char *start = words[at].c_str();
    char *end = nullptr;
    const double x = std::strtod(start, &end);
    if (end == start || *end != '\0' || !std::isfinite(x))
      fail(name + " must be a number, but is " + words[at]);
    at++;
    return x;
  }
};

/* ---------------------------------------------------------------------- */

inline double mean_or_unknown(double a, double b)
{
  return a >= 0.0 && b >= 0.0 ? 0.5 * (a + b) : -1.0;
}

// A law that one of them has not, the pair has not; a load-dependent law wins over a plain one.
inline SolidFriction mix(const SolidFriction &a, const SolidFriction &b)
{
  SolidFriction f;
  if (a.law == SolidFriction::UNKNOWN || b.law == SolidFriction::UNKNOWN) return f;
  f.law = SolidFriction::NONE;
  if (a.law == SolidFriction::NONE || b.law == SolidFriction::NONE) return f;
  f.law = a.law > b.law ? a.law : b.law;
  f.mu = std::sqrt(a.mu * b.mu);
  if (a.law != SolidFriction::BY_LOAD || b.law != SolidFriction::BY_LOAD) {
    const SolidFriction &loaded = a.law == SolidFriction::BY_LOAD ? a : b;
    f.words = loaded.words;
    f.load = loaded.load;
  } else if (a.words == b.words) {
    f.words = a.words;
    f.load = std::sqrt(a.load * b.load);
  } else {
    f.law = SolidFriction::UNKNOWN;    // somebody has to say
  }
  return f;
}

inline Surface mix(const Surface &a, const Surface &b)
{
  Surface s;
  s.roughness = mean_or_unknown(a.roughness, b.roughness);
  s.adhesion = mean_or_unknown(a.adhesion, b.adhesion);
  if (a.repulsion >= 0.0 && b.repulsion >= 0.0) s.repulsion = std::sqrt(a.repulsion * b.repulsion);
  s.screening = mean_or_unknown(a.screening, b.screening);
  s.friction = mix(a.friction, b.friction);
  return s;
}

// Mixed, and then what the file says about this pair.
inline Surface pair_surface(const MaterialFile &file, const Material &a, const Material &b)
{
  Surface s = a.name == b.name ? a.surface : mix(a.surface, b.surface);
  for (const auto &pair : file.pairs) {
    if (!((pair.first == a.name && pair.second == b.name) ||
          (pair.first == b.name && pair.second == a.name)))
      continue;
    const Surface &own = pair.surface;
    if (own.roughness >= 0.0) s.roughness = own.roughness;
    if (own.adhesion >= 0.0) s.adhesion = own.adhesion;
    if (own.repulsion >= 0.0) {
      s.repulsion = own.repulsion;
      s.screening = own.screening;
    }
    if (own.friction.law != SolidFriction::UNKNOWN) s.friction = own.friction;
  }
  return s;
}

inline std::string to_word(double x)
{
  char buffer[40];
  std::snprintf(buffer, sizeof(buffer), "%.17g", x);
  return buffer;
}

// One property per entry, each the words of pair_coeff, in units of LAMMPS; a is the effective
// radius in these units.
inline std::vector<Words> surface_words(const Surface &s, double a, const UnitScale &unit)
{
  std::vector<Words> all;
  if (s.roughness >= 0.0) all.push_back({"roughness", to_word(s.roughness / unit.length / a)});
  if (s.adhesion >= 0.0) all.push_back({"adhesion", to_word(s.adhesion / unit.length / a)});
  if (s.repulsion >= 0.0)
    all.push_back({"repulsion", to_word(s.repulsion * unit.length / unit.force() * a),
                   to_word(s.screening / unit.length)});
  const SolidFriction &f = s.friction;
  if (f.law == SolidFriction::NONE) all.push_back({"friction", "none"});
  if (f.law == SolidFriction::COULOMB) all.push_back({"friction", "coulomb", to_word(f.mu)});
  if (f.law == SolidFriction::BY_LOAD) {
    Words words{"friction"};
    words.insert(words.end(), f.words.begin(), f.words.end());
    words.push_back(to_word(f.mu));
    words.push_back(to_word(f.load / unit.force()));
    all.push_back(words);
  }
  return all;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
