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
#include "scene_instance.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS::Rheometer_NS {
struct StrainMeans;
}

namespace LAMMPS_NS::Scene_NS {
struct Numbers;
struct Plan;
struct Scene;
struct Settling;
struct Verdict;
}    // namespace LAMMPS_NS::Scene_NS

namespace LAMMPS_NS {

// Only reads the system.
class SuspensionScene : public Command {
 public:
  SuspensionScene(class LAMMPS *);
  ~SuspensionScene() override;
  void command(int, char **) override;

 protected:
  // advice from the numbers of the scene
  std::unique_ptr<Scene_NS::Scene> scene;
  PairLubcontact *pair;    // or null
  bool walls;
  bool limit_known;    // of the time step, from the last run
  struct {
    bool used = false;                   // is the pressure of the scene
    double strain = 0.0;                 // that the mean spans; too short: not used
    double deviation = 0.0;              // of single values
    double first = 0.0, second = 0.0;    // means of its halves
  } measured;
  std::string gravity;       // IDs of the fixes
  double total_mass;         // of the particles
  std::string overridden;    // words given that are other than in the pair style
  double screening;          // length of the repulsion, if the script gives it
  double tolerance;          // of the viscosity, or NaN
  bool brief;                // verdicts and lines only
  struct Keyword;
  std::vector<Keyword> keywords();
  double number(char **, int, const char *, bool) const;
  void take(const Keyword &, int, char **);
  void parse(int, char **);
  void read_particles();
  void read_box();
  void read_pair();
  void read_flow();
  void read_plates();
  void read_pressure(const Rheometer_NS::StrainMeans &, double);
  void read_gravity();
  bool falls() const;
  std::string report() const;
  std::string advice_for_falling() const;
  std::string advice_for_shear() const;
  std::string table(const std::vector<Scene_NS::Verdict> &) const;
  std::string describe() const;
  std::string describe_pressure() const;
  std::string describe_numbers() const;
  std::string describe_settling(const Scene_NS::Settling &) const;
  std::string doubts_of_pressure() const;
  bool overdamped() const;
  std::string law_words(const std::vector<Scene_NS::Verdict> &) const;
  std::string drag_line() const;
  std::string pair_line(const std::vector<Scene_NS::Verdict> &,
                        const std::vector<std::string> &) const;
  std::string room_for_inertia(bool) const;
  std::string deck_lines(const std::vector<Scene_NS::Verdict> &) const;

  // settings for a tolerance
  std::string plan_text(const Scene_NS::Plan &) const;
  std::string stiffer_coeffs(double) const;
  std::string tolerance_lines() const;

  // advice from runs of copies
  struct Measured;
  struct Options;
  void measure(int, char **);
  Options parse_measure(int, char **) const;
  void check_laws(const Options &, const PairLubcontact *) const;
  Measured run_copy(const SceneInstance::Plan &, int, const SceneInstance::Effects &) const;
  std::string deck_lines_of(const PairLubcontact *, const SceneInstance::Plan &, bool) const;
  std::string leave_out_in_turn(const SceneInstance::Plan &, const Options &) const;
  std::string head_of(const SceneInstance::Plan &, const Measured &, int, bool) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
