// All functions that a device would call, as numbers. test_defs.cpp compiles them as the package
// does, marked.cpp as a device compiler would: marked, without exceptions.

#ifndef KERNEL_MARKED_CASE_H
#define KERNEL_MARKED_CASE_H

#include "fluid_drag.h"
#include "fluid_flow.h"
#include "lubcontact_power.h"
#include "lubcontact_stiffness.h"

namespace {

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace LAMMPS_NS::Fluid_NS;

struct Numbers {
  static constexpr int MOST = 200000;
  double *out;
  int size = 0;
  std::uint64_t state = 4711;

  void put(double x)
  {
    if (size < MOST) out[size] = x;
    size++;
  }
  void put(const Vec3 &a)
  {
    put(a.x);
    put(a.y);
    put(a.z);
  }
  double uniform(double lo, double hi)    // Knuth's generator
  {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return lo + (hi - lo) * static_cast<double>(state >> 11) * 0x1p-53;
  }
  Vec3 vector(double size_)
  {
    const double x = uniform(-size_, size_), y = uniform(-size_, size_);
    return {x, y, uniform(-size_, size_)};
  }
};

template <class E>
void put_load(Numbers &n, const PairCoeffs &c, const PairGeometry &g, const Load &load,
              const double *history)
{
  n.put(force_on_i(load, g));
  n.put(torque_on_i(load, g));
  n.put(torque_on_j(load, g));
  for (const Vec3 &f : force_by_channel(g, load).of) n.put(f);
  n.put(load.u);
  n.put(pair_energy<E>(c, g, load));
  for (const double x : stored_energy<E>(c, g, load, history).of) n.put(x);
}

// A pair on its way, with long and short steps.
template <unsigned MASK> void put_pair(Numbers &n, Range rule, bool euler)
{
  using E = Effects<MASK>;
  const Film f = make_film(n.uniform(0.0, 2.0), 0.5, rule, 0.6);
  const double eps_a = n.uniform(0.01, 0.1);
  GapLaw gap{n.uniform(0.1, 10.0), eps_a, std::log(eps_a), euler};
  gap.release_a = 1.1 * eps_a;
  gap.ln_release = std::log(gap.release_a);
  const double g = n.uniform(100.0, 1000.0);
  const PairCoeffs c{{g, gap.alpha * g, gap, {n.uniform(0.0, 1.0), 50.0}},
                     n.uniform(100.0, 1000.0),
                     n.uniform(0.0, 1.0),
                     make_threshold(euler ? FrictionLaw::BRIZMER : FrictionLaw::RAMP, 0.1, 0.3),
                     {},
                     restitution_coeff(n.uniform(0.1, 0.9), g)};
  Body i{{2.1, 0.0, 0.0}, {}, {}, 1.1}, j{{}, {}, {}, 0.9};
  const double a = effective_radius(Radius::HARMONIC, i.radius, j.radius);
  double old[E::HISTORY_SIZE + 1] = {}, next[E::HISTORY_SIZE + 1] = {};
  first_history<E>(c, pair_geometry(i.x, j.x, i.radius, j.radius, a), old);
  for (int step = 0; step < 20; step++) {
    const double dt = step % 5 ? 1e-3 : 0.1;
    i.v = n.vector(0.5) - 0.3 * (i.x - Vec3{1.98, 0.0, 0.0});
    i.omega = n.vector(1.0);
    j.omega = n.vector(1.0);
    i.x = i.x + dt * i.v;
    const PairGeometry at = pair_geometry(i.x, j.x, i.radius, j.radius, a);
    if (!next_history_usual<E>(c, f, at, i, j, dt, old, next))
      next_history<E>(c, f, at, i, j, dt, old, next);
    put_load<E>(n, c, at, pair_load<E>(c, f, at, next), next);
    for (const double x : step_loss<E>(c, f, at, i, j, dt, old, next).of) n.put(x);
    const PairStiffness k =
        pair_stiffness(g, c.kt, SPIN_OF_INERTIA, at, i.radius, j.radius, E::roll, E::twist);
    n.put(k.i);
    n.put(k.j);
    for (int m = 0; m < E::HISTORY_SIZE; m++) n.put(old[m] = next[m]);
  }
}

template <unsigned... MASK> void put_pairs(Numbers &n)
{
  for (int pair = 0; pair < 10; pair++)
    (put_pair<MASK>(n, pair % 2 ? Range::CUT : Range::SHIFTED, pair % 5 == 4), ...);
}

void put_particle(Numbers &n)
{
  const Drag d = drag(Shape::SPHERE, n.uniform(0.1, 2.0), n.uniform(0.5, 1.5));
  const Flow flow = couette_flow({-1.0, -2.0, 1.0, 2.0}, n.uniform(-1.5, 1.5));
  const Flow other = poiseuille_flow({-1.0, 1.0, 2.0}, n.uniform(-1.5, 1.5));
  const Vec3 v = n.vector(1.0), force = n.vector(1.0);
  n.put(damped(mean_drag(n.uniform(0.0, 2.0)), d.translation, force, v, flow.velocity));
  n.put(damped(mean_drag_full(n.uniform(0.0, 2.0)), d.rotation, force, v, other.velocity));
  n.put(overdamped(d.translation, force, shear_flow(2.0, v.y).velocity));
  double rate[6], inverse[6];
  for (int m = 0; m < 6; m++) rate[m] = n.uniform(-1.0, 1.0), inverse[m] = n.uniform(-1.0, 1.0);
  const Flow cell = cell_flow(rate, inverse, v, force, v);
  n.put(cell.velocity);
  n.put(cell.spin);
}

int put_all(double *out)
{
  Numbers n{out};
  put_pairs<0, SQUEEZE, SQUEEZE | SHEAR, FRICTION, 63, SQUEEZE | ADHESION, 255, RESTITUTION, 511>(
      n);
  for (int m = 0; m < 100; m++) put_particle(n);
  return n.size;
}

}    // namespace

#endif
