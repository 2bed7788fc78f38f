/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_hydro_grid.h"

#include "atom.h"
#include "error.h"
#include "fix.h"
#include "fix_hydro_held.h"
#include "fix_hydro_precondition.h"
#include "fix_hydro_settings.h"
#include "hydro_hold.h"
#include "restart_seal.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using Hydro_NS::HOLD;
using Hydro_NS::LOAD;
using Hydro_NS::MOTION;
using Hydro_NS::NUM_HELD;
using Lubcontact_NS::get_vector;

static constexpr double FIRST = 0.1;    // tolerance of the first solution, over that of the others

/* ---------------------------------------------------------------------- */

HydroGrid::HydroGrid(LAMMPS *lmp, Fix *owner, int narg, char **arg) :
    HydroLevel(lmp, owner, NUM_HELD), settings(new HydroSettings()),
    field(new HydroField(lmp, owner)), preconditioner(new HydroPreconditioner(lmp)), list(nullptr)
{
  if (!HydroField::has_library()) error->all(FLERR, 2, "Fix hydro {}", HydroField::NO_LIBRARY);
  parse_all(narg, arg);
}

HydroGrid::~HydroGrid() = default;

/* ----------------------------------------------------------------------
   the width of the Gaussians is that of a run: particles that come later do not change it
------------------------------------------------------------------------- */

void HydroGrid::measure_radius()
{
  double mine[2] = {}, all[2];
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & fix->groupbit) {
      if (!(atom->radius[i] > 0.0))
        error->one(FLERR, "Fix hydro: atom {} has no radius; give the fix a group without it",
                   atom->tag[i]);
      mine[0] += atom->radius[i];
      mine[1] += 1.0;
    }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (all[1] == 0.0) error->all(FLERR, "Fix hydro has no particles in its group");
  const double now = all[0] / all[1];
  if (!Suspension_NS::is_same_sum(state.radius, now)) state.radius = now;
}

/* ----------------------------------------------------------------------
   a solution that is known, from a restart file or the last run, is held on
------------------------------------------------------------------------- */

void HydroGrid::start()
{
  fluid->setup();
  find_strain(strain);
  if (state.solutions == 0.0) solve(FIRST * settings->tolerance);
  heat = heat_before = sum_heat();
  find_dragged();
}

void HydroGrid::new_step()
{
  fluid->new_step();
  double square = 0.0;
  find_strain(strain);
  for (const double value : strain) square += value * value;
  state.strain += sqrt(2.0 * square) * update->dt;
  const double steps = static_cast<double>(update->ntimestep) - state.step;
  const bool due = settings->every ? steps >= settings->every || steps < 0.0
                                   : state.strain >= settings->strain * (1.0 - 1e-9);
  if (due) solve(settings->tolerance);
  heat_before = heat;
  heat = sum_heat();
  find_dragged();
}

/* ----------------------------------------------------------------------
   from one solution to the next
------------------------------------------------------------------------- */

bool HydroGrid::pull(int i, Pull &p) const
{
  const double *h = held[i];
  p.flow = fluid->flow_at(i);
  p.drag = Hydro_NS::held_drag({std::max(state.translation, h[HOLD]), state.rotation},
                               state.viscosity, atom->radius[i]);
  p.target = {Hydro_NS::held_target(p.drag.translation, p.flow.velocity, get_vector(h + MOTION),
                                    get_vector(h + LOAD)),
              Hydro_NS::held_target(p.drag.rotation, p.flow.spin, get_vector(h + MOTION + 3),
                                    get_vector(h + LOAD + 3))};
  return true;
}

void HydroGrid::stresslet(int i, double *five) const
{
  std::copy_n(held[i] + LOAD + 6, 5, five);
}

double HydroGrid::sum_heat() const
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & fix->groupbit)
      for (int k = 0; k < 5; k++) sum -= held[i][LOAD + 6 + k] * strain[k];
  return sum;
}

/* ---------------------------------------------------------------------- */

void HydroGrid::write(FILE *fp) const
{
  Suspension_NS::write_sealed(fp, state);
}

const char *HydroGrid::read(char *buffer)
{
  return Suspension_NS::read_sealed(buffer, state);
}

/* ---------------------------------------------------------------------- */

int HydroGrid::comm_size() const
{
  return Hydro_NS::NUMBERS;
}

int HydroGrid::pack_loads(int n, const int *atoms, double *buf) const
{
  return field->pack_loads(n, atoms, buf);
}

void HydroGrid::unpack_loads(int n, int first, const double *buf)
{
  field->unpack_loads(n, first, buf);
}

int HydroGrid::pack_motions(int n, int first, double *buf) const
{
  return field->pack_motions(n, first, buf);
}

void HydroGrid::unpack_motions(int n, const int *atoms, const double *buf)
{
  field->unpack_motions(n, atoms, buf);
}

double HydroGrid::memory_usage() const
{
  return HydroLevel::memory_usage() + field->memory_usage() + preconditioner->memory_usage();
}
