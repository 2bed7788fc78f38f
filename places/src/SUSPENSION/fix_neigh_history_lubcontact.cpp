/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_neigh_history_lubcontact.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "my_page.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "restart_seal.h"
#include "update.h"

#include <algorithm>
#include <utility>

using namespace LAMMPS_NS;

static constexpr int EXTRA =
    4;    // values of an atom after those of LAMMPS: ID, radius, layout, checksum
static constexpr int OWNER = 2;    // of them, what exchanges carry

/* ----------------------------------------------------------------------
   fix ID all NEIGH_HISTORY/LUBCONTACT dnum layout
------------------------------------------------------------------------- */

FixNeighHistoryLubcontact::FixNeighHistoryLubcontact(LAMMPS *lmp, int narg, char **arg) :
    FixNeighHistory(lmp, MIN(narg, 4), arg), layout(0.0), part(-1), restarted(false)
{
  if (narg != 5) error->all(FLERR, "Fix {} is internal to pair style lubcontact", style);
  layout = utils::numeric(FLERR, arg[4], false, lmp);
  comm_forward = 1;
  owner.resize(atom->nmax);
}

/* ----------------------------------------------------------------------
   new pages of neighbor lists are new pages of records, into which the old ones are copied
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::init()
{
  const bool renewed = ipage_atom && (pgsize != neighbor->pgsize || oneatom != neighbor->oneatom);
  std::vector<double> kept;
  if (renewed)
    for (int i = 0; i < atom->nlocal; i++) {
      if (npartner[i] > neighbor->oneatom)
        error->one(FLERR,
                   "Atom {} has {} partners with a history, more than neigh_modify one {} allows: "
                   "increase it",
                   atom->tag[i], npartner[i], neighbor->oneatom);
      const std::size_t begin = kept.size();
      kept.resize(begin + 1 + (dnum + 1) * npartner[i]);
      FixNeighHistory::pack_exchange(i, &kept[begin]);
    }
  FixNeighHistory::init();
  if (!renewed) return;
  double *next = kept.data();
  for (int i = 0; i < atom->nlocal; i++) next += FixNeighHistory::unpack_exchange(i, next);
}

/* ----------------------------------------------------------------------
   Between runs the partner lists are those that the end of the last run left. The neighbor list is
   not: the write_restart command renumbers the ghosts before it comes here.
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::pre_exchange()
{
  if (update->whichflag == 0) return;
  check_rows();
  FixNeighHistory::pre_exchange();
  for (int i = 0; i < nlocal_neigh; i++) owner[i] = {atom->tag[i], atom->radius[i]};
  maxexchange += OWNER;
}

/* ----------------------------------------------------------------------
   the neighbor list counts atoms by their rows
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::check_rows() const
{
  bool same = atom->nlocal >= nlocal_neigh;
  for (int i = 0; same && i < nlocal_neigh; i++) same = atom->tag[i] == row_id[i];
  if (!same)
    error->one(FLERR,
               "Atoms were deleted, or got other IDs, while pair style lubcontact still had a "
               "neighbor list of the old ones: define a fix that deletes atoms after pair_style, "
               "and do not continue with run ... pre no after a command that changes atoms");
}

/* ----------------------------------------------------------------------
   Partners are found by the IDs that the records know, which are those of the atoms unless a
   command has changed them since
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::post_neighbor()
{
  enum { RECORDS, RENAMED, RESIZED, RESTARTED, NUM };
  int mine[NUM] = {0, 0, 0, restarted ? 1 : 0}, any[NUM];
  for (int i = 0; i < atom->nlocal; i++) {
    const Owner &known = owner[i];
    if (npartner[i]) mine[RECORDS] = 1;
    if (known.id != atom->tag[i]) mine[RENAMED] = 1;
    if (known.id && known.radius != atom->radius[i]) mine[RESIZED] = 1;
  }
  MPI_Allreduce(mine, any, NUM, MPI_INT, MPI_MAX, world);
  if (any[RECORDS] && any[RESIZED]) drop_resized();
  if (any[RECORDS] && (any[RENAMED] || any[RESIZED]))
    find_partners();
  else
    FixNeighHistory::post_neighbor();
  row_id.assign(atom->tag, atom->tag + atom->nlocal);
  if (any[RECORDS] && any[RESTARTED]) check_found();
  restarted = false;
}

/* ----------------------------------------------------------------------
   the film of a particle that was given another size is not that of the old one
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::drop_resized()
{
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++)
    if (owner[i].id && owner[i].radius != atom->radius[i]) {
      mine++;
      npartner[i] = 0;
      owner[i] = Owner();
    }
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (comm->me == 0)
    error->warning(FLERR,
                   "The radii of {} atoms were changed since the last run: pair style lubcontact "
                   "treats their pairs as new pairs, without history",
                   all);
}

/* ----------------------------------------------------------------------
   LAMMPS' own search, in which every atom bears the ID of its record for a moment
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::find_partners()
{
  ids.resize(atom->nlocal + atom->nghost);
  for (int i = 0; i < atom->nlocal; i++) ids[i] = owner[i].id;
  comm->forward_comm(this);
  tagint *tag = atom->tag;
  atom->tag = ids.data();
  FixNeighHistory::post_neighbor();
  atom->tag = tag;
}

int FixNeighHistoryLubcontact::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  for (int m = 0; m < n; m++) buf[m] = ubuf(ids[list[m]]).d;
  return n;
}

void FixNeighHistoryLubcontact::unpack_forward_comm(int n, int first, double *buf)
{
  for (int m = 0; m < n; m++) ids[first + m] = static_cast<tagint>(ubuf(buf[m]).i);
}

/* ----------------------------------------------------------------------
   Records are of pairs in range, so that the first list after a restart has them all, but for those
   of atoms that were deleted
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::check_found() const
{
  const NeighList *list = pair->list;
  double mine[2] = {0.0, 0.0}, all[2];    // found, of all; either side of a pair counts
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const bool both = newton_pair || (list->firstneigh[i][jj] & NEIGHMASK) < atom->nlocal;
      if (firstflag[i][jj]) mine[0] += both ? 2.0 : 1.0;
    }
  }
  for (int i = 0; i < atom->nlocal; i++) mine[1] += npartner[i];
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (all[0] == all[1]) return;

  // not those whose partner is gone
  const auto alive = present_ids();
  mine[1] = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    mine[1] += std::count_if(partner[i], partner[i] + npartner[i], [&](tagint id) {
      return alive.count(id) > 0;
    });
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  const double lost = 0.5 * (all[1] - all[0]);
  if (lost <= 0.0) return;
  const auto text = fmt::format(
      "{} of {} pair histories of the restart file do not belong to any pair of this pair style "
      "lubcontact",
      lost, 0.5 * all[1]);
  if (all[0] == 0.0)
    error->all(FLERR,
               "{}: give the sub-styles of pair_style hybrid in the order of the run that wrote "
               "it, and the same pair_coeff and neigh_modify exclude; or start without histories: "
               "suspension_history forget all",
               text);
  if (comm->me == 0)
    error->warning(FLERR, "{}: they are deleted (atoms were moved apart, or pairs excluded)", text);
}

/* ---------------------------------------------------------------------- */

