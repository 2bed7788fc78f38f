/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The loop of pair style lubcontact over the pairs, one instance per covering combination of effects.

#ifndef LMP_PAIR_LUBCONTACT_LOOP_H
#define LMP_PAIR_LUBCONTACT_LOOP_H

#include "pair_lubcontact.h"

#include "atom.h"
#include "fix_neigh_history_lubcontact.h"
#include "force.h"
#include "lubcontact_batch.h"
#include "lubcontact_channels.h"
#include "lubcontact_power.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <numeric>

using namespace LAMMPS_NS;
using Lubcontact_NS::Batch;
using Lubcontact_NS::Body;
using Lubcontact_NS::Load;
using Lubcontact_NS::PairCoeffs;
using Lubcontact_NS::PairGeometry;
using Lubcontact_NS::Vec3;

static inline Vec3 vector(const double *a)
{
  return {a[0], a[1], a[2]};
}

static inline void add(const Vec3 &a, double *sum)
{
  sum[0] += a.x;
  sum[1] += a.y;
  sum[2] += a.z;
}

// Pairs in range, in the order of the neighbor list. In every step all forces are added in this
// order, whoever computes them: a set-up finds the sums of the run to the last bit.
struct PairLubcontact::Queue {
  Batch batch = Lubcontact_NS::idle_batch();
  int n = 0;
  int i[Batch::WIDTH], j[Batch::WIDTH];
  const PairCoeffs *coeffs[Batch::WIDTH];
  double *history[Batch::WIDTH];
  bool first[Batch::WIDTH];       // seen for the first time
  Batch::Lanes virial[6] = {};    // xx yy zz xy xz yz of the pairs so far, one sum per lane
};

/* ----------------------------------------------------------------------
   the loop: find the pairs in range
------------------------------------------------------------------------- */

template <unsigned MASK> void PairLubcontact::eval_effects()
{
  using E = Lubcontact_NS::Effects<MASK>;
  constexpr int SIZE = E::HISTORY_SIZE;
  const bool guard = update->whichflag != 2;    // a minimization may separate anything
  const auto rule = static_cast<Lubcontact_NS::Radius>(radius_rule);
  const int *type = atom->type;
  const double *radius = atom->radius;
  const double *const *x = atom->x;
  // contact alone acts without a common face: no range voronoi, no question
  constexpr bool REACHES = E::squeeze || E::films || E::repulsion;
  const bool screened = REACHES && !faces.empty();
  Queue queue;

  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int *jlist = list->firstneigh[i];
    const int jnum = list->numneigh[i];
    int *known = SIZE ? fix_history->firstflag[i] : nullptr;
    double *histories = SIZE ? fix_history->firstvalue[i] : nullptr;
    const Vec3 xi = vector(x[i]);
    const double ri = radius[i];
    const PairCoeffs *coeffs_i = coeffs[type[i]];
    const double *reach_i = reach[type[i]];
    const char *faces_i = screened ? faces_of(i) : nullptr;

    for (int jj = 0; jj < jnum; jj++) {
      const int j = jlist[jj] & NEIGHMASK;
      if (force->special_lj[sbmask(jlist[jj])] == 0.0) continue;

      // a is at most the mean radius: most pairs out of range need no division
      const int jtype = type[j];
      const double radsum = ri + radius[j];
      const double most = radsum * (1.0 + 0.5 * reach_i[jtype]);
      const Vec3 d = xi - vector(x[j]);
      const double rsq = dot(d, d);
      bool near = rsq < most * most;
      double a = 0.0;
      if (near) {
        a = Lubcontact_NS::effective_radius(rule, ri, radius[j]);
        const double end = radsum + reach_i[jtype] * a;
        near = rsq < end * end;
        if (screened && !faces_i[jj]) {
          const double touch = radsum + touching_gap(coeffs_i[jtype]) * a;
          near = rsq < touch * touch;
        }
      }
      if (!near) {
        if (SIZE) known[jj] = 0;
        continue;
      }
      if (!(rsq > (radsum - a) * (radsum - a)) && guard)
        overlap_error(i, j, (norm(d) - radsum) / a);

      const int l = queue.n++;
      queue.i[l] = i;
      queue.j[l] = j;
      queue.coeffs[l] = &coeffs_i[jtype];
      put_lane(d, queue.batch.x, l);
      queue.batch.radius_i[l] = ri;
      queue.batch.radius_j[l] = radius[j];
      queue.batch.a[l] = a;
      queue.first[l] = false;
      if (SIZE) {
        queue.history[l] = histories + SIZE * jj;
        queue.first[l] = !known[jj];
        known[jj] = 1;
      }
      if (queue.n == Batch::WIDTH) flush<E>(queue);
    }
  }
  flush<E>(queue);
  // instead of what ev_tally_xyz() has summed: the same bits, whatever else this step asks for
  if (vflag_global)
    for (int n = 0; n < 6; n++)
      virial[n] = std::accumulate(queue.virial[n], queue.virial[n] + Batch::WIDTH, 0.0);
}

