/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_HYDRO_PRECONDITION_H
#define LMP_FIX_HYDRO_PRECONDITION_H

#include "fix_hydro_waves.h"
#include "hydro_spread.h"
#include "hydro_wide.h"

namespace LAMMPS_NS {

class HydroField;

// Approximate loads from motions, for conjugate gradients: see hydro_precondition.h.
class HydroPreconditioner : protected Pointers {
 public:
  explicit HydroPreconditioner(LAMMPS *);

  // the particles that the field has prepared
  void prepare(const HydroField &, double mean_radius);
  double phi() const { return fraction; }      // their volume fraction
  std::vector<double> find_neighborhoods();    // that about each of the particles of the field

  // NUMBERS of each particle of this rank, and of others 0
  void apply(const double *motions, double *loads);
  void apply_alone(const double *motions, double *loads) const;    // of each sphere alone

  double memory_usage() const;

 private:
  HydroWaves waves;
  std::vector<Hydro_NS::OnGrid> members;
  std::vector<Hydro_NS::Self> selves;    // of each of them
  std::vector<double> weights;
  std::vector<Hydro_NS::Load> loads;    // of the particles of this rank
  std::vector<Hydro_NS::Motion> motions;
  double fraction;

  void find_weights(double mean_radius, double resistance);
  void through_grid();    // loads to motions
};

}    // namespace LAMMPS_NS

#endif