std::unordered_map<tagint, tagint> FixNeighHistoryLubcontact::present_ids() const
{
  std::vector<tagint> mine;    // ID in the records, ID now
  for (int i = 0; i < atom->nlocal; i++)
    if (owner[i].id) {
      mine.push_back(owner[i].id);
      mine.push_back(atom->tag[i]);
    }
  const int n = static_cast<int>(mine.size());
  std::vector<int> counts(comm->nprocs), starts(comm->nprocs, 0);
  MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  for (int rank = 1; rank < comm->nprocs; rank++)
    starts[rank] = starts[rank - 1] + counts[rank - 1];
  std::vector<tagint> all(starts.back() + counts.back());
  MPI_Allgatherv(mine.data(), n, MPI_LMP_TAGINT, all.data(), counts.data(), starts.data(),
                 MPI_LMP_TAGINT, world);
  std::unordered_map<tagint, tagint> found;
  for (std::size_t m = 0; m < all.size(); m += 2) found[all[m]] = all[m + 1];
  return found;
}

/* ---------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::adopt(int i, std::vector<double> &values)
{
  FixNeighHistory::unpack_exchange(i, values.data());
  owner[i] = {atom->tag[i], atom->radius[i]};
  maxexchange = (dnum + 1) * maxpartner + 1 + OWNER;
}

/* ----------------------------------------------------------------------
   between runs; number of records, of which a pair has two
------------------------------------------------------------------------- */

bigint FixNeighHistoryLubcontact::forget(int groupbit_forget)
{
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit_forget)) continue;
    mine += npartner[i];
    npartner[i] = 0;
    owner[i] = Owner();
  }
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::grow_arrays(int nmax)
{
  FixNeighHistory::grow_arrays(nmax);
  owner.resize(nmax);
}

