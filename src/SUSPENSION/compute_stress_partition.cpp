/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "compute_stress_partition.h"

#include "atom.h"
#include "background_fluid.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "pair_lubcontact.h"
#include "update.h"

#include <cstring>

using namespace LAMMPS_NS;

static constexpr int NUM_PARTS = PairLubcontact::NUM_PARTS;
static constexpr int NUM_COMPONENTS = PairLubcontact::NUM_COMPONENTS;

/* ---------------------------------------------------------------------- */

ComputeStressPartition::ComputeStressPartition(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg)
{
  if (narg > 3)
    error->all(FLERR, 3, "Unknown compute stress/partition argument: {}; it takes none", arg[3]);
  if (igroup)
    error->all(FLERR, 1,
               "Compute stress/partition is of the whole cell: use group all instead of {}",
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
  pairs = find_pairs(lmp, style);
}

/* ----------------------------------------------------------------------
   the pair style, or every sub-style of its kind
------------------------------------------------------------------------- */

std::vector<PairLubcontact *> ComputeStressPartition::find_pairs(LAMMPS *lmp, const char *style)
{
  Force *force = lmp->force;
  std::vector<PairLubcontact *> found;
  if (Pair *only = force->pair_match("^lubcontact", 0)) {
    found.push_back(dynamic_cast<PairLubcontact *>(only));
  } else {    // several under hybrid
    for (int nsub = 1; Pair *pair = force->pair_match("^lubcontact", 0, nsub); nsub++)
      found.push_back(dynamic_cast<PairLubcontact *>(pair));
  }
  if (found.empty())
    lmp->error->all(FLERR,
                    "Compute {} splits the forces of pair_style lubcontact, which is not defined",
                    style);
  return found;
}

/* ----------------------------------------------------------------------
   Cauchy stress by origin, tension positive: -(1/V) sum r_a F_b, and -(1/V) sum m v'_a v'_b
------------------------------------------------------------------------- */

void ComputeStressPartition::compute_array()
{
  invoked_array = update->ntimestep;

  double mine[NUM_ROWS][NUM_COMPONENTS] = {};
  for (const auto &pair : pairs) {
    if (pair->partition_step != update->ntimestep)
      error->all(FLERR,
                 "Stress by origin was not tallied in step {}: use compute stress/partition where "
                 "its steps are known in advance (thermo, fix ave, dump, every-type variables)",
                 update->ntimestep);
    for (int m = 0; m < NUM_PARTS; m++)
      for (int n = 0; n < NUM_COMPONENTS; n++) mine[row_of(m)][n] += pair->partition[m][n];
  }
  add_all_inertial(lmp, mine[INERTIA]);

  double volume = domain->xprd * domain->yprd;
  if (domain->dimension == 3) volume *= domain->zprd;
  for (int m = 0; m < NUM_ROWS; m++)
    for (double &component : mine[m])
      component *= -force->nktv2p / volume * (m == INERTIA ? force->mvv2e : 1.0);
  MPI_Allreduce(mine, array[0], NUM_ROWS * NUM_COMPONENTS, MPI_DOUBLE, MPI_SUM, world);
}

/* ----------------------------------------------------------------------
   adds m v'_a v'_b of atom i, with v' relative to the velocity of the deforming cell
------------------------------------------------------------------------- */

void ComputeStressPartition::add_inertial(LAMMPS *lmp, int i, double *sum)
{
  const Atom *atom = lmp->atom;
  Domain *domain = lmp->domain;
  double v[3] = {atom->v[i][0], atom->v[i][1], atom->v[i][2]};
  if (domain->deform_flag) {
    const double *rate = domain->h_rate, *lo_rate = domain->h_ratelo;
    double lamda[3];
    domain->x2lamda(atom->x[i], lamda);
    v[0] -= rate[0] * lamda[0] + rate[5] * lamda[1] + rate[4] * lamda[2] + lo_rate[0];
    v[1] -= rate[1] * lamda[1] + rate[3] * lamda[2] + lo_rate[1];
    v[2] -= rate[2] * lamda[2] + lo_rate[2];
  }
  const double m = atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
  const double product[NUM_COMPONENTS] = {v[0] * v[0], v[1] * v[1], v[2] * v[2],
                                          v[0] * v[1], v[0] * v[2], v[1] * v[2],
                                          v[1] * v[0], v[2] * v[0], v[2] * v[1]};
  for (int n = 0; n < NUM_COMPONENTS; n++) sum[n] += m * product[n];
}

/* ----------------------------------------------------------------------
   the same of all atoms of this rank but those of fix overdamped/sphere, which have no inertia
------------------------------------------------------------------------- */

void ComputeStressPartition::add_all_inertial(LAMMPS *lmp, double *sum)
{
  const int massless = overdamped_groups(lmp);
  for (int i = 0; i < lmp->atom->nlocal; i++)
    if (!(lmp->atom->mask[i] & massless)) add_inertial(lmp, i, sum);
}

/* ---------------------------------------------------------------------- */

double ComputeStressPartition::memory_usage()
{
  return sizeof(double) * NUM_ROWS * NUM_COMPONENTS;
}
