/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "suspension_history.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "group.h"
#include "lubcontact_pairs.h"
#include "pair_lubcontact.h"
#include "suspension_host.h"

#include <string>

using namespace LAMMPS_NS;

void SuspensionHistory::command(int narg, char **arg)
{
  static constexpr int WHAT = 0, WHOSE = 1;    // places of the words
  static constexpr const char *FORM = "suspension_history forget group-ID";
  if (narg != 2)
    error->all(FLERR, "Command suspension_history takes two words, but has {}: {}", narg, FORM);
  if (std::string(arg[0]) != "forget")
    error->all(FLERR, WHAT, "Unknown word {} of command suspension_history; use: {}", arg[0], FORM);
  if (!domain->box_exist)
    error->all(FLERR, "Command suspension_history comes before the simulation box is defined");
  const int igroup = group->find(arg[1]);
  if (igroup < 0)
    error->all(FLERR, WHOSE, "Group {} of command suspension_history does not exist", arg[1]);

  if (Suspension_NS::all_lubcontact(lmp).empty())
    error->all(FLERR,
               "Command suspension_history is of pair_style lubcontact, which is not defined");
  bigint forgotten = 0;
  for (const auto &pair : PairLubcontact::all(lmp))
    forgotten += pair->neighbors().history().forget(group->bitmask[igroup]);
  const bigint members = group->count(igroup);
  if (comm->me == 0)
    utils::logmesg(lmp,
                   "Pairs of the {} particles of group {} begin the next run without a history{}\n",
                   members, arg[1], forgotten ? "" : "; there was none");
}