/* ----------------------------------------------------------------------
   the rest of what a batch needs
------------------------------------------------------------------------- */

template <class E> void PairLubcontact::fill(Queue &queue)
{
  using Lubcontact_NS::put_lane;
  Batch &b = queue.batch;
  for (int l = 0; l < queue.n; l++) {
    const int i = queue.i[l], j = queue.j[l];
    const PairCoeffs &c = *queue.coeffs[l];
    for (int m = 0; m < E::HISTORY_SIZE; m++) b.history[m][l] = queue.history[l][m];
    if constexpr (E::turns || E::twist) {
      put_lane(vector(atom->v[i]) - vector(atom->v[j]), b.v, l);
      put_lane(vector(atom->omega[i]), b.omega_i, l);
      put_lane(vector(atom->omega[j]), b.omega_j, l);
      b.kt[l] = c.kt;
      b.mu[l] = c.mu;
    }
    if constexpr (E::threshold) {
      b.least[l] = c.threshold.least;
      b.shift[l] = c.threshold.shift;
      b.per_ramp[l] = c.threshold.per_ramp;
    }
    if constexpr (E::adhesion) {
      b.release[l] = c.normal.gap.release;
      b.ln_release[l] = c.normal.gap.ln_release;
    }
    if constexpr (E::repulsion) {
      b.repulsion[l] = c.normal.repulsion.force;
      b.per_screening[l] = c.normal.repulsion.per_length;
    }
    b.g[l] = c.normal.g;
    b.asperity[l] = c.normal.asperity;
    b.alpha[l] = c.normal.gap.alpha;
    b.eps[l] = c.normal.gap.eps;
    b.ln_eps[l] = c.normal.gap.ln_eps;
  }
}

inline Body PairLubcontact::body(int i) const
{
  return {vector(atom->x[i]), vector(atom->v[i]), vector(atom->omega[i]), atom->radius[i]};
}

/* ----------------------------------------------------------------------
   one pair by itself; not to advance leaves its history as it is
------------------------------------------------------------------------- */

template <class E>
[[gnu::noinline, gnu::flatten]] Load
PairLubcontact::step_alone(const Queue &queue, int l, bool advance, PairGeometry &geometry)
{
  const int i = queue.i[l], j = queue.j[l];
  const PairCoeffs &c = *queue.coeffs[l];
  const Body body_i = body(i), body_j = body(j);
  geometry = Lubcontact_NS::pair_geometry(body_i.x, body_j.x, body_i.radius, body_j.radius,
                                          queue.batch.a[l]);
  if constexpr (E::HISTORY_SIZE > 0) {
    double *history = queue.history[l];
    if (queue.first[l])
      Lubcontact_NS::first_history<E>(c, geometry, history);
    else if (advance)
      Lubcontact_NS::next_history<E>(c, *film, geometry, body_i, body_j, update->dt, history,
                                     history);
    return Lubcontact_NS::pair_load<E>(c, *film, geometry, history);
  }
  return Lubcontact_NS::pair_load<E>(c, *film, geometry, nullptr);
}

/* ----------------------------------------------------------------------
   steps and forces of the pairs in the queue, together where the step is usual
------------------------------------------------------------------------- */

template <class E> [[gnu::noinline]] void PairLubcontact::flush(Queue &queue)
{
  using Lubcontact_NS::get_lane;
  constexpr bool TORQUE = E::turns || E::twist;
  const bool advance = !update->setupflag;    // a set-up sees the history of the last step
  const bool together = (advance || !E::HISTORY_SIZE) && !(E::gap_history && euler);
  const bool tally = eflag_either || vflag_atom || partition_now || partition_atom_now || power_now;
  [[maybe_unused]] double old[E::HISTORY_SIZE + 1];    // for the power of the step
  const Batch &b = queue.batch;
  double **f = atom->f, **torque = atom->torque;
  if (together) {
    fill<E>(queue);
    Lubcontact_NS::step_together<E>(queue.batch, *film, update->dt);
  }

  for (int l = 0; l < queue.n; l++) {
    const int i = queue.i[l], j = queue.j[l];
    const bool done = together && !queue.first[l] && b.usual[l] != 0.0;
    PairGeometry geometry;
    Load load;
    Vec3 force_i, torque_i, torque_j;
    if (power_now)
      for (int m = 0; m < E::HISTORY_SIZE; m++) old[m] = queue.history[l][m];
    if (done) {
      for (int m = 0; m < E::HISTORY_SIZE; m++) queue.history[l][m] = b.history[m][l];
      force_i = get_lane(b.force, l);
      torque_i = get_lane(b.torque_i, l);
      torque_j = get_lane(b.torque_j, l);
    }
    if (!done || tally) load = step_alone<E>(queue, l, advance && !done, geometry);
    if (!done) {
      force_i = Lubcontact_NS::force_on_i(load, geometry);
      torque_i = Lubcontact_NS::torque_on_i(load, geometry);
      torque_j = Lubcontact_NS::torque_on_j(load, geometry);
      put_lane(force_i, queue.batch.force, l);
    }
    add(force_i, f[i]);
    if (TORQUE) add(torque_i, torque[i]);
    if (force->newton_pair || j < atom->nlocal) {
      add(-1.0 * force_i, f[j]);
      if (TORQUE) add(torque_j, torque[j]);
    }
    if (tally) tally_pair<E>(i, j, *queue.coeffs[l], geometry, load);
    if (power_now) tally_power<E>(queue, l, old, geometry, load);
  }
  if (vflag_global) add_virial(queue);
  queue.n = 0;
}

