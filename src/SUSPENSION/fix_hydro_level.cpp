/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the levels of fix hydro share: words, the fluid, and what they do not work with.

#include "fix_hydro_level.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_background_fluid.h"
#include "hydro_tensors.h"
#include "lubcontact_law.h"
#include "memory.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "suspension_host.h"

#include <algorithm>

using namespace LAMMPS_NS;
using Suspension_NS::require_words;

// fixes that may come later: they read forces, or set them whatever they were
static constexpr const char *READERS[] = {"setforce", "freeze", "store/force"};

/* ---------------------------------------------------------------------- */

HydroLevel::HydroLevel(LAMMPS *lmp, Fix *owner, int numbers) :
    Pointers(lmp), columns(numbers), held(nullptr), fix(owner), strain()
{
}

HydroLevel::~HydroLevel()
{
  memory->destroy(held);
}

/* ---------------------------------------------------------------------- */

std::map<std::string, int> HydroLevel::parse(int narg, char **arg, const Keywords &keywords,
                                             const std::function<int(int)> &parse_one) const
{
  std::map<std::string, int> given;
  for (int iarg = 4; iarg < narg;) {
    const std::string key = arg[iarg];
    const auto found = keywords.find(key);
    if (found == keywords.end())
      error->all(FLERR, iarg, "Unknown fix hydro {} keyword: {}", arg[3], key);
    if (given.count(key)) error->all(FLERR, iarg, "Fix hydro {} is given twice", key);
    given[key] = iarg;
    require_words(FLERR, error, "fix hydro", narg - iarg, key + " " + found->second);
    iarg += parse_one(iarg);
  }
  return given;
}

int HydroLevel::parse_viscosity(int iarg, char **arg, BackgroundFluid::Choice &choice) const
{
  choice.of_pair = arg[iarg + 1] == std::string("pair");
  if (choice.of_pair) return 2;
  choice.viscosity = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
  if (choice.viscosity.is_number()) positive(iarg + 1, arg, arg[iarg]);
  return 2;
}

double HydroLevel::positive(int iarg, char **arg, const std::string &key) const
{
  const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
  if (!(value > 0.0))
    error->all(FLERR, iarg, "Fix hydro {} must be > 0, but is {}", key, arg[iarg]);
  return value;
}

/* ---------------------------------------------------------------------- */

void HydroLevel::init()
{
  check_alone();
  fluid->init();
  check_films();
  check_others();
  check_order();
}

void HydroLevel::check_alone() const
{
  if (modify->get_fix_by_style("^hydro").size() > 1)
    error->all(FLERR, "More than one fix hydro: all particles move each other, use one for all");
  if (domain->dimension == 2)
    error->all(FLERR,
               "Fix hydro works in 3d only: in 2d particles have no volume of fluid around them; "
               "use fix drag/background");
  const auto plates = modify->get_fix_by_style("^rheometer/plates");
  if (!plates.empty())
    error->all(FLERR,
               "Fix hydro knows no walls: the plates of fix {} would be spheres in a periodic "
               "fluid; use fix deform/rheometer",
               plates[0]->id);
}

/* ----------------------------------------------------------------------
   what the films and the fluid share would act twice, or not at all
------------------------------------------------------------------------- */

void HydroLevel::check_films() const
{
  for (const PairLubcontact *pair : PairLubcontact::all(lmp)) {
    const Lubcontact_NS::Settings &s = pair->settings();
    const bool residual = s.range == Lubcontact_NS::Range::RESIDUAL;
    if (!s.films || residual == leaves_residual()) continue;
    if (residual)
      error->all(FLERR,
                 "Fix hydro mean has no far field that would leave films of range residual: use "
                 "range cut, or fix hydro grid");
    error->all(FLERR,
               "Fix hydro grid has a part of the films of pair_style lubcontact ... {}, which "
               "would act twice: use range residual, or switch the films off",
               Lubcontact_NS::RANGE_NAME[static_cast<int>(s.range)]);
  }
}

