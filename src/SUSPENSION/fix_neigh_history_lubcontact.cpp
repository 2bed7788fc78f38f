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
#include "update.h"

using namespace LAMMPS_NS;

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
------------------------------------------------------------------------- */

int FixNeighHistoryLubcontact::pack_restart(int i, double *buffer)
{
  const int n = FixNeighHistory::pack_restart(i, buffer);
  buffer[n] = layout;
  buffer[0] = n + 1;
  return n + 1;
}

void FixNeighHistoryLubcontact::unpack_restart(int nlocal, int nth)
{
  const double *extra = atom->extra[nlocal];
  int m = 0;
  for (int i = 0; i < nth; i++) m += static_cast<int>(extra[m]);
  const int length = static_cast<int>(extra[m]), partners = static_cast<int>(extra[m + 1]);
  if (length != 3 + partners * (1 + dnum) || extra[m + length - 1] != layout)
    error->one(
        FLERR,
        "The restart file holds the pair history of other effects than those that pair style "
        "lubcontact has now: keep the effects it was written with for the first run after "
        "read_restart");
  FixNeighHistory::unpack_restart(nlocal, nth);
}

int FixNeighHistoryLubcontact::size_restart(int i)
{
  return FixNeighHistory::size_restart(i) + 1;
}

int FixNeighHistoryLubcontact::maxsize_restart()
{
  return FixNeighHistory::maxsize_restart() + 1;
}
