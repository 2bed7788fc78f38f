/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "compute_stress_partition.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_hydro.h"
#include "fix_pore_pressure.h"
#include "force.h"
#include "lubcontact_inertia.h"
#include "lubcontact_tally.h"
#include "memory.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "particle_inertia.h"
#include "suspension_host.h"
#include "uncounted_forces.h"
#include "update.h"

using namespace LAMMPS_NS;

using Lubcontact_NS::NUM_CHANNELS;
static constexpr int PORE = Lubcontact_NS::NUM_STRESS_ROWS, STRESSLET = PORE + 1,
                     NUM_ROWS = STRESSLET + 1;
static constexpr int NUM_COMPONENTS = LubcontactTally::NUM_COMPONENTS;

/* ---------------------------------------------------------------------- */

ComputeStressPartition::ComputeStressPartition(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), pore(nullptr), hydro(nullptr)
{
  if (narg > 3)
    error->all(FLERR, 3, "Unknown compute stress/partition argument: {}; it takes none", arg[3]);
  if (igroup)
    error->all(FLERR, 1,
               "Compute stress/partition applies to the whole cell: use group all instead of {}",
               arg[1]);

  array_flag = 1;
  size_array_rows = NUM_ROWS;
  size_array_cols = NUM_COMPONENTS;
  extarray = 0;
  timeflag = 1;    // the pair style tallies in the steps announced for this compute
  memory->create(array, size_array_rows, size_array_cols, "stress/partition:array");
}

/* ---------------------------------------------------------------------- */

ComputeStressPartition::~ComputeStressPartition()
{
  memory->destroy(array);
}

/* ---------------------------------------------------------------------- */

void ComputeStressPartition::init()
{
  pairs = PairLubcontact::require(lmp, std::string("Compute ") + style);
  check_rows(lmp, this);
  pore = FixPorePressure::find(lmp);
  hydro = FixHydro::find(lmp);
}

/* ----------------------------------------------------------------------
   Cauchy stress by origin, tension positive: -(1/V) sum r_a F_b, and -(1/V) sum m v'_a v'_b
------------------------------------------------------------------------- */

void ComputeStressPartition::compute_array()
{
  invoked_array = update->ntimestep;

  // forces, and behind them what inertia needs: one reduction for both
  struct Sums {
    double row[NUM_ROWS][NUM_COMPONENTS] = {};
    Lubcontact_NS::Inertia inertia;
  } mine, all;
  static_assert(sizeof(Sums) % sizeof(double) == 0, "doubles only");
  for (const auto &pair : pairs) {
    if (!pair->tally().has_stress())
      error->all(FLERR,
                 "Stress by origin was not tallied in step {}: use compute stress/partition where "
                 "its steps are known in advance (thermo output, fix ave/*, dumps, and variables "
                 "they evaluate)",
                 update->ntimestep);
    for (int m = 0; m < NUM_CHANNELS; m++)
      for (int n = 0; n < NUM_COMPONENTS; n++)
        mine.row[Lubcontact_NS::stress_row(m)][n] += pair->tally().stress()[m][n];
  }
  if (hydro) hydro->add_stresslets(mine.row[STRESSLET]);
  mine.inertia = Suspension_NS::measure_inertia(lmp);
  MPI_Allreduce(mine.row[0], all.row[0], sizeof(Sums) / sizeof(double), MPI_DOUBLE, MPI_SUM, world);

  const Lubcontact_NS::Fluctuation f = Lubcontact_NS::fluctuation(all.inertia);
  const double inertial[NUM_COMPONENTS] = {f.xx, f.yy, f.zz, f.xy, f.xz, f.yz, f.xy, f.xz, f.yz};
  for (int n = 0; n < NUM_COMPONENTS; n++)
    all.row[Lubcontact_NS::INERTIA_ROW][n] = force->mvv2e * inertial[n];

  const double volume = Suspension_NS::cell_volume(domain);
  for (int m = 0; m < NUM_ROWS; m++)
    for (int n = 0; n < NUM_COMPONENTS; n++) array[m][n] = -force->nktv2p / volume * all.row[m][n];
  // the fluid between the particles: the same on all ranks
  if (pore && pore->acts())
    for (int d = 0; d < 3; d++) array[PORE][d] = -force->nktv2p / volume * pore->pressure_volume();
}

/* ---------------------------------------------------------------------- */

double ComputeStressPartition::memory_usage()
{
  return sizeof(double) * NUM_ROWS * NUM_COMPONENTS;
}
