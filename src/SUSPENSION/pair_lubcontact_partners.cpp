/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Sums over the partners of each particle.

#include "pair_lubcontact.h"
#include "pair_lubcontact_count.h"

#include "atom.h"
#include "comm.h"
#include "force.h"
#include "lubcontact_history.h"
#include "lubcontact_law.h"
#include "lubcontact_pairs.h"
#include "lubcontact_stiffness.h"
#include "neigh_list.h"
#include "update.h"

#include <vector>

using namespace LAMMPS_NS;
using Lubcontact_NS::PairGeometry;

/* ----------------------------------------------------------------------
   sum over the partners of each atom of the stiffest mode of a pair, particles turning as easily as
   spin says; a dashpot counts as dashpot_stiffness(). Returns the number of pairs in range on this
   rank
------------------------------------------------------------------------- */

double PairLubcontact::sum_over_partners(double spin)
{
  of_partners.assign(atom->nlocal + atom->nghost, 0.0);
  const bool roll = given->films & Lubcontact_NS::ROLL, twist = given->films & Lubcontact_NS::TWIST;
  double number = 0.0;
  pairs->each([&](const LubcontactPairs::Acting &p) {
    const auto &c = pairs->range().of(atom->type[p.i], atom->type[p.j]);
    const PairGeometry g = pairs->geometry(p.i, p.j, p.a);
    double normal = c.normal.g;
    if (c.restitution > 0.0) {
      const double mi = atom->rmass[p.i], mj = atom->rmass[p.j];
      normal += Lubcontact_NS::dashpot_stiffness(c.restitution, mi * mj / (mi + mj) / force->ftm2v,
                                                 update->dt);
    }
    Lubcontact_NS::PairStiffness k = Lubcontact_NS::pair_stiffness(
        normal, c.kt, spin, g, atom->radius[p.i], atom->radius[p.j], roll, twist);
    if (film->residual)
      k = Lubcontact_NS::larger_stiffness(
          k,
          Lubcontact_NS::pair_stiffness(normal, c.kt, spin, Lubcontact_NS::with_lever(g),
                                        atom->radius[p.i], atom->radius[p.j], roll, twist));
    of_partners[p.i] += k.i;
    of_partners[p.j] += k.j;
    number += p.weight;
  });
  if (force->newton_pair) comm->reverse_comm(this);
  return number;
}

/* ---------------------------------------------------------------------- */

const std::vector<double> &PairLubcontact::count_partners()
{
  if (counted->known)
    count_changes();
  else
    count_all_partners();
  counted->changes.clear();
  counted->asked = true;
  counted->known = pairs->history().size() > 0;
  return counted->number;
}

/* ----------------------------------------------------------------------
   the loop of the forces has marked the pairs that act, if they have a history
------------------------------------------------------------------------- */

void PairLubcontact::count_all_partners()
{
  of_partners.assign(atom->nlocal + atom->nghost, 0.0);
  const NeighList *list = pairs->list();
  LubcontactHistory &history = pairs->history();
  if (!history.size())
    pairs->each([&](const LubcontactPairs::Acting &p) {
      of_partners[p.i] += 1.0;
      of_partners[p.j] += 1.0;
    });
  else
    for (int ii = 0; ii < list->inum; ii++) {
      const int i = list->ilist[ii], number = list->numneigh[i];
      const int *entries = list->firstneigh[i], *known = history.known(i);
      double mine = 0.0;
      for (int n = 0; n < number; n++) {
        if (!known[n] || force->special_lj[entries[n] >> SBBITS & 3] == 0.0) continue;
        mine += 1.0;
        of_partners[entries[n] & NEIGHMASK] += 1.0;
      }
      of_partners[i] += mine;
    }
  if (force->newton_pair) comm->reverse_comm(this);
  counted->number.swap(of_partners);
}

/* ----------------------------------------------------------------------
   ranks tell each other of ghosts only in steps in which there is something to tell
------------------------------------------------------------------------- */

void PairLubcontact::count_changes()
{
  int mine = 0, any = 0;
  for (const LubcontactChange &c : counted->changes) {
    counted->number[c.i] += c.number;
    counted->number[c.j] += c.number;
    if (c.j >= atom->nlocal) mine = 1;
  }
  if (!force->newton_pair) return;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any) return;

  of_partners.assign(atom->nlocal + atom->nghost, 0.0);
  for (const LubcontactChange &c : counted->changes)
    if (c.j >= atom->nlocal) of_partners[c.j] += c.number;
  comm->reverse_comm(this);
  for (int i = 0; i < atom->nlocal; i++) counted->number[i] += of_partners[i];
}

void PairLubcontact::sum_stiffness(double spin, std::vector<double> &sum)
{
  sum_over_partners(spin);
  sum.swap(of_partners);
}

int PairLubcontact::pack_reverse_comm(int n, int first, double *buf)
{
  for (int m = 0; m < n; m++) buf[m] = of_partners[first + m];
  return n;
}

void PairLubcontact::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int m = 0; m < n; m++) of_partners[list[m]] += buf[m];
}
