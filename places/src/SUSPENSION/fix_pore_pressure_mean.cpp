/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The mean pressure: of a periodic cell, whose grid does not know it, and of an even layer, which
// has no grid.

#include "fix_pore_pressure.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_pore_pressure_settings.h"
#include "fix_rheometer_plates.h"
#include "force.h"
#include "modify.h"
#include "pore_layer.h"
#include "suspension_host.h"
#include "update.h"

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

/* ---------------------------------------------------------------------- */

double FixPorePressure::evaluate()
{
  evaluated = true;
  PoreSettings &s = *settings;
  bool variables = false;
  for (const auto *number : s.numbers())
    if (!number->is_number()) variables = true;
  if (variables) modify->clearstep_compute();
  for (auto *number : s.numbers()) number->evaluate(lmp);
  if (variables) modify->addstep_compute(update->ntimestep + 1);
  const double *of_pair = s.viscosity_of_pair ? Suspension_NS::viscosity_of_pair(lmp)
                                              : &s.viscosity.value;
  if (!of_pair || !(*of_pair > 0.0))
    error->all(FLERR, "Fix pore/pressure viscosity must be > 0, but is {} at step {}",
               of_pair ? *of_pair : 0.0, update->ntimestep);
  return *of_pair;
}

/* ----------------------------------------------------------------------
   the mean pressure of a periodic cell answers to the change of its volume, which works against it;
   one that is known is that of this moment
------------------------------------------------------------------------- */

double FixPorePressure::next_mean(double storage, bool is_known)
{
  const double before = mean.pressure;
  if (settings->mean == PoreSettings::DRAINED) {
    mean.pressure = 0.0;
  } else if (settings->mean == PoreSettings::UNDRAINED) {
    const double now = Suspension_NS::cell_volume(domain);
    if (mean.cell > 0.0) mean.pressure -= std::log1p((now - mean.cell) / mean.cell) / storage;
    mean.cell = now;
  } else {
    resistance = layer_resistance();
    if (!is_known) mean.pressure = -resistance * *dilation;
  }
  if (settings->mean != PoreSettings::UNDRAINED) mean.cell = 0.0;
  // that of a layer belongs to the dilation of the whole step
  const bool is_stored = settings->mean == PoreSettings::UNDRAINED;
  const double of_step = is_stored ? 0.5 * (before + mean.pressure) : mean.pressure;
  const auto l = Suspension_NS::cell_gradient(domain);
  of_cell = -of_step * (l.xx + l.yy + l.zz) * Suspension_NS::cell_volume(domain);
  return mean.pressure;
}

/* ----------------------------------------------------------------------
   force*time/area. The permeability is that at the volume of all particles over that of the cell or
   the gap, with their Sauter radius: of an even layer, not a mean over the elements of the grid.
   Sums stay as they were if they differ by rounding.
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
  even_k = Pore_NS::permeability(settings->law, mean.volume / volume(),
                                 Pore_NS::sauter_radius(mean.volume, mean.squares));
  return plates ? Pore_NS::layer_drainage(*of_pair, gap(), even_k, settings->lower, settings->upper)
                : Pore_NS::layer_drainage(*of_pair, settings->layer, even_k);
}

double FixPorePressure::drainage()
{
  if (settings->mean != PoreSettings::LAYER || !acts()) return 0.0;
  return force->nktv2p * layer_resistance();
}

/* ---------------------------------------------------------------------- */

double FixPorePressure::gap() const
{
  if (plates->gap() > 0.0) return plates->gap();
  double bottom, top;    // before the first step
  plates->measure_surfaces(bottom, top);
  return top - bottom;
}

double FixPorePressure::volume() const
{
  const double cell = Suspension_NS::cell_volume(domain);
  return plates ? cell / domain->yprd * gap() : cell;
}

double FixPorePressure::dilation_of_gap() const
{
  return plates ? plates->opening() / gap() : 0.0;
}

double FixPorePressure::mean_of_layer() const
{
  return plates ? -resistance * dilation_of_gap() : mean.pressure;
}

double FixPorePressure::layer_heat() const
{
  const bool has_layer = plates ? settings->even : settings->mean == PoreSettings::LAYER;
  const double p = mean_of_layer();
  return has_layer && resistance > 0.0 ? p * p / resistance : 0.0;
}

/* ----------------------------------------------------------------------
   solver mean: a dashpot of the plates or the cell, which pushes no particle
------------------------------------------------------------------------- */

void FixPorePressure::follow_layer(bool is_setup)
{
  evaluate();
  if (plates) {
    resistance = layer_resistance();
    if (acts()) plates->drain(resistance);
    const double heat = layer_heat() * volume();
    work = comm->me == 0 ? -heat : 0.0;
  } else {
    next_mean(settings->storage * force->nktv2p, is_setup && mean.volume > 0.0);
  }
}

double FixPorePressure::layer_output(int n)
{
  const double unit = force->nktv2p, p = unit * mean_of_layer(), e = dilation_of_gap();
  const Pore_NS::Wall lower = settings->lower, upper = settings->upper;
  switch (n) {
    case Output::LOWER:
      return plates ? Pore_NS::layer_pressure(lower) * p : p;
    case Output::UPPER:
      return plates ? Pore_NS::layer_pressure(upper) * p : p;
    case Output::MEAN:
      return p;
    case Output::LARGEST:
      return plates ? Pore_NS::LAYER_PEAK * fabs(p) : fabs(p);
    case Output::LOWER_FLUX:
      return plates ? Pore_NS::layer_flux(lower, upper, gap(), e) : 0.0;
    case Output::UPPER_FLUX:
      return plates ? Pore_NS::layer_flux(upper, lower, gap(), e) : 0.0;
    case Output::DISSIPATION:
      return layer_heat() * unit;
    case Output::K_MIN:
    case Output::K_MAX:
      return even_k;
    case Output::POWER:
      return acts() ? mean_power() : 0.0;
    default:
      return 0.0;
  }
}

/* ----------------------------------------------------------------------
   one layer: all of it
------------------------------------------------------------------------- */

double FixPorePressure::layer_profile(int j) const
{
  const double height = plates ? gap() : domain->yprd, e = dilation_of_gap();
  double bottom = domain->boxlo[1], top;
  if (plates) plates->measure_surfaces(bottom, top);
  switch (j) {
    case Output::Y:
      return bottom + 0.5 * height;
    case Output::PRESSURE:
      return force->nktv2p * mean_of_layer();
    case Output::PHI:
      return mean.volume / volume();
    case Output::U_Y:
      return 0.5 * e * height;
    default:    // mean of -(k/eta) dp/dy
      return plates ? 0.5 *
              (Pore_NS::layer_flux(settings->upper, settings->lower, height, e) -
               Pore_NS::layer_flux(settings->lower, settings->upper, height, e))
                    : 0.0;
  }
}

/* ---------------------------------------------------------------------- */

double FixPorePressure::pressure_volume() const
{
  return settings->even ? mean_of_layer() * volume() : field->report().mean * field->volume();
}

std::vector<double> FixPorePressure::pressure_shares() const
{
  if (!settings->even) return field->pressure_shares();
  std::vector<double> shares(atom->nlocal, 0.0);
  const double per_volume = pressure_volume() / mean.volume;    // of particles
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      shares[i] = per_volume * Suspension_NS::particle_volume(domain, atom->radius[i]);
  return shares;
}

double FixPorePressure::mean_power()
{
  double all;
  MPI_Allreduce(&work, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return of_cell - all;
}
