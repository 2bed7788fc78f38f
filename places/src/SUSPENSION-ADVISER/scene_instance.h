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

namespace LAMMPS_NS::Lubcontact_NS {
struct Law;
}

namespace LAMMPS_NS {
class BackgroundFluid;
class Fix;
class LAMMPS;
class PairLubcontact;

// A second LAMMPS on the ranks of the first, with a copy of its sheared suspension under a pair law
// that may be another: what happens in there leaves the first one alone, which is only read.
// Silent; its errors are thrown.
class SceneInstance {
 public:
  // what can be copied; errors name what cannot
  struct Parts {
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
    Fix *pores = nullptr;        // fix pore/pressure, among them
    Fix *far = nullptr;          // fix hydro, among them
    bool overdamped = false;     // and the drag moves the particles
  };
  struct Fluids {    // that a copy has
    bool drag = true, pores = true, far = true;
  };
  static constexpr const char *CURE = "suspension_scene without measure works; or "
                                      "compare two runs of your own, with the effect and without";
  static Parts parts_of(LAMMPS *);
  static double deform_rate(LAMMPS *);
  static const BackgroundFluid *background_of(const Fix *);    // null: it has none

  SceneInstance(LAMMPS *, const Parts &, const Lubcontact_NS::Law &, const Fluids &);
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
  void copy_neighbor_style() const;
  void copy_atoms() const;
  void adopt_law(const Lubcontact_NS::Law &) const;
  void copy_fixes(const Parts &, const Fluids &) const;
  void copy_state(Fix *) const;
  void copy_history(const PairLubcontact *, const Lubcontact_NS::Law &);
  void migrate() const;
};

}    // namespace LAMMPS_NS

#endif
