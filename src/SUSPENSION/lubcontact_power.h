/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Power of a pair by origin: what a step put into its springs and what it turned into heat. From
// the history before and after the step, so that the sum over a run closes the balance of energy:
//     work done on the pair = dissipated + stored,   work = -(F0 + F1)/2 . displacement
// F0 and F1 being the force before and after the step; the rest is the error of the step in the
// kinetic energy, of second order.

#ifndef LUBCONTACT_POWER_H
#define LUBCONTACT_POWER_H

#include "lubcontact_defs.h"
#include "lubcontact_pair.h"

namespace LAMMPS_NS::Lubcontact_NS {

enum PowerOrigin {
  NORMAL_CONTACT,    // bulk and asperities; loses energy in the dashpot, and where an adhesive
                     // contact breaks
  FRICTION_CONTACT,
  SQUEEZE_FILM,
  SHEAR_FILM,
  ROLL_FILM,
  TWIST_FILM,
  REPULSIVE_FORCE,
  NUM_ORIGINS
};

inline constexpr const char *ORIGIN_NAME[NUM_ORIGINS] = {
    "contact/normal", "contact/tangential", "squeeze", "shear", "roll", "twist", "repulsion"};

struct Energies {
  double of[NUM_ORIGINS] = {};
};

// Energy stored in the springs. The one of shear belongs to friction and film as they share its
// force.
template <class E>
LUBCONTACT_FN inline Energies stored_energy(const PairCoeffs &c, const PairGeometry &g,
                                            const Load &load, const double *history)
{
  Energies energy;
  const double all = normal_energy<E::normal>(c.normal, g.a, g.un, load.u, load.touch);
  if constexpr (E::repulsion)
    energy.of[REPULSIVE_FORCE] = repulsion_energy(c.normal.repulsion, load.u);
  energy.of[NORMAL_CONTACT] = all - energy.of[REPULSIVE_FORCE];
  if constexpr (E::tangential) {
    const double shear = 0.5 * dot(load.shear, load.shear) / c.kt, contact = split(load).contact;
    energy.of[FRICTION_CONTACT] = contact * shear;
    energy.of[SHEAR_FILM] = (1.0 - contact) * shear;
  }
  const double kr = c.kt * g.a * g.a;
  if constexpr (E::roll) {
    const Vec3 q = get_vector(history + E::ROLL_SLOT);
    energy.of[ROLL_FILM] = 0.5 * kr * dot(q, q);
  }
  if constexpr (E::twist)
    energy.of[TWIST_FILM] = 0.5 * kr * history[E::TWIST_SLOT] * history[E::TWIST_SLOT];
  return energy;
}

// Lost by a Maxwell spring that moved from q0 to q1 while its ends moved by `moved`.
LUBCONTACT_FN inline double lost(double stiffness, const Vec3 &q0, const Vec3 &q1,
                                 const Vec3 &moved)
{
  return 0.5 * stiffness * dot(q0 + q1, moved - (q1 - q0));
}

// Of the bulk and the asperities between two states; with a film all but the energy of a contact
// that breaks and that of the dashpot is its loss. dashpot: sum of its forces in the two states.
template <class E>
LUBCONTACT_FN inline void normal_loss(const PairCoeffs &c, double a, bool film, double un_moved,
                                      const Load &before, const Load &after, double stored,
                                      [[maybe_unused]] double dashpot, Energies &loss)
{
  const double all = -0.5 * (before.normal + after.normal) * un_moved - stored;
  double broken = 0.0;
  if constexpr (E::restitution) broken = -0.5 * dashpot * un_moved;
  if constexpr (E::adhesion)
    if (before.touch && !after.touch) {
      const double stretch = a * c.normal.gap.release_a - a * c.normal.gap.eps_a;
      broken += 0.5 * c.normal.asperity * stretch * stretch;
    }
  loss.of[NORMAL_CONTACT] = film ? broken : all;
  loss.of[SQUEEZE_FILM] = film ? all - broken : 0.0;
}

// RESIDUAL: heat of the films beside that of their forces: the work of the stresslet in the flow.
LUBCONTACT_FN inline void flow_loss(const FlowResponse &r, const PairStrain &flow, double dt,
                                    double squeeze, Energies &loss)
{
  loss.of[SQUEEZE_FILM] += dt * flow.along * (r.part * squeeze + r.stretch * flow.along);
  loss.of[SHEAR_FILM] += dt * r.extend * dot(flow.across, flow.across);
}

// RESTITUTION: what the dashpot adds to the force of the contact.
template <class E>
LUBCONTACT_FN inline double dashpot_of(const PairCoeffs &c, const Film &f, const PairGeometry &g,
                                       const Load &load, const double *history)
{
  return load.contact - normal_force_of<E>(c, f, g, load.u, holds<E>(history)).contact;
}

// Energy turned into heat by the step of length dt that ended at the geometry g with the history
// `next`; `old` is the one before.
template <class E>
LUBCONTACT_FN inline Energies step_loss(const PairCoeffs &c, const Film &f, const PairGeometry &g,
                                        const Body &i, const Body &j, double dt, const double *old,
                                        const double *next)
{
  Energies loss;
  if constexpr (!E::surface_history && !E::adhesion) return loss;    // elastic

  PairGeometry g0 = g;
  if constexpr (E::surface_history)
    g0.un = old[E::SURFACE_SLOT];
  else
    g0.un = g.un - dt * dot(i.v - j.v, g.n);
  g0.un_a = g0.un * g.per_a;
  g0.r = g.r - g.un + g0.un;
  const Load before = pair_load<E>(c, f, g0, old), after = pair_load<E>(c, f, g, next);

  auto normal_stored = [&](const PairGeometry &at, const Load &load) {
    return normal_energy<E::normal>(c.normal, at.a, at.un, load.u, load.touch);
  };
  double dashpot = 0.0;
  if constexpr (E::restitution)
    dashpot = dashpot_of<E>(c, f, g0, before, old) + dashpot_of<E>(c, f, g, after, next);
  normal_loss<E>(c, g.a, has_film<E>(f), g.un - g0.un, before, after,
                 normal_stored(g, after) - normal_stored(g0, before), dashpot, loss);

  if constexpr (E::turns || E::twist) {
    PairMotion m = pair_motion(g, i, j, g0.r, dt);
    if constexpr (E::residual) {
      const double u_a = 0.5 * (old[E::GAP_SLOT] + next[E::GAP_SLOT]);
      const double ln_u = 0.5 * (old[E::GAP_SLOT + 1] + next[E::GAP_SLOT + 1]);
      const bool rubs = after.cone > 0.0;
      flow_loss(flow_response(f, g, u_a, ln_u, rubs), strain_of_step(f, m), dt,
                0.5 * (before.film + after.film), loss);
      m = tangential_films<E>(f, g, m, u_a, ln_u, dt, rubs).seen;
    }
    const double kr = c.kt * g.a * g.a;
    auto old_vector = [&](int slot) {
      return turned(get_vector(old + slot), m.turn);
    };
    if constexpr (E::tangential) {
      const Vec3 q1 = get_vector(next + E::SHEAR_SLOT);
      const double heat = lost(c.kt, old_vector(E::SHEAR_SLOT), q1, m.slip);
      // friction and film slip together
      const double contact = split(after).contact;
      loss.of[FRICTION_CONTACT] = contact * heat;
      loss.of[SHEAR_FILM] += (1.0 - contact) * heat;
    }
    if constexpr (E::roll)
      loss.of[ROLL_FILM] =
          lost(kr, old_vector(E::ROLL_SLOT), get_vector(next + E::ROLL_SLOT), m.roll);
    if constexpr (E::twist) {
      const double q0 = old[E::TWIST_SLOT], q1 = next[E::TWIST_SLOT];
      loss.of[TWIST_FILM] = 0.5 * kr * (q0 + q1) * (m.twist - (q1 - q0));
    }
  }
  return loss;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
