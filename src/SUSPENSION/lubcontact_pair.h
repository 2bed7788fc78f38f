/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The whole law of a pair, composed of its modes. Pure: old history in, next history or load out;
// the caller decides what is stored. The load depends on positions and history alone, so that a
// restarted run, single() and the computes see exactly the forces of the run.

#ifndef LUBCONTACT_PAIR_H
#define LUBCONTACT_PAIR_H

#include "lubcontact_channels.h"
#include "lubcontact_coeffs.h"
#include "lubcontact_defs.h"
#include "lubcontact_effects.h"
#include "lubcontact_friction.h"
#include "lubcontact_geometry.h"
#include "lubcontact_normal.h"
#include "lubcontact_restitution.h"
#include "lubcontact_roll.h"
#include "lubcontact_shear.h"
#include "lubcontact_strain.h"
#include "lubcontact_stresslet.h"
#include "lubcontact_twist.h"

#include <cmath>

namespace LAMMPS_NS::Lubcontact_NS {

struct PairCoeffs {    // of a pair of types
  NormalCoeffs normal;
  double kt;    // tangential stiffness, force/length; kt a^2 for roll and twist
  double mu;    // coefficient of friction
  Threshold threshold{};
  double column[NUM_LAW_COLUMNS + 1] = {};    // law_column(&TypeCoeffs::name) says which
  double restitution = 0.0;    // restitution_coeff(): resistance over the root of the mass
};

// Surfaces that are closer may hold each other without any film: ADHESION stretches the bulk.
LUBCONTACT_FN inline double touching_gap_a(const PairCoeffs &c)
{
  const GapLaw &law = c.normal.gap;
  return law.eps_a + (1.0 + law.alpha) * larger(0.0, law.release_a - law.eps_a);
}

struct Load {
  double contact;    // normal forces on i along n: of the contact, of the squeeze film,
  double film;
  double repulsion;
  double normal;    // their sum
  bool touch;       // do the asperities touch, or hold?
  Vec3 shear;       // tangential force on i: friction and film
  Vec3 couple;      // rolling and twisting torque on i; j gets the opposite
  double u;         // gap of the deformed surfaces
  double cone;      // largest friction force
  double lever;     // RESIDUAL: how far off the middle of the gap, towards i, the shear force acts;
                    // the couple has its torque
};

template <class E> LUBCONTACT_FN inline bool has_film(const Film &f)
{
  return E::squeeze && f.viscosity > 0.0;
}

// Do the asperities hold? (ADHESION)
template <class E> LUBCONTACT_FN inline bool holds([[maybe_unused]] const double *history)
{
  if constexpr (E::adhesion) return history[E::BOND_SLOT] != 0.0;
  return false;
}

// Gap of the present state.
template <class E>
LUBCONTACT_FN inline double present_gap_a(const PairCoeffs &c, const PairGeometry &g,
                                          const double *history)
{
  if constexpr (E::gap_history) return history[E::GAP_SLOT];
  return elastic_gap_a<E::normal>(c.normal, g.a, g.un_a, holds<E>(history));
}

// Normal forces at the gap u, without dashpot.
template <class E>
LUBCONTACT_FN inline NormalForce normal_force_of(const PairCoeffs &c, const Film &f,
                                                 const PairGeometry &g, double u, bool bond)
{
  return normal_force<E::normal>(c.normal, g.a, g.un, u, has_film<E>(f), bond);
}

// Force of the asperities with that of the dashpot, from the history of that moment.
template <class E>
LUBCONTACT_FN inline double contact_force_of(double springs, [[maybe_unused]] const double *history)
{
  if constexpr (E::restitution) return damped_contact(springs, history[E::DASHPOT_SLOT]);
  return springs;
}

// Load of the asperities that counts for friction. Tension has none.
template <class E> LUBCONTACT_FN inline double frictional_load(const PairCoeffs &c, double contact)
{
  if constexpr (E::adhesion) contact = larger(0.0, contact);
  if constexpr (E::threshold && E::plastic) return rubbing_load_any(c.threshold, contact);
  if constexpr (E::threshold) return rubbing_load(c.threshold, contact);
  return contact;
}

// History of a pair seen for the first time.
template <class E>
LUBCONTACT_FN inline void first_history(const PairCoeffs &c, const PairGeometry &g, double *next)
{
  for (int m = 0; m < E::HISTORY_SIZE; m++) next[m] = 0.0;
  bool bond = false;
  if constexpr (E::adhesion) {
    bond = elastic_contact<E::normal>(c.normal, g.a, g.un_a, false);
    next[E::BOND_SLOT] = bond ? 1.0 : 0.0;
  }
  if constexpr (E::gap_history) {
    next[E::GAP_SLOT] = elastic_gap_a<E::normal>(c.normal, g.a, g.un_a, bond);
    next[E::GAP_SLOT + 1] = std::log(next[E::GAP_SLOT]);
  }
  if constexpr (E::surface_history) next[E::SURFACE_SLOT] = g.un;
}

// History at the beginning of a step in which a pair is seen for the first time: where the dashpot
// acts, the step in which a contact begins has a force. (RESTITUTION)
template <class E>
LUBCONTACT_FN inline void earlier_history(const PairCoeffs &c, PairGeometry g, const Body &i,
                                          const Body &j, double dt, double *next)
{
  const double radsum = g.r - g.un;
  g.r = norm(g.r * g.n - dt * (i.v - j.v));    // the velocities undo the step
  g.un = g.r - radsum;
  g.un_a = g.un * g.per_a;
  first_history<E>(c, g, next);
}

// Strain of the flow at mid-step in the frame of the pair, carried to the end as its motion is.
LUBCONTACT_FN inline PairStrain strain_of_step(const Film &f, const PairMotion &m)
{
  PairStrain s = pair_strain(f.strain, m.middle);
  s.across = s.across + 0.5 * cross(m.turn, s.across);
  return s;
}

// What the squeeze film needs of the motion of a step.
template <class E>
LUBCONTACT_FN inline auto squeeze_flow([[maybe_unused]] const Film &f,
                                       [[maybe_unused]] const PairGeometry &g,
                                       [[maybe_unused]] const PairMotion &m)
{
  if constexpr (E::residual)
    return SqueezeFlow{strain_of_step(f, m).along, size_difference(g)};
  else
    return NoFlow{};
}

// Resistances of the films of shear, roll and twist, and the motion that they see: residual ones
// have no force where the spheres move as in a flow, and that of shear acts off the middle of the
// gap. Where a contact rubs, the two act at one place, that of the contact.
struct TangentialFilms {
  double shear, roll, twist;
  PairMotion seen;
};

template <class E>
LUBCONTACT_FN inline TangentialFilms
tangential_films(const Film &f, const PairGeometry &g, const PairMotion &m,
                 [[maybe_unused]] double u_a, [[maybe_unused]] double ln_u,
                 [[maybe_unused]] double dt, [[maybe_unused]] bool rubs)
{
  TangentialFilms films{0.0, 0.0, 0.0, m};
  if constexpr (E::residual) {
    const double delta = size_difference(g);
    const TangentialResidual t = residual_films(f, g.a, delta, residual_place(u_a, ln_u, delta));
    const Vec3 flow = dt * strain_of_step(f, m).across;
    films.shear = t.shear;
    films.roll = t.roll;
    films.twist = t.twist;
    films.seen.slip =
        m.slip + (rubs ? 0.0 : t.lever) * cross(m.roll, g.n) - (rubs ? 0.0 : t.slide) * flow;
    films.seen.roll = m.roll - t.turn * cross(g.n, flow);
  } else {
    if constexpr (E::shear) films.shear = shear_resistance(f, g.a, u_a, ln_u);
    if constexpr (E::roll) films.roll = roll_resistance(f, g.a, u_a, ln_u);
    if constexpr (E::twist) films.twist = twist_resistance(f, g.a, u_a, ln_u);
  }
  return films;
}

// History after a step of length dt that ended at the geometry g, next_gap(old, un0_a, un1_a,
// motion) giving the gap. old and next may be the same.
template <class E, class NextGap>
LUBCONTACT_FN inline void step_history(NextGap next_gap, const PairCoeffs &c, const Film &f,
                                       const PairGeometry &g, const Body &i, const Body &j,
                                       double dt, const double *old, double *next)
{
  Gap before{}, after{};
  [[maybe_unused]] const bool held = holds<E>(old);
  [[maybe_unused]] bool holding = false;
  if constexpr (E::adhesion) before.bond = old[E::BOND_SLOT];
  if constexpr (E::adhesion && !E::gap_history) {
    holding = elastic_contact<E::normal>(c.normal, g.a, g.un_a, held);
    next[E::BOND_SLOT] = holding ? 1.0 : 0.0;
  }
  if constexpr (!E::surface_history) return;

  const double un_old = old[E::SURFACE_SLOT];
  const double un_old_a = un_old * g.per_a;
  PairMotion m{};
  if constexpr (E::turns || E::twist) m = pair_motion(g, i, j, g.r - g.un + un_old, dt);
  if constexpr (E::gap_history) {
    before = {old[E::GAP_SLOT], old[E::GAP_SLOT + 1], before.bond};
    after = next_gap(before, un_old_a, g.un_a, m);
    next[E::GAP_SLOT] = after.u_a;
    next[E::GAP_SLOT + 1] = after.ln_u;
    if constexpr (E::adhesion) next[E::BOND_SLOT] = after.bond;
    holding = after.bond != 0.0;
  } else if constexpr (E::reads_gap) {
    before.u_a = elastic_gap_a<E::normal>(c.normal, g.a, un_old_a, held);
    after.u_a = elastic_gap_a<E::normal>(c.normal, g.a, g.un_a, holding);
    if constexpr (E::films) {    // friction alone needs no logarithm
      before.ln_u = logarithm(larger(1e-300, before.u_a));
      after.ln_u = logarithm(larger(1e-300, after.u_a));
    }
  }
  next[E::SURFACE_SLOT] = g.un;
  [[maybe_unused]] double dashpot[2] = {};    // at the ends of the step
  if constexpr (E::restitution) {
    dashpot[0] = old[E::DASHPOT_SLOT];
    dashpot[1] = dashpot_force(c.restitution, i.mass * j.mass / (i.mass + j.mass),
                               g.a * c.normal.gap.eps_a, un_old, g.un, dt);
    next[E::DASHPOT_SLOT] = dashpot[1];
  }

  if constexpr (E::turns || E::twist) {
    // the films of shear, roll and twist see the gap at mid-step
    [[maybe_unused]] const double ln_u = 0.5 * (before.ln_u + after.ln_u);
    [[maybe_unused]] const double u_a = 0.5 * (before.u_a + after.u_a);

    [[maybe_unused]] double cone0 = 0.0, cone = 0.0;
    if constexpr (E::friction) {
      auto cone_at = [&](const PairGeometry &at, double gap_a, bool bond,
                         [[maybe_unused]] double dash) {
        double contact = normal_force_of<E>(c, f, at, g.a * gap_a, bond).contact;
        if constexpr (E::restitution) contact = damped_contact(contact, dash);
        return c.mu / c.kt * frictional_load<E>(c, contact);
      };
      cone = cone_at(g, after.u_a, holding, dashpot[1]);
      if constexpr (E::shear) {    // without film only the end of the step counts
        PairGeometry g0 = g;
        g0.un = un_old;
        cone0 = cone_at(g0, before.u_a, held, dashpot[0]);
      }
    }
    const TangentialFilms films = tangential_films<E>(f, g, m, u_a, ln_u, dt, cone > 0.0);
    if constexpr (E::tangential) {
      const Vec3 q0 = turned(get_vector(old + E::SHEAR_SLOT), m.turn);
      put_vector(
          tangential(next_shear(q0, films.seen.slip, cone0, cone, films.shear, c.kt * dt), g.n),
          next + E::SHEAR_SLOT);
    }
    const double kr = c.kt * g.a * g.a;
    if constexpr (E::roll) {
      const Vec3 q0 = turned(get_vector(old + E::ROLL_SLOT), m.turn);
      put_vector(next_roll(q0, films.seen.roll, films.roll, kr * dt), next + E::ROLL_SLOT);
    }
    if constexpr (E::twist)
      next[E::TWIST_SLOT] = next_twist(old[E::TWIST_SLOT], m.twist, films.twist, kr * dt);
  }
}

template <class E>
LUBCONTACT_FN inline void next_history(const PairCoeffs &c, const Film &f, const PairGeometry &g,
                                       const Body &i, const Body &j, double dt, const double *old,
                                       double *next)
{
  auto gap = [&](const Gap &before, double un0_a, double un1_a, const PairMotion &m) {
    return next_gap<E::normal>(c.normal, f, g.a, before, un0_a, un1_a, dt,
                               squeeze_flow<E>(f, g, m));
  };
  step_history<E>(gap, c, f, g, i, j, dt, old, next);
}

// The same without a branch, for a loop over pairs: false, and next void, if the step is not usual.
template <class E>
LUBCONTACT_FN inline bool next_history_usual(const PairCoeffs &c, const Film &f,
                                             const PairGeometry &g, const Body &i, const Body &j,
                                             double dt, const double *old, double *next)
{
  bool usual = true;
  auto gap = [&](const Gap &before, double un0_a, double un1_a, const PairMotion &m) {
    return next_gap_usual<E::normal>(c.normal, f, g.a, before, un0_a, un1_a, dt, usual,
                                     squeeze_flow<E>(f, g, m));
  };
  step_history<E>(gap, c, f, g, i, j, dt, old, next);
  return usual;
}

// Forces and torques at the geometry g, from the history of that moment.
template <class E>
LUBCONTACT_FN inline Load pair_load(const PairCoeffs &c, const Film &f, const PairGeometry &g,
                                    const double *history)
{
  Load load{};
  load.u = g.a * present_gap_a<E>(c, g, history);
  const bool bond = holds<E>(history);
  const NormalForce normal = normal_force_of<E>(c, f, g, load.u, bond);
  load.contact = contact_force_of<E>(normal.contact, history);
  load.film = normal.film;
  load.normal = load.contact + normal.film;
  load.touch = bond | (load.contact > 0.0);
  if constexpr (E::repulsion) {
    load.repulsion = normal.repulsion;
    load.normal = load.normal + normal.repulsion;
  }
  if constexpr (E::friction) load.cone = c.mu * frictional_load<E>(c, load.contact);
  if constexpr (E::tangential) load.shear = -c.kt * get_vector(history + E::SHEAR_SLOT);
  const double kr = c.kt * g.a * g.a;
  if constexpr (E::roll) load.couple = -kr * get_vector(history + E::ROLL_SLOT);
  if constexpr (E::twist) load.couple = load.couple + (-kr * history[E::TWIST_SLOT]) * g.n;
  if constexpr (E::residual) {
    const double delta = size_difference(g);
    const ResidualPlace p = residual_place(history[E::GAP_SLOT], history[E::GAP_SLOT + 1], delta);
    load.lever = select(load.cone > 0.0, 0.0, residual_lever(g.a, delta, p));
    load.couple = load.couple + load.lever * cross(g.n, load.shear);
  }
  return load;
}

LUBCONTACT_FN inline Vec3 force_on_i(const Load &load, const PairGeometry &g)
{
  return load.normal * g.n + load.shear;
}

// Torques about the centers; together with the force they conserve angular momentum.
LUBCONTACT_FN inline Vec3 torque_on_i(const Load &load, const PairGeometry &g)
{
  return load.couple - g.arm_i * cross(g.n, load.shear);
}

LUBCONTACT_FN inline Vec3 torque_on_j(const Load &load, const PairGeometry &g)
{
  return -1.0 * load.couple - g.arm_j * cross(g.n, load.shear);
}

// Present stresslet of residual films.
template <class E>
LUBCONTACT_FN inline FilmStresslet present_stresslet(const PairCoeffs &c, const Film &f,
                                                     const PairGeometry &g, const Load &load,
                                                     const double *history)
{
  const FlowResponse r =
      flow_response(f, g, history[E::GAP_SLOT], history[E::GAP_SLOT + 1], load.cone > 0.0);
  const Vec3 couple = -c.kt * g.a * g.a * get_vector(history + E::ROLL_SLOT);
  return film_stresslet(r, f.strain, g.n, load.film, load.shear, couple);
}

// Contact state, and the share of friction in the tangential force.
LUBCONTACT_FN inline ShearSplit split(const Load &load)
{
  return shear_split(load.shear, load.cone, load.touch);
}

// Forces on i by origin.
struct ChannelForces {
  Vec3 of[NUM_CHANNELS];
};

LUBCONTACT_FN inline ChannelForces force_by_channel(const PairGeometry &g, const Load &load)
{
  static_assert(NUM_CHANNELS == 5, "each channel needs its force here");
  const ShearSplit parts = split(load);
  ChannelForces force;
  force.of[CONTACT_NORMAL] = load.contact * g.n;
  force.of[LUBRICATION_NORMAL] = load.film * g.n;
  force.of[CONTACT_TANGENTIAL] = parts.contact * load.shear;
  force.of[LUBRICATION_TANGENTIAL] = (1.0 - parts.contact) * load.shear;
  force.of[SCREENED_REPULSION] = load.repulsion * g.n;
  return force;
}

// Energy stored in the springs.
template <class E>
LUBCONTACT_FN inline double pair_energy(const PairCoeffs &c, const PairGeometry &g,
                                        const Load &load)
{
  double energy = normal_energy<E::normal>(c.normal, g.a, g.un, load.u, load.touch);
  if constexpr (E::tangential) energy += 0.5 * dot(load.shear, load.shear) / c.kt;
  if constexpr (E::roll || E::twist) {
    Vec3 couple = load.couple;
    if constexpr (E::residual) couple = couple - load.lever * cross(g.n, load.shear);
    energy += 0.5 * dot(couple, couple) / (c.kt * g.a * g.a);
  }
  return energy;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