/* ----------------------------------------------------------------------
   nobody else drags these particles
------------------------------------------------------------------------- */

void HydroLevel::check_others()
{
  for (const auto &other : modify->get_fix_list()) {
    const std::string name = other->id, kind = other->style;
    if (utils::strmatch(kind, "^drag/background"))
      fluid->exclusive().forbid(other->groupbit, [name](const std::string &who) {
        return fmt::format("Fix hydro has the drag of {} already: remove fix {} drag/background, "
                           "or give it another group",
                           who, name);
      });
    if (!utils::strmatch(kind, "^overdamped")) continue;
    const auto *mover = dynamic_cast<FixBackgroundFluid *>(other);
    if (!drags_all())
      fluid->exclusive().forbid(other->groupbit, [name, kind](const std::string &who) {
        return fmt::format("Fix hydro mean acts on {} of fix {} {}, which has a drag of its own on "
                           "all: use fix nve/sphere with a small density",
                           who, name, kind);
      });
    else if (mover && !mover->background().is_elsewhere())
      fluid->exclusive().forbid(other->groupbit, [name, kind](const std::string &who) {
        return fmt::format("Fix hydro acts on {} of fix {} {}, which has a drag of its own: use "
                           "fix {} {} hydro",
                           who, name, kind, name, kind);
      });
  }
}

/* ----------------------------------------------------------------------
   what acts together with a strong drag is damped by it: all forces must be known here
------------------------------------------------------------------------- */

void HydroLevel::check_order() const
{
  bool later = false;
  for (const auto &other : modify->get_fix_list()) {
    const std::string kind = other->style;
    const bool reads = std::any_of(std::begin(READERS), std::end(READERS), [&](const char *reader) {
      return kind == reader;
    });
    if (other == fix)
      later = true;
    else if (later && !reads && (modify->get_fix_mask(other) & FixConst::POST_FORCE))
      error->all(FLERR,
                 "Fix {} {} may add forces after fix hydro, which needs all other forces: define "
                 "it before fix hydro",
                 other->id, other->style);
  }
}

/* ---------------------------------------------------------------------- */

void HydroLevel::find_strain(double *five) const
{
  const auto e = Suspension_NS::cell_strain(domain);
  Hydro_NS::put_strain({{e.xx, e.xy, e.xz}, {e.xy, e.yy, e.yz}, {e.xz, e.yz, e.zz}}, five);
}

/* ---------------------------------------------------------------------- */

void HydroLevel::find_dragged()
{
  const int *mask = atom->mask, groupbit = fix->groupbit, number = atom->nlocal;
  const BackgroundFluid::Isolation isolation = fluid->isolation();
  const ExclusiveParticles &exclusive = fluid->exclusive();
  pulled.clear();
  const bool everyone = fix->igroup == 0 && !exclusive.has_rules();
  if (everyone && isolation.partners) {    // the usual case, in few instructions
    for (int i = 0; i < number; i++)
      if (isolation.partners[i] < isolation.fewer) pulled.push_back(i);
    return;
  }
  for (int i = 0; i < number; i++) {
    if (!(mask[i] & groupbit)) continue;
    exclusive.check(mask[i]);
    if (isolation.of(i)) pulled.push_back(i);
  }
}

void HydroLevel::sum_stresslets(double *five) const
{
  double s[5];
  std::fill_n(five, 5, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & fix->groupbit)) continue;
    stresslet(i, s);
    for (int k = 0; k < 5; k++) five[k] += s[k];
  }
}

double HydroLevel::volume_of_group() const
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & fix->groupbit)
      sum += Suspension_NS::particle_volume(domain, atom->radius[i]);
  return sum;
}

double HydroLevel::memory_usage() const
{
  return fluid->memory_usage() + static_cast<double>(columns) * atom->nmax * sizeof(double);
}
