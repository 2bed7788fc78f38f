/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the styles of the package ask of the LAMMPS that they run in: who else is here, what the
// cell and the particles are, what every style demands. Knows no style of the package.

#ifndef LMP_SUSPENSION_HOST_H
#define LMP_SUSPENSION_HOST_H

#include "lubcontact_strain.h"

#include <array>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class Domain;
class LAMMPS;
class Pair;
}    // namespace LAMMPS_NS

namespace LAMMPS_NS::Suspension_NS {

// ---- who else is here

std::vector<Pair *> all_lubcontact(LAMMPS *);    // pair style lubcontact, all sub-styles of hybrid

// viscosity of their fluid, pressure*time over LAMMPS' unit of pressure; null without them, if it
// is a variable, or if they do not agree
const double *viscosity_of_pair(LAMMPS *);
std::string why_no_viscosity(LAMMPS *);    // then, in words

// bits of the groups that a fix overdamped/sphere moves: their particles have no inertia
int groups_without_inertia(LAMMPS *);

// ---- the cell and the particles; in 2d an area for a volume, and discs

double cell_volume(const Domain *);
double particle_volume(const Domain *, double radius);

// of all particles with a radius: under hybrid others are points. Radii are 0 without any
struct Particles {
  double number = 0.0, mass = 0.0;
  double smallest = 0.0, largest = 0.0, mean = 0.0;    // radii
  double density = 0.0;                                // mean, of spheres
};
Particles measure_particles(LAMMPS *);

// distance of opposite faces, along x, y and z
std::array<double, 3> cell_heights(const Domain *);

// velocity gradient L of the deforming cell, upper triangular as the cell is: dv_x/dy is xy
struct CellGradient {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;
};
CellGradient cell_gradient(const Domain *);
Lubcontact_NS::Strain cell_strain(const Domain *);    // without a change of volume

// Velocity of the deforming cell at this moment; 0 if it does not deform.
class CellFlow {
 public:
  explicit CellFlow(const Domain *);
  std::array<double, 3> at(const double *x) const
  {
    const double r[3] = {x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]};
    return {at_origin[0] + gradient.xx * r[0] + gradient.xy * r[1] + gradient.xz * r[2],
            at_origin[1] + gradient.yy * r[1] + gradient.yz * r[2],
            at_origin[2] + gradient.zz * r[2]};
  }

 private:
  CellGradient gradient;
  std::array<double, 3> origin{}, at_origin{};
};

// A sum over particles as it was, if the new one differs by rounding alone: another order of the
// particles then leaves a continued run as it is.
constexpr double SUM_ROUNDING = 1e-12;
inline bool is_same_sum(double before, double now)
{
  return (now > before ? now - before : before - now) <= SUM_ROUNDING * (now > 0.0 ? now : -now);
}

// ---- what every style demands; who: "Fix drag/background"

void require_spheres(LAMMPS *, const std::string &who);    // errors with their cure
void require_verlet(LAMMPS *, const std::string &who);

}    // namespace LAMMPS_NS::Suspension_NS

#endif
