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

#include <cstring>
#include <map>

using namespace LAMMPS_NS;

static constexpr int FEW_PARTNERS = 3;

// values of each keyword; isolated may have one
static std::map<std::string, std::string> keywords()
{
  std::map<std::string, std::string> all = {{"spin", "wx wy wz"},
                                            {"shape", "sphere|disc"},
                                            {"hindrance", "none|mean|phi|factor"},
                                            {"isolated", ""},
                                            {"others", "factor"}};
  for (const auto &flow : BackgroundFlow::styles()) all[flow.keyword] = flow.usage;
  return all;
}

/* ---------------------------------------------------------------------- */

BackgroundFluid::BackgroundFluid(LAMMPS *lmp, Fix *owner, int narg, char **arg) :
    Pointers(lmp), fix(owner), style(owner->style), own(lmp), eta_of_pair(false),
    needs_viscosity(false), elsewhere(false), eta_word("eta"),
    rule(BackgroundHindrance::none(lmp, owner)), body(Fluid_NS::Shape::SPHERE), isolated(0),
    evaluated(false), viscosity(0.0), partners(nullptr)
{
  Suspension_NS::require_words(FLERR, error, "fix " + style, narg + 1,
                               "fix ID group " + style + " eta ...");
  words = utils::join_words(std::vector<std::string>(arg + 3, arg + narg), " ");
  if (strcmp(arg[3], "pair") == 0)
    eta_of_pair = true;
  else
    eta = Suspension_NS::InputNumber(lmp, arg[3]);
  if (!eta_of_pair && eta.is_number() && !(eta.value >= 0.0))
    error->all(FLERR, 3, "Fix {} viscosity must be >= 0, but is {}", style, arg[3]);
  parse(narg, arg);
  if (!flow) flow = BackgroundFlow::at_rest(lmp, owner);
}

BackgroundFluid::BackgroundFluid(LAMMPS *lmp, Fix *owner, const Choice &choice) :
    Pointers(lmp), fix(owner), style(owner->style), words(choice.typed), own(lmp),
    eta(choice.viscosity), eta_of_pair(choice.of_pair), needs_viscosity(true),
    elsewhere(choice.elsewhere), eta_word("viscosity"), flow(BackgroundFlow::of_cell(lmp, owner)),
    rule(BackgroundHindrance::none(lmp, owner)), body(Fluid_NS::Shape::SPHERE),
    isolated(choice.isolated), evaluated(false), viscosity(0.0), partners(nullptr)
{
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::parse(int narg, char **arg)
{
  const auto known = keywords();
  std::map<std::string, int> places;
  std::string found;    // flow
  for (int iarg = 4; iarg < narg;) {
    const std::string key = arg[iarg];
    const auto usage = known.find(key);
    if (usage == known.end())
      error->all(FLERR, iarg, "Unknown fix {} keyword: {}", style, arg[iarg]);
    Suspension_NS::require_words(FLERR, error, "fix " + style, narg - iarg,
                                 key + " " + usage->second);
    if (places.count(key)) error->all(FLERR, iarg, "Fix {} {} is given twice", style, key);
    places[key] = iarg;

    for (const auto &kind : BackgroundFlow::styles()) {
      if (key != kind.keyword) continue;
      if (flow) error->all(FLERR, iarg, "Fix {} already has flow {}; remove {}", style, found, key);
      flow = kind.make(lmp, {fix, arg, iarg});
      found = key;
    }
    if (key == "shape") parse_shape(iarg + 1, arg);
    if (key == "others") parse_others(iarg + 1, arg);
    iarg++;
    if (key == "hindrance")
      rule = BackgroundHindrance::make(lmp, fix, narg, arg, iarg);
    else if (key == "isolated")
      parse_isolated(narg, arg, iarg);
    else
      iarg += static_cast<int>(utils::count_words(usage->second));
  }
  if (places.count("others") && !places.count("isolated"))
    error->all(FLERR, places["others"],
               "Fix {} others cannot act without isolated; for a weaker drag on all particles use "
               "hindrance",
               style);
  const auto spin = places.find("spin");
  if (spin == places.end()) return;
  if (!flow || !flow->take_spin(arg + spin->second + 1))
    error->all(FLERR, spin->second, "Fix {} spin cannot act without velocity", style);
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::parse_shape(int iarg, char **arg)
{
  if (strcmp(arg[iarg], "disc") == 0)
    body = Fluid_NS::Shape::DISC;
  else if (strcmp(arg[iarg], "sphere") != 0)
    error->all(FLERR, iarg, "Fix {} shape must be sphere or disc, but is {}", style, arg[iarg]);
  if (body == Fluid_NS::Shape::DISC && domain->dimension != 2)
    error->all(FLERR, iarg, "Fix {} shape disc needs a 2d simulation; use: dimension 2", style);
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::parse_isolated(int narg, char **arg, int &iarg)
{
  isolated = FEW_PARTNERS;
  if (iarg == narg || !utils::is_integer(arg[iarg])) return;
  isolated = utils::inumeric(FLERR, arg[iarg], false, lmp);
  if (isolated < 1)
    error->all(FLERR, iarg, "Fix {} isolated must be > 0, but is {}", style, arg[iarg]);
  iarg++;
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::parse_others(int iarg, char **arg)
{
  others = Suspension_NS::InputNumber(lmp, arg[iarg]);
  if (others.is_number() && !(others.value >= 0.0))
    error->all(FLERR, iarg, "Fix {} others must be >= 0, but is {}", style, arg[iarg]);
}
