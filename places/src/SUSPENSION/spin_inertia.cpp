/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "spin_inertia.h"

#include "atom.h"
#include "fix_nve_sphere.h"
#include "modify.h"

using namespace LAMMPS_NS;

static constexpr double SPHERE = 0.4;    // moment of inertia over m R^2

// the member of fix nve/sphere is protected; a derived class may read it
struct MomentOfInertia : FixNVESphere {
  static double of(FixNVESphere *fix) { return fix->*&MomentOfInertia::inertia; }
};

void SpinInertia::find(LAMMPS *lmp)
{
  movers.clear();
  for (const auto &fix : lmp->modify->get_fix_by_style("^nve/sphere")) {
    auto *mover = dynamic_cast<FixNVESphere *>(fix);
    if (mover) movers.emplace_back(mover->groupbit, MomentOfInertia::of(mover));
  }
}

double SpinInertia::of(Atom *atom, int i) const
{
  double ratio = SPHERE;
  for (const auto &mover : movers)
    if (atom->mask[i] & mover.first) ratio = mover.second;
  return ratio * atom->rmass[i] * atom->radius[i] * atom->radius[i];
}