void FixNeighHistoryLubcontact::copy_arrays(int i, int j, int delflag)
{
  FixNeighHistory::copy_arrays(i, j, delflag);
  owner[j] = owner[i];
}

void FixNeighHistoryLubcontact::set_arrays(int i)
{
  FixNeighHistory::set_arrays(i);
  owner[i] = Owner();
}

/* ---------------------------------------------------------------------- */

int FixNeighHistoryLubcontact::pack_exchange(int i, double *buf)
{
  const int n = FixNeighHistory::pack_exchange(i, buf);
  buf[n] = ubuf(owner[i].id).d;
  buf[n + 1] = owner[i].radius;
  return n + OWNER;
}

int FixNeighHistoryLubcontact::unpack_exchange(int nlocal, double *buf)
{
  const int n = FixNeighHistory::unpack_exchange(nlocal, buf);
  owner[nlocal] = {static_cast<tagint>(ubuf(buf[n]).i), buf[n + 1]};
  return n + OWNER;
}

/* ----------------------------------------------------------------------
   of one atom: length, number of partners, ID and dnum values of each, then ID and radius of the
   atom in the record, the layout of the values and the checksum of all
------------------------------------------------------------------------- */

int FixNeighHistoryLubcontact::pack_restart(int i, double *buffer)
{
  const int n = FixNeighHistory::pack_restart(i, buffer);
  buffer[0] = n + EXTRA;
  buffer[n] = ubuf(owner[i].id).d;
  buffer[n + 1] = owner[i].radius;
  buffer[n + 2] = layout;
  buffer[n + 3] = Suspension_NS::seal(buffer, sizeof(double) * (n + 3));
  return n + EXTRA;
}

/* ----------------------------------------------------------------------
   not yet: the atoms may have left the rows that LAMMPS has kept for them
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::unpack_restart(int /*nlocal*/, int nth)
{
  part = nth;
}

void FixNeighHistoryLubcontact::take_restart(const std::vector<std::vector<double>> &rows)
{
  if (part < 0) return;
  if (!ipage_atom) allocate_pages();
  for (int i = 0; i < atom->nlocal; i++) {
    npartner[i] = 0;
    owner[i] = Owner();
    if (rows.empty())
      record(i, atom->extra[i]);
    else if (!rows[i].empty())
      record(i, rows[i].data());
  }
  maxexchange = (dnum + 1) * maxpartner + 1 + OWNER;
  restarted = true;
}

/* ----------------------------------------------------------------------
   of atom i, from what the fixes have kept of it
------------------------------------------------------------------------- */

void FixNeighHistoryLubcontact::record(int i, const double *row)
{
  const double *mine = Suspension_NS::part_of_atom(row, part, atom->nextra_store);
  const double length = mine ? mine[0] : 0.0;    // if damaged perhaps no integer
  const double expected = mine ? 2.0 + mine[1] * (1.0 + dnum) + EXTRA : 0.0;
  const int n = length == expected && length > 0.0 && length <= atom->nextra_store
      ? static_cast<int>(length)
      : 0;
  if (n && Suspension_NS::seal(mine, sizeof(double) * (n - 1)) != mine[n - 1])
    error->one(FLERR,
               "The pair history of atom {} in the restart file is damaged: use another restart "
               "file",
               atom->tag[i]);
  if (n == 0 || mine[n - 2] != layout)
    error->one(
        FLERR,
        "The restart file contains the pair history of different effects than pair style "
        "lubcontact has now, or it is damaged: keep the effects it was written with for the first "
        "run after read_restart");
  std::vector<double> copy(mine + 1, mine + n);
  FixNeighHistory::unpack_exchange(i, copy.data());
  owner[i] = {static_cast<tagint>(ubuf(copy[n - 1 - EXTRA]).i), copy[n - EXTRA]};
}

/* ---------------------------------------------------------------------- */

int FixNeighHistoryLubcontact::size_restart(int i)
{
  return FixNeighHistory::size_restart(i) + EXTRA;
}

int FixNeighHistoryLubcontact::maxsize_restart()
{
  return FixNeighHistory::maxsize_restart() + EXTRA;
}

/* ---------------------------------------------------------------------- */

double FixNeighHistoryLubcontact::memory_usage()
{
  return FixNeighHistory::memory_usage() + owner.capacity() * sizeof(Owner) +
      (row_id.capacity() + ids.capacity()) * sizeof(tagint);
}