/* ----------------------------------------------------------------------
   a pair with a ghost is seen twice without newton: half of it each time
------------------------------------------------------------------------- */

inline double PairLubcontact::share(int j) const
{
  return force->newton_pair || j < atom->nlocal ? 1.0 : 0.5;
}

/* ----------------------------------------------------------------------
   energy, virial per atom and stress by origin, in the steps that need them
------------------------------------------------------------------------- */

template <class E>
[[gnu::noinline]] void PairLubcontact::tally_pair(int i, int j, const PairCoeffs &c,
                                                  const PairGeometry &geometry, const Load &load)
{
  if (eflag_either || vflag_atom) {
    const double energy = eflag_either ? Lubcontact_NS::pair_energy<E>(c, geometry, load) : 0.0;
    const Vec3 force_i = Lubcontact_NS::force_on_i(load, geometry), d = geometry.r * geometry.n;
    ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, energy, 0.0, force_i.x, force_i.y,
                 force_i.z, d.x, d.y, d.z);
  }
  if (partition_now || partition_atom_now) tally_partition(i, j, geometry, load);
}

/* ----------------------------------------------------------------------
   energy by origin: stored after this step, and lost in it; old is the history before it
------------------------------------------------------------------------- */

template <class E>
[[gnu::noinline]] void PairLubcontact::tally_power(const Queue &queue, int l, const double *old,
                                                   const PairGeometry &geometry, const Load &load)
{
  const int i = queue.i[l], j = queue.j[l];
  const PairCoeffs &c = *queue.coeffs[l];
  const double *next = E::HISTORY_SIZE ? queue.history[l] : nullptr;
  const double weight = share(j);
  const auto energy = Lubcontact_NS::stored_energy<E>(c, geometry, load, next);
  for (int m = 0; m < NUM_ORIGINS; m++) stored[m] += weight * energy.of[m];
  if (queue.first[l] || update->setupflag) return;

  const auto loss =
      Lubcontact_NS::step_loss<E>(c, *film, geometry, body(i), body(j), update->dt, old, next);
  for (int m = 0; m < NUM_ORIGINS; m++) heat[m] += weight * loss.of[m];
}

/* ---------------------------------------------------------------------- */

template <unsigned MASK>
Load PairLubcontact::single_effects(int i, int j, const PairGeometry &geometry,
                                    const double *history, double &energy)
{
  using E = Lubcontact_NS::Effects<MASK>;
  const PairCoeffs &c = coeffs[atom->type[i]][atom->type[j]];
  double buffer[E::HISTORY_SIZE + 1];
  if (!history) {
    Lubcontact_NS::first_history<E>(c, geometry, buffer);
    history = buffer;
  }
  const Load load = Lubcontact_NS::pair_load<E>(c, *film, geometry, history);
  energy = Lubcontact_NS::pair_energy<E>(c, geometry, load);
  return load;
}

/* ----------------------------------------------------------------------
   table of the instances with these extensions of the normal mode; the style keeps the one it needs.
   Four files share the work of compiling them
------------------------------------------------------------------------- */

template <unsigned... MASK>
void PairLubcontact::choose_among(std::integer_sequence<unsigned, MASK...>)
{
  using Lubcontact_NS::Effects;
  static constexpr unsigned masks[] = {MASK...};
  static constexpr Eval evals[] = {&PairLubcontact::eval_effects<MASK>...};
  static constexpr Single singles[] = {&PairLubcontact::single_effects<MASK>...};
  static constexpr Exchange exchanges[] = {&Lubcontact_NS::exchange_history<Effects<MASK>>...};
  static constexpr int sizes[] = {Effects<MASK>::HISTORY_SIZE...};
  static constexpr int layouts[] = {Effects<MASK>::LAYOUT...};
  for (std::size_t m = 0; m < sizeof...(MASK); m++) {
    if (masks[m] != instance) continue;
    eval = evals[m];
    eval_single = singles[m];
    exchange = exchanges[m];
    size_history = sizes[m];
    history_layout = layouts[m];
  }
}

template <unsigned EXTENSIONS> void PairLubcontact::choose_extended()
{
  choose_among(Lubcontact_NS::instances<EXTENSIONS>());
}

#endif
