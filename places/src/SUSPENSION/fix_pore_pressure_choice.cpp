/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Which solver fix pore/pressure has, and what that one cannot do.

#include "fix_pore_pressure.h"

#include "domain.h"
#include "error.h"
#include "fix_pore_pressure_field.h"
#include "fix_pore_pressure_network.h"
#include "fix_pore_pressure_settings.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   who holds the pressure, and what that one does not know
------------------------------------------------------------------------- */

void FixPorePressure::make_solver(const std::map<std::string, int> &given)
{
  if (!settings->network) {
    if (!settings->even && !PoreField::has_library())
      error->all(FLERR, 2, "Fix pore/pressure {}", PoreField::NO_LIBRARY);
    if (given.count("alpha"))
      error->all(
          FLERR, given.at("alpha"),
          "Fix pore/pressure alpha is that of a network: it cannot act on a grid; remove alpha "
          "or use solver network");
    field = std::make_unique<PoreField>(lmp);
    return;
  }
  if (!RadicalTessellation::has_library())
    error->all(FLERR, 2, "Fix pore/pressure solver network {}", PoreNetwork::NO_LIBRARY);
  for (const char *key : {"spacing", "grid", "permeability", "phi_min", "every"})
    if (given.count(key))
      error->all(
          FLERR, given.at(key),
          "Fix pore/pressure {} is that of a grid: it cannot act on a network, which has its "
          "permeability from its pores; remove it or use solver grid",
          key);
  if (given.count("plates") && given.count("gradient"))
    error->all(
        FLERR, given.at("gradient"),
        "Fix pore/pressure solver network has no mean gradient between plates: use solver grid "
        "or cg");
  if (domain->dimension == 2)
    error->all(FLERR, given.at("solver"),
               "Fix pore/pressure solver network has no pores between discs; use solver grid with "
               "permeability constant k");
  field = std::make_unique<PoreNetwork>(lmp);
}

/* ----------------------------------------------------------------------
   solver mean: a layer that dilates evenly has no pressure in space
------------------------------------------------------------------------- */

void FixPorePressure::check_even(const std::map<std::string, int> &given) const
{
  for (const char *key : {"spacing", "grid", "tolerance", "pressure", "gradient", "every"})
    if (given.count(key))
      error->all(FLERR, given.at(key),
                 "Fix pore/pressure solver mean has no pressure in space: {} cannot act; remove it",
                 key);
  if (given.count("storage") && settings->mean != PoreSettings::UNDRAINED)
    error->all(FLERR, given.at("storage"),
               "Fix pore/pressure solver mean follows the motion at once: storage cannot act; "
               "remove it, or use a cell with mean undrained");
  if (settings->coupling == PoreSolver::Coupling::EXPLICIT)
    error->all(
        FLERR, given.at("coupling"),
        "Fix pore/pressure solver mean is a dashpot, which has no explicit form: use coupling "
        "implicit");
  if (settings->plates.empty() && settings->mean == PoreSettings::DRAINED)
    error->all(
        FLERR, given.at("solver"),
        "Fix pore/pressure solver mean has nothing to do in a cell that is drained: add mean "
        "layer H, or mean undrained with a storage");
}
