/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Arguments of fix hydro, and what it does not work with.

#include "fix_hydro.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "exclusive_particles.h"
#include "fix_hydro_settings.h"
#include "lubcontact_law.h"
#include "modify.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "pair_lubcontact.h"
#include "spin_inertia.h"
#include "suspension_host.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <string>

using namespace LAMMPS_NS;
using Suspension_NS::InputNumber;
using Suspension_NS::require_words;

// values of each keyword; hold may have two
static const std::map<std::string, std::string> KEYWORDS = {{"viscosity", "eta|pair"},
                                                            {"strain", "step"},
                                                            {"every", "n"},
                                                            {"tol", "t"},
                                                            {"width", "w"},
                                                            {"spacing", "h"},
                                                            {"support", "s"},
                                                            {"reach", "rc"},
                                                            {"hold", "auto|z_force ..."}};

// fixes that may come later: they read forces, or set them whatever they were
static const char *const READERS[] = {"setforce", "freeze", "store/force"};

/* ----------------------------------------------------------------------
   fix ID group hydro grid keyword value ...
------------------------------------------------------------------------- */

void FixHydro::parse(int narg, char **arg)
{
  require_words(FLERR, error, "fix hydro", narg + 1, "fix ID group hydro grid ...");
  if (strcmp(arg[3], "grid") != 0)
    error->all(FLERR, 3, "Fix hydro level must be grid, but is {}", arg[3]);
  std::map<std::string, int> given;
  for (int iarg = 4; iarg < narg;) {
    const std::string key = arg[iarg];
    if (KEYWORDS.find(key) == KEYWORDS.end())
      error->all(FLERR, iarg, "Unknown fix hydro keyword: {}", key);
    if (given.count(key)) error->all(FLERR, iarg, "Fix hydro {} is given twice", key);
    given[key] = iarg;
    require_words(FLERR, error, "fix hydro", narg - iarg, key + " " + KEYWORDS.at(key));
    iarg += parse_keyword(iarg, narg, arg);
  }
  if (given.count("strain") && given.count("every"))
    error->all(FLERR, given["every"], "Fix hydro has strain already: every cannot act");
}

/* ----------------------------------------------------------------------
   returns the number of words
------------------------------------------------------------------------- */

int FixHydro::parse_keyword(int iarg, int narg, char **arg)
{
  HydroSettings &s = *settings;
  const std::string key = arg[iarg];
  auto at_least = [this, arg, &key](int at, double least) {
    const double value = utils::numeric(FLERR, arg[at], false, lmp);
    if (!(value >= least))
      error->all(FLERR, at, "Fix hydro {} must be at least {}, but is {}", key, least, arg[at]);
    return value;
  };
  auto positive = [this, arg, &key](int at) {
    const double value = utils::numeric(FLERR, arg[at], false, lmp);
    if (!(value > 0.0)) error->all(FLERR, at, "Fix hydro {} must be > 0, but is {}", key, arg[at]);
    return value;
  };
  if (key == "viscosity") {
    s.viscosity_of_pair = strcmp(arg[iarg + 1], "pair") == 0;
    if (s.viscosity_of_pair) return 2;
    s.viscosity = InputNumber(lmp, arg[iarg + 1]);
    if (s.viscosity.is_number()) positive(iarg + 1);
  } else if (key == "strain") {
    s.strain = positive(iarg + 1);
  } else if (key == "every") {
    s.every = utils::inumeric(FLERR, arg[iarg + 1], false, lmp);
    if (s.every < 1)
      error->all(FLERR, iarg + 1, "Fix hydro every must be > 0, but is {}", arg[iarg + 1]);
  } else if (key == "tol") {
    s.tolerance = positive(iarg + 1);
    if (s.tolerance >= 1.0)
      error->all(FLERR, iarg + 1, "Fix hydro tol must be < 1, but is {}", arg[iarg + 1]);
  } else if (key == "width") {
    s.field.width = positive(iarg + 1);
  } else if (key == "spacing") {
    s.field.spacing = positive(iarg + 1);
    if (s.field.spacing > 1.0)
      error->all(FLERR, iarg + 1,
                 "Fix hydro spacing must be <= 1, in widths of the Gaussians, which the grid "
                 "resolves no longer at {}",
                 arg[iarg + 1]);
  } else if (key == "support") {
    s.field.support = at_least(iarg + 1, 3.0);
  } else if (key == "reach") {
    s.field.reach = at_least(iarg + 1, 3.0);
  } else {    // hold
    s.hold[0] = s.hold[1] = 0.0;
    if (strcmp(arg[iarg + 1], "auto") == 0) return 2;
    require_words(FLERR, error, "fix hydro", narg - iarg, "hold z_force z_torque");
    s.hold[0] = positive(iarg + 1);
    s.hold[1] = positive(iarg + 2);
    return 3;
  }
  return 2;
}

/* ---------------------------------------------------------------------- */

