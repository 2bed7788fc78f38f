/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_PLATES_STATE_H
#define LMP_PLATES_STATE_H

#include "rheometer_mean.h"

namespace LAMMPS_NS {

// What fix rheometer/plates writes to a restart file: numbers only.
struct PlatesState {
  double gap = 0.0, vx = 0.0, vy = 0.0;    // gap 0: not yet known
  double strain = 0.0, rate = 0.0;         // rate of the last step
  double drive = 0.0, load = 0.0;          // what it belongs to, and the oscillation
  double amplitude = 0.0, frequency = 0.0;
  double clock = 0.0;       // time since the oscillation was set
  double dilation = 0.0;    // of the servo, 1/time
  double deviation_x = 0.0, age_x = 0.0, warned_x = 0.0;
  double deviation_y = 0.0, age_y = 0.0, warned_y = 0.0;
  double code_x = 0.0, code_y = 0.0;       // Rheometer_NS::State
  double solid = 0.0;                      // volume of the suspended particles
  double density = 0.0, diameter = 0.0;    // and their means
  double plate_mass = 0.0;                 // of the particles of the upper plate
  Rheometer_NS::StrainMeans means;         // of the plates
};

}    // namespace LAMMPS_NS

#endif
