/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Virial and stress by origin of pair style lubcontact: what all instances of the loop share.

#include "pair_lubcontact_loop.h"

using namespace LAMMPS_NS;

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

void PairLubcontact::add_virial(Queue &queue) const
{
  Batch &b = queue.batch;
  if (!force->newton_pair)
    for (int l = 0; l < queue.n; l++)
      put_lane(share(queue.j[l]) * Lubcontact_NS::get_lane(b.force, l), b.force, l);
  for (int l = queue.n; l < Batch::WIDTH; l++) put_lane(Vec3{}, b.force, l);
  add_products(b, queue.virial);
}

/* ----------------------------------------------------------------------
   sum of r_a F_b by origin, of the cell and of each particle: half of a pair to either
------------------------------------------------------------------------- */

void PairLubcontact::tally_partition(int i, int j, const PairGeometry &geometry, const Load &load)
{
  const auto force_of = Lubcontact_NS::force_by_channel(geometry, load);
  const double weight = share(j);
  const Vec3 d = geometry.r * geometry.n;
  for (int m = 0; m < NUM_PARTS; m++) {
    const Vec3 &f = force_of.of[m];
    const double product[NUM_COMPONENTS] = {d.x * f.x, d.y * f.y, d.z * f.z, d.x * f.y, d.x * f.z,
                                            d.y * f.z, d.y * f.x, d.z * f.x, d.z * f.y};
    if (partition_now)
      for (int n = 0; n < NUM_COMPONENTS; n++) partition[m][n] += weight * product[n];
    if (partition_atom_now)
      for (int n = 0; n < NUM_COMPONENTS; n++) {
        partition_atom[i][m * NUM_COMPONENTS + n] += 0.5 * product[n];
        partition_atom[j][m * NUM_COMPONENTS + n] += 0.5 * product[n];
      }
  }
}
