/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The loop of the forces; included by the files that compile its instances.

#ifndef LMP_LUBCONTACT_LOOP_INSTANCES_H
#define LMP_LUBCONTACT_LOOP_INSTANCES_H

#include "lubcontact_loop.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "lubcontact_batch.h"
#include "lubcontact_power.h"
#include "neigh_list.h"
#include "update.h"

#include <numeric>

namespace LAMMPS_NS {

using Lubcontact_NS::Batch;
using Lubcontact_NS::Body;
using Lubcontact_NS::Load;
using Lubcontact_NS::PairCoeffs;
using Lubcontact_NS::PairGeometry;
using Lubcontact_NS::Vec3;

// Pairs in range, in the order of the neighbor list. In every step all forces are added in this
// order, whoever computes them: a set-up finds the sums of the run to the last bit.
struct LubcontactQueue {
  Batch batch = Lubcontact_NS::idle_batch();
  int n = 0;
  int i[Batch::WIDTH], j[Batch::WIDTH];
  const PairCoeffs *coeffs[Batch::WIDTH];
  double *history[Batch::WIDTH];
  bool first[Batch::WIDTH];       // seen for the first time
  Batch::Lanes virial[6] = {};    // xx yy zz xy xz yz of the pairs so far, one sum per lane
};

// Virial of the queue, of which this rank has a share with ghosts if newton is off.
void add_virial(const Force *, const Atom *, LubcontactQueue &);

[[noreturn]] void overlap_error(LAMMPS *, int i, int j, double overlap);

template <class E> class LubcontactLoop : protected Pointers {
 public:
  LubcontactLoop(LAMMPS *lmp, const LubcontactStep &now) :
      Pointers(lmp), step(now), film(now.film), asked(now.tally.asked() || now.tally_atoms)
  {
  }
  void run();

 private:
  template <bool NOTED> void run_through();

  static constexpr int SIZE = E::HISTORY_SIZE;
  const LubcontactStep &step;
  const Lubcontact_NS::Film &film;
  const bool asked;    // does anybody ask for more than forces in this step?
  LubcontactQueue queue;

  void fill();
  void flush();
  Load step_alone(int lane, bool advance, PairGeometry &);
  void tally_pair(int lane, const double *old, const PairGeometry &, const Load &);
  void add_stresslets();
  void tally_stresslet(int lane, double weight, const PairGeometry &, const Load &,
                       const double *history);
  void begin_contacts();
  double mass(int i) const { return atom->rmass[i] / force->ftm2v; }
  Body body(int i) const
  {
    Body body{Lubcontact_NS::get_vector(atom->x[i]), Lubcontact_NS::get_vector(atom->v[i]),
              Lubcontact_NS::get_vector(atom->omega[i]), atom->radius[i]};
    if constexpr (E::restitution) body.mass = mass(i);
    return body;
  }
};

/* ----------------------------------------------------------------------
   find the pairs in range
------------------------------------------------------------------------- */

template <class E> void LubcontactLoop<E>::run()
{
  queue.batch.plastic = step.plastic;
  if (SIZE && step.changes)
    run_through<true>();
  else
    run_through<false>();
  flush();
  if (step.virial)
    for (int n = 0; n < 6; n++)
      step.virial[n] = std::accumulate(queue.virial[n], queue.virial[n] + Batch::WIDTH, 0.0);
}

template <class E> template <bool NOTED> void LubcontactLoop<E>::run_through()
{
  const bool guard = update->whichflag != 2;    // a minimization may separate anything
  const NeighList *list = step.pairs.list();
  LubcontactHistory &history = step.pairs.history();
  const int *type = atom->type;
  const double *radius = atom->radius;
  const double *const *x = atom->x;

  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int *jlist = list->firstneigh[i];
    const int jnum = list->numneigh[i];
    int *known = SIZE ? history.known(i) : nullptr;
    double *histories = SIZE ? history.values(i) : nullptr;
    const Vec3 xi = Lubcontact_NS::get_vector(x[i]);
    const double ri = radius[i];
    const Lubcontact_NS::RangeOf range = step.pairs.around(i);

    for (int jj = 0; jj < jnum; jj++) {
      const int entry = jlist[jj], j = entry & NEIGHMASK;
      if (force->special_lj[entry >> SBBITS & 3] == 0.0) continue;
      const Vec3 d = xi - Lubcontact_NS::get_vector(x[j]);
      const double rsq = dot(d, d);
      const int jtype = type[j];
      const double a = range.acting(rsq, radius[j], jtype, jj);
      if (a == 0.0) {
        if (NOTED && known[jj]) step.changes->push_back({i, j, -1.0});
        if (SIZE) known[jj] = 0;
        continue;
      }
      const double radsum = ri + radius[j];
      if (!(rsq > (radsum - a) * (radsum - a)) && guard)
        overlap_error(lmp, i, j, (radsum - norm(d)) / a);

      const int l = queue.n++;
      queue.i[l] = i;
      queue.j[l] = j;
      queue.coeffs[l] = &range.coeffs[jtype];
      put_lane(d, queue.batch.x, l);
      queue.batch.radius_i[l] = ri;
      queue.batch.radius_j[l] = radius[j];
      queue.batch.a[l] = a;
      queue.first[l] = false;
      if (SIZE) {
        queue.history[l] = histories + SIZE * jj;
        queue.first[l] = !known[jj];
        if (NOTED && queue.first[l]) step.changes->push_back({i, j, 1.0});
        known[jj] = 1;
      }
      if (queue.n == Batch::WIDTH) flush();
    }
  }
}

