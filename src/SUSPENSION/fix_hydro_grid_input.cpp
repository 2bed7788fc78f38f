/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Arguments of fix hydro grid, and what it does not work with.

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_hydro_grid.h"
#include "fix_hydro_settings.h"
#include "modify.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "suspension_input.h"

#include <cstring>
#include <map>
#include <string>

using namespace LAMMPS_NS;
using Suspension_NS::require_words;

// values of each keyword; hold may have two
static const std::map<std::string, std::string> KEYWORDS = {{"viscosity", "eta|pair"},
                                                            {"strain", "step"},
                                                            {"every", "n"},
                                                            {"tol", "t"},
                                                            {"width", "w"},
                                                            {"spacing", "h"},
                                                            {"points", "p"},
                                                            {"reach", "rc"},
                                                            {"hold", "auto|z_force ..."}};

/* ----------------------------------------------------------------------
   fix ID group hydro grid keyword value ...
------------------------------------------------------------------------- */

void HydroGrid::parse_all(int narg, char **arg)
{
  BackgroundFluid::Choice choice;
  auto given = parse(narg, arg, KEYWORDS, [&](int iarg) {
    return parse_keyword(iarg, narg, arg, choice);
  });
  if (given.count("strain") && given.count("every"))
    error->all(FLERR, given["every"], "Fix hydro has strain already: every cannot act");
  fluid = std::make_unique<BackgroundFluid>(lmp, fix, choice);
}

/* ----------------------------------------------------------------------
   returns the number of words
------------------------------------------------------------------------- */

int HydroGrid::parse_keyword(int iarg, int narg, char **arg, BackgroundFluid::Choice &choice)
{
  HydroSettings &s = *settings;
  const std::string key = arg[iarg];
  auto at_least = [this, arg, &key](int at, double least) {
    const double value = utils::numeric(FLERR, arg[at], false, lmp);
    if (!(value >= least))
      error->all(FLERR, at, "Fix hydro {} must be at least {}, but is {}", key, least, arg[at]);
    return value;
  };
  if (key == "viscosity") return parse_viscosity(iarg, arg, choice);
  if (key == "strain") {
    s.strain = positive(iarg + 1, arg, key);
  } else if (key == "every") {
    s.every = utils::inumeric(FLERR, arg[iarg + 1], false, lmp);
    if (s.every < 1)
      error->all(FLERR, iarg + 1, "Fix hydro every must be > 0, but is {}", arg[iarg + 1]);
  } else if (key == "tol") {
    s.tolerance = positive(iarg + 1, arg, key);
    if (s.tolerance >= 1.0)
      error->all(FLERR, iarg + 1, "Fix hydro tol must be < 1, but is {}", arg[iarg + 1]);
  } else if (key == "width") {
    s.field.width = positive(iarg + 1, arg, key);
  } else if (key == "spacing") {
    s.field.spacing = positive(iarg + 1, arg, key);
    if (s.field.spacing > 1.0)
      error->all(FLERR, iarg + 1,
                 "Fix hydro spacing must be <= 1, in widths of the Gaussians, which the grid "
                 "resolves no longer at {}",
                 arg[iarg + 1]);
  } else if (key == "points") {
    s.field.points = utils::inumeric(FLERR, arg[iarg + 1], false, lmp);
    if (s.field.points < 4 || s.field.points > Hydro_NS::MOST_POINTS || s.field.points % 2)
      error->all(FLERR, iarg + 1, "Fix hydro points must be 4, 6, 8, 10 or 12, but is {}",
                 arg[iarg + 1]);
  } else if (key == "reach") {
    s.field.reach = at_least(iarg + 1, 3.0);
  } else {    // hold
    s.hold[0] = s.hold[1] = 0.0;
    if (strcmp(arg[iarg + 1], "auto") == 0) return 2;
    require_words(FLERR, error, "fix hydro", narg - iarg, "hold z_force z_torque");
    s.hold[0] = positive(iarg + 1, arg, key);
    s.hold[1] = positive(iarg + 2, arg, key);
    return 3;
  }
  return 2;
}

/* ---------------------------------------------------------------------- */

void HydroGrid::init()
{
  check_pores();
  HydroLevel::init();
  check_cell();
  if (neighbor->nex_type || neighbor->nex_group || neighbor->nex_mol)
    error->all(FLERR,
               "Fix hydro needs all pairs, of which neigh_modify exclude leaves some out: use "
               "neigh_modify exclude none");
  measure_radius();

  // pairs reach beyond the contacts
  const double cut = settings->field.reach * settings->field.width * state.radius + neighbor->skin;
  comm->cutghostuser = MAX(comm->cutghostuser, cut);
  neighbor->add_request(fix, NeighConst::REQ_OCCASIONAL | NeighConst::REQ_NEWTON_ON)
      ->set_cutoff(cut);
}

/* ---------------------------------------------------------------------- */

void HydroGrid::check_pores() const
{
  const auto pores = modify->get_fix_by_style("^pore/pressure");
  if (!pores.empty())
    error->all(FLERR,
               "Fix hydro and fix {} pore/pressure describe the same fluid twice: remove one of "
               "them",
               pores[0]->id);
}

void HydroGrid::check_cell() const
{
  for (int d = 0; d < 3; d++)
    if (!domain->periodicity[d])
      error->all(FLERR,
                 "Fix hydro needs a cell that is periodic in all directions, but {} is not: use "
                 "boundary p p p",
                 "xyz"[d]);
  if (settings->every == 0 && modify->get_fix_by_style("^deform").empty())
    error->all(FLERR,
               "Fix hydro solves every {} of strain, but the cell does not deform: use fix "
               "deform/rheometer, or every n",
               settings->strain);
}
