/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Entry point of the plugin: LAMMPS calls lammpsplugin_init() when it loads suspensionplugin.so.

#include "compute_microstructure.h"
#include "compute_power_partition.h"
#include "compute_stress_partition.h"
#include "compute_stress_partition_atom.h"
#include "fix_deform_rheometer.h"
#include "fix_drag_background.h"
#include "fix_hydro.h"
#include "fix_neigh_history_lubcontact.h"
#include "fix_neigh_history_place.h"
#include "fix_overdamped_sphere.h"
#include "fix_pore_pressure.h"
#include "fix_rheometer_plates.h"
#include "pair_lubcontact.h"
#include "suspension_history.h"
#ifdef SUSPENSION_ADVISER
#include "suspension_scene.h"
#endif

#include "lammpsplugin.h"
#include "library.h"
#include "version.h"

#include <string>

using namespace LAMMPS_NS;

namespace {

// creators as LAMMPS wants them; it casts the result to Base *, hence the conversion before void *

template <class Base, class Style> void *create(void *lmp)
{
  return static_cast<Base *>(new Style(static_cast<LAMMPS *>(lmp)));
}

template <class Base, class Style> void *create_with_args(void *lmp, int narg, char **arg)
{
  return static_cast<Base *>(new Style(static_cast<LAMMPS *>(lmp), narg, arg));
}

// LAMMPS merely reports a version mismatch, and not even that when it loads plugins by itself.
// The layout of its classes differs between versions, hence only its C functions are used here.

void refuse_other_version(void *lmp)
{
  if (lammps_version(lmp) == LAMMPS_VERNUM) return;

  const auto message = "Cannot use the SUSPENSION plugin: it was compiled for LAMMPS version " +
      std::to_string(LAMMPS_VERNUM) + ", this is version " + std::to_string(lammps_version(lmp)) +
      ". Compile the plugin with the sources of this LAMMPS (CMake option LAMMPS_SOURCE_DIR).";
  lammps_error(lmp, LMP_ERROR_ALL | LMP_ERROR_WORLD, message.c_str());
}

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  refuse_other_version(lmp);

  lammpsplugin_t plugin{};
  plugin.version = LAMMPS_VERSION;
  plugin.info = "SUSPENSION: dense suspensions with lubricated contacts";
  plugin.author = "the SUSPENSION authors";
  plugin.handle = handle;
  const auto register_plugin = reinterpret_cast<lammpsplugin_regfunc>(regfunc);

  const auto without_args = [&](const char *style, const char *name,
                                lammpsplugin_factory1 *creator) {
    plugin.style = style;
    plugin.name = name;
    plugin.creator.v1 = creator;
    register_plugin(&plugin, lmp);
  };
  const auto with_args = [&](const char *style, const char *name, lammpsplugin_factory2 *creator) {
    plugin.style = style;
    plugin.name = name;
    plugin.creator.v2 = creator;
    register_plugin(&plugin, lmp);
  };

  without_args("pair", "lubcontact", &create<Pair, PairLubcontact>);
  without_args("command", "suspension_history", &create<Command, SuspensionHistory>);
#ifdef SUSPENSION_ADVISER
  without_args("command", "suspension_scene", &create<Command, SuspensionScene>);
#endif
  with_args("compute", "microstructure", &create_with_args<Compute, ComputeMicrostructure>);
  with_args("compute", "power/partition", &create_with_args<Compute, ComputePowerPartition>);
  with_args("compute", "stress/partition", &create_with_args<Compute, ComputeStressPartition>);
  with_args("compute", "stress/partition/atom",
            &create_with_args<Compute, ComputeStressPartitionAtom>);
  with_args("fix", "NEIGH_HISTORY/LUBCONTACT", &create_with_args<Fix, FixNeighHistoryLubcontact>);
  with_args("fix", "NEIGH_HISTORY/LUBCONTACT/PLACE", &create_with_args<Fix, FixNeighHistoryPlace>);
  with_args("fix", "deform/rheometer", &create_with_args<Fix, FixDeformRheometer>);
  with_args("fix", "drag/background", &create_with_args<Fix, FixDragBackground>);
  with_args("fix", "hydro", &create_with_args<Fix, FixHydro>);
  with_args("fix", "overdamped/sphere", &create_with_args<Fix, FixOverdampedSphere>);
  with_args("fix", "pore/pressure", &create_with_args<Fix, FixPorePressure>);
  with_args("fix", "rheometer/plates", &create_with_args<Fix, FixRheometerPlates>);
}
