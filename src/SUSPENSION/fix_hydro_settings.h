/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_HYDRO_SETTINGS_H
#define LMP_FIX_HYDRO_SETTINGS_H

#include "fix_hydro_field.h"

namespace LAMMPS_NS {

// What the arguments of fix hydro grid say.
struct HydroSettings {
  HydroField::Settings field;
  double strain = 0.0025;    // between two solutions
  int every = 0;             // steps between them instead; 0: by strain
  double tolerance = 0.01;
  double hold[2] = {};    // factors of the drag between them; 0: by the volume fraction
};

}    // namespace LAMMPS_NS

#endif
