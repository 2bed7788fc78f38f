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
  HydroWaves(LAMMPS *);
  ~HydroWaves() override;

  void fit(double spacing);    // to the present cell
  const Hydro_NS::Lattice &lattice() const { return grid; }
  void set_response(const std::function<Hydro_NS::WaveFactors(const Hydro_NS::WaveVector &)> &);

  // of the lattice coordinates of some particles; false without any
  bool corners(const std::vector<int> &atoms, Hydro_NS::Vec3 &low, Hydro_NS::Vec3 &high) const;
  void set_brick(const Hydro_NS::Brick &);    // all ranks together
  const Hydro_NS::Brick &brick() const { return mine; }

  std::vector<double> field;    // of the brick
  void solve();
  double memory_usage() const;

 private:
  Hydro_NS::Lattice grid;
  Hydro_NS::Brick mine;
  std::unique_ptr<HydroTransforms> transforms;
  std::vector<Hydro_NS::Brick> bricks;    // of all ranks
  std::vector<double> out, in;
  std::vector<int> sent, sent_from, received, received_from;

  Hydro_NS::Points points() const { return {grid.nx, grid.ny, grid.nz}; }
};

}    // namespace LAMMPS_NS

#endif
