/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix rheometer/plates checks at the start of a run.

#include "fix_rheometer_plates.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "exclusive_particles.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "plates_targets.h"
#include "rheometer_plate.h"
#include "suspension_host.h"
#include "update.h"

#include <cmath>
#include <vector>

using namespace LAMMPS_NS;
using Rheometer_NS::LOWER;
using Rheometer_NS::UPPER;

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::init()
{
  Suspension_NS::require_verlet(lmp, "Fix rheometer/plates");
  for (int plate : {LOWER, UPPER}) find_plate(plate, Error::NOPOINTER);
  check_cell();
  check_groups();
  for (int plate : {LOWER, UPPER}) check_exclusion(plate);
  targets->check();
  own->start(plate_bits());
  drainage = 0.0;    // who knows it says so before the first step
  if (update->whichflag != 1) return;
  exclude_integrators();
  set_velocities();
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::check_cell() const
{
  if (domain->yperiodic)
    error->all(FLERR,
               "Fix rheometer/plates: the plates would meet across the periodic boundary "
               "along y; use: boundary p m p");
  if (!domain->xperiodic || !domain->zperiodic)
    error->all(FLERR,
               "Fix rheometer/plates: plates must be periodic along x{}; use: boundary p m p",
               domain->dimension == 3 ? " and z" : "");
}

/* ---------------------------------------------------------------------- */

void FixRheometerPlates::check_groups() const
{
  enum { LOW, UP, BOTH, SUSPENDED, NUM };
  bigint mine[NUM] = {0, 0, 0, 0}, all[NUM];
  for (int i = 0; i < atom->nlocal; i++) {
    const bool low = atom->mask[i] & bit[LOWER], up = atom->mask[i] & bit[UPPER];
    if (low) mine[LOW]++;
    if (up) mine[UP]++;
    if (low && up) mine[BOTH]++;
    if ((low || up) && (atom->mask[i] & groupbit)) mine[SUSPENDED]++;
  }
  MPI_Allreduce(mine, all, NUM, MPI_LMP_BIGINT, MPI_SUM, world);
  for (int plate : {LOWER, UPPER})
    if (all[plate == LOWER ? LOW : UP] == 0)
      error->all(FLERR, "Fix rheometer/plates: group {} of the {} plate is empty",
                 group->names[igroup_plate[plate]], PLATE_NAME[plate]);
  if (all[BOTH])
    error->all(FLERR, "Fix rheometer/plates: {} particles are in both plates", all[BOTH]);
  if (all[SUSPENDED])
    error->all(FLERR,
               "Fix rheometer/plates: group {} contains {} particles of the plates; use the group "
               "of the particles between them, for example: group between subtract all {} {}",
               group->names[igroup], all[SUSPENDED], group->names[igroup_plate[LOWER]],
               group->names[igroup_plate[UPPER]]);
}

/* ----------------------------------------------------------------------
   nobody else moves the plates
------------------------------------------------------------------------- */

void FixRheometerPlates::exclude_integrators()
{
  for (const auto &other : modify->get_fix_list()) {
    if (other == this) continue;
    int moved = other->time_integrate ? other->groupbit : 0;
    const auto *cell = dynamic_cast<FixRheometerPlates *>(other);
    if (cell) moved = cell->plate_bits();
    if (!moved) continue;
    const std::string name = other->id, kind = other->style, between = group->names[igroup];
    own->forbid(moved, [name, kind, between](const std::string &who) {
      return fmt::format("Fix {0} {1} moves {2} of the plates, which are moved by fix "
                         "rheometer/plates; use group {3} for fix {0}",
                         name, kind, who, between);
    });
  }
}

/* ----------------------------------------------------------------------
   particles of one plate overlap and must not interact
------------------------------------------------------------------------- */

void FixRheometerPlates::check_exclusion(int plate) const
{
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & bit[plate]) mine++;
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all < 2 || excluded_by_group(plate) || excluded_by_type(plate)) return;
  const char *name = group->names[igroup_plate[plate]];
  error->all(FLERR,
             "Fix rheometer/plates: the particles of the {} plate interact with each other; add: "
             "neigh_modify exclude group {} {}",
             PLATE_NAME[plate], name, name);
}

/* ---------------------------------------------------------------------- */

bool FixRheometerPlates::excluded_by_group(int plate) const
{
  for (int m = 0; m < neighbor->nex_group; m++) {
    const int bit1 = group->bitmask[neighbor->ex1_group[m]];
    const int bit2 = group->bitmask[neighbor->ex2_group[m]];
    int mine = 1, all;
    for (int i = 0; i < atom->nlocal; i++) {
      const int mask = atom->mask[i];
      if ((mask & bit[plate]) && !((mask & bit1) && (mask & bit2))) mine = 0;
    }
    MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, world);
    if (all) return true;
  }
  return false;
}

/* ---------------------------------------------------------------------- */

bool FixRheometerPlates::excluded_by_type(int plate) const
{
  const int ntypes = atom->ntypes;
  std::vector<int> mine(ntypes + 1, 0), present(ntypes + 1);
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & bit[plate]) mine[atom->type[i]] = 1;
  MPI_Allreduce(mine.data(), present.data(), ntypes + 1, MPI_INT, MPI_MAX, world);
  auto excluded = [](const Neighbor *n, int itype, int jtype) {
    for (int m = 0; m < n->nex_type; m++)
      if ((n->ex1_type[m] == itype && n->ex2_type[m] == jtype) ||
          (n->ex1_type[m] == jtype && n->ex2_type[m] == itype))
        return true;
    return false;
  };
  for (int i = 1; i <= ntypes; i++)
    for (int j = i; j <= ntypes; j++)
      if (present[i] && present[j] && !excluded(neighbor, i, j)) return false;
  return true;
}

/* ----------------------------------------------------------------------
   a plate lighter than its particles is moved by their contacts faster than the particles are:
   each has two partners of the stiffest pair of types
------------------------------------------------------------------------- */

void FixRheometerPlates::check_time_step() const
{
  if ((targets->drive() != PlatesTargets::STRESS && targets->load() != PlatesTargets::LOAD) ||
      targets->mass() == 0.0 || !force->pair)
    return;
  int dim = -1;
  const auto *stiffness = static_cast<double **>(force->pair->extract("g", dim));
  if (!stiffness || dim != 2) return;
  double mine[2] = {0.0, 0.0}, stiffest, number;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & bit[UPPER])) continue;
    mine[0] += 1.0;
    for (int j = 1; j <= atom->ntypes; j++) mine[1] = MAX(mine[1], stiffness[atom->type[i]][j]);
  }
  MPI_Allreduce(&mine[0], &number, 1, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(&mine[1], &stiffest, 1, MPI_DOUBLE, MPI_MAX, world);
  const double limit = Rheometer_NS::plate_step_limit(moving_mass(), 2.0 * number * stiffest);
  if (update->dt > limit && comm->me == 0)
    error->warning(FLERR,
                   "Time step {} exceeds {:.4g}, where a plate of mass {:.6g} is unstable when all "
                   "of its particles are in contact: reduce it, or increase the mass",
                   update->dt, limit, targets->mass());
}
