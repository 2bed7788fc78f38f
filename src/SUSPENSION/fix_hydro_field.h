/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_HYDRO_FIELD_H
#define LMP_FIX_HYDRO_FIELD_H

#include "fix_hydro_waves.h"
#include "hydro_pairs.h"
#include "hydro_spread.h"
#include "hydro_wide.h"
#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

class Fix;
class NeighList;

// The mobility of the particles of a group, on the ranks that have them: loads on the fluid to
// velocities. Each rank spreads its own particles to a brick of the grid and solves for some layers
// of the whole grid.
class HydroField : protected Pointers {
 public:
  struct Settings {
    double width = 1.0;      // over the mean radius; the others over that width
    double spacing = 0.9;    // of the grid
    double reach = 5.0;      // of pairs
    int points = 6;          // of the splines
  };

  HydroField(LAMMPS *, Fix *);
  ~HydroField() override;
  static bool has_library();
  static const char *const NO_LIBRARY;

  const std::vector<int> &particles() const { return members; }    // of this rank, in prepare()

  // the present particles and cell; pairs from a half list with Newton's law that reaches as far
  void prepare(const Settings &, int groupbit, double mean_radius, double viscosity, NeighList *);

  // for the particles of this rank: NUMBERS each, those of others 0
  void apply(const double *loads, double *motions);

  // what a load alone does to its own sphere
  const Hydro_NS::Self &self(int i) const { return of_sphere[i]; }

  // communication of the fix
  int pack_loads(int n, const int *list, double *buf) const;
  void unpack_loads(int n, int first, const double *buf);
  int pack_motions(int n, int first, double *buf) const;
  void unpack_motions(int n, const int *list, const double *buf);

  double memory_usage() const;

 private:
  Fix *fix;
  double width, eta;
  HydroWaves waves;
  std::vector<Hydro_NS::OnGrid> on_grid;    // members
  std::vector<int> members;                 // of this rank
  std::vector<Hydro_NS::Body> bodies;       // of all particles and ghosts
  std::vector<Hydro_NS::Self> of_sphere, missing;
  std::vector<Hydro_NS::PairBlock> pairs;
  std::vector<double> load, motion;    // of ghosts, too
  std::vector<Hydro_NS::Load> loads;
  std::vector<Hydro_NS::Motion> motions;

  void find_members(int groupbit);
  void find_pairs(double cut, int groupbit, NeighList *);
  void add_far();
  void add_near();
};

}    // namespace LAMMPS_NS

#endif
