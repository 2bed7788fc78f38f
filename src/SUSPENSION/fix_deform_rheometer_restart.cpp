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
#include "error.h"
#include "list_keeper.h"
#include "memory.h"
#include "restart_seal.h"
#include "rheometer_flow.h"
#include "rheometer_mean.h"
#include "rheometer_servo.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

// clang-format off
enum { SIZE, FLOW, DRIVE, DRIVEN, AMPLITUDE, FREQUENCY, CONFINEMENT, PRESSED, FRESH,
       STRAIN, PATH, TIME, NOW_RATE, NOW_DILATION, XX, YY, ZZ, XY, LX, LY, LZ, TILT, MOVED,
       P_MEAN, P_AGE, S_MEAN, S_AGE, R_MEAN, R_AGE, PARTICLES };
// clang-format on
static constexpr int MEANS = PARTICLES + 4;
static constexpr int SEAL = MEANS + sizeof(Rheometer_NS::StrainMeans) / sizeof(double);
static constexpr int RESTART_SIZE = SEAL + 1;
static constexpr int PERATOM_RESTART = 4;    // this size, position

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::write_restart(FILE *fp)
{
  if (comm->me) return;
  double buf[RESTART_SIZE] = {RESTART_SIZE,
                              static_cast<double>(flow),
                              static_cast<double>(drive),
                              driven.value,
                              amplitude.value,
                              frequency.value,
                              static_cast<double>(confinement),
                              pressure.value,
                              static_cast<double>(fresh),
                              strain,
                              path,
                              time,
                              rate,
                              dilation,
                              gradient->xx,
                              gradient->yy,
                              gradient->zz,
                              gradient->xy,
                              cell_rate->lx,
                              cell_rate->ly,
                              cell_rate->lz,
                              cell_rate->xy,
                              moved,
                              watch_pressure->deviation,
                              watch_pressure->age,
                              watch_stress->deviation,
                              watch_stress->age,
                              watch_rate->deviation,
                              watch_rate->age,
                              particles[0],
                              particles[1],
                              particles[2],
                              particles[3]};
  memcpy(buf + MEANS, averages.get(), sizeof(*averages));
  buf[SEAL] = Suspension_NS::seal(buf, SEAL * sizeof(double));
  const int size = sizeof(buf);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(buf, 1, size, fp);
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::restart(char *buf)
{
  double from[RESTART_SIZE];
  memcpy(from, buf, sizeof(double));
  if (from[SIZE] != RESTART_SIZE)
    error->all(FLERR, "Fix {} cannot read the restart file of another version of it", style);
  memcpy(from, buf, sizeof(from));
  if (Suspension_NS::seal(from, SEAL * sizeof(double)) != from[SEAL])
    error->all(FLERR, "The part of fix {} in the restart file is damaged: use another one", style);
  if (from[FLOW] != flow)
    error->all(FLERR, "Fix {} cannot go on from a restart file with another flow", style);
  strain = from[STRAIN];
  path = from[PATH];
  time = from[TIME];
  rate = from[NOW_RATE];
  dilation = from[NOW_DILATION];
  *gradient = {from[XX], from[YY], from[ZZ], from[XY]};
  *cell_rate = {from[LX], from[LY], from[LZ], from[TILT]};
  moved = from[MOVED];

  // other targets than in the run that wrote the file begin at once, as after fix_modify
  const bool other_wave = (frequency.is_number() && frequency.value != from[FREQUENCY]) ||
      (amplitude.is_number() && amplitude.value != from[AMPLITUDE]);
  const bool turned = drive != from[DRIVE] || (drive == OSCILLATE && other_wave);
  const bool moved_target = turned || confinement != from[CONFINEMENT] ||
      (driven.is_number() && driven.value != from[DRIVEN]) ||
      (pressure.is_number() && pressure.value != from[PRESSED]);
  fresh = moved_target || from[FRESH] != 0.0;
  if (turned) time = 0.0;
  if (!moved_target) {
    memcpy(static_cast<void *>(averages.get()), from + MEANS, sizeof(*averages));
    *watch_pressure = {from[P_MEAN], from[P_AGE]};
    *watch_stress = {from[S_MEAN], from[S_AGE]};
    *watch_rate = {from[R_MEAN], from[R_AGE]};
  }
  std::copy_n(from + PARTICLES, 4, particles);
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
