/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_SCENE_MEASUREMENT_H
#define LMP_SCENE_MEASUREMENT_H

#include "lubcontact_law.h"
#include "pointers.h"
#include "scene_instance.h"
#include "scene_laws.h"

#include <string>

namespace LAMMPS_NS {

// Advice from runs of copies of the system: with everything on, and without each effect in turn.
class SceneMeasurement : protected Pointers {
 public:
  explicit SceneMeasurement(LAMMPS *lmp) : Pointers(lmp) {}
  std::string advice(int, char **);    // measure N keyword values ...

 private:
  using Parts = SceneInstance::Parts;
  struct Case {    // what acts in a copy
    Lubcontact_NS::Law law;
    SceneInstance::Fluids fluids;
  };
  struct Options {    // what the script asks for
    int nsteps = 0;
    double limit = 0.02;
    Scene_NS::SurfaceLaws laws;                  // that the deck need not have
    int critical_word = 0, adhesion_word = 0;    // where they are, 0: nowhere
  };
  static constexpr int BLOCKS = 10;    // of a run; the second half counts
  struct Measured;
  struct Row;
  struct Comparison;

  Options parse(int, char **) const;
  void check_laws(const Options &, const Lubcontact_NS::Law &) const;
  Measured run_copy(const Parts &, int, const Case &) const;
  std::string deck_lines(const Parts &, const Case &) const;
  static std::string why_it_stays(const Row &, const Parts &, const Case &);
  std::string leave_out_in_turn(const Parts &, const Options &) const;
  std::string head_of(const Parts &, const Measured &, int, bool) const;
};

}    // namespace LAMMPS_NS

#endif
