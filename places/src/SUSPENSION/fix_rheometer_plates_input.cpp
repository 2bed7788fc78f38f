/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Arguments of fix rheometer/plates.

#include "fix_rheometer_plates.h"

#include "atom.h"
#include "error.h"
#include "exclusive_particles.h"
#include "group.h"
#include "list_keeper.h"
#include "plates_state.h"
#include "plates_targets.h"
#include "rheometer_mean.h"
#include "rheometer_plate.h"
#include "suspension_host.h"
#include "suspension_input.h"

using namespace LAMMPS_NS;
using Rheometer_NS::LOWER;
using Rheometer_NS::UPPER;

/* ----------------------------------------------------------------------
   fix ID group rheometer/plates lower upper keyword value ...
------------------------------------------------------------------------- */

FixRheometerPlates::FixRheometerPlates(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), igroup_plate{0, 0}, bit{0, 0}, targets(new PlatesTargets(lmp, style)),
    state(new PlatesState()), own(new ExclusiveParticles(lmp)), force_on{}, drainage(0.0),
    keeper(new ListKeeper(lmp, this))
{
  force_reneighbor = 1;
  next_reneighbor = -1;
  Suspension_NS::require_words(FLERR, error, "fix rheometer/plates", narg + 1,
                               "fix ID group rheometer/plates lower upper ...");
  Suspension_NS::require_spheres(lmp, "Fix rheometer/plates");
  for (int plate : {LOWER, UPPER}) {
    plate_name[plate] = arg[3 + plate];
    find_plate(plate, 3 + plate);
  }
  if (igroup_plate[LOWER] == igroup_plate[UPPER])
    error->all(FLERR, 4, "Fix rheometer/plates needs two plates, but both are group {}", arg[4]);
  const int end = targets->parse(narg, arg, 5).next;
  keeper->allow(targets->affine_lists());
  if (end < narg) error->all(FLERR, end, "Unknown fix rheometer/plates keyword: {}", arg[end]);

  dynamic_group_allow = 1;
  restart_global = 1;
  vector_flag = 1;
  size_vector = Output::MEANS + Rheometer_NS::MEAN_OUTPUTS;
  global_freq = 1;
  extvector = 0;
}

FixRheometerPlates::~FixRheometerPlates() = default;

/* ----------------------------------------------------------------------
   again in each run: a group may have been deleted, or made dynamic
------------------------------------------------------------------------- */

void FixRheometerPlates::find_plate(int plate, int iarg)
{
  const std::string &name = plate_name[plate];
  const int found = group->find(name);
  if (found < 0)
    error->all(FLERR, iarg, "Group {} of the {} plate of fix rheometer/plates does not exist", name,
               PLATE_NAME[plate]);
  if (group->dynamic[found])
    error->all(FLERR, iarg, "Group {} of fix rheometer/plates must not be dynamic", name);
  igroup_plate[plate] = found;
  bit[plate] = group->bitmask[found];
}

/* ----------------------------------------------------------------------
   new targets: nothing of the old ones is held against them
------------------------------------------------------------------------- */

int FixRheometerPlates::modify_param(int narg, char **arg)
{
  const auto parsed = targets->parse(narg, arg, 0);
  keeper->allow(targets->affine_lists());
  if (parsed.drive) start_drive();
  if (parsed.load) start_load(parsed.same_load);
  return parsed.next;
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::start_drive()
{
  state->clock = 0.0;    // of the oscillation
  state->means = {};
  state->deviation_x = state->age_x = state->warned_x = 0.0;
}

void FixRheometerPlates::start_load(bool same)
{
  // the servo goes on with the motion that the plate has
  if (targets->load() == PlatesTargets::PRESSURE && !same)
    state->dilation = state->gap == 0.0 ? 0.0 : state->vy / state->gap;
  state->deviation_y = state->age_y = state->warned_y = 0.0;
  state->means = {};
}
