/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_deform_rheometer.h"

#include "atom.h"
#include "comm.h"
#include "deform_judge.h"
#include "deform_stress.h"
#include "deform_targets.h"
#include "domain.h"
#include "error.h"
#include "fix_pore_pressure.h"
#include "force.h"
#include "kspace.h"
#include "list_keeper.h"
#include "modify.h"
#include "output.h"
#include "pair.h"
#include "rheometer_flow.h"
#include "rheometer_list.h"
#include "rheometer_servo.h"
#include "suspension_host.h"
#include "uncounted_forces.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;
using Rheometer_NS::Cell;
using Rheometer_NS::Flow;
using Rheometer_NS::Gradient;

static constexpr double ROUNDING = 1e-9;    // of a box length: more than a conversion of positions

/* ----------------------------------------------------------------------
   the box moves together with the positions, in post_integrate: a set-up finds the cell in which
   the forces were computed
------------------------------------------------------------------------- */

int FixDeformRheometer::setmask()
{
  return POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::init()
{
  if (modify->get_fix_by_style("^deform").size() > 1)
    error->all(FLERR, "More than one fix deform: only one can control the cell");
  Suspension_NS::require_verlet(lmp, "Fix deform/rheometer");
  for (const auto &other : modify->get_fix_list())
    if (other->rigid_flag)
      error->all(FLERR, "Fix {} cannot move the rigid bodies of fix {}", style, other->id);
  refuse_constraints(lmp, std::string("Fix ") + style);
  const std::string missing = uncounted_forces(lmp, false);
  if (!missing.empty() && comm->me == 0)
    error->warning(FLERR,
                   "Fix {}: pressure and stress include only the pair style and inertia, not {}",
                   style, missing);
  check_directions();
  if (domain->xz != 0.0 || domain->yz != 0.0)
    error->all(FLERR, "Fix {} needs a cell without tilts xz and yz, but they are {} and {}", style,
               domain->xz, domain->yz);
  if (flow != Rheometer_NS::SHEAR && domain->triclinic && domain->xy != 0.0)
    error->all(FLERR, "Fix {} needs a cell without tilt for extension, but xy is {}", style,
               domain->xy);

  const std::string minimizer = update->minimize_style;
  if (update->whichflag == 2 && (minimizer == "fire" || minimizer == "quickmin") && comm->me == 0)
    error->warning(FLERR,
                   "min_style {} overwrites the velocities of the flow; use min_style cg or sd",
                   minimizer);

  targets->check_variables();
  targets->find_viscosity();
  h_rate = domain->h_rate;
  h_ratelo = domain->h_ratelo;
  kspace_flag = force->kspace ? 1 : 0;
  varflag = 0;
  pore = FixPorePressure::find(lmp);
  stress->init();
  publish_rates();
}

/* ----------------------------------------------------------------------
   before ghosts are made: the flow of the first step
------------------------------------------------------------------------- */

void FixDeformRheometer::setup_pre_exchange()
{
  if (update->whichflag != 1) return;
  if (from_restart) restore_positions();
  from_restart = false;
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 3; d++) held[i][d] = atom->x[i][d];

  stepped = false;
  if (!fresh) return;    // goes on as it did
  fresh = false;
  stress->set_means({});
  if (!targets->holds_pressure()) motion->dilation = 0.0;
  update_targets();
  if (targets->drive() != DeformTargets::STRESS) motion->rate = next_rate();
  set_gradient();
}

/* ----------------------------------------------------------------------
   in a triclinic cell read_restart and the set-up convert positions to lamda coordinates and back,
   which rounds them: undo it, so that a restarted run goes on bit for bit
------------------------------------------------------------------------- */

void FixDeformRheometer::restore_positions()
{
  for (int i = 0; i < atom->nlocal; i++) {
    double *x = atom->x[i];
    bool same = true;    // neither wrapped into the cell nor new
    for (int d = 0; d < 3; d++)
      if (!(fabs(x[d] - held[i][d]) <= ROUNDING * domain->prd[d])) same = false;
    for (int d = 0; same && d < 3; d++) x[d] = held[i][d];
  }
}

/* ----------------------------------------------------------------------
   positions of new ghosts come from lamda coordinates: make them as in all other steps, so that
   a restarted run finds those of the run that wrote the file
------------------------------------------------------------------------- */

void FixDeformRheometer::setup_pre_neighbor()
{
  if (update->whichflag == 1) restore_positions();
  comm->forward_comm();
  check_cell();
  start_list();
}

void FixDeformRheometer::pre_neighbor()
{
  if (update->ntimestep == output->next_restart) comm->forward_comm();
  check_cell();
  start_list();
}

