/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_SCENE_INSTANCE_H
#define LMP_SCENE_INSTANCE_H

#include <string>
#include <vector>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
class PairLubcontact;

// A second LAMMPS on the ranks of the first, with a copy of its sheared suspension: what happens in
// there leaves the first one alone, which is only read. Silent; its errors are thrown.
class SceneInstance {
 public:
  // what can be copied; errors name what cannot
  struct Plan {
    PairLubcontact *pair = nullptr;
    Fix *flow = nullptr;    // deform/rheometer, or deform of the tilt xy
    double rate = 0.0;      // of deform
    std::vector<Fix *> movers;
  };
  static Plan plan(LAMMPS *);
  static double deform_rate(LAMMPS *);

  SceneInstance(LAMMPS *, const Plan &, const std::vector<std::string> &without);
  ~SceneInstance();
  SceneInstance(const SceneInstance &) = delete;
  SceneInstance &operator=(const SceneInstance &) = delete;

  void one(const std::string &) const;    // a command
  LAMMPS *lmp;
  bool history_kept;    // or films and springs build up anew

 private:
  LAMMPS *original;
  void set_up() const;
  void copy_box() const;
  void copy_atoms() const;
  void copy_pair(const Plan &, const std::vector<std::string> &) const;
  void copy_fixes(const Plan &) const;
  void copy_history(const PairLubcontact *);
  void migrate() const;
};

}    // namespace LAMMPS_NS

#endif
