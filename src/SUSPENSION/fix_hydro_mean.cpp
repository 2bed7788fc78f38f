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
}

void HydroMean::set_up()
{
  fluid->setup();
}

void HydroMean::new_step()
{
  fluid->new_step();
}

HydroLevel::Pull HydroMean::pull(int i) const
{
  const Fluid_NS::Flow flow = fluid->flow_at(i);
  return {fluid->drag(i), flow, flow};
}

void HydroMean::stresslet(int i, const double *strain, double *five) const
{
  const double factor = Fluid_NS::straining(fluid->viscosity_now(), atom->radius[i]);
  for (int k = 0; k < 5; k++) five[k] = factor * strain[k];
}

double HydroMean::phi()
{
  const double mine = volume_of_group();
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all / Suspension_NS::cell_volume(domain);
}
