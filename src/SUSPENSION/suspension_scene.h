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

#include <memory>
#include <string>
#include <vector>

namespace scene {
struct Numbers;
struct Scene;
struct Verdict;
}    // namespace scene

namespace LAMMPS_NS {
class PairLubcontact;

// Only reads the system.
class SuspensionScene : public Command {
 public:
  SuspensionScene(class LAMMPS *);
  ~SuspensionScene() override;
  void command(int, char **) override;

 protected:
  // advice from the numbers of the scene
  std::unique_ptr<scene::Scene> scene;
  PairLubcontact *pair;    // or null
  bool walls;
  void parse(int, char **);
  void read_particles();
  void read_box();
  void read_pair();
  void read_flow();
  void read_plates();
  void report() const;
  std::string describe(const scene::Numbers &) const;
  std::string drag_line() const;
  std::string deck_lines(const scene::Numbers &, const std::vector<scene::Verdict> &) const;

  // advice from a run of a copy
  struct Measured;
  void measure(int, char **);
  std::string leave_out_in_turn(const PairLubcontact *, int, double) const;
  Measured run_copy(int, const std::vector<std::string> &) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
