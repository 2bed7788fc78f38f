/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_SCENE_INSTANCE_H
#define LMP_SCENE_INSTANCE_H

#include "pair_lubcontact.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {
class BackgroundFluid;
class Fix;
class LAMMPS;

// A second LAMMPS on the ranks of the first, with a copy of its sheared suspension: what happens in
// there leaves the first one alone, which is only read. Silent; its errors are thrown.
class SceneInstance {
 public:
  // what can be copied; errors name what cannot
  struct Plan {
    PairLubcontact *pair = nullptr;
    Fix *flow = nullptr;    // deform/rheometer, or deform of the tilt xy
    double rate = 0.0;      // of deform
    bool holds_rate = true, holds_pressure = false;
    struct Part {
      Fix *fix;
      std::string settings;
    };
    std::vector<Part> fixes;     // in their order
    std::vector<Fix *> drags;    // among them
    bool overdamped = false;     // and the drag moves the particles
  };
  // what acts in the copy
  struct Effects {
    bool everything = true;              // or as the deck is
    PairLubcontact::Laws laws{};         // that the deck need not have
    double radius = 1.0;                 // of their pull-off force
    std::vector<std::string> without;    // PairLubcontact::EFFECTS and DRAG
  };
  static constexpr const char *DRAG = "drag";
  static constexpr const char *CURE = "the advice without the word measure works here, too; or "
                                      "compare two runs of your own, with the effect and without";
  static Plan plan(LAMMPS *);
  static double deform_rate(LAMMPS *);
  static const BackgroundFluid *background_of(const Fix *);    // null: it has none

  SceneInstance(LAMMPS *, const Plan &, const Effects &);
  ~SceneInstance();
  SceneInstance(const SceneInstance &) = delete;
  SceneInstance &operator=(const SceneInstance &) = delete;

  void one(const std::string &) const;    // a command
  LAMMPS *lmp;
  bool history_kept;    // or films and springs build up anew

 private:
  LAMMPS *original;
  static void check_system(LAMMPS *);
  void set_up() const;
  void copy_box() const;
  void copy_atoms() const;
  void copy_pair(const Plan &, const Effects &) const;
  void copy_fixes(const Plan &, const Effects &) const;
  void copy_state(Fix *) const;
  void copy_history(const PairLubcontact *);
  void migrate() const;
};

}    // namespace LAMMPS_NS

#endif
