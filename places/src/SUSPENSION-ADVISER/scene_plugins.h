/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_SCENE_PLUGINS_H
#define LMP_SCENE_PLUGINS_H

#include "error.h"
#include "lammps.h"
#if defined(LMP_PLUGIN)
#include "plugin.h"
#endif

#include <vector>

namespace LAMMPS_NS {

// Until 2026 the destructor of any LAMMPS unloads all plugins, those that other instances use and
// the one that runs now: hide them meanwhile.
class KeepPlugins {
 public:
#if defined(LMP_PLUGIN)
  explicit KeepPlugins(LAMMPS *user) : lmp(user)
  {
    for (int n = 0; n < plugin_get_num_plugins(); n++) plugins.push_back(*plugin_get_info(n));
    for (const auto &plugin : plugins) plugin_erase(plugin.style, plugin.name);
  }
  ~KeepPlugins()
  {
    FILE *screen = lmp->screen, *logfile = lmp->logfile;
    const int warned = lmp->error->get_numwarn();
    lmp->screen = lmp->logfile = nullptr;    // it would report them as loaded again
    for (auto &plugin : plugins) plugin_register(&plugin, lmp);
    lmp->error->set_numwarn(warned);
    lmp->screen = screen;
    lmp->logfile = logfile;
  }

 private:
  LAMMPS *lmp;
  std::vector<lammpsplugin_t> plugins;
#else
  explicit KeepPlugins(LAMMPS *) {}
#endif
};

}    // namespace LAMMPS_NS

#endif
