/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Moments of inertia with which fix nve/sphere turns the particles: spheres or discs.

#ifndef LMP_SPIN_INERTIA_H
#define LMP_SPIN_INERTIA_H

#include <utility>
#include <vector>

namespace LAMMPS_NS {

class SpinInertia {
 public:
  void find(class LAMMPS *);             // anew when fixes may have changed
  double of(class Atom *, int) const;    // of particle i, mass*length^2

 private:
  std::vector<std::pair<int, double>> movers;    // group bit, inertia over m R^2
};

}    // namespace LAMMPS_NS

#endif
