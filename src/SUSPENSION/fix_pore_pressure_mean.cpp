/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The mean pressure of a periodic cell, which its grid does not know.

#include "fix_pore_pressure.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_pore_pressure_settings.h"
#include "force.h"
#include "modify.h"
#include "suspension_host.h"

#include <cmath>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   the pressure of a layer is that of the dilation, which only this fix makes
------------------------------------------------------------------------- */

void FixPorePressure::find_flow()
{
  dilation = nullptr;
  if (settings->mean != PoreSettings::LAYER) return;
  int dimension;
  for (const auto &flow : modify->get_fix_by_style("^deform/rheometer"))
    dilation = static_cast<const double *>(flow->extract("dilation", dimension));
  if (!dilation)
    error->all(FLERR,
               "Fix pore/pressure mean layer follows the dilation of a fix deform/rheometer, but "
               "there is none: add one, or use mean drained or undrained");
}

/* ----------------------------------------------------------------------
   the mean pressure of a periodic cell answers to the change of its volume; one that is known is
   that of this moment
------------------------------------------------------------------------- */

double FixPorePressure::next_mean(double storage, bool is_known)
{
  if (settings->mean == PoreSettings::DRAINED) {
    mean.pressure = 0.0;
  } else if (settings->mean == PoreSettings::UNDRAINED) {
    const double now = Suspension_NS::cell_volume(domain);
    if (mean.cell > 0.0) mean.pressure -= std::log1p((now - mean.cell) / mean.cell) / storage;
    mean.cell = now;
  } else if (!is_known) {
    mean.pressure = -layer_resistance() * *dilation;
  }
  if (settings->mean != PoreSettings::UNDRAINED) mean.cell = 0.0;
  return mean.pressure;
}

/* ----------------------------------------------------------------------
   force*time/area. The permeability is that at the volume of all particles over that of the cell,
   with their Sauter radius: of an even layer, not a mean over the elements of the grid. Sums stay
   as they were if they differ by rounding.
------------------------------------------------------------------------- */

double FixPorePressure::layer_resistance()
{
  double mine[2] = {}, all[2];
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) {
      const double r = atom->radius[i];
      mine[0] += Suspension_NS::particle_volume(domain, r);
      mine[1] += r * r;
    }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  using Suspension_NS::is_same_sum;
  if (!is_same_sum(mean.volume, all[0]) || !is_same_sum(mean.squares, all[1])) {
    mean.volume = all[0];
    mean.squares = all[1];
  }
  const double *of_pair = settings->viscosity_of_pair ? Suspension_NS::viscosity_of_pair(lmp)
                                                      : &settings->viscosity.value;
  const double phi = mean.volume / Suspension_NS::cell_volume(domain);
  const double k =
      Pore_NS::permeability(settings->law, phi, Pore_NS::sauter_radius(mean.volume, mean.squares));
  return Pore_NS::layer_drainage(*of_pair, settings->layer, k);
}

double FixPorePressure::drainage()
{
  if (settings->mean != PoreSettings::LAYER || !acts()) return 0.0;
  return force->nktv2p * layer_resistance();
}

/* ---------------------------------------------------------------------- */

std::vector<double> FixPorePressure::pressure_shares() const
{
  return field->pressure_shares();
}
