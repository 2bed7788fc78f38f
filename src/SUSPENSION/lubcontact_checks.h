/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What a deck asks of pair style lubcontact, held against what can act; and what the host must be
// like.

#ifndef LMP_LUBCONTACT_CHECKS_H
#define LMP_LUBCONTACT_CHECKS_H

#include <string>
#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {
struct Law;
struct Settings;
}    // namespace LAMMPS_NS::Lubcontact_NS

namespace LAMMPS_NS {
class LAMMPS;
class Pair;

namespace lubcontact_checks {

  // why an effect that is switched on does nothing at present; empty: it acts
  std::string idle(const Lubcontact_NS::Law &, unsigned effect);

  // coefficients that never will: friction an error, asperities a warning
  void check_coefficients(LAMMPS *, const Lubcontact_NS::Law &, bool viscosity_varies);

  // a repulsion that jumps where pairs come into range: a warning
  void check_repulsion(LAMMPS *, const Lubcontact_NS::Law &, double smallest_radius);

  // residual films without the far field that they are left of, and more
  void check_residual(LAMMPS *, const Lubcontact_NS::Settings &);

  // or of spheres that differ more than what is known of them: a warning
  void check_sizes(LAMMPS *, const Lubcontact_NS::Settings &, double smallest_radius,
                   double largest_radius);

  // forces that others would scale: an error
  void check_factors(LAMMPS *);

  // other pair styles that act on the same pairs: a warning
  void check_hybrid(LAMMPS *, const Pair *, const Lubcontact_NS::Law &);

  // what moves the particles in a way that cannot be meant: a warning
  void check_motion(LAMMPS *, unsigned effects);

  // dashpots between particles that move without inertia: an error
  void check_restitution(LAMMPS *, unsigned effects);

  // a skin of the neighbor list that was not meant for particles of this size: a warning
  void check_skin(LAMMPS *, double largest_radius);

  // a cell in which a pair could meet through two images, `longest` being its range: an error
  void check_box(LAMMPS *, double longest);

  // positions that are no numbers; radii beyond those for which the list was made: errors
  void check_positions(LAMMPS *);
  void check_radii(LAMMPS *, const std::vector<double> &max_radius);

  // largest radius of each type, those that fix pour and deposit will insert included
  std::vector<double> find_max_radius(LAMMPS *);

  // largest stable time step of springs whose sum over the partners of each atom is given:
  // omega_max^2 <= 2 max_i sum_j k_ij/m_i (Gershgorin)
  double step_limit(LAMMPS *, const std::vector<double> &stiffness);

}    // namespace lubcontact_checks
}    // namespace LAMMPS_NS

#endif