/* ----------------------------------------------------------------------
   the rest of what a batch needs
------------------------------------------------------------------------- */

template <class E> void LubcontactLoop<E>::fill()
{
  using Lubcontact_NS::put_lane;
  Batch &b = queue.batch;
  for (int l = 0; l < queue.n; l++) {
    const int i = queue.i[l], j = queue.j[l];
    const PairCoeffs &c = *queue.coeffs[l];
    for (int m = 0; m < SIZE; m++) b.history[m][l] = queue.history[l][m];
    if constexpr (E::turns || E::twist) {
      put_lane(Lubcontact_NS::get_vector(atom->v[i]) - Lubcontact_NS::get_vector(atom->v[j]), b.v,
               l);
      put_lane(Lubcontact_NS::get_vector(atom->omega[i]), b.omega_i, l);
      put_lane(Lubcontact_NS::get_vector(atom->omega[j]), b.omega_j, l);
      b.kt[l] = c.kt;
      b.mu[l] = c.mu;
    }
    if constexpr (E::threshold) {
      b.least[l] = c.threshold.least;
      b.shift[l] = c.threshold.shift;
      b.per_ramp[l] = c.threshold.per_ramp;
      if (b.plastic) b.per_plastic[l] = c.threshold.per_plastic;
    }
    if constexpr (E::adhesion) {
      b.release_a[l] = c.normal.gap.release_a;
      b.ln_release[l] = c.normal.gap.ln_release;
    }
    if constexpr (E::repulsion) {
      b.repulsion[l] = c.normal.repulsion.force;
      b.per_screening[l] = c.normal.repulsion.per_length;
    }
    if constexpr (E::restitution) {
      b.restitution[l] = c.restitution;
      b.mass_i[l] = mass(i);
      b.mass_j[l] = mass(j);
    }
    Lubcontact_NS::copy_columns<E>([&](std::size_t n) {
      b.column[n][l] = c.column[n];
    });
    b.g[l] = c.normal.g;
    b.asperity[l] = c.normal.asperity;
    b.alpha[l] = c.normal.gap.alpha;
    b.eps_a[l] = c.normal.gap.eps_a;
    b.ln_eps[l] = c.normal.gap.ln_eps;
  }
}

/* ----------------------------------------------------------------------
   pairs seen for the first time in a step take this step from their state before it
------------------------------------------------------------------------- */

