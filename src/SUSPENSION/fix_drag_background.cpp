/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_drag_background.h"

#include "atom.h"
#include "background_fluid.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "restart_seal.h"
#include "spin_inertia.h"
#include "update.h"

#include <algorithm>
#include <string>

using namespace LAMMPS_NS;
using namespace FixConst;
using Fluid_NS::Vec3;

// fixes that may come later: they read forces, or set them whatever they were
static const char *const READERS[] = {"enforce2d", "setforce", "freeze", "store/force",
                                      "rheometer/plates"};

namespace {

// what a restart file holds
struct Saved {
  double energy = 0.0, kept = 0.0;
};

}    // namespace

/* ----------------------------------------------------------------------
   fix ID group drag/background eta keyword value ...
------------------------------------------------------------------------- */

FixDragBackground::FixDragBackground(LAMMPS *lmp, int narg, char **arg) :
    FixBackgroundFluid(lmp, narg, arg), inertia(new SpinInertia()), power(0.0), energy(0.0),
    others()
{
  scalar_flag = 1;
  extscalar = 1;
  ecouple_flag = 1;
  size_vector = NUM_ALL;
}

FixDragBackground::~FixDragBackground() = default;

/* ---------------------------------------------------------------------- */

int FixDragBackground::setmask()
{
  return POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixDragBackground::init()
{
  fluid->init();
  check_order();
  inertia->find(lmp);
}

/* ----------------------------------------------------------------------
   what acts together with a strong drag is damped by it: all forces must be known here
------------------------------------------------------------------------- */

void FixDragBackground::check_order()
{
  bool later = false;
  for (const auto &other : modify->get_fix_list()) {
    const std::string name = other->id, kind = other->style;
    if (other == this) later = true;
    if (other == this || !later || !(modify->get_fix_mask(other) & POST_FORCE)) continue;
    const bool reads = std::any_of(std::begin(READERS), std::end(READERS), [&](const char *reader) {
      return kind == reader;
    });
    if (kind == style)
      fluid->exclusive().forbid(other->groupbit, [this, name](const std::string &who) {
        return fmt::format("Fixes {} and {} both act on the same particles, {}; give the fixes "
                           "disjoint groups",
                           id, name, who);
      });
    else if (!reads)
      fluid->exclusive().forbid(other->groupbit, [this, name, kind](const std::string &who) {
        return fmt::format("Fix {} {} adds forces after fix drag/background, which needs all other "
                           "forces to integrate the drag of {}: define fix {} after fix {}",
                           name, kind, who, id, name);
      });
  }
  for (const auto &other : modify->get_fix_by_style("^overdamped")) {
    const std::string name = other->id, kind = other->style;
    fluid->exclusive().forbid(other->groupbit, [name, kind](const std::string &who) {
      return fmt::format(
          "Fix drag/background acts on {} of fix {} {}, which already applies the drag", who, name,
          kind);
    });
  }
}

/* ---------------------------------------------------------------------- */

void FixDragBackground::setup(int /*vflag*/)
{
  fluid->setup();
  drag_all(true);
  step_power = 0.0;    // no step yet
}

void FixDragBackground::post_force(int /*vflag*/)
{
  const double before = power, dissipated = sums[POWER];
  fluid->new_step();
  drag_all(false);
  energy += 0.5 * update->dt * (before + power);
  step_power = 0.5 * (dissipated + sums[POWER]);
}

/* ----------------------------------------------------------------------
   velocities are those of the last half step, or of the full step in a set-up; see fluid_drag.h
------------------------------------------------------------------------- */

void FixDragBackground::drag_all(bool full)
{
  const double dt = update->dt * force->ftm2v;
  std::fill_n(sums, NUM_SUMS, 0.0);
  std::fill_n(others, NUM_ALL - OTHERS, 0.0);
  power = 0.0;
  // damps what acts on v; returns the mean drag, and adds what it takes from the particle
  auto damp = [&](double coefficient, double mass, const Vec3 &v, const Vec3 &fluid_v, double *f) {
    const Vec3 others = Lubcontact_NS::get_vector(f);
    const auto step = Fluid_NS::drag_step(full, dt, mass, coefficient, others, v, fluid_v);
    Lubcontact_NS::put_vector(step.force, f);
    const Vec3 mine = step.force - others;
    power -= dot(mine, step.v_full);
    sums[POWER] -= dot(mine, step.v_full - fluid_v);
    return mine;
  };
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    fluid->exclusive().check(atom->mask[i]);
    const Fluid_NS::Drag drag = fluid->drag(i);
    if (drag.translation == 0.0) continue;
    const Fluid_NS::Flow flow = fluid->flow_at(i);
    const Vec3 pull = damp(drag.translation, atom->rmass[i], Lubcontact_NS::get_vector(atom->v[i]),
                           flow.velocity, atom->f[i]);
    Lubcontact_NS::add_vector(pull, &sums[FORCE]);
    Lubcontact_NS::add_vector(damp(drag.rotation, inertia->of(atom, i),
                                   Lubcontact_NS::get_vector(atom->omega[i]), flow.spin,
                                   atom->torque[i]),
                              &sums[TORQUE]);
    sums[NUMBER] += 1.0;
    if (fluid->is_isolated(i)) continue;
    Lubcontact_NS::add_vector(pull, others);
    others[NUM_OTHERS - OTHERS] += 1.0;
  }
}

/* ----------------------------------------------------------------------
   the columns of all fixes with a background fluid, then force on and number of the others
------------------------------------------------------------------------- */

double FixDragBackground::compute_vector(int n)
{
  if (n < OTHERS) return FixBackgroundFluid::compute_vector(n);
  double all;
  MPI_Allreduce(&others[n - OTHERS], &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ----------------------------------------------------------------------
   energy that the particles have given to the fluid
------------------------------------------------------------------------- */

double FixDragBackground::compute_scalar()
{
  double all;
  MPI_Allreduce(&energy, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixDragBackground::write_restart(FILE *fp)
{
  const Saved now = {compute_scalar(), fluid->kept()};
  if (comm->me == 0) Suspension_NS::write_sealed(fp, now);
}

void FixDragBackground::restart(char *buffer)
{
  Saved from{};
  check_restart(Suspension_NS::read_sealed(buffer, from));
  energy = comm->me ? 0.0 : from.energy;
  fluid->keep(from.kept);
}
