/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_neigh_history_place.h"

#include "atom.h"

#include <algorithm>
#include <utility>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

FixNeighHistoryPlace::FixNeighHistoryPlace(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), orphan(false), loaded(false)
{
  create_attribute = 1;
  maxexchange_dynamic = 1;
  FixNeighHistoryPlace::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
}

FixNeighHistoryPlace::~FixNeighHistoryPlace()
{
  atom->delete_callback(id, Atom::GROW);
}

/* ----------------------------------------------------------------------
   from the first run on the restart file is history
------------------------------------------------------------------------- */

void FixNeighHistoryPlace::init()
{
  loaded = false;
  rows = Rows();
  maxexchange = 0;
}

/* ----------------------------------------------------------------------
   before one of the first n atoms, which came from the restart file, leaves its row
------------------------------------------------------------------------- */

void FixNeighHistoryPlace::load(int n)
{
  if (loaded || atom->nextra_store == 0 || !atom->extra) return;
  loaded = true;
  rows.resize(atom->nmax);
  for (int i = 0; i < n; i++) rows[i].assign(atom->extra[i], atom->extra[i] + atom->nextra_store);
}

/* ---------------------------------------------------------------------- */

FixNeighHistoryPlace::Rows FixNeighHistoryPlace::take_rows()
{
  Rows taken;
  taken.swap(rows);
  loaded = false;
  return taken;
}

/* ----------------------------------------------------------------------
   number of atoms
------------------------------------------------------------------------- */

bigint FixNeighHistoryPlace::forget(int groupbit_forget)
{
  load(atom->nlocal);
  bigint mine = 0, all;
  for (int i = 0; loaded && i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit_forget) || rows[i].empty()) continue;
    rows[i].clear();
    mine++;
  }
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixNeighHistoryPlace::grow_arrays(int nmax)
{
  if (loaded) rows.resize(nmax);
  maxexchange = 1 + atom->nextra_store;
}

void FixNeighHistoryPlace::copy_arrays(int i, int j, int /*delflag*/)
{
  load(atom->nlocal);
  if (loaded && i != j) rows[j] = rows[i];
}

/* ----------------------------------------------------------------------
   of a new atom the restart file holds nothing
------------------------------------------------------------------------- */

void FixNeighHistoryPlace::set_arrays(int i)
{
  load(i);
  if (loaded) rows[i].clear();
}

/* ---------------------------------------------------------------------- */

int FixNeighHistoryPlace::pack_exchange(int i, double *buf)
{
  load(atom->nlocal);
  const std::size_t n = loaded ? rows[i].size() : 0;
  buf[0] = static_cast<double>(n);
  if (n) std::copy(rows[i].begin(), rows[i].end(), buf + 1);
  return static_cast<int>(n) + 1;
}

int FixNeighHistoryPlace::unpack_exchange(int nlocal, double *buf)
{
  const int n = static_cast<int>(buf[0]);
  load(atom->nlocal);
  if (loaded) rows[nlocal].assign(buf + 1, buf + 1 + n);
  return n + 1;
}

/* ---------------------------------------------------------------------- */

double FixNeighHistoryPlace::memory_usage()
{
  double bytes = 0.0;
  for (const auto &row : rows) bytes += sizeof(row) + row.capacity() * sizeof(double);
  return bytes;
}