/* ----------------------------------------------------------------------
   a list lives for as long as the deformation of the cell, and what particles do besides, allow
------------------------------------------------------------------------- */

void FixDeformRheometer::start_list()
{
  *listed = {domain->xprd, domain->yprd, domain->zprd, domain->xy};
  keeper->listed();
}

void FixDeformRheometer::keep_list(const Cell &cell)
{
  check_cell();    // which otherwise is done with the lists
  const Rheometer_NS::Deformation f = Rheometer_NS::deformation(*listed, cell);
  if (!keeper->decide({f}, domain->boxlo)) next_reneighbor = update->ntimestep;
}

void FixDeformRheometer::post_run()
{
  keeper->release();
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::check_cell() const
{
  if (!force->pair) return;
  const double cut = force->pair->cutforce;
  const auto height = Suspension_NS::cell_heights(domain);
  for (int d = 0; d < domain->dimension; d++)
    if (domain->periodicity[d] && height[d] < 2.0 * cut)
      error->all(FLERR,
                 "Fix {}: at strain {:.6g} the height {:.6g} of the cell along {} has come below "
                 "twice the cutoff {:.6g} of the pair style, so that a pair could meet through two "
                 "images: start from a larger cell or stop earlier",
                 style, motion->strain, height[d], "xyz"[d], cut);
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::setup(int /*vflag*/)
{
  measure_stress();
  stress->announce((update->ntimestep / nevery + 1) * nevery);
}

/* ----------------------------------------------------------------------
   what LAMMPS would follow edge by edge, for as long as it takes, or not at all
------------------------------------------------------------------------- */

void FixDeformRheometer::check_move(const Cell &old, const Cell &cell) const
{
  auto small = [](double from, double to, double edge) {
    return fabs(to - from) <= 0.5 * edge;    // false for what is not a number
  };
  if (small(old.lx, cell.lx, old.lx) && small(old.ly, cell.ly, old.ly) &&
      small(old.lz, cell.lz, old.lz) && small(old.xy, cell.xy, old.lx))
    return;
  error->all(FLERR,
             "Fix {}: at step {} the cell would move by more than half its length in one step, at "
             "a shear rate of {:.6g} and a step of {:.6g}: reduce the time step",
             style, update->ntimestep, motion->rate, update->dt);
}

/* ----------------------------------------------------------------------
   the cell moves with the positions; flips at once if it tilts by more than half an edge
------------------------------------------------------------------------- */

void FixDeformRheometer::post_integrate()
{
  const double dt = update->dt;
  Rheometer_NS::pass(*motion, dt);
  stepped = true;

  const Cell old = {domain->xprd, domain->yprd, domain->zprd, domain->xy};
  const Cell cell = Rheometer_NS::advance(old, motion->rate_of_cell, dt);
  check_move(old, cell);
  if (cell.lx != old.lx) domain->boxhi[0] = domain->boxlo[0] + cell.lx;
  if (cell.ly != old.ly) domain->boxhi[1] = domain->boxlo[1] + cell.ly;
  if (cell.lz != old.lz) domain->boxhi[2] = domain->boxlo[2] + cell.lz;
  if (domain->triclinic) domain->xy = cell.xy;
  domain->set_global_box();
  domain->set_local_box();

  flipxy = flow == Rheometer_NS::SHEAR ? Rheometer_NS::flips(cell) : 0;
  flipxz = flipyz = 0;
  flip = flipxy != 0;
  if (flip) {
    set[3].tilt_flip = domain->yz;
    set[4].tilt_flip = domain->xz;
    set[5].tilt_flip = cell.xy + flipxy * cell.lx;
    next_reneighbor = update->ntimestep;
  } else if (keeper->allowed()) {
    keep_list(cell);
  }
  if (kspace_flag) force->kspace->setup();
}

/* ----------------------------------------------------------------------
   the flip of the parent wraps positions only: particles that have left the cell change their
   velocity, too
------------------------------------------------------------------------- */

void FixDeformRheometer::pre_exchange()
{
  if (!flip) return;
  domain->x2lamda(atom->nlocal);
  domain->pbc();
  domain->lamda2x(atom->nlocal);
  FixDeform::pre_exchange();
}

/* ----------------------------------------------------------------------
   called every nevery steps: the flow until the next time
------------------------------------------------------------------------- */

void FixDeformRheometer::end_of_step()
{
  measure_stress();
  stress->announce(update->ntimestep + nevery);
  if (!stepped) return;
  stress->add_to_means(motion->rate * motion->moved, motion->moved);

  if (targets->has_variables()) modify->clearstep_compute();
  update_targets();
  if (targets->has_variables()) modify->addstep_compute(update->ntimestep + nevery);
  const double rate_next = next_rate();
  const double dilation_next = next_dilation();
  judge->judge(*targets, *stress, motion->rate, motion->dilation, trouton(), interval());
  motion->rate = rate_next;
  motion->dilation = dilation_next;
  set_gradient();
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::update_targets()
{
  targets->update();
  stress->set_viscosity(force->nktv2p * targets->viscosity());
}

/* ----------------------------------------------------------------------
   with what has become of the flow, whose particles move at a constant velocity; the fluid answers
   to the dilation of now
------------------------------------------------------------------------- */

void FixDeformRheometer::measure_stress()
{
  stress->measure(static_cast<Flow>(flow), Rheometer_NS::at_end(motion->gradient, motion->moved));
  stress->drain(pore ? pore->drainage() : 0.0, motion->dilation);
}

/* ----------------------------------------------------------------------
   time until the flow is adjusted again
------------------------------------------------------------------------- */

double FixDeformRheometer::interval() const
{
  return (nevery - update->ntimestep % nevery) * update->dt;
}

double FixDeformRheometer::trouton() const
{
  return Rheometer_NS::trouton_ratio(static_cast<Flow>(flow));
}

/* ---------------------------------------------------------------------- */

double FixDeformRheometer::next_rate() const
{
  const double driven = targets->driven();
  switch (targets->drive()) {
    case DeformTargets::IV:
      return driven * targets->pressure() / stress->material().eta;
    case DeformTargets::OSCILLATE:
      return Rheometer_NS::oscillation_rate(driven, targets->amplitude(), targets->frequency(),
                                            motion->time, interval());
    case DeformTargets::STRESS:
      return Rheometer_NS::next_rate(stress->material(), motion->rate, stress->stress(), driven,
                                     trouton(), interval());
    default:
      return driven;
  }
}

double FixDeformRheometer::next_dilation() const
{
  if (!targets->holds_pressure()) return 0.0;
  return Rheometer_NS::next_dilation(stress->material(), motion->dilation,
                                     stress->particle_pressure(), targets->pressure(), motion->rate,
                                     targets->gain(), interval(), stress->drainage());
}

/* ----------------------------------------------------------------------
   new flow, in which the edges of the cell change at a constant velocity: so do the particles of
   the flow, which need no further push until it is adjusted again
------------------------------------------------------------------------- */

void FixDeformRheometer::set_gradient()
{
  const Gradient before = motion->gradient;
  const Gradient next = Rheometer_NS::gradient(static_cast<Flow>(flow), domain->dimension,
                                               motion->rate, motion->dilation, interval());
  const Gradient k = Rheometer_NS::change(before, next, motion->moved);
  motion->gradient = next;
  motion->rate_of_cell =
      Rheometer_NS::cell_rate(next, {domain->xprd, domain->yprd, domain->zprd, domain->xy});
  motion->moved = 0.0;
  publish_rates();
  push_particles(k, -0.5 * (next.xy - before.xy));
}

/* ----------------------------------------------------------------------
   the change of velocity and of spin that keeps each particle in the flow
------------------------------------------------------------------------- */

void FixDeformRheometer::push_particles(const Gradient &k, double spin)
{
  if (k.xx == 0.0 && k.yy == 0.0 && k.zz == 0.0 && k.xy == 0.0) return;
  const double lo[3] = {domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]};
  const int nlocal = atom->nlocal;
  const int *mask = atom->mask;
  for (int i = 0; i < nlocal; i++) {
    if (!(mask[i] & groupbit)) continue;
    const double *x = atom->x[i];
    double *v = atom->v[i];
    const double y = x[1] - lo[1];
    v[0] += k.xx * (x[0] - lo[0]) + k.xy * y;
    v[1] += k.yy * y;
    v[2] += k.zz * (x[2] - lo[2]);
    atom->omega[i][2] += spin;
  }
}

/* ----------------------------------------------------------------------
   rates of change of the cell, from which LAMMPS makes the velocities of ghosts
------------------------------------------------------------------------- */

void FixDeformRheometer::publish_rates()
{
  h_rate[0] = motion->rate_of_cell.lx;
  h_rate[1] = motion->rate_of_cell.ly;
  h_rate[2] = motion->rate_of_cell.lz;
  h_rate[3] = h_rate[4] = 0.0;
  h_rate[5] = motion->rate_of_cell.xy;
  h_ratelo[0] = h_ratelo[1] = h_ratelo[2] = 0.0;
}