void FixHydro::init()
{
  Suspension_NS::require_spheres(lmp, "Fix hydro");
  Suspension_NS::require_verlet(lmp, "Fix hydro");
  settings->viscosity.check(lmp, style, "viscosity");
  if (settings->viscosity_of_pair && !Suspension_NS::viscosity_of_pair(lmp))
    error->all(FLERR, "Fix hydro: {}; give it to fix hydro: viscosity eta",
               Suspension_NS::why_no_viscosity(lmp));
  own->start(groupbit);
  check_others();
  check_films();
  check_cell();
  check_order();
  inertia->find(lmp);
  measure_radius();

  // pairs reach beyond the contacts
  const double cut = settings->field.reach * settings->field.width * state.radius + neighbor->skin;
  comm->cutghostuser = MAX(comm->cutghostuser, cut);
  neighbor->add_request(this, NeighConst::REQ_OCCASIONAL | NeighConst::REQ_NEWTON_ON)
      ->set_cutoff(cut);
}

void FixHydro::init_list(int /*id*/, NeighList *ptr)
{
  list = ptr;
}

/* ---------------------------------------------------------------------- */

void FixHydro::check_cell() const
{
  if (domain->dimension == 2)
    error->all(FLERR, "Fix hydro works in 3d only: the far field of discs has no end in 2d");
  for (int d = 0; d < 3; d++)
    if (!domain->periodicity[d])
      error->all(FLERR,
                 "Fix hydro needs a cell that is periodic in all directions, but {} is not: use "
                 "boundary p p p",
                 "xyz"[d]);
  const auto deform = modify->get_fix_by_style("^deform");
  if (deform.empty()) {
    if (settings->every == 0)
      error->all(FLERR,
                 "Fix hydro solves every {} of strain, but the cell does not deform: use fix "
                 "deform/rheometer, or every n",
                 settings->strain);
    return;
  }
  if (!domain->deform_vremap)
    error->all(FLERR,
               "Fix hydro needs velocities that follow the cell; add to fix deform: remap v");
  if ((groupbit & domain->deform_groupbit) != groupbit && domain->deform_groupbit != 1)
    error->all(FLERR, "Fix hydro: use group all for fix {}", deform[0]->id);
}

/* ----------------------------------------------------------------------
   nobody else drags these particles
------------------------------------------------------------------------- */

void FixHydro::check_others()
{
  if (modify->get_fix_by_style("^hydro").size() > 1)
    error->all(FLERR, "More than one fix hydro: all particles move each other, use one for all");
  const auto plates = modify->get_fix_by_style("^rheometer/plates");
  if (!plates.empty())
    error->all(FLERR,
               "Fix hydro knows no walls: the plates of fix {} would be spheres in a periodic "
               "fluid; use fix deform/rheometer",
               plates[0]->id);
  const auto pores = modify->get_fix_by_style("^pore/pressure");
  if (!pores.empty())
    error->all(FLERR,
               "Fix hydro and fix {} pore/pressure describe the same fluid twice: remove one of "
               "them",
               pores[0]->id);
  for (const auto &other : modify->get_fix_list()) {
    if (other->rigid_flag)
      error->all(FLERR, "Fix hydro cannot drag the rigid bodies of fix {}", other->id);
    const std::string name = other->id, kind = other->style;
    if (utils::strmatch(kind, "^drag/background"))
      own->forbid(other->groupbit, [name](const std::string &who) {
        return fmt::format("Fix hydro has the drag of {} already: remove fix {} drag/background, "
                           "or give it another group",
                           who, name);
      });
    if (utils::strmatch(kind, "^overdamped"))
      own->forbid(other->groupbit, [name, kind](const std::string &who) {
        return fmt::format("Fix hydro acts on {} of fix {} {}, which has a drag of its own: use "
                           "fix nve/sphere with a small density",
                           who, name, kind);
      });
  }
  if (neighbor->nex_type || neighbor->nex_group || neighbor->nex_mol)
    error->all(FLERR,
               "Fix hydro needs all pairs, of which neigh_modify exclude leaves some out: use "
               "neigh_modify exclude none");
}

/* ----------------------------------------------------------------------
   films of another range would be in the far field once more
------------------------------------------------------------------------- */

void FixHydro::check_films() const
{
  for (const PairLubcontact *pair : PairLubcontact::all(lmp)) {
    const Lubcontact_NS::Settings &s = pair->settings();
    if (s.films && s.range != Lubcontact_NS::Range::RESIDUAL)
      error->all(FLERR,
                 "Fix hydro grid has a part of the films of pair_style lubcontact ... {}, which "
                 "would act twice: use range residual, or switch the films off",
                 Lubcontact_NS::RANGE_NAME[static_cast<int>(s.range)]);
  }
}

/* ----------------------------------------------------------------------
   what acts together with a strong drag is damped by it: all forces must be known here
------------------------------------------------------------------------- */

void FixHydro::check_order() const
{
  bool later = false;
  for (const auto &other : modify->get_fix_list()) {
    const std::string kind = other->style;
    const bool reads = std::any_of(std::begin(READERS), std::end(READERS), [&](const char *reader) {
      return kind == reader;
    });
    if (other == this)
      later = true;
    else if (later && !reads && (modify->get_fix_mask(other) & FixConst::POST_FORCE))
      error->all(FLERR,
                 "Fix {} {} may add forces after fix hydro, which needs all other forces: define "
                 "it before fix hydro",
                 other->id, other->style);
  }
}
