/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "compute_power_partition.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_background_fluid.h"
#include "fix_hydro.h"
#include "fix_pore_pressure.h"
#include "force.h"
#include "lubcontact_inertia.h"
#include "lubcontact_tally.h"
#include "memory.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "particle_inertia.h"
#include "spin_inertia.h"
#include "suspension_host.h"
#include "uncounted_forces.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

using Lubcontact_NS::NUM_ORIGINS;
static constexpr int DRAG = NUM_ORIGINS, KINETIC = DRAG + 1, PORE = KINETIC + 1, FAR = PORE + 1,
                     NUM_ROWS = FAR + 1;
static constexpr int NUM_COMPONENTS = LubcontactTally::NUM_COMPONENTS;

/* ---------------------------------------------------------------------- */

ComputePowerPartition::ComputePowerPartition(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), pore(nullptr), hydro(nullptr), inertia(new SpinInertia())
{
  if (narg > 3)
    error->all(FLERR, 3, "Unknown compute power/partition argument: {}; it takes none", arg[3]);
  if (igroup)
    error->all(FLERR, 1,
               "Compute power/partition applies to the whole cell: use group all instead of {}",
               arg[1]);

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
  pairs = PairLubcontact::require(lmp, std::string("Compute ") + style);
  check_rows(lmp, this);
  drags.clear();
  for (const auto &fix : modify->get_fix_list())
    if (auto *drag = dynamic_cast<FixBackgroundFluid *>(fix)) drags.push_back(drag);
  inertia->find(lmp);
  pore = FixPorePressure::find(lmp);
  hydro = FixHydro::find(lmp);
}

/* ---------------------------------------------------------------------- */

void ComputePowerPartition::require_tally() const
{
  for (const auto &pair : pairs)
    if (!pair->tally().has_power())
      error->all(
          FLERR,
          "Power by origin was not tallied in step {}: use compute power/partition where its "
          "steps are known in advance (thermo output, fix ave/*, dumps, and variables they "
          "evaluate)",
          update->ntimestep);
}

/* ----------------------------------------------------------------------
   column 1: turned into heat by the last step, per time; column 2: stored
------------------------------------------------------------------------- */

void ComputePowerPartition::compute_array()
{
  invoked_array = update->ntimestep;
  require_tally();

  // and behind the rows what inertia needs: one reduction for both
  struct Sums {
    double row[NUM_ROWS][2] = {};
    Lubcontact_NS::Inertia inertia;
  } mine, all;
  for (const auto &pair : pairs)
    for (int m = 0; m < NUM_ORIGINS; m++) {
      mine.row[m][0] += pair->tally().heat().of[m] / update->dt;
      mine.row[m][1] += pair->tally().stored().of[m];
    }
  mine.row[KINETIC][1] = spin_energy();
  mine.inertia = Suspension_NS::measure_inertia(lmp);
  MPI_Allreduce(mine.row[0], all.row[0], sizeof(Sums) / sizeof(double), MPI_DOUBLE, MPI_SUM, world);

  std::copy_n(all.row[0], 2 * NUM_ROWS, array[0]);
  const Lubcontact_NS::Fluctuation f = Lubcontact_NS::fluctuation(all.inertia);
  array[KINETIC][1] += 0.5 * force->mvv2e * (f.xx + f.yy + f.zz);
  if (pairs.front()->tally().power_of_step())
    for (auto &fix : drags) array[DRAG][0] += fix->mean_power();
  array[PORE][0] =
      pore && pore->acts() && pairs.front()->tally().power_of_step() ? pore->mean_power() : 0.0;
  array[FAR][0] = hydro && pairs.front()->tally().power_of_step() ? hydro->mean_power() : 0.0;
}

/* ----------------------------------------------------------------------
   of the spins of this rank's particles
------------------------------------------------------------------------- */

double ComputePowerPartition::spin_energy() const
{
  double sum = 0.0;
  const int massless = Suspension_NS::groups_without_inertia(lmp);
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->mask[i] & massless) continue;
    const double *omega = atom->omega[i];
    sum += inertia->of(atom, i) * (omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2]);
  }
  return 0.5 * force->mvv2e * sum;
}

/* ----------------------------------------------------------------------
   power that the deformation of the cell puts in: sum of sigma_ab L_ba times volume, with the
   velocity gradient L of the cell, and with the mean pressure of the pores; what a fluid that turns
   with the cell gives to the spins; and what the common drift of the particles, whose energy is not
   counted, loses to the drag
------------------------------------------------------------------------- */

double ComputePowerPartition::compute_scalar()
{
  invoked_scalar = update->ntimestep;
  require_tally();

  // r_a F_b of the pairs, over the components xx yy zz xy xz yz yx zx zy; and inertia
  struct Sums {
    double pairs[NUM_COMPONENTS] = {}, stresslets = 0.0;
    Lubcontact_NS::Inertia inertia;
  } mine, all;
  for (const auto &pair : pairs)
    for (const auto &part : pair->tally().stress())
      for (int n = 0; n < NUM_COMPONENTS; n++) mine.pairs[n] += part[n];
  mine.inertia = Suspension_NS::measure_inertia(lmp);
  if (hydro) mine.stresslets = hydro->stresslet_power();
  MPI_Allreduce(mine.pairs, all.pairs, sizeof(Sums) / sizeof(double), MPI_DOUBLE, MPI_SUM, world);

  const Lubcontact_NS::Fluctuation f = Lubcontact_NS::fluctuation(all.inertia);
  const Lubcontact_NS::Vec3 drift = all.inertia.drift();
  const auto l = Suspension_NS::cell_gradient(domain);
  // L_xy moves along x what is displaced along y: r_y F_x
  const double *r = all.pairs, unit = force->mvv2e;
  scalar =
      -(l.xx * (r[0] + unit * f.xx) + l.yy * (r[1] + unit * f.yy) + l.zz * (r[2] + unit * f.zz) +
        l.xy * (r[6] + unit * f.xy) + l.xz * (r[7] + unit * f.xz) + l.yz * (r[8] + unit * f.yz));
  if (pore && pore->acts())
    scalar -= (l.xx + l.yy + l.zz) * pore->cell_pressure() * Suspension_NS::cell_volume(domain);
  if (hydro)
    scalar += all.stresslets +
        0.5 * (-l.yz * hydro->torque(0) + l.xz * hydro->torque(1) - l.xy * hydro->torque(2)) -
        drift.x * hydro->force_of_fluid(0) - drift.y * hydro->force_of_fluid(1) -
        drift.z * hydro->force_of_fluid(2);
  for (auto &fix : drags) {
    // the spin of the fluid is half the curl of L
    scalar += 0.5 *
        (-l.yz * fix->drag_torque(0) + l.xz * fix->drag_torque(1) - l.xy * fix->drag_torque(2));
    // without inertia there is no energy of a drift
    if (!fix->time_integrate)
      scalar -= drift.x * fix->drag_force(0) + drift.y * fix->drag_force(1) +
          drift.z * fix->drag_force(2);
  }
  return scalar;
}

/* ---------------------------------------------------------------------- */

double ComputePowerPartition::memory_usage()
{
  return sizeof(double) * NUM_ROWS * 2;
}
