// Random pairs for the tests of batches.

#ifndef KERNEL_BATCH_CASE_H
#define KERNEL_BATCH_CASE_H

#include "lubcontact_batch.h"
#include "tools.h"

namespace testing_tools {

using namespace LAMMPS_NS::Lubcontact_NS;

struct Case {
  PairCoeffs c;
  Body i, j;
  double a, history[Batch::HISTORY];

  explicit Case(Random &rnd)
  {
    const double g = rnd.log_uniform(1e2, 1e4), k = rnd.log_uniform(1e2, 1e5);
    const double eps = rnd.coin() ? rnd.log_uniform(1e-3, 0.1) : 0.0;
    c = {{g, k, {k / g, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, false}},
         rnd.log_uniform(1e2, 1e4),
         rnd.uniform(0.0, 1.0)};
    c.normal.gap.release_a = eps > 0.0 && rnd.coin() ? eps * rnd.uniform(1.0, 2.0) : eps;
    c.normal.gap.ln_release = c.normal.gap.release_a > eps ? std::log(c.normal.gap.release_a)
                                                           : c.normal.gap.ln_eps;
    if (rnd.coin()) c.normal.repulsion = {rnd.log_uniform(1e-2, 1e2), rnd.log_uniform(10.0, 1e3)};
    const FrictionLaw laws[] = {FrictionLaw::COULOMB, FrictionLaw::STEP, FrictionLaw::SHIFT,
                                FrictionLaw::RAMP, FrictionLaw::BRIZMER};
    c.threshold = make_threshold(laws[rnd.engine() % 5], rnd.log_uniform(1e-2, 1e2), c.mu);
    const double ri = rnd.uniform(0.5, 1.5), rj = rnd.uniform(0.5, 1.5);
    a = effective_radius(Radius::HARMONIC, ri, rj);
    const double un = a * rnd.uniform(-0.02, 0.4);
    const Vec3 xj = rnd.vector(10.0);
    i = {xj + (ri + rj + un) * rnd.unit(), rnd.vector(1.0), rnd.vector(1.0), ri};
    j = {xj, rnd.vector(1.0), rnd.vector(1.0), rj};
    for (double &slot : history) slot = rnd.uniform(-1e-2, 1e-2);
    if (rnd.coin()) c.restitution = restitution_coeff(rnd.log_uniform(1e-3, 1.0), g);
    i.mass = rnd.log_uniform(1e-2, 1e2);
    j.mass = rnd.log_uniform(1e-2, 1e2);
  }

  template <class E> void set_history(Random &rnd, const PairGeometry &g)
  {
    if constexpr (E::gap_history) {
      const double u = g.un > 0.0 ? g.un_a * rnd.uniform(0.9, 1.1) : rnd.log_uniform(1e-4, 1e-2);
      history[E::GAP_SLOT] = u;
      history[E::GAP_SLOT + 1] = std::log(u);
    }
    if constexpr (E::adhesion) {
      const double u = E::gap_history ? history[E::GAP_SLOT] : g.un_a;
      const bool may = u < c.normal.gap.release_a && rnd.coin();
      history[E::BOND_SLOT] = may || u < c.normal.gap.eps_a ? 1.0 : 0.0;
    }
    if constexpr (E::surface_history)
      history[E::SURFACE_SLOT] = g.un + g.a * rnd.uniform(-1e-4, 1e-4);
  }

  PairGeometry geometry() const { return pair_geometry(i.x, j.x, i.radius, j.radius, a); }
};

inline void put(const Case &k, Batch &b, int l)
{
  put_lane(k.i.x - k.j.x, b.x, l);
  put_lane(k.i.v - k.j.v, b.v, l);
  put_lane(k.i.omega, b.omega_i, l);
  put_lane(k.j.omega, b.omega_j, l);
  b.radius_i[l] = k.i.radius;
  b.radius_j[l] = k.j.radius;
  b.a[l] = k.a;
  b.g[l] = k.c.normal.g;
  b.asperity[l] = k.c.normal.asperity;
  b.alpha[l] = k.c.normal.gap.alpha;
  b.eps_a[l] = k.c.normal.gap.eps_a;
  b.ln_eps[l] = k.c.normal.gap.ln_eps;
  b.release_a[l] = k.c.normal.gap.release_a;
  b.ln_release[l] = k.c.normal.gap.ln_release;
  b.restitution[l] = k.c.restitution;
  b.mass_i[l] = k.i.mass;
  b.mass_j[l] = k.j.mass;
  b.repulsion[l] = k.c.normal.repulsion.force;
  b.per_screening[l] = k.c.normal.repulsion.per_length;
  b.least[l] = k.c.threshold.least;
  b.shift[l] = k.c.threshold.shift;
  b.per_ramp[l] = k.c.threshold.per_ramp;
  b.per_plastic[l] = k.c.threshold.per_plastic;
  b.plastic = b.plastic || b.per_plastic[l] > 0.0;
  b.kt[l] = k.c.kt;
  b.mu[l] = k.c.mu;
  for (int m = 0; m < Batch::HISTORY; m++) b.history[m][l] = k.history[m];
}

}    // namespace testing_tools

#endif
