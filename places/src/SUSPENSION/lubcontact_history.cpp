/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "lubcontact_history.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_neigh_history_place.h"
#include "modify.h"
#include "pair.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

LubcontactHistory::LubcontactHistory(LAMMPS *lmp) : Pointers(lmp), fix(nullptr), place(nullptr)
{
  find_place();
}

/* ---------------------------------------------------------------------- */

LubcontactHistory::~LubcontactHistory()
{
  const std::string &mine = fix ? history_id : dummy_id;
  if (!modify->get_fix_by_id(mine)) return;    // unloaded with its style
  if (!fix && place && place->holds_rows())
    place->orphan = true;
  else
    modify->delete_fix(mine);
}

/* ----------------------------------------------------------------------
   Keeps the place of the history among the fixes until its size is known. The number is the lowest
   free one: a restarted script finds its history whatever pair styles either script had. An orphan
   has followed the atoms of a restart file for a pair style that was given again
------------------------------------------------------------------------- */

void LubcontactHistory::find_place()
{
  for (int number = 1;; number++) {
    history_id = fmt::format("NEIGH_HISTORY_LUBCONTACT{}", number);
    dummy_id = fmt::format("NEIGH_HISTORY_LUBCONTACT_DUMMY{}", number);
    if (modify->get_fix_by_id(history_id)) continue;
    Fix *found = modify->get_fix_by_id(dummy_id);
    place = dynamic_cast<FixNeighHistoryPlace *>(found);
    if (found && !(place && place->orphan)) continue;
    // before there is a cell there are no atoms to follow, and LAMMPS takes no other fix
    if (!found && domain->box_exist)
      place = dynamic_cast<FixNeighHistoryPlace *>(
          modify->add_fix(dummy_id + " all NEIGH_HISTORY/LUBCONTACT/PLACE"));
    else if (!found)
      modify->add_fix(dummy_id + " all DUMMY");
    if (place) place->orphan = false;
    return;
  }
}

/* ---------------------------------------------------------------------- */

void LubcontactHistory::require(Pair *owner, const Form &needed)
{
  form = needed;
  if (fix && modify->get_fix_by_id(history_id) != fix)
    error->all(FLERR,
               "Fix {} of pair style lubcontact has been deleted: load the plugin and give "
               "pair_style and pair_coeff again",
               history_id);
  if (fix && fix->get_dnum() != form.size) {
    if (comm->me == 0)
      error->warning(FLERR,
                     "Pair style lubcontact has different effects now: its history is deleted");
    place = dynamic_cast<FixNeighHistoryPlace *>(
        modify->replace_fix(history_id, dummy_id + " all NEIGH_HISTORY/LUBCONTACT/PLACE", 1));
    fix = nullptr;
  }
  if (fix || !form.size) return;
  const auto rows = place ? place->take_rows() : FixNeighHistoryPlace::Rows();
  place = nullptr;
  fix = dynamic_cast<FixNeighHistoryLubcontact *>(modify->replace_fix(
      dummy_id,
      fmt::format("{} all NEIGH_HISTORY/LUBCONTACT {} {}", history_id, form.size, form.layout), 1));
  if (!fix) error->all(FLERR, "Could not find pair fix neigh history ID {}", history_id);
  fix->pair = owner;
  fix->take_restart(rows);
}

/* ---------------------------------------------------------------------- */

bigint LubcontactHistory::forget(int groupbit)
{
  if (fix) return fix->forget(groupbit);
  return place ? place->forget(groupbit) : 0;
}
