/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// fix ID group rigid/claim: claims to hold rigid bodies and does nothing. For tests with a LAMMPS
// that was built without its package RIGID.

#include "fix.h"
#include "lammpsplugin.h"
#include "version.h"

using namespace LAMMPS_NS;

namespace {

class FixRigidClaim : public Fix {
 public:
  FixRigidClaim(LAMMPS *owner, int narg, char **arg) : Fix(owner, narg, arg) { rigid_flag = 1; }
  int setmask() override { return 0; }
};

Fix *create(LAMMPS *lmp, int narg, char **arg)
{
  return new FixRigidClaim(lmp, narg, arg);
}

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  lammpsplugin_t plugin{};
  plugin.version = LAMMPS_VERSION;
  plugin.style = "fix";
  plugin.name = "rigid/claim";
  plugin.info = "claims to hold rigid bodies";
  plugin.author = "tests of SUSPENSION";
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create;
  plugin.handle = handle;
  (*(lammpsplugin_regfunc) regfunc)(&plugin, lmp);
}
