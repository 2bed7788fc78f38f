/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "exclusive_particles.h"

#include "atom.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

static constexpr int ALL = 1;    // bit of group all

/* ---------------------------------------------------------------------- */

void ExclusiveParticles::start(int bits)
{
  mine = bits;
  others = 0;
  rules.clear();
}

/* ---------------------------------------------------------------------- */

bigint ExclusiveParticles::count(int bits) const
{
  bigint found = 0, all;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & mine) && (atom->mask[i] & bits)) found++;
  MPI_Allreduce(&found, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

/* ----------------------------------------------------------------------
   fix pour and fix deposit put what they insert into the group all and their own
------------------------------------------------------------------------- */

void ExclusiveParticles::forbid(int bits, const Complaint &complaint)
{
  const bigint found = count(bits);
  if (found) error->all(FLERR, complaint(fmt::format("{} particles", found)));
  for (const char *inserts : {"^pour", "^deposit"})
    for (const auto &fix : modify->get_fix_by_style(inserts)) {
      const int mask = ALL | fix->groupbit;
      if ((mask & mine) && (mask & bits))
        error->all(FLERR, complaint(fmt::format("particles inserted by fix {}", fix->id)));
    }
  others |= bits;
  rules.emplace_back(bits, complaint);
}

/* ---------------------------------------------------------------------- */

void ExclusiveParticles::stop(int mask) const
{
  for (const auto &rule : rules)
    if (mask & rule.first)
      error->one(FLERR, "{}; step {}", rule.second("a particle new in its group"),
                 update->ntimestep);
  error->one(FLERR, "A particle is in two groups that exclude each other");    // cannot be
}