template <class E> void LubcontactLoop<E>::begin_contacts()
{
  for (int l = 0; l < queue.n; l++) {
    if (!queue.first[l] || queue.coeffs[l]->restitution == 0.0) continue;
    const Body i = body(queue.i[l]), j = body(queue.j[l]);
    const PairGeometry g =
        Lubcontact_NS::pair_geometry(i.x, j.x, i.radius, j.radius, queue.batch.a[l]);
    Lubcontact_NS::earlier_history<E>(*queue.coeffs[l], g, i, j, update->dt, queue.history[l]);
    queue.first[l] = false;
  }
}

/* ----------------------------------------------------------------------
   one pair by itself; not to advance leaves its history as it is
------------------------------------------------------------------------- */

template <class E>
[[gnu::noinline]] Load LubcontactLoop<E>::step_alone(int l, bool advance, PairGeometry &geometry)
{
  const PairCoeffs &c = *queue.coeffs[l];
  const Body body_i = body(queue.i[l]), body_j = body(queue.j[l]);
  geometry = Lubcontact_NS::pair_geometry(body_i.x, body_j.x, body_i.radius, body_j.radius,
                                          queue.batch.a[l]);
  if constexpr (SIZE > 0) {
    double *history = queue.history[l];
    if (queue.first[l])
      Lubcontact_NS::first_history<E>(c, geometry, history);
    else if (advance)
      Lubcontact_NS::next_history<E>(c, film, geometry, body_i, body_j, update->dt, history,
                                     history);
    return Lubcontact_NS::pair_load<E>(c, film, geometry, history);
  }
  return Lubcontact_NS::pair_load<E>(c, film, geometry, nullptr);
}

/* ----------------------------------------------------------------------
   steps and forces of the pairs in the queue, together where the step is usual
------------------------------------------------------------------------- */

template <class E> [[gnu::noinline]] void LubcontactLoop<E>::flush()
{
  using Lubcontact_NS::get_lane;
  constexpr bool TORQUE = E::turns || E::twist;
  const bool advance = !update->setupflag;    // a set-up sees the history of the last step
  const bool together = (advance || !SIZE) && !(E::gap_history && step.euler);
  const bool power = step.tally.asked_power();
  [[maybe_unused]] double old[SIZE + 1];    // for the power of the step
  const Batch &b = queue.batch;
  double **f = atom->f, **torque = atom->torque;
  if constexpr (E::restitution)
    if (advance) begin_contacts();
  if (together) {
    fill();
    Lubcontact_NS::step_together<E>(queue.batch, film, update->dt);
  }

  for (int l = 0; l < queue.n; l++) {
    const int i = queue.i[l], j = queue.j[l];
    const bool done = together && !queue.first[l] && b.usual[l] != 0.0;
    PairGeometry geometry;
    Load load;
    Vec3 force_i, torque_i, torque_j;
    if (power)
      for (int m = 0; m < SIZE; m++) old[m] = queue.history[l][m];
    if (done) {
      for (int m = 0; m < SIZE; m++) queue.history[l][m] = b.history[m][l];
      force_i = get_lane(b.force, l);
      torque_i = get_lane(b.torque_i, l);
      torque_j = get_lane(b.torque_j, l);
    }
    if (!done || asked) load = step_alone(l, advance && !done, geometry);
    if (!done) {
      force_i = Lubcontact_NS::force_on_i(load, geometry);
      torque_i = Lubcontact_NS::torque_on_i(load, geometry);
      torque_j = Lubcontact_NS::torque_on_j(load, geometry);
      put_lane(force_i, queue.batch.force, l);
    }
    Lubcontact_NS::add_vector(force_i, f[i]);
    if (TORQUE) Lubcontact_NS::add_vector(torque_i, torque[i]);
    if (force->newton_pair || j < atom->nlocal) {
      Lubcontact_NS::add_vector(-1.0 * force_i, f[j]);
      if (TORQUE) Lubcontact_NS::add_vector(torque_j, torque[j]);
    }
    if (asked) tally_pair(l, old, geometry, load);
  }
  if (step.virial) add_virial(force, atom, queue);
  if constexpr (E::residual)
    if (step.virial) add_stresslets();
  queue.n = 0;
}

