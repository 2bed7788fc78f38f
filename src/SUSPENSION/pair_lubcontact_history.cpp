/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Which pairs of the neighbor list act, and where pair style lubcontact finds their history.

#include "pair_lubcontact.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_neigh_history_lubcontact.h"
#include "fix_neigh_history_place.h"
#include "force.h"
#include "lubcontact_pair.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   Keeps the place of the history among the fixes until its size is known. The number is the lowest
   free one: a restarted script finds its history whatever pair styles either script had. An orphan has
   followed the atoms of a restart file for a pair style that was given again
------------------------------------------------------------------------- */

void PairLubcontact::find_place()
{
  for (int number = 1;; number++) {
    history_id = fmt::format("NEIGH_HISTORY_LUBCONTACT{}", number);
    dummy_id = fmt::format("NEIGH_HISTORY_LUBCONTACT_DUMMY{}", number);
    if (modify->get_fix_by_id(history_id)) continue;
    Fix *found = modify->get_fix_by_id(dummy_id);
    history_place = dynamic_cast<FixNeighHistoryPlace *>(found);
    if (found && !(history_place && history_place->orphan)) continue;
    // before there is a cell there are no atoms to follow, and LAMMPS takes no other fix
    if (!found && domain->box_exist)
      history_place = dynamic_cast<FixNeighHistoryPlace *>(
          modify->add_fix(dummy_id + " all NEIGH_HISTORY/LUBCONTACT/PLACE"));
    else if (!found)
      modify->add_fix(dummy_id + " all DUMMY");
    if (history_place) history_place->orphan = false;
    return;
  }
}

void PairLubcontact::leave_place()
{
  const std::string &mine = fix_history ? history_id : dummy_id;
  if (!modify->get_fix_by_id(mine)) return;    // unloaded with its style
  if (!fix_history && history_place && history_place->holds_rows())
    history_place->orphan = true;
  else
    modify->delete_fix(mine);
}

/* ----------------------------------------------------------------------
   fix that carries the history, of the size that the effects need
------------------------------------------------------------------------- */

void PairLubcontact::require_history()
{
  if (fix_history && modify->get_fix_by_id(history_id) != fix_history)
    error->all(FLERR,
               "Fix {} of pair style lubcontact is gone: load the plugin and give pair_style and "
               "pair_coeff again",
               history_id);
  if (fix_history && fix_history->get_dnum() != size_history) {
    if (comm->me == 0)
      error->warning(FLERR, "Pair style lubcontact now has other effects: its history is dropped");
    history_place = dynamic_cast<FixNeighHistoryPlace *>(
        modify->replace_fix(history_id, dummy_id + " all NEIGH_HISTORY/LUBCONTACT/PLACE", 1));
    fix_history = nullptr;
  }
  if (fix_history || !size_history) return;
  const auto rows = history_place ? history_place->take_rows() : FixNeighHistoryPlace::Rows();
  history_place = nullptr;
  fix_history = dynamic_cast<FixNeighHistoryLubcontact *>(
      modify->replace_fix(dummy_id,
                          fmt::format("{} all NEIGH_HISTORY/LUBCONTACT {} {}", history_id,
                                      size_history, history_layout),
                          1));
  if (!fix_history) error->all(FLERR, "Could not find pair fix neigh history ID {}", history_id);
  fix_history->pair = this;
  fix_history->take_restart(rows);
}

/* ---------------------------------------------------------------------- */

bigint PairLubcontact::forget_history(int groupbit)
{
  if (fix_history) return fix_history->forget(groupbit);
  return history_place ? history_place->forget(groupbit) : 0;
}

/* ----------------------------------------------------------------------
   parity of the history under exchange of i and j
------------------------------------------------------------------------- */

void PairLubcontact::transfer_history(double *source, double *target, int, int)
{
  exchange(source, target);
}

/* ----------------------------------------------------------------------
   A gap is kept over the effective radius: where radii grow in a run it stays the same length
------------------------------------------------------------------------- */

