/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */
#include "fix_hydro_mean.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "suspension_host.h"

using namespace LAMMPS_NS;

// values of each keyword
static const std::map<std::string, std::string> KEYWORDS = {{"viscosity", "eta|pair"},
                                                            {"isolated", "n"}};
static constexpr int FEW_PARTNERS = 3;

/* ----------------------------------------------------------------------
   fix ID group hydro mean keyword value ...
------------------------------------------------------------------------- */

HydroMean::HydroMean(LAMMPS *lmp, Fix *owner, int narg, char **arg) : HydroLevel(lmp, owner, 0)
{
  BackgroundFluid::Choice choice;
  choice.isolated = FEW_PARTNERS;
  parse(narg, arg, KEYWORDS, [&](int iarg) {
    if (arg[iarg] == std::string("viscosity")) return parse_viscosity(iarg, arg, choice);
    choice.isolated = utils::inumeric(FLERR, arg[iarg + 1], false, lmp);
    if (choice.isolated < 1)
      error->all(FLERR, iarg + 1, "Fix hydro isolated must be > 0, but is {}", arg[iarg + 1]);
    return 2;
  });
  fluid = std::make_unique<BackgroundFluid>(lmp, owner, choice);
}

void HydroMean::start()
{
  fluid->evaluate();
  find_strain(strain);
  rate = rate_before = find_rate();
}

void HydroMean::set_up()
{
  fluid->setup();
  find_dragged();
}

void HydroMean::new_step()
{
  fluid->new_step();
  find_strain(strain);
  rate_before = rate;
  rate = find_rate();
  find_dragged();
}

bool HydroMean::pull(int i, Pull &p) const
{
  p.drag = fluid->drag(i);
  if (p.drag.translation == 0.0) return false;
  p.flow = p.target = fluid->flow_at(i);
  return true;
}

void HydroMean::stresslet(int i, double *five) const
{
  const double factor = Fluid_NS::straining(fluid->viscosity_now(), atom->radius[i]);
  for (int k = 0; k < 5; k++) five[k] = factor * strain[k];
}

void HydroMean::sum_stresslets(double *five) const
{
  const double factor = Fluid_NS::straining(fluid->viscosity_now(), 1.0) * cubes();
  for (int k = 0; k < 5; k++) five[k] = factor * strain[k];
}

double HydroMean::find_rate() const
{
  double square = 0.0;
  for (const double e : strain) square += e * e;
  return -Fluid_NS::straining(fluid->viscosity_now(), 1.0) * square;
}

double HydroMean::cubes() const
{
  const int *mask = atom->mask, groupbit = fix->groupbit, number = atom->nlocal;
  const double *radius = atom->radius;
  double sum = 0.0;
  for (int i = 0; i < number; i++)
    if (mask[i] & groupbit) sum += radius[i] * radius[i] * radius[i];
  return sum;
}

double HydroMean::phi()
{
  const double mine = volume_of_group();
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all / Suspension_NS::cell_volume(domain);
}
