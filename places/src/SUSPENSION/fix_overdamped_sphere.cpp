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
#include "fix_hydro.h"
#include "fix_hydro_level.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace LAMMPS_NS;
using namespace FixConst;
using Fluid_NS::Vec3;

static constexpr char FAR[] = "hydro";

struct FixOverdampedSphere::Pull : HydroLevel::Pull {};

/* ----------------------------------------------------------------------
   fix ID group overdamped/sphere eta keyword value ...
------------------------------------------------------------------------- */

FixOverdampedSphere::FixOverdampedSphere(LAMMPS *lmp, int narg, char **arg) :
    FixBackgroundFluid(lmp, narg, arg, FAR), limit(HUGE_VAL), warned(false), far(nullptr)
{
  if (fluid->only_isolated())
    for (int iarg = 4; iarg < narg; iarg++)
      if (std::string(arg[iarg]) == "isolated")
        error->all(FLERR, iarg,
                   "Fix overdamped/sphere cannot move particles without drag: remove isolated");
  time_integrate = 1;
}

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
  far = nullptr;
  if (fluid->is_elsewhere()) check_far();
}

/* ----------------------------------------------------------------------
   it says where particles go without forces, and how easily forces move them
------------------------------------------------------------------------- */

void FixOverdampedSphere::check_far()
{
  far = FixHydro::find(lmp);
  if (!far || !far->fluid().drags_all())
    error->all(FLERR,
               "Fix overdamped/sphere hydro needs a fix hydro grid, which has the drag of all "
               "particles: add one, or use fix overdamped/sphere eta");
}

/* ----------------------------------------------------------------------
   nobody else moves these particles
------------------------------------------------------------------------- */

void FixOverdampedSphere::check_others()
{
  for (const auto &other : modify->get_fix_list()) {
    if (other == this || !other->time_integrate) continue;
    const std::string name = other->id, kind = other->style;
    fluid->exclusive().forbid(other->groupbit, [name, kind](const std::string &who) {
      return fmt::format("Fix {0} {1} and fix overdamped/sphere both move {2}: remove fix {0}, or "
                         "give it another group",
                         name, kind, who);
    });
  }
}

/* ----------------------------------------------------------------------
   of a particle of the fix: there must be a drag
------------------------------------------------------------------------- */

void FixOverdampedSphere::pull(int i, Pull &p) const
{
  fluid->exclusive().check(atom->mask[i]);
  if (far) {
    if (!(atom->mask[i] & far->groupbit))
      error->one(FLERR,
                 "Fix overdamped/sphere hydro cannot move atom {}, which is not in the group of "
                 "fix {}: use the same group for both",
                 atom->tag[i], far->id);
    far->fluid().pull(i, p);
    return;
  }
  p.drag = fluid->drag(i);
  p.flow = p.target = fluid->flow_at(i);
  if (!(p.drag.translation > 0.0))
    error->one(FLERR,
               "Fix overdamped/sphere cannot move atom {} without drag: viscosity, hindrance and "
               "radius must be > 0",
               atom->tag[i]);
}

/* ---------------------------------------------------------------------- */

void FixOverdampedSphere::setup(int /*vflag*/)
{
  if (!far) fluid->setup();
  find_limit();
  warned = false;
  reset_dt();
}

/* ----------------------------------------------------------------------
   the springs of all partners in range, over the drag
------------------------------------------------------------------------- */

void FixOverdampedSphere::find_limit()
{
  limit = HUGE_VAL;
  std::vector<double> stiffness(atom->nlocal, 0.0), part;
  for (PairLubcontact *pair : PairLubcontact::all(lmp)) {
    pair->sum_stiffness(Fluid_NS::SPIN_OF_DRAG, part);
    for (int i = 0; i < atom->nlocal; i++) stiffness[i] += part[i];
  }
  double mine = HUGE_VAL;
  Pull p;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    pull(i, p);
    if (stiffness[i] > 0.0)
      mine = std::min(mine, Fluid_NS::overdamped_step_limit(stiffness[i], p.drag.translation));
  }
  MPI_Allreduce(&mine, &limit, 1, MPI_DOUBLE, MPI_MIN, world);
  if (comm->me == 0 && limit < HUGE_VAL)
    utils::logmesg(
        lmp, "Fix overdamped/sphere: time step {:.6g}, {:.3g} of the stability limit {:.6g}\n",
        update->dt, update->dt / limit, limit);
}

void FixOverdampedSphere::reset_dt()
{
  if (update->dt <= limit || warned || update->whichflag == 0) return;
  warned = true;
  if (comm->me == 0)
    error->warning(FLERR,
                   "Time step {} exceeds {:.4g}, the stability limit of the contact springs "
                   "against the drag of fix overdamped/sphere in the present state: reduce it, or "
                   "soften the contact",
                   update->dt, limit);
}

/* ----------------------------------------------------------------------
   v and omega stay those of the step. Fix hydro sums up what its fluid does
------------------------------------------------------------------------- */

void FixOverdampedSphere::initial_integrate(int /*vflag*/)
{
  const double dt = update->dt;
  if (!far) fluid->new_step();
  std::fill_n(sums, NUM_SUMS, 0.0);
  Pull p;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    pull(i, p);
    const Vec3 force = Lubcontact_NS::get_vector(atom->f[i]),
               torque = Lubcontact_NS::get_vector(atom->torque[i]);
    const Vec3 v = Fluid_NS::overdamped(p.drag.translation, force, p.target.velocity);
    const Vec3 omega = Fluid_NS::overdamped(p.drag.rotation, torque, p.target.spin);
    Lubcontact_NS::put_vector(v, atom->v[i]);
    Lubcontact_NS::put_vector(omega, atom->omega[i]);
    Lubcontact_NS::put_vector(Lubcontact_NS::get_vector(atom->x[i]) + dt * v, atom->x[i]);

    sums[NUMBER] += 1.0;
    if (far) continue;
    sums[POWER] += dot(force, v - p.flow.velocity) + dot(torque, omega - p.flow.spin);
    const double drags[] = {-force.x, -force.y, -force.z, -torque.x, -torque.y, -torque.z};
    for (int n = 0; n < 6; n++) sums[FORCE + n] += drags[n];
  }
  step_power = sums[POWER];    // a step has one velocity
}