void PairLubcontact::follow_radii()
{
  const double *radius = atom->radius;
  const std::size_t nall = atom->nlocal + atom->nghost;
  const bool known = neighbor->ago != 0 && !update->setupflag && radii.size() == nall;
  if (known && std::equal(radii.begin(), radii.end(), radius)) return;
  if (known && (mask & Lubcontact_NS::SQUEEZE))
    for (int ii = 0; ii < list->inum; ii++) {
      const int i = list->ilist[ii];
      for (int jj = 0; jj < list->numneigh[i]; jj++) {
        const int j = list->firstneigh[i][jj] & NEIGHMASK;
        if (!fix_history->firstflag[i][jj]) continue;
        if (radius[i] == radii[i] && radius[j] == radii[j]) continue;
        Lubcontact_NS::rescale_gap(effective_radius(radii[i], radii[j]) /
                                       effective_radius(radius[i], radius[j]),
                                   fix_history->firstvalue[i] + size_history * jj);
      }
    }
  radii.assign(radius, radius + nall);
}

/* ----------------------------------------------------------------------
   does entry jj of the list of i act at the gap un? a: effective radius
------------------------------------------------------------------------- */

bool PairLubcontact::acts(int i, int jj, double un, double a) const
{
  const int entry = list->firstneigh[i][jj], j = entry & NEIGHMASK;
  if (force->special_lj[sbmask(entry)] == 0.0) return false;
  const int itype = atom->type[i], jtype = atom->type[j];
  const char *faces_i = faces_of(i);
  const bool screened = faces_i && !faces_i[jj];
  return un < (screened ? touching_gap(coeffs[itype][jtype]) : reach[itype][jtype]) * a;
}

/* ----------------------------------------------------------------------
   The place of the pair (i,j) in the list, perhaps as (j,i), false if it is in none. A compute with a
   list of its own may see a pair from the side of the other particle
------------------------------------------------------------------------- */

bool PairLubcontact::find_entry(int i, int j, Entry &entry) const
{
  auto search = [this, &entry](int owner, int partner, bool swapped, bool by_id) {
    if (owner < 0 || owner >= atom->nlocal) return false;
    const int *jlist = list->firstneigh[owner];
    for (int jj = 0; jj < list->numneigh[owner]; jj++) {
      const int k = jlist[jj] & NEIGHMASK;
      if (by_id ? atom->tag[k] != atom->tag[partner] : k != partner) continue;
      entry = {owner, jj, swapped};
      return true;
    }
    return false;
  };
  if (!list || list->inum == 0) return false;
  if (search(i, j, false, false) || search(j, i, true, false)) return true;
  if (atom->map_style != Atom::MAP_NONE && search(atom->map(atom->tag[j]), i, true, true))
    return true;
  if (force->newton_pair && !excluded(i, j))
    error->one(FLERR,
               "The history of the pair of atoms {} and {} is on another rank, where the compute "
               "that asks for it does not look: use atom_modify map yes on one rank, or newton off",
               atom->tag[i], atom->tag[j]);
  return false;
}

/* ----------------------------------------------------------------------
   by neigh_modify exclude
------------------------------------------------------------------------- */

bool PairLubcontact::excluded(int i, int j) const
{
  if (!neighbor->exclude) return false;
  const int *type = atom->type, *bits = atom->mask;
  for (int m = 0; m < neighbor->nex_type; m++) {
    const int a = neighbor->ex1_type[m], b = neighbor->ex2_type[m];
    if ((type[i] == a && type[j] == b) || (type[i] == b && type[j] == a)) return true;
  }
  for (int m = 0; m < neighbor->nex_group; m++) {
    const int a = neighbor->ex1_bit[m], b = neighbor->ex2_bit[m];
    if ((bits[i] & a && bits[j] & b) || (bits[i] & b && bits[j] & a)) return true;
  }
  return neighbor->nex_mol > 0;    // by molecule: perhaps
}

/* ----------------------------------------------------------------------
   copied to buffer if the pair is asked for from the other side; null if it has none
------------------------------------------------------------------------- */

const double *PairLubcontact::find_history(const Entry &entry, double *buffer) const
{
  if (!fix_history || !fix_history->firstflag[entry.owner][entry.jj]) return nullptr;
  const double *found = fix_history->firstvalue[entry.owner] + size_history * entry.jj;
  if (!entry.swapped) return found;
  exchange(found, buffer);
  return buffer;
}
