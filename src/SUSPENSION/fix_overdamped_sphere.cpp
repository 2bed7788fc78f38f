/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_overdamped_sphere.h"

#include "atom.h"
#include "background_fluid.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "restart_seal.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using lubcontact::Drag;
using lubcontact::Flow;
using lubcontact::Vec3;

static Vec3 vector(const double *a)
{
  return {a[0], a[1], a[2]};
}

static void put(const Vec3 &a, double *to)
{
  to[0] = a.x;
  to[1] = a.y;
  to[2] = a.z;
}

/* ----------------------------------------------------------------------
   fix ID group overdamped/sphere eta keyword value ...
------------------------------------------------------------------------- */

FixOverdampedSphere::FixOverdampedSphere(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), fluid(new BackgroundFluid(lmp, this, narg, arg)), sums(), limit(HUGE_VAL)
{
  if (fluid->only_isolated())
    for (int iarg = 4; iarg < narg; iarg++)
      if (std::string(arg[iarg]) == "isolated")
        error->all(FLERR, iarg,
                   "Fix overdamped/sphere cannot move particles without drag: remove isolated");
  dynamic_group_allow = 1;
  time_integrate = 1;
  restart_global = 1;
  vector_flag = 1;
  size_vector = NUM_SUMS + 2;
  extvector = 0;
  global_freq = 1;
}

FixOverdampedSphere::~FixOverdampedSphere() = default;

/* ---------------------------------------------------------------------- */

int FixOverdampedSphere::setmask()
{
  return INITIAL_INTEGRATE;
}

/* ---------------------------------------------------------------------- */

void FixOverdampedSphere::init()
{
  fluid->init();
  check_others();
}

/* ----------------------------------------------------------------------
   nobody else moves these particles
------------------------------------------------------------------------- */

void FixOverdampedSphere::check_others() const
{
  for (const auto &other : modify->get_fix_list()) {
    if (other == this || !other->time_integrate) continue;
    const bigint both = fluid->count(other->groupbit);
    if (both)
      error->all(
          FLERR,
          "Fix {} {} moves {} particles that fix overdamped/sphere moves, too: remove it, or "
          "give it another group",
          other->id, other->style, both);
  }
}

/* ---------------------------------------------------------------------- */

void FixOverdampedSphere::setup(int /*vflag*/)
{
  fluid->setup();
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && !(fluid->drag(i).translation > 0.0))
      error->one(FLERR,
                 "Fix overdamped/sphere cannot move atom {} without drag: viscosity, "
                 "hindrance and radius must be > 0",
                 atom->tag[i]);
  find_limit();
  reset_dt();
}

/* ----------------------------------------------------------------------
   the springs of all partners in range, over the drag
------------------------------------------------------------------------- */

void FixOverdampedSphere::find_limit()
{
  limit = HUGE_VAL;
  auto *pair = dynamic_cast<PairLubcontact *>(find_lubcontact(lmp));
  if (!pair) return;
  std::vector<double> stiffness;
  pair->sum_stiffness_overdamped(lubcontact::SPIN_OF_DRAG, stiffness);
  double mine = HUGE_VAL;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && stiffness[i] > 0.0)
      mine = std::min(mine,
                      lubcontact::overdamped_step_limit(stiffness[i], fluid->drag(i).translation));
  MPI_Allreduce(&mine, &limit, 1, MPI_DOUBLE, MPI_MIN, world);
  if (comm->me == 0 && limit < HUGE_VAL)
    utils::logmesg(
        lmp, "Fix overdamped/sphere: time step {:.6g}, {:.3g} of the stability limit {:.6g}\n",
        update->dt, update->dt / limit, limit);
}

void FixOverdampedSphere::reset_dt()
{
  if (update->dt > limit && comm->me == 0)
    error->warning(FLERR,
                   "Time step {} exceeds {:.4g}, the stability limit of the contact springs "
                   "against the drag of fix overdamped/sphere in the present state: reduce it, or "
                   "soften the contact",
                   update->dt, limit);
}

/* ----------------------------------------------------------------------
   v and omega stay those of the step
------------------------------------------------------------------------- */

void FixOverdampedSphere::initial_integrate(int /*vflag*/)
{
  const double dt = update->dt;
  fluid->new_step();
  std::fill_n(sums, NUM_SUMS, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const Drag drag = fluid->drag(i);
    const Flow flow = fluid->flow(i);
    const Vec3 force = vector(atom->f[i]), torque = vector(atom->torque[i]);
    const Vec3 v = lubcontact::overdamped(drag.translation, force, flow.velocity);
    const Vec3 omega = lubcontact::overdamped(drag.rotation, torque, flow.spin);
    put(v, atom->v[i]);
    put(omega, atom->omega[i]);
    put(vector(atom->x[i]) + dt * v, atom->x[i]);

    sums[POWER] += dot(force, v - flow.velocity) + dot(torque, omega - flow.spin);
    const double drags[] = {-force.x, -force.y, -force.z, -torque.x, -torque.y, -torque.z};
    for (int n = 0; n < 6; n++) sums[FORCE + n] += drags[n];
    sums[NUMBER] += 1.0;
  }
}

/* ----------------------------------------------------------------------
   dissipated power, force and torque of the drag, number of particles, hindrance, dissipated power
   as the mean of the last step
------------------------------------------------------------------------- */

double FixOverdampedSphere::compute_vector(int n)
{
  if (n == NUM_SUMS) return fluid->hindrance();
  // a step has one velocity: its power is the mean of the step
  const double mine = sums[n < NUM_SUMS ? n : static_cast<int>(POWER)];
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixOverdampedSphere::write_restart(FILE *fp)
{
  if (comm->me) return;
  const double state[] = {fluid->solid, suspension::seal(&fluid->solid, sizeof(double))};
  const int size = sizeof(state);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(state, sizeof(state), 1, fp);
}

void FixOverdampedSphere::restart(char *buffer)
{
  double state[2];
  memcpy(state, buffer, sizeof(state));
  if (suspension::seal(state, sizeof(double)) != state[1])
    error->all(FLERR, "The part of fix {} in the restart file is damaged: use another one", style);
  fluid->solid = state[0];
}

/* ---------------------------------------------------------------------- */

double FixOverdampedSphere::memory_usage()
{
  return fluid->memory_usage();
}
