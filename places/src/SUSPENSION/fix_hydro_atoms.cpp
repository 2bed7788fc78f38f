/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix hydro keeps of particles: between ranks, in restart files, and for its level.

#include "fix_hydro.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_hydro_level.h"
#include "memory.h"
#include "restart_seal.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void FixHydro::write_restart(FILE *fp)
{
  if (comm->me == 0) level->write(fp);
}

void FixHydro::restart(char *buffer)
{
  const char *wrong = level->read(buffer);
  if (wrong) error->all(FLERR, "The part of fix hydro in the restart file {}", wrong);
}

/* ---------------------------------------------------------------------- */

void FixHydro::grow_arrays(int nmax)
{
  if (level->columns) memory->grow(level->held, nmax, level->columns, "hydro:held");
  memory->grow(force_of_atom, nmax, 6, "hydro:force");
  array_atom = force_of_atom;
}

void FixHydro::copy_arrays(int i, int j, int /*delflag*/)
{
  if (level->columns) std::copy_n(level->held[i], level->columns, level->held[j]);
  std::copy_n(force_of_atom[i], 6, force_of_atom[j]);
}

void FixHydro::set_arrays(int i)
{
  if (level->columns) std::fill_n(level->held[i], level->columns, 0.0);
  std::fill_n(force_of_atom[i], 6, 0.0);
}

int FixHydro::pack_exchange(int i, double *buf)
{
  const int n = level->columns;
  if (n) std::copy_n(level->held[i], n, buf);
  std::copy_n(force_of_atom[i], 6, buf + n);
  return n + 6;
}

int FixHydro::unpack_exchange(int nlocal, double *buf)
{
  const int n = level->columns;
  if (n) std::copy_n(buf, n, level->held[nlocal]);
  std::copy_n(buf + n, 6, force_of_atom[nlocal]);
  return n + 6;
}

/* ----------------------------------------------------------------------
   length, numbers, their seal; what another level wrote is of no use
------------------------------------------------------------------------- */

int FixHydro::pack_restart(int i, double *buf)
{
  const int n = level->columns;
  buf[0] = n + 2;
  std::copy_n(level->held[i], n, buf + 1);
  buf[n + 1] = Suspension_NS::seal(level->held[i], n * sizeof(double));
  return n + 2;
}

void FixHydro::unpack_restart(int i, int nth)
{
  std::fill_n(force_of_atom[i], 6, 0.0);
  const int n = level->columns;
  if (n == 0) return;
  const double *part = Suspension_NS::part_of_atom(atom->extra[i], nth, atom->nextra_store);
  if (!part || part[0] != n + 2 || part[n + 1] != Suspension_NS::seal(part + 1, n * sizeof(double)))
    error->one(FLERR,
               "What the restart file has of atom {} for fix hydro is damaged: use another "
               "one",
               atom->tag[i]);
  std::copy_n(part + 1, n, level->held[i]);
}

int FixHydro::size_restart(int /*i*/)
{
  return level->columns + 2;
}

int FixHydro::maxsize_restart()
{
  return level->columns + 2;
}

/* ---------------------------------------------------------------------- */

int FixHydro::pack_forward_comm(int n, int *list, double *buf, int /*pbc_flag*/, int * /*pbc*/)
{
  return level->pack_loads(n, list, buf);
}

void FixHydro::unpack_forward_comm(int n, int first, double *buf)
{
  level->unpack_loads(n, first, buf);
}

int FixHydro::pack_reverse_comm(int n, int first, double *buf)
{
  return level->pack_motions(n, first, buf);
}

void FixHydro::unpack_reverse_comm(int n, int *list, double *buf)
{
  level->unpack_motions(n, list, buf);
}
