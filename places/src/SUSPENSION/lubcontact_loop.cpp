/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the instances of the loop share.

#include "lubcontact_loop_instances.h"

#include "comm.h"

using namespace LAMMPS_NS;

// compiled elsewhere
static_assert(Lubcontact_NS::NUM_SHARES == 4, "one file for each share");
extern template void LAMMPS_NS::find_in_share<0>(LubcontactInstance &);
extern template void LAMMPS_NS::find_in_share<1>(LubcontactInstance &);
extern template void LAMMPS_NS::find_in_share<2>(LubcontactInstance &);
extern template void LAMMPS_NS::find_in_share<3>(LubcontactInstance &);

/* ---------------------------------------------------------------------- */

LubcontactInstance LAMMPS_NS::find_instance(unsigned effects, bool residual)
{
  LubcontactInstance found{effects, Lubcontact_NS::covering(effects), {}, nullptr, nullptr};
  if (residual) {
    found.covering = Lubcontact_NS::covering_residual(effects);
    find_residual(found);
    return found;
  }
  find_in_share<0>(found);
  find_in_share<1>(found);
  find_in_share<2>(found);
  find_in_share<3>(found);
  return found;
}

/* ---------------------------------------------------------------------- */

void LAMMPS_NS::overlap_error(LAMMPS *lmp, int i, int j, double overlap)
{
  const Atom *atom = lmp->atom;
  lmp->error->one(FLERR,
                  "Atoms {} and {} overlap by {:.4g} effective radii at step {}: reduce the time "
                  "step, stiffen the contact, or separate the particles first",
                  atom->tag[i], atom->tag[j], overlap, lmp->update->ntimestep);
}

/* ----------------------------------------------------------------------
   virial of the cell: so cheap that a fix may ask for it in every step
------------------------------------------------------------------------- */

[[LUBCONTACT_EACH_PROCESSOR gnu::noinline]] static void add_products(const Batch &b,
                                                                     Batch::Lanes *sum)
{
  LUBCONTACT_INDEPENDENT_LANES
  for (int l = 0; l < Batch::WIDTH; l++) {
    sum[0][l] += b.x[0][l] * b.force[0][l];
    sum[1][l] += b.x[1][l] * b.force[1][l];
    sum[2][l] += b.x[2][l] * b.force[2][l];
    sum[3][l] += b.x[0][l] * b.force[1][l];
    sum[4][l] += b.x[0][l] * b.force[2][l];
    sum[5][l] += b.x[1][l] * b.force[2][l];
  }
}

void LAMMPS_NS::add_virial(const Force *force, const Atom *atom, LubcontactQueue &queue)
{
  Batch &b = queue.batch;
  if (!force->newton_pair)
    for (int l = 0; l < queue.n; l++) {
      const double share = queue.j[l] < atom->nlocal ? 1.0 : 0.5;
      put_lane(share * Lubcontact_NS::get_lane(b.force, l), b.force, l);
    }
  for (int l = queue.n; l < Batch::WIDTH; l++) put_lane(Vec3{}, b.force, l);
  add_products(b, queue.virial);
}
