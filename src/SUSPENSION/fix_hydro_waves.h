/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_HYDRO_WAVES_H
#define LMP_FIX_HYDRO_WAVES_H

#include "hydro_layers.h"
#include "hydro_spline.h"
#include "hydro_waves.h"
#include "pointers.h"

#include <functional>
#include <memory>
#include <vector>

namespace LAMMPS_NS {

struct HydroTransforms;

// A vector field on a grid that all ranks share. Each of them adds to a brick of it, whatever its
// particles reach; then all solve together, each for some layers of the whole grid, and the brick
// has the response.
class HydroWaves : protected Pointers {
 public:
  HydroWaves(LAMMPS *, int components);
  ~HydroWaves() override;

  void fit(double spacing, int points);    // to the present cell; with splines of so many points
  const Hydro_NS::Lattice &lattice() const { return grid; }
  const Hydro_NS::LatticeGradients &gradients() const { return to; }

  // Of densities to their means: what the splines do to a wave is taken out of it.
  void set_response(const std::function<Hydro_NS::WaveFactors(const Hydro_NS::WaveVector &)> &);

  void reach_for(const std::vector<int> &atoms);    // of this rank; all ranks together
  const Hydro_NS::Brick &brick() const { return mine; }
  Hydro_NS::Spline spline(int atom) const;

  std::vector<double> field;    // of the brick
  void solve();
  double memory_usage() const;

 private:
  int order;
  const int components;
  Hydro_NS::Lattice grid;
  Hydro_NS::LatticeGradients to;
  Hydro_NS::Brick mine;
  std::unique_ptr<HydroTransforms> transforms;
  std::vector<Hydro_NS::Brick> bricks;    // of all ranks
  std::vector<double> out, in;
  std::vector<int> sent, sent_from, received, received_from;

  Hydro_NS::Points points() const { return {grid.nx, grid.ny, grid.nz}; }
};

}    // namespace LAMMPS_NS

#endif
