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
   Between runs the partner lists are those that the end of the last run left. The neighbor list is
   not: the write_restart command renumbers the ghosts before it comes here.
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::pre_exchange()
{
  if (update->whichflag) FixNeighHistory::pre_exchange();
}

/* ----------------------------------------------------------------------
   of one atom: length, number of partners, then ID and dnum values of each
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::unpack_restart(int nlocal, int nth)
{
  const double *extra = atom->extra[nlocal];
  int m = 0;
  for (int i = 0; i < nth; i++) m += static_cast<int>(extra[m]);
  const int length = static_cast<int>(extra[m]), partners = static_cast<int>(extra[m + 1]);
  if (length != 2 + partners * (1 + dnum))
    error->one(FLERR,
               "The restart file holds {} values of history a pair, but the effects of pair style "
               "lubcontact now need {}: keep the effects it was written with for the first run "
               "after read_restart",
               (length - 2) / partners - 1, dnum);
  FixNeighHistory::unpack_restart(nlocal, nth);
}
