/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix hydro keeps of particles: between ranks, in restart files, and for its field.

#include "fix_hydro.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_hydro_field.h"
#include "fix_hydro_held.h"
#include "memory.h"
#include "restart_seal.h"

#include <algorithm>

using namespace LAMMPS_NS;
using Hydro_NS::NUM_HELD;

/* ---------------------------------------------------------------------- */

void FixHydro::write_restart(FILE *fp)
{
  if (comm->me == 0) Suspension_NS::write_sealed(fp, state);
}

void FixHydro::restart(char *buffer)
{
  const char *wrong = Suspension_NS::read_sealed(buffer, state);
  if (wrong) error->all(FLERR, "The part of fix hydro in the restart file {}", wrong);
}

/* ---------------------------------------------------------------------- */

void FixHydro::grow_arrays(int nmax)
{
  memory->grow(held, nmax, NUM_HELD, "hydro:held");
  memory->grow(force_of_atom, nmax, 6, "hydro:force");
  array_atom = force_of_atom;
}

void FixHydro::copy_arrays(int i, int j, int /*delflag*/)
{
  std::copy_n(held[i], NUM_HELD, held[j]);
  std::copy_n(force_of_atom[i], 6, force_of_atom[j]);
}

void FixHydro::set_arrays(int i)
{
  std::fill_n(held[i], NUM_HELD, 0.0);
  std::fill_n(force_of_atom[i], 6, 0.0);
}

int FixHydro::pack_exchange(int i, double *buf)
{
  std::copy_n(held[i], NUM_HELD, buf);
  std::copy_n(force_of_atom[i], 6, buf + NUM_HELD);
  return NUM_HELD + 6;
}

int FixHydro::unpack_exchange(int nlocal, double *buf)
{
  std::copy_n(buf, NUM_HELD, held[nlocal]);
  std::copy_n(buf + NUM_HELD, 6, force_of_atom[nlocal]);
  return NUM_HELD + 6;
}

/* ----------------------------------------------------------------------
   length, numbers, their seal
------------------------------------------------------------------------- */

int FixHydro::pack_restart(int i, double *buf)
{
  buf[0] = NUM_HELD + 2;
  std::copy_n(held[i], NUM_HELD, buf + 1);
  buf[NUM_HELD + 1] = Suspension_NS::seal(held[i], NUM_HELD * sizeof(double));
  return NUM_HELD + 2;
}

void FixHydro::unpack_restart(int i, int nth)
{
  const double *part = Suspension_NS::part_of_atom(atom->extra[i], nth, atom->nextra_store);
  if (!part || part[0] != NUM_HELD + 2 ||
      part[NUM_HELD + 1] != Suspension_NS::seal(part + 1, NUM_HELD * sizeof(double)))
    error->one(FLERR,
               "What the restart file has of atom {} for fix hydro is damaged: use another "
               "one",
               atom->tag[i]);
  std::copy_n(part + 1, NUM_HELD, held[i]);
  std::fill_n(force_of_atom[i], 6, 0.0);
}

int FixHydro::size_restart(int /*i*/)
{
  return NUM_HELD + 2;
}

int FixHydro::maxsize_restart()
{
  return NUM_HELD + 2;
}

/* ---------------------------------------------------------------------- */

int FixHydro::pack_forward_comm(int n, int *list, double *buf, int /*pbc_flag*/, int * /*pbc*/)
{
  return field->pack_loads(n, list, buf);
}

void FixHydro::unpack_forward_comm(int n, int first, double *buf)
{
  field->unpack_loads(n, first, buf);
}

int FixHydro::pack_reverse_comm(int n, int first, double *buf)
{
  return field->pack_motions(n, first, buf);
}

void FixHydro::unpack_reverse_comm(int n, int *list, double *buf)
{
  field->unpack_motions(n, list, buf);
}
