/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Tangential mode: Maxwell film with Coulomb friction of the asperities in parallel.
//   F = -kt q,  dq/dt = slip rate                          while the contact sticks
//   nu_t (slip rate - dq/dt) = kt q - (mu N) q/|q|         while it slips, or N = 0 without contact
// Model: W. Chevremont, H. Bodiguel, B. Chareyre, Powder Technol. 372, 600 (2020), eqs. 23-33, with
// the sign of eqs. 26 and 31 corrected. In time: second order, but first where a slip turns.

#ifndef LUBCONTACT_SHEAR_H
#define LUBCONTACT_SHEAR_H

#include "lubcontact_defs.h"
#include "lubcontact_maxwell.h"
#include "lubcontact_vec3.h"

namespace LAMMPS_NS::Lubcontact_NS {

enum class ContactState { NONE, STICK, SLIP };

// q after a step.
//   q0      elastic displacement, already turned with the pair
//   slip    tangential displacement of the step
//   cone0, cone    mu N/kt before and after: longest elastic displacement that friction alone can
//                  hold; 0 without contact
//   resistance, stiffness_dt    of the film (0: none) and kt dt
LUBCONTACT_FN inline Vec3 next_shear(const Vec3 &q0, const Vec3 &slip, double cone0, double cone,
                                     double resistance, double stiffness_dt)
{
  const Vec3 trial = q0 + slip;
  const double far = norm(trial), near = norm(q0);

  // what is beyond the cone, which moves with the load, is the film's and relaxes. A slip that
  // begins inside sticks until the border and slips for the share last/moved of the step; only
  // stiffness dt/resistance counts
  const double first = near - cone0, last = far - cone, moved = last - first;
  const bool slips = far > cone;
  const bool inside = (first < 0.0) & (cone > 0.0) & slips;
  const Relaxation f =
      relaxation(resistance * (inside ? moved : 1.0), stiffness_dt * (inside ? last : 1.0));
  // slip along the trial direction
  const double left = larger(0.0, f.keep * first + f.gain * moved);
  const double size = cone + (inside ? f.gain * last : left);
  const double ratio = size / larger(far, larger(cone, 1e-300));    // of use where far is more
  const Vec3 rubbed = (slips ? ratio : 1.0) * trial;    // stick: the film carries nothing
  return select(cone > 0.0, rubbed, f.keep * q0 + f.gain * slip);
}

// State and share of the friction in the tangential force, from the elastic displacement alone.
struct ShearSplit {
  ContactState state;
  double contact;    // friction over the whole tangential force, 0 to 1; the rest is the film
};

LUBCONTACT_FN inline ShearSplit shear_split(const Vec3 &q, double cone, bool touching)
{
  if (!touching) return {ContactState::NONE, 0.0};
  const double size = norm(q);
  // a slip without film returns to the cone only to rounding
  if (size < cone * (1.0 - 1e-12)) return {ContactState::STICK, 1.0};
  return {ContactState::SLIP, size > 0.0 ? smaller(cone / size, 1.0) : 1.0};
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
