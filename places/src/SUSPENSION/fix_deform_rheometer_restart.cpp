/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_deform_rheometer.h"

#include "atom.h"
#include "comm.h"
#include "deform_judge.h"
#include "deform_stress.h"
#include "deform_targets.h"
#include "error.h"
#include "list_keeper.h"
#include "memory.h"
#include "restart_seal.h"
#include "rheometer_flow.h"

#include <cstring>

using namespace LAMMPS_NS;

namespace {

// what a restart file holds
struct Saved {
  double flow = 0.0, fresh = 0.0;
  DeformTargets::Saved targets;
  Rheometer_NS::CellMotion motion;
  DeformStress::Particles particles;
  DeformJudge::Watches watches;
  Rheometer_NS::StrainMeans means;
};

}    // namespace

static constexpr int PERATOM_RESTART = 4;    // this size, position

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::write_restart(FILE *fp)
{
  if (comm->me) return;
  Saved now;
  now.flow = flow;
  now.fresh = fresh;
  now.targets = targets->saved();
  now.motion = *motion;
  now.particles = stress->particles();
  now.watches = judge->watches();
  now.means = stress->means();
  Suspension_NS::write_sealed(fp, now);
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::restart(char *buffer)
{
  Saved from{};
  if (const char *wrong = Suspension_NS::read_sealed(buffer, from))
    error->all(FLERR, "The part of fix {} in the restart file {}", style, wrong);
  if (from.flow != flow)
    error->all(FLERR,
               "Fix {} cannot continue from a restart file that was written with a different flow",
               style);
  *motion = from.motion;
  stress->set_particles(from.particles);

  // other targets than in the run that wrote the file begin at once, as after fix_modify
  const bool others = targets->differ_from(from.targets);
  fresh = others || from.fresh != 0.0;
  if (targets->turned_from(from.targets)) motion->time = 0.0;
  if (others) return;
  stress->set_means(from.means);
  judge->set_watches(from.watches);
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::grow_arrays(int nmax)
{
  memory->grow(held, nmax, 3, "deform/rheometer:held");
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::copy_arrays(int i, int j, int /*delflag*/)
{
  memcpy(held[j], held[i], 3 * sizeof(double));
}

/* ---------------------------------------------------------------------- */

int FixDeformRheometer::pack_exchange(int i, double *buf)
{
  memcpy(buf, held[i], 3 * sizeof(double));
  return 3;
}

/* ---------------------------------------------------------------------- */

int FixDeformRheometer::unpack_exchange(int nlocal, double *buf)
{
  memcpy(held[nlocal], buf, 3 * sizeof(double));
  return 3;
}

/* ---------------------------------------------------------------------- */

int FixDeformRheometer::pack_restart(int i, double *buf)
{
  buf[0] = PERATOM_RESTART;
  memcpy(buf + 1, atom->x[i], 3 * sizeof(double));
  return PERATOM_RESTART;
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::unpack_restart(int nlocal, int nth)
{
  const double *extra = Suspension_NS::part_of_atom(atom->extra[nlocal], nth, atom->nextra_store);
  if (!extra)
    error->one(FLERR, "The data of atom {} in the restart file are damaged: use another one",
               atom->tag[nlocal]);
  memcpy(held[nlocal], extra + 1, 3 * sizeof(double));
  from_restart = true;
}

/* ---------------------------------------------------------------------- */

int FixDeformRheometer::size_restart(int /*nlocal*/)
{
  return PERATOM_RESTART;
}

/* ---------------------------------------------------------------------- */

int FixDeformRheometer::maxsize_restart()
{
  return PERATOM_RESTART;
}

/* ---------------------------------------------------------------------- */

double FixDeformRheometer::memory_usage()
{
  return FixDeform::memory_usage() + 3.0 * atom->nmax * sizeof(double) + keeper->memory_usage();
}
