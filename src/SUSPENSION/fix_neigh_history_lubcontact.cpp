/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_neigh_history_lubcontact.h"

#include "atom.h"
#include "error.h"
#include "restart_seal.h"
#include "update.h"

using namespace LAMMPS_NS;

static constexpr int EXTRA = 2;    // values of an atom after those of LAMMPS: layout, checksum

/* ----------------------------------------------------------------------
   fix ID all NEIGH_HISTORY/LUBCONTACT dnum layout
------------------------------------------------------------------------- */

FixNeighHistoryLubcontact::FixNeighHistoryLubcontact(LAMMPS *lmp, int narg, char **arg) :
    FixNeighHistory(lmp, MIN(narg, 4), arg), layout(0.0)
{
  if (narg != 5) error->all(FLERR, "Fix {} is internal to pair style lubcontact", style);
  layout = utils::numeric(FLERR, arg[4], false, lmp);
}

/* ----------------------------------------------------------------------
   Between runs the partner lists are those that the end of the last run left. The neighbor list is
   not: the write_restart command renumbers the ghosts before it comes here.
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::pre_exchange()
{
  if (update->whichflag) FixNeighHistory::pre_exchange();
}

/* ----------------------------------------------------------------------
   of one atom: length, number of partners, ID and dnum values of each, then the layout of the values
   and the checksum of all
------------------------------------------------------------------------- */

int FixNeighHistoryLubcontact::pack_restart(int i, double *buffer)
{
  const int n = FixNeighHistory::pack_restart(i, buffer);
  buffer[0] = n + EXTRA;
  buffer[n] = layout;
  buffer[n + 1] = suspension::seal(buffer, sizeof(double) * (n + 1));
  return n + EXTRA;
}

void FixNeighHistoryLubcontact::unpack_restart(int nlocal, int nth)
{
  const double *mine = suspension::part_of_atom(atom->extra[nlocal], nth, atom->nextra_store);
  const double length = mine ? mine[0] : 0.0;    // if damaged perhaps no integer
  const double expected = mine ? 2.0 + mine[1] * (1.0 + dnum) + EXTRA : 0.0;
  const int n = length == expected && length > 0.0 && length <= atom->nextra_store
      ? static_cast<int>(length)
      : 0;
  if (n && suspension::seal(mine, sizeof(double) * (n - 1)) != mine[n - 1])
    error->one(FLERR,
               "The pair history of atom {} in the restart file is damaged: use another restart "
               "file",
               atom->tag[nlocal]);
  if (n == 0 || mine[n - EXTRA] != layout)
    error->one(
        FLERR,
        "The restart file holds the pair history of other effects than those that pair style "
        "lubcontact has now, or it is damaged: keep the effects it was written with for the first "
        "run after read_restart");
  FixNeighHistory::unpack_restart(nlocal, nth);
}

int FixNeighHistoryLubcontact::size_restart(int i)
{
  return FixNeighHistory::size_restart(i) + EXTRA;
}

int FixNeighHistoryLubcontact::maxsize_restart()
{
  return FixNeighHistory::maxsize_restart() + EXTRA;
}
