// A few spheres under the law of pairs, moved by velocity Verlet as LAMMPS' fix nve/sphere does:
// whole scenes without LAMMPS. Velocities of the half step go into the law, pairs out of range
// forget, all pairs have the same coefficients.

#ifndef HARD_CASES_SCENE_H
#define HARD_CASES_SCENE_H

#include "../kernel/tools.h"
#include "lubcontact_power.h"

#include <numeric>
#include <vector>

namespace hard_cases {

using namespace LAMMPS_NS::Lubcontact_NS;

// The functions of one mask of effects.
struct Law {
  unsigned mask;
  int size;
  void (*first)(const PairCoeffs &, const PairGeometry &, double *);
  void (*next)(const PairCoeffs &, const Film &, const PairGeometry &, const Body &, const Body &,
               double, const double *, double *);
  Load (*load)(const PairCoeffs &, const Film &, const PairGeometry &, const double *);
  Energies (*stored)(const PairCoeffs &, const PairGeometry &, const Load &, const double *);
  Energies (*loss)(const PairCoeffs &, const Film &, const PairGeometry &, const Body &,
                   const Body &, double, const double *, const double *);
};

template <unsigned MASK> Law make_law()
{
  using E = Effects<MASK>;
  return {MASK,          E::HISTORY_SIZE,   &first_history<E>, &next_history<E>,
          &pair_load<E>, &stored_energy<E>, &step_loss<E>};
}

struct Sphere {
  Vec3 x, v, omega;
  double radius, mass;    // mass 0: it does not move
  Vec3 force{}, torque{};
};

struct Pair {
  int i, j;
  bool known = false;
  double history[11] = {};
  PairGeometry g{};
  Load load{};
};

struct Scene {
  const Law &law;
  PairCoeffs c;
  Film film;
  Radius rule = Radius::HARMONIC;
  double dt = 0.0;
  Vec3 gravity{};
  std::vector<Sphere> spheres{};
  std::vector<Pair> pairs{};
  Energies heat{};
  double dropped = 0.0;    // energy of springs that left the range with their pair
  double brought = 0.0;    // energy that pairs have where they come into range: repulsion

  void start()
  {
    const int n = static_cast<int>(spheres.size());
    pairs.clear();
    for (int i = 0; i < n; i++)
      for (int j = i + 1; j < n; j++) pairs.push_back({i, j});
    add_forces(false);
  }

  void step()
  {
    kick();
    for (Sphere &s : spheres)
      if (s.mass > 0.0) s.x = s.x + dt * s.v;
    add_forces(true);
    kick();
  }

  double kinetic() const
  {
    double sum = 0.0;
    for (const Sphere &s : spheres)
      sum += 0.5 * s.mass * dot(s.v, s.v) +
          0.2 * s.mass * s.radius * s.radius * dot(s.omega, s.omega) - s.mass * dot(gravity, s.x);
    return sum;
  }

  double stored() const
  {
    double sum = 0.0;
    for (const Pair &p : pairs)
      if (p.known) sum += total(law.stored(c, p.g, p.load, p.history));
    return sum;
  }

  static double total(const Energies &e) { return std::accumulate(e.of, e.of + NUM_ORIGINS, 0.0); }

  Vec3 momentum() const
  {
    Vec3 sum;
    for (const Sphere &s : spheres) sum = sum + s.mass * s.v;
    return sum;
  }

  Vec3 angular_momentum() const
  {
    Vec3 sum;
    for (const Sphere &s : spheres)
      sum = sum + s.mass * cross(s.x, s.v) + (0.4 * s.mass * s.radius * s.radius) * s.omega;
    return sum;
  }

 private:
  void kick()
  {
    for (Sphere &s : spheres) {
      if (s.mass == 0.0) continue;
      s.v = s.v + (0.5 * dt / s.mass) * s.force + (0.5 * dt) * gravity;
      s.omega = s.omega + (0.5 * dt / (0.4 * s.mass * s.radius * s.radius)) * s.torque;
    }
  }

  void add_forces(bool advance)
  {
    for (Sphere &s : spheres) s.force = s.torque = {};
    for (Pair &p : pairs) {
      Sphere &si = spheres[static_cast<std::size_t>(p.i)];
      Sphere &sj = spheres[static_cast<std::size_t>(p.j)];
      const double a = effective_radius(rule, si.radius, sj.radius);
      const PairGeometry before = p.g;
      p.g = pair_geometry(si.x, sj.x, si.radius, sj.radius, a);
      if (p.g.un >= film.reach_a * a) {
        if (p.known) dropped += total(law.stored(c, before, p.load, p.history));
        p.known = false;
        continue;
      }
      const Body i{si.x, si.v, si.omega, si.radius}, j{sj.x, sj.v, sj.omega, sj.radius};
      const bool known = p.known;
      if (!known)
        law.first(c, p.g, p.history);
      else if (advance)
        advance_pair(p, i, j);
      p.known = true;
      p.load = law.load(c, film, p.g, p.history);
      if (advance && !known) brought += total(law.stored(c, p.g, p.load, p.history));
      const Vec3 force = force_on_i(p.load, p.g);
      si.force = si.force + force;
      sj.force = sj.force - force;
      si.torque = si.torque + torque_on_i(p.load, p.g);
      sj.torque = sj.torque + torque_on_j(p.load, p.g);
    }
  }

  void advance_pair(Pair &p, const Body &i, const Body &j)
  {
    double old[11];
    std::copy(p.history, p.history + law.size, old);
    law.next(c, film, p.g, i, j, dt, old, p.history);
    const Energies lost = law.loss(c, film, p.g, i, j, dt, old, p.history);
    for (int m = 0; m < NUM_ORIGINS; m++) heat.of[m] += lost.of[m];
  }
};

inline PairCoeffs make_coeffs(double g, double k, double eps, double kt, double mu)
{
  PairCoeffs c{{g, k, {k / g, eps, eps > 0.0 ? std::log(eps) : -HUGE_VAL, false}}, kt, mu};
  c.normal.gap.release_a = eps;
  c.normal.gap.ln_release = c.normal.gap.ln_eps;
  return c;
}

inline double ball_mass(double density, double radius)
{
  return 4.0 / 3.0 * PI * density * radius * radius * radius;
}

}    // namespace hard_cases

#endif
