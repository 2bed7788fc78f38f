/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Arguments of fix pore/pressure.

#ifndef LMP_FIX_PORE_PRESSURE_SETTINGS_H
#define LMP_FIX_PORE_PRESSURE_SETTINGS_H

#include "fix_pore_pressure_solver.h"
#include "suspension_input.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

struct PoreSettings {
  using Number = Suspension_NS::InputNumber;

  bool viscosity_of_pair = false;
  Number viscosity;
  double spacing = 0.0;    // length; 0: from the size of the particles
  int elements[3] = {};    // 0: from the spacing
  Pore_NS::Permeability law;
  std::string plates;    // ID of a fix rheometer/plates, empty: periodic cell
  Pore_NS::Wall lower = Pore_NS::Wall::PERIODIC, upper = Pore_NS::Wall::PERIODIC;
  Number drained;          // pressure at drained plates, LAMMPS' units
  double storage = 0.0;    // 1/pressure, LAMMPS' units
  enum Mean { DRAINED, UNDRAINED, LAYER };
  Mean mean = DRAINED;    // pressure of a periodic cell
  double layer = 0.0;     // height of Mean::LAYER
  Number gradient[3];     // mean one, LAMMPS' pressure over length
  PoreSolver::Coupling coupling = PoreSolver::Coupling::IMPLICIT;
  bool network = false, iterate = false;
  bool even = false;     // solver mean: a layer that dilates evenly, without a grid
  double alpha = 0.0;    // factor of the conductances of a network; 0: auto
  double tolerance = 1e-8;
  int every = 20;    // steps that particles keep their weights

  std::vector<Number *> numbers()
  {
    return {&viscosity, &drained, &gradient[0], &gradient[1], &gradient[2]};
  }
};

}    // namespace LAMMPS_NS

#endif
