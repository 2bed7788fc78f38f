/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The table that pair style lubcontact prints at the start of a run: what is simulated.

#ifndef LMP_LUBCONTACT_REPORT_H
#define LMP_LUBCONTACT_REPORT_H

#include "lubcontact_law.h"
#include "suspension_host.h"

#include <string>

namespace LAMMPS_NS {

struct LubcontactRun {
  unsigned effects;
  int history;          // doubles of a pair
  double pairs;         // in range
  double step_limit;    // infinite: none
  Suspension_NS::Particles particles;
};

// variable: that of the viscosity, empty for a number
void report_lubcontact(LAMMPS *, const Lubcontact_NS::Law &, const std::string &variable,
                       const LubcontactRun &);

}    // namespace LAMMPS_NS

#endif
