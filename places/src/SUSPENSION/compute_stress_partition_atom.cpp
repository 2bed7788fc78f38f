/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "compute_stress_partition_atom.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_hydro.h"
#include "fix_pore_pressure.h"
#include "force.h"
#include "lubcontact_inertia.h"
#include "lubcontact_tally.h"
#include "memory.h"
#include "pair_lubcontact.h"
#include "particle_inertia.h"
#include "suspension_host.h"
#include "uncounted_forces.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

static constexpr int NUM_COMPONENTS = LubcontactTally::NUM_COMPONENTS;
using Lubcontact_NS::NUM_CHANNELS;
static constexpr int PORE = Lubcontact_NS::NUM_STRESS_ROWS, STRESSLET = PORE + 1,
                     NUM_ROWS = STRESSLET + 1;
static constexpr int COLUMNS = NUM_ROWS * NUM_COMPONENTS;    // one row after the other
static constexpr int OF_GHOSTS = PORE * NUM_COMPONENTS;      // columns that ghosts have a part of

/* ---------------------------------------------------------------------- */

ComputeStressPartitionAtom::ComputeStressPartitionAtom(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), nmax(0), pore(nullptr), hydro(nullptr)
{
  if (narg > 3)
    error->all(FLERR, 3, "Unknown compute stress/partition/atom argument: {}; it takes none",
               arg[3]);

  peratom_flag = 1;
  size_peratom_cols = COLUMNS;
  timeflag = 1;    // the pair style tallies in the steps announced for this compute
  comm_reverse = OF_GHOSTS;
}

/* ---------------------------------------------------------------------- */

ComputeStressPartitionAtom::~ComputeStressPartitionAtom()
{
  memory->destroy(array_atom);
}

/* ---------------------------------------------------------------------- */

void ComputeStressPartitionAtom::init()
{
  pairs = PairLubcontact::require(lmp, std::string("Compute ") + style);
  check_rows(lmp, this);
  pore = FixPorePressure::find(lmp);
  hydro = FixHydro::find(lmp);
}

/* ----------------------------------------------------------------------
   volume times Cauchy stress by origin, tension positive: what compute stress/partition sums up
------------------------------------------------------------------------- */

void ComputeStressPartitionAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;

  if (atom->nmax > nmax) {
    memory->destroy(array_atom);
    nmax = atom->nmax;
    memory->create(array_atom, nmax, COLUMNS, "stress/partition/atom:array");
  }
  collect_parts();

  const int massless = Suspension_NS::groups_without_inertia(lmp);
  const Lubcontact_NS::Vec3 drift = find_drift();
  const bool has_pores = pore && pore->acts();
  const std::vector<double> shares = has_pores ? pore->pressure_shares() : std::vector<double>();
  std::vector<std::array<double, NUM_COMPONENTS>> stresslets;
  if (hydro) stresslets = hydro->stresslets();
  for (int i = 0; i < atom->nlocal; i++) {
    double *parts = array_atom[i];
    double *inertial = parts + Lubcontact_NS::INERTIA_ROW * NUM_COMPONENTS;
    if (!(atom->mask[i] & groupbit)) {
      std::fill_n(parts, COLUMNS, 0.0);
      continue;
    }
    if (!(atom->mask[i] & massless)) {
      const double m = force->mvv2e * (atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]]);
      const Lubcontact_NS::Vec3 v = Suspension_NS::relative_velocity(lmp, i) - drift;
      const double xy = m * v.x * v.y, xz = m * v.x * v.z, yz = m * v.y * v.z;
      const double product[] = {
          m * v.x * v.x, m * v.y * v.y, m * v.z * v.z, xy, xz, yz, xy, xz, yz};
      for (int n = 0; n < NUM_COMPONENTS; n++) inertial[n] += product[n];
    }
    if (has_pores)
      for (int d = 0; d < 3; d++) parts[PORE * NUM_COMPONENTS + d] = shares[i];
    if (hydro)
      std::copy_n(stresslets[i].data(), NUM_COMPONENTS, parts + STRESSLET * NUM_COMPONENTS);
    for (int n = 0; n < COLUMNS; n++) parts[n] *= -force->nktv2p;
  }
}

/* ----------------------------------------------------------------------
   common velocity of all particles with inertia, in the group or not
------------------------------------------------------------------------- */

Lubcontact_NS::Vec3 ComputeStressPartitionAtom::find_drift() const
{
  const Lubcontact_NS::Inertia mine = Suspension_NS::measure_inertia(lmp);
  Lubcontact_NS::Inertia all;
  MPI_Allreduce(mine.sum, all.sum, Lubcontact_NS::Inertia::SIZE, MPI_DOUBLE, MPI_SUM, world);
  return all.drift();
}

/* ----------------------------------------------------------------------
   sum of r_a F_b by origin of the owned atoms: their own tally, and that of their ghosts
------------------------------------------------------------------------- */

void ComputeStressPartitionAtom::collect_parts()
{
  const int nall = atom->nlocal + atom->nghost;
  for (int i = 0; i < nall; i++) std::fill_n(array_atom[i], COLUMNS, 0.0);
  for (const auto &pair : pairs) {
    if (!pair->tally().has_atoms())
      error->all(FLERR,
                 "Stress by origin per atom was not tallied in step {}: use compute "
                 "stress/partition/atom where its steps are known in advance (thermo output, "
                 "fix ave/*, dumps, and variables they evaluate)",
                 update->ntimestep);
    for (int i = 0; i < nall; i++)
      for (int m = 0; m < NUM_CHANNELS; m++) {
        const auto &part = pair->tally().stress_of_atom(i)[m];
        double *sum = array_atom[i] + Lubcontact_NS::stress_row(m) * NUM_COMPONENTS;
        for (int n = 0; n < NUM_COMPONENTS; n++) sum[n] += part[n];
      }
  }
  if (force->newton_pair) comm->reverse_comm(this);
}

/* ---------------------------------------------------------------------- */

int ComputeStressPartitionAtom::pack_reverse_comm(int n, int first, double *buf)
{
  for (int i = first; i < first + n; i++) buf = std::copy_n(array_atom[i], OF_GHOSTS, buf);
  return n * OF_GHOSTS;
}

void ComputeStressPartitionAtom::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int i = 0; i < n; i++)
    for (int m = 0; m < OF_GHOSTS; m++) array_atom[list[i]][m] += *buf++;
}

/* ---------------------------------------------------------------------- */

double ComputeStressPartitionAtom::memory_usage()
{
  return sizeof(double) * nmax * COLUMNS;
}
