/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(suspension_scene,SuspensionScene);
// clang-format on
#else

#ifndef LMP_SUSPENSION_SCENE_H
#define LMP_SUSPENSION_SCENE_H

#include "command.h"

namespace LAMMPS_NS {

// Which effects a scene needs: from its numbers (scene_adviser), or measured in copies of it
// (scene_measurement). Only reads the system.
class SuspensionScene : public Command {
 public:
  SuspensionScene(class LAMMPS *lmp) : Command(lmp) {}
  void command(int, char **) override;
};

}    // namespace LAMMPS_NS

#endif
#endif
