/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Which entries of a neighbor list share a face.

#include "radical_tessellation.h"

#include "atom.h"
#include "neigh_list.h"

using namespace LAMMPS_NS;

// Smaller faces are none, so that ties of regular arrangements (Voro++ decides to 1e-11) do not
// depend on the rounding of a rank. Over the largest radius squared; in 2d a length over it.
static constexpr double LEAST_AREA = 1e-8;

/* ---------------------------------------------------------------------- */

void RadicalTessellation::mark_faces(const NeighList *list, FaceFlags &faces) const
{
  std::size_t total = 0;
  faces.first.assign(atom->nlocal, FaceFlags::NONE);    // under hybrid: a particle of other styles
  for (int ii = 0; ii < list->inum; ii++) {
    faces.first[list->ilist[ii]] = total;
    total += list->numneigh[list->ilist[ii]];
  }
  faces.flags.assign(total, 0);
  if (total == 0) return;

  std::vector<int> entry(atom->nlocal + atom->nghost, -1);    // place in the list of i
  each_cell([&](const Cell &cell) {
    const int i = cell.owner;
    if (faces.first[i] == FaceFlags::NONE) return;
    const int *jlist = list->firstneigh[i];
    for (int jj = 0; jj < list->numneigh[i]; jj++) entry[jlist[jj] & NEIGHMASK] = jj;
    for (std::size_t n = 0; n < cell.neighbors.size(); n++) {
      const int j = cell.neighbors[n];
      if (j < 0 || entry[j] < 0 || cell.areas[n] < LEAST_AREA) continue;
      faces.flags[faces.first[i] + entry[j]] = 1;
      cell.require_sure(n);
    }
    for (int jj = 0; jj < list->numneigh[i]; jj++) entry[jlist[jj] & NEIGHMASK] = -1;
  });
}
