/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_LUBCONTACT_CHECKS_H
#define LMP_PAIR_LUBCONTACT_CHECKS_H

#include <string>

// What a deck asks of pair style lubcontact, held against what can act.

namespace LAMMPS_NS {
class LAMMPS;
class PairLubcontact;

namespace lubcontact_checks {

  // can the surfaces of types i and j touch? Smooth ones do not through a squeeze film
  bool can_touch(PairLubcontact *, int i, int j);

  // why an effect that is switched on does nothing at present; empty: it acts
  std::string idle(LAMMPS *, PairLubcontact *, const std::string &effect);

  // coefficients that never will: friction an error, asperities a warning
  void check_coefficients(LAMMPS *, PairLubcontact *);

  // other pair styles that act on the same pairs: a warning, or an error
  void check_hybrid(LAMMPS *, PairLubcontact *);

  // a skin of the neighbor list that was not meant for particles of this size: a warning
  void check_skin(LAMMPS *, double largest_radius);

}    // namespace lubcontact_checks
}    // namespace LAMMPS_NS

#endif
