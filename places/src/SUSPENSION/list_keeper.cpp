/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "list_keeper.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "npair.h"
#include "pair.h"
#include "rheometer_list.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using Rheometer_NS::Deformation;
using Rheometer_NS::Scatter;

static constexpr int NEVER = MAXSMALLINT;    // steps between the decisions of LAMMPS

/* ---------------------------------------------------------------------- */

ListKeeper::ListKeeper(LAMMPS *lmp, Fix *owner) :
    Pointers(lmp), on(true), fix(owner), keeps(false), asked(false), every(1), narrowest{}
{
}

ListKeeper::~ListKeeper()
{
  release();
}

/* ---------------------------------------------------------------------- */

void ListKeeper::listed()
{
  held.clear();
  if (!on || update->whichflag != 1) return;
  held.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) held[i][k] = atom->x[i][k];

  // how far a particle may go before it passes by the rank, or the image, beside its own
  double mine[3];
  for (int k = 0; k < 3; k++) {
    const double part = domain->triclinic ? domain->subhi_lamda[k] - domain->sublo_lamda[k]
                                          : (domain->subhi[k] - domain->sublo[k]) / domain->prd[k];
    const bool open = part >= 1.0 && !domain->periodicity[k];
    mine[k] = open ? HUGE_VAL : part * domain->prd[k];
  }
  MPI_Allreduce(mine, narrowest, 3, MPI_DOUBLE, MPI_MIN, world);
}

/* ----------------------------------------------------------------------
   The largest of the pair styles' cut-offs and of those that lists were asked for, skin included
------------------------------------------------------------------------- */

double ListKeeper::longest_cutoff() const
{
  double longest = neighbor->cutneighmax;
  for (int n = 0; n < neighbor->nlist; n++)
    if (neighbor->lists[n]->np) longest = std::max(longest, neighbor->lists[n]->np->cutoff_custom);
  return longest;
}

/* ----------------------------------------------------------------------
   Not if the user has fixed the steps, if a pair style makes more with its list than to look for
   pairs, or if another fix moves particles afterwards
------------------------------------------------------------------------- */

bool ListKeeper::may_keep() const
{
  if (!on || update->whichflag != 1 || !neighbor->dist_check || neighbor->build_once) return false;
  if (held.size() != static_cast<std::size_t>(atom->nlocal)) return false;
  int dim = 0;
  if (force->pair && force->pair->extract("faces", dim)) return false;
  bool later = false;
  for (const auto &other : modify->get_fix_list()) {
    if (later && (modify->get_fix_mask(other) & FixConst::POST_INTEGRATE)) return false;
    if (other == fix) later = true;
  }
  return true;
}

/* ---------------------------------------------------------------------- */

void ListKeeper::take_over()
{
  asked = true;
  int mine = may_keep() ? 1 : 0, all;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, world);
  if (!all) return;
  keeps = true;
  every = neighbor->every;
  neighbor->every = NEVER;
}

void ListKeeper::release()
{
  if (keeps && neighbor)
    neighbor->every = every;    // a LAMMPS that ends in a run has none any more
  keeps = asked = false;
}

/* ----------------------------------------------------------------------
   a particle that leaves its sub-domain must arrive in the next one
------------------------------------------------------------------------- */

bool ListKeeper::crosses(const Scatter &moved) const
{
  for (int k = 0; k < 3; k++)
    if (std::max(moved.most[k], -moved.least[k]) >= narrowest[k]) return true;
  return false;
}

/* ----------------------------------------------------------------------
   The last reference is that of the sub-domains: a deforming cell's, or that of particles at rest
------------------------------------------------------------------------- */

bool ListKeeper::decide(const std::vector<Deformation> &references, const double *origin)
{
  if (!asked) take_over();
  if (!keeps) return true;

  static constexpr int SIZE = 7;
  std::vector<double> mine, all(SIZE * references.size());
  for (const Deformation &f : references) {
    Scatter scatter;
    for (int i = 0; i < atom->nlocal; i++) {
      const double *x = atom->x[i], *x0 = held[i].data();
      const double from[3] = {x0[0] - origin[0], x0[1] - origin[1], x0[2] - origin[2]};
      const double to[3] = {x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]};
      scatter.add(f, from, to);
    }
    mine.push_back(scatter.longest);
    for (int k = 0; k < 3; k++) mine.push_back(scatter.most[k]);
    for (int k = 0; k < 3; k++) mine.push_back(-scatter.least[k]);
  }
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_MAX, world);

  bool holds = false;
  const double cut_and_skin = longest_cutoff();
  for (std::size_t n = 0; n < references.size(); n++) {
    const double *a = &all[SIZE * n];
    const Scatter s = {a[0], {-a[4], -a[5], -a[6]}, {a[1], a[2], a[3]}};
    holds = holds ||
        Rheometer_NS::list_holds(references[n], domain->dimension,
                                 Rheometer_NS::largest_difference(s), cut_and_skin, neighbor->skin);
    if (n + 1 == references.size() && crosses(s)) return false;
  }

  // lists that a compute asks for are of the moment, not of when it asked for the first time
  for (int n = 0; holds && n < neighbor->nlist; n++)
    if (neighbor->lists[n]->occasional && neighbor->lists[n]->np)
      neighbor->lists[n]->np->last_build = -1;
  return holds;
}

/* ---------------------------------------------------------------------- */

double ListKeeper::memory_usage() const
{
  return static_cast<double>(held.capacity() * sizeof(held[0]));
}
