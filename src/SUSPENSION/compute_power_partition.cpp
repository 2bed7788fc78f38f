/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "compute_power_partition.h"

#include "atom.h"
#include "background_fluid.h"
#include "compute_stress_partition.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

static constexpr int NUM_ORIGINS = PairLubcontact::NUM_ORIGINS;
static constexpr int DRAG = NUM_ORIGINS, KINETIC = DRAG + 1, NUM_ROWS = KINETIC + 1;
static constexpr int NUM_COMPONENTS = PairLubcontact::NUM_COMPONENTS;

/* ---------------------------------------------------------------------- */

ComputePowerPartition::ComputePowerPartition(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg)
{
  if (narg > 3)
    error->all(FLERR, 3, "Unknown compute power/partition argument: {}; it takes none", arg[3]);
  if (igroup)
    error->all(FLERR, 1,
               "Compute power/partition is of the whole cell: use group all instead of {}", arg[1]);

  scalar_flag = array_flag = 1;
  extscalar = extarray = 1;
  size_array_rows = NUM_ROWS;
  size_array_cols = 2;    // turned into heat per time, stored
  timeflag = 1;           // the pair style tallies in the steps announced for this compute
  memory->create(array, NUM_ROWS, 2, "power/partition:array");
}

/* ---------------------------------------------------------------------- */

ComputePowerPartition::~ComputePowerPartition()
{
  memory->destroy(array);
}

/* ---------------------------------------------------------------------- */

void ComputePowerPartition::init()
{
  pairs = ComputeStressPartition::find_pairs(lmp, style);
  drags.clear();
  for (const char *name : {"^drag/background", "^overdamped/sphere"})
    for (auto &fix : modify->get_fix_by_style(name)) drags.push_back(fix);
  inertia.find(lmp);
}

/* ---------------------------------------------------------------------- */

void ComputePowerPartition::require_tally() const
{
  for (const auto &pair : pairs)
    if (pair->power_step != update->ntimestep)
      error->all(
          FLERR,
          "Power by origin was not tallied in step {}: use compute power/partition where its "
          "steps are known in advance (thermo, fix ave, dump, every-type variables)",
          update->ntimestep);
}

/* ----------------------------------------------------------------------
   column 1: turned into heat by the last step, per time; column 2: stored
------------------------------------------------------------------------- */

void ComputePowerPartition::compute_array()
{
  invoked_array = update->ntimestep;
  require_tally();

  double mine[NUM_ROWS][2] = {};
  for (const auto &pair : pairs)
    for (int m = 0; m < NUM_ORIGINS; m++) {
      mine[m][0] += pair->heat[m] / update->dt;
      mine[m][1] += pair->stored[m];
    }
  mine[KINETIC][1] = kinetic_energy();
  MPI_Allreduce(mine, array[0], 2 * NUM_ROWS, MPI_DOUBLE, MPI_SUM, world);
  if (pairs.front()->power_of_step)
    for (auto &fix : drags) array[DRAG][0] += fix->compute_vector(fix->size_vector - 1);
}

/* ----------------------------------------------------------------------
   of the particles of this rank, relative to the flow of the cell, and of their spins
------------------------------------------------------------------------- */

double ComputePowerPartition::kinetic_energy() const
{
  double sum[NUM_COMPONENTS] = {}, spin = 0.0;
  const int massless = overdamped_groups(lmp);
  ComputeStressPartition::add_all_inertial(lmp, sum);
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->mask[i] & massless) continue;
    const double *omega = atom->omega[i];
    spin += inertia.of(atom, i) * (omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2]);
  }
  return 0.5 * force->mvv2e * (sum[0] + sum[1] + sum[2] + spin);
}

/* ----------------------------------------------------------------------
   power that the deformation of the cell puts in: sum of sigma_ab L_ba times volume, with the velocity
   gradient L of the cell; and what a fluid that turns with the cell gives to the spins
------------------------------------------------------------------------- */

double ComputePowerPartition::compute_scalar()
{
  invoked_scalar = update->ntimestep;
  require_tally();

  // r_a F_b of the pairs and m v_a v_b, over the components xx yy zz xy xz yz yx zx zy
  double mine[NUM_COMPONENTS] = {}, all[NUM_COMPONENTS];
  ComputeStressPartition::add_all_inertial(lmp, mine);
  for (double &product : mine) product *= force->mvv2e;
  for (const auto &pair : pairs)
    for (const auto &part : pair->partition)
      for (int n = 0; n < NUM_COMPONENTS; n++) mine[n] += part[n];
  MPI_Allreduce(mine, all, NUM_COMPONENTS, MPI_DOUBLE, MPI_SUM, world);

  scalar = 0.0;
  if (!domain->deform_flag) return scalar;
  // L = (rate of h)/h is upper triangular as h is: order xx yy zz yz xz xy
  const double *rate = domain->h_rate, *inv = domain->h_inv;
  const double xx = rate[0] * inv[0], yy = rate[1] * inv[1], zz = rate[2] * inv[2];
  const double xy = rate[0] * inv[5] + rate[5] * inv[1];
  const double yz = rate[1] * inv[3] + rate[3] * inv[2];
  const double xz = rate[0] * inv[4] + rate[5] * inv[3] + rate[4] * inv[2];
  // L_xy moves along x what is displaced along y: r_y F_x
  scalar = -(xx * all[0] + yy * all[1] + zz * all[2] + xy * all[6] + xz * all[7] + yz * all[8]);
  for (auto &fix : drags)    // elements 5 to 7: torque of the fluid; its spin is half the curl of L
    scalar += 0.5 *
        (-yz * fix->compute_vector(4) + xz * fix->compute_vector(5) - xy * fix->compute_vector(6));
  return scalar;
}

/* ---------------------------------------------------------------------- */

double ComputePowerPartition::memory_usage()
{
  return sizeof(double) * NUM_ROWS * 2;
}