/* ----------------------------------------------------------------------
   energy, virial per atom, stress and power by origin, in the steps that need them: power from the
   history before the step (old) and after it
------------------------------------------------------------------------- */

template <class E>
[[gnu::noinline]] void LubcontactLoop<E>::tally_pair(int l, [[maybe_unused]] const double *old,
                                                     const PairGeometry &geometry, const Load &load)
{
  const int i = queue.i[l], j = queue.j[l];
  const PairCoeffs &c = *queue.coeffs[l];
  const double weight = step.pairs.share(j);
  if (step.tally_atoms) {
    const double energy = step.asked_energy ? Lubcontact_NS::pair_energy<E>(c, geometry, load)
                                            : 0.0;
    step.tally_atoms(i, j, energy, Lubcontact_NS::force_on_i(load, geometry),
                     geometry.r * geometry.n);
  }
  const double *next = SIZE ? queue.history[l] : nullptr;
  if (step.tally.asked_stress()) step.tally.add_stress(i, j, weight, geometry, load);
  if constexpr (E::residual) tally_stresslet(l, weight, geometry, load, next);
  if (!step.tally.asked_power()) return;

  step.tally.add_stored(weight, Lubcontact_NS::stored_energy<E>(c, geometry, load, next));
  if (queue.first[l] || update->setupflag) return;
  step.tally.add_heat(
      weight,
      Lubcontact_NS::step_loss<E>(c, film, geometry, body(i), body(j), update->dt, old, next));
}

/* ----------------------------------------------------------------------
   the virial is that of forces on i, positive if they repel: minus the stresslet
------------------------------------------------------------------------- */

template <class E> [[gnu::noinline]] void LubcontactLoop<E>::add_stresslets()
{
  fill();    // histories of this step
  Lubcontact_NS::stresslets_together<E>(queue.batch, film);
  for (int n = 0; n < 6; n++)
    for (int l = 0; l < queue.n; l++)
      queue.virial[n][l] -= step.pairs.share(queue.j[l]) * queue.batch.stresslet[n][l];
}

template <class E>
void LubcontactLoop<E>::tally_stresslet(int l, double weight, const PairGeometry &geometry,
                                        const Load &load, const double *history)
{
  const int i = queue.i[l], j = queue.j[l];
  const auto s =
      Lubcontact_NS::present_stresslet<E>(*queue.coeffs[l], film, geometry, load, history);
  if (step.tally_stresslet) step.tally_stresslet(i, j, s.normal + s.tangential);
  if (step.tally.asked_stress()) step.tally.add_stresslet(i, j, weight, s);
}

/* ---------------------------------------------------------------------- */

template <class E> void run_loop(LAMMPS *lmp, const LubcontactStep &step)
{
  LubcontactLoop<E>(lmp, step).run();
}

template <class E>
Load single_load(const PairCoeffs &c, const Lubcontact_NS::Film &film, const PairGeometry &geometry,
                 const double *history, double &energy)
{
  double buffer[E::HISTORY_SIZE + 1];
  if (!history) {
    Lubcontact_NS::first_history<E>(c, geometry, buffer);
    history = buffer;
  }
  const Load load = Lubcontact_NS::pair_load<E>(c, film, geometry, history);
  energy = Lubcontact_NS::pair_energy<E>(c, geometry, load);
  return load;
}

template <class E> void take_instance(LubcontactInstance &found)
{
  found.history = {E::HISTORY_SIZE, E::LAYOUT, &Lubcontact_NS::exchange_history<E>};
  found.loop = &run_loop<E>;
  found.single = &single_load<E>;
}

template <unsigned SHARE> void find_in_share(LubcontactInstance &found)
{
  Lubcontact_NS::with_share_of_effects<SHARE>(found.covering, [&found](auto effects) {
    take_instance<decltype(effects)>(found);
  });
}

}    // namespace LAMMPS_NS

#endif
