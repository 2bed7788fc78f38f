/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_SCENE_ADVISER_H
#define LMP_SCENE_ADVISER_H

#include "pointers.h"
#include "scene_laws.h"
#include "scene_numbers.h"
#include "scene_verdict.h"

#include <string>
#include <vector>

namespace LAMMPS_NS::Rheometer_NS {
struct StrainMeans;
}

namespace LAMMPS_NS::Scene_NS {
struct Plan;
struct Settling;
}    // namespace LAMMPS_NS::Scene_NS

namespace LAMMPS_NS {
class PairLubcontact;

// Advice from the numbers of the scene: reads them, has them judged, writes what they say.
class SceneAdviser : protected Pointers {
 public:
  explicit SceneAdviser(LAMMPS *);
  std::string advice(int, char **);

 private:
  Scene_NS::Scene scene;
  PairLubcontact *pair = nullptr;    // or none
  Lubcontact_NS::Law law;            // that it has
  bool walls = false;
  bool limit_known = false;    // of the time step, from the last run
  struct {
    bool used = false;                   // is the pressure of the scene
    double strain = 0.0;                 // that the mean spans; too short: not used
    double deviation = 0.0;              // of single values
    double first = 0.0, second = 0.0;    // means of its halves
  } measured;
  std::string gravity;                     // IDs of the fixes
  double total_mass = 0.0;                 // of the particles
  std::string overridden;                  // words given that are other than in the pair style
  double screening = Scene_NS::UNKNOWN;    // length of the repulsion, if the script gives it
  double tolerance = Scene_NS::UNKNOWN;    // of the viscosity
  bool brief = false;                      // verdicts and lines only

  // what the script says
  struct Keyword;
  std::vector<Keyword> keywords();
  double number(char **, int, const char *, bool) const;
  void take(const Keyword &, int, char **);
  void parse(int, char **);

  // what is found in the system
  void read_particles();
  void read_box();
  void read_pair();
  void read_flow();
  void read_plates();
  void read_pressure(const Rheometer_NS::StrainMeans &, double);
  void read_gravity();
  bool falls() const;
  bool overdamped() const;

  // what is printed
  std::string report() const;
  std::string advice_for_falling() const;
  std::string advice_for_shear() const;
  std::string table(const std::vector<Scene_NS::Verdict> &) const;
  std::string describe() const;
  std::string describe_pressure() const;
  std::string describe_numbers() const;
  std::string describe_settling(const Scene_NS::Settling &) const;
  std::string advice_on_pores() const;
  std::string doubts_of_pressure() const;

  // lines for the input script
  std::string law_words(const std::vector<Scene_NS::Verdict> &) const;
  std::string drag_line() const;
  std::string fluid_line(const std::vector<Scene_NS::Verdict> &) const;
  std::string viscosity_word() const;
  std::string room_for_inertia(bool) const;
  std::string deck_lines(const std::vector<Scene_NS::Verdict> &) const;

  // settings for a tolerance
  std::string plan_text(const Scene_NS::Plan &) const;
  std::string stiffer_coeffs(double) const;
  std::string tolerance_lines() const;
};

}    // namespace LAMMPS_NS

#endif
