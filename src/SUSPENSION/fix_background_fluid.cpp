/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_background_fluid.h"

#include "background_fluid.h"
#include "comm.h"
#include "error.h"
#include "restart_seal.h"

#include <cstring>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   fix ID group style eta keyword value ...
------------------------------------------------------------------------- */

FixBackgroundFluid::FixBackgroundFluid(LAMMPS *lmp, int narg, char **arg, const char *elsewhere) :
    Fix(lmp, narg, arg), sums(), step_power(0.0)
{
  if (elsewhere && narg > 3 && strcmp(arg[3], elsewhere) == 0) {
    if (narg > 4)
      error->all(FLERR, 4, "Fix {} {} has its fluid elsewhere: {} cannot act; remove it", style,
                 elsewhere, arg[4]);
    BackgroundFluid::Choice choice;
    choice.elsewhere = true;
    choice.typed = elsewhere;
    fluid = std::make_unique<BackgroundFluid>(lmp, this, choice);
  } else {
    fluid = std::make_unique<BackgroundFluid>(lmp, this, narg, arg);
  }
  dynamic_group_allow = 1;
  restart_global = 1;
  vector_flag = 1;
  size_vector = NUM_COLUMNS;
  extvector = 0;
  global_freq = 1;
}

FixBackgroundFluid::~FixBackgroundFluid() = default;

/* ----------------------------------------------------------------------
   dissipated power, force, torque, number of particles that feel the drag, hindrance, and the
   dissipated power as the mean of the last step
------------------------------------------------------------------------- */

double FixBackgroundFluid::compute_vector(int n)
{
  if (n == HINDRANCE) return fluid->hindrance();
  const double mine = n == MEAN_POWER ? step_power : sums[n];
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixBackgroundFluid::write_restart(FILE *fp)
{
  if (comm->me == 0) Suspension_NS::write_sealed(fp, fluid->kept());
}

void FixBackgroundFluid::restart(char *buffer)
{
  double kept = 0.0;
  check_restart(Suspension_NS::read_sealed(buffer, kept));
  fluid->keep(kept);
}

void FixBackgroundFluid::check_restart(const char *wrong) const
{
  if (wrong) error->all(FLERR, "The part of fix {} in the restart file {}", style, wrong);
}

/* ---------------------------------------------------------------------- */

double FixBackgroundFluid::memory_usage()
{
  return fluid->memory_usage();
}
