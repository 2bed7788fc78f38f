/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_drag_background.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "lubcontact_drag.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using lubcontact::Vec3;

/* ----------------------------------------------------------------------
   fix ID group drag/background eta keyword value ...
------------------------------------------------------------------------- */

FixDragBackground::FixDragBackground(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), eta(0.0), rate(0.0)
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "fix drag/background", error);
  eta = utils::numeric(FLERR, arg[3], false, lmp);
  if (!(eta >= 0.0))
    error->all(FLERR, 3, "Fix drag/background viscosity must be >= 0, but is {}", arg[3]);
  for (int iarg = 4; iarg < narg; iarg += 2) {
    if (strcmp(arg[iarg], "shear") != 0)
      error->all(FLERR, iarg, "Unknown fix drag/background keyword: {}", arg[iarg]);
    if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "fix drag/background shear", error);
    rate = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
  }
  dynamic_group_allow = 1;
}

/* ---------------------------------------------------------------------- */

int FixDragBackground::setmask()
{
  return POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixDragBackground::init()
{
  if (!atom->radius_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "Fix drag/background needs finite-size spheres; use: atom_style sphere");
}

/* ----------------------------------------------------------------------
   the drag is explicit: a step beyond its relaxation time would be unstable
------------------------------------------------------------------------- */

void FixDragBackground::setup(int vflag)
{
  double mine = HUGE_VAL, limit;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      mine = MIN(mine, atom->rmass[i] / (6.0 * lubcontact::PI * eta * atom->radius[i]));
  MPI_Allreduce(&mine, &limit, 1, MPI_DOUBLE, MPI_MIN, world);
  // the spin relaxes faster: J/(8 pi eta R^3) is 0.3 of it
  limit *= 0.3 / force->ftm2v;
  if (update->dt > limit)
    error->all(FLERR,
               "Time step {} exceeds {:.4g}, the shortest relaxation time under the drag of fix "
               "drag/background: reduce it or increase the density",
               update->dt, limit);
  post_force(vflag);
}

/* ---------------------------------------------------------------------- */

void FixDragBackground::post_force(int /*vflag*/)
{
  const Vec3 vorticity{0.0, 0.0, -0.5 * rate};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double *v = atom->v[i], *omega = atom->omega[i];
    const Vec3 flow{rate * atom->x[i][1], 0.0, 0.0};
    const Vec3 force = lubcontact::drag_force(eta, atom->radius[i], {v[0], v[1], v[2]}, flow);
    const Vec3 torque =
        lubcontact::drag_torque(eta, atom->radius[i], {omega[0], omega[1], omega[2]}, vorticity);
    double *f = atom->f[i], *t = atom->torque[i];
    f[0] += force.x;
    f[1] += force.y;
    f[2] += force.z;
    t[0] += torque.x;
    t[1] += torque.y;
    t[2] += torque.z;
  }
}
