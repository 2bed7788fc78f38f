// Shared by the tests of the pore pressure with FFTW: steps and solutions on one rank.

#ifndef KERNEL_PORE_RUN_H
#define KERNEL_PORE_RUN_H

#include "pore_case.h"
#include "pore_solve.h"

namespace pore_case {

inline double same_on_all_ranks(double value)
{
  return value;
}

// K p = -D v - K G by conjugate gradients
inline Convergence solve_darcy(const Pores &pores, const std::vector<Motion> &motion,
                               const WallVelocity &wall, const Vec3 &mean_gradient,
                               double tolerance, Field &p)
{
  const Grid &g = pores.grid;
  ConstantSolver solver(g);
  solver.set_cell(g);
  Field r = imbalance(g, pores.matrix, pores.mobility, motion, wall, mean_gradient, p);
  project(g, false, r);
  const auto none = [](const Field &, std::vector<Motion> &, WallVelocity &) {
  };
  const auto apply = [&](const Field &q, Field &y) {
    apply_implicit(g, pores.matrix, pores.mobility, 0.0, 0.0, none, q, y);
  };
  const auto precondition = [&](const Field &q, Field &y) {
    solver.solve(q, 1.0, 0.0, y);
  };
  Field change(g.nodes(), 0.0);
  const Convergence found =
      conjugate_gradients(apply, precondition, same_on_all_ranks, r, tolerance, 500, change);
  for (std::size_t n = 0; n < p.size(); n++) p[n] += change[n];
  return found;
}

// Particles that move so little that D and K stay; plates at rest.
struct LinearRun {
  const Pores &pores;
  double dt;
  std::vector<double> inverse_mass;
  ConstantSolver solver;
  std::vector<Vec3> v, f_pore;
  Field p;

  LinearRun(const Pores &all, double time_step, const std::vector<double> &inverse) :
      pores(all), dt(time_step), inverse_mass(inverse), solver(all.grid), v(inverse.size()),
      f_pore(inverse.size()), p(all.grid.nodes(), 0.0)
  {
    solver.set_cell(pores.grid);
  }

  // from v(n-1/2) to v(n+1/2)
  void step(const std::vector<Vec3> &other)
  {
    std::vector<Vec3> ahead = pores.forces(p);
    for (std::size_t i = 0; i < v.size(); i++)
      ahead[i] = predicted(v[i], other[i], ahead[i], inverse_mass[i], dt);
    const std::vector<Motion> motion = pores.motion(ahead);
    Field r = imbalance(pores.grid, pores.matrix, pores.mobility, motion, {}, {}, p), change;
    project(pores.grid, false, r);
    solver.solve(r, largest(implicit_mobilities(pores.mobility, pores.bounds(inverse_mass), dt)),
                 0.0, change);
    for (std::size_t n = 0; n < p.size(); n++) p[n] += change[n];
    f_pore = pores.forces(p);
    for (std::size_t i = 0; i < v.size(); i++)
      v[i] = predicted(v[i], other[i], f_pore[i], inverse_mass[i], dt);
  }
};

// springs between neighbors, at their rest lengths at the start; the motion is small
struct Springs {
  struct Bond {
    std::size_t i, j;
    Vec3 n;
  };
  std::vector<Bond> bonds;
  double stiffness;

  Springs(const Bed &bed, const Cell &c, bool plates, double range, double k) : stiffness(k)
  {
    for (std::size_t i = 0; i < bed.size(); i++)
      for (std::size_t j = 0; j < i; j++) {
        const Vec3 d = difference(c, plates, bed.x[i], bed.x[j]);
        if (norm(d) < range) bonds.push_back({i, j, (1.0 / norm(d)) * d});
      }
  }
  std::vector<Vec3> forces(const std::vector<Vec3> &u) const
  {
    std::vector<Vec3> f(u.size());
    for (const Bond &b : bonds) {
      const Vec3 push = (-stiffness * dot(b.n, u[b.i] - u[b.j])) * b.n;
      f[b.i] = f[b.i] + push;
      f[b.j] = f[b.j] - push;
    }
    return f;
  }
  double energy(const std::vector<Vec3> &u) const
  {
    double sum = 0.0;
    for (const Bond &b : bonds) {
      const double stretch = dot(b.n, u[b.i] - u[b.j]);
      sum += 0.5 * stiffness * stretch * stretch;
    }
    return sum;
  }
  // largest eigenvalue
  double largest(std::size_t size, Random &rnd) const
  {
    std::vector<Vec3> u(size);
    for (Vec3 &one : u) one = rnd.vector(1.0);
    double value = 0.0;
    for (int n = 0; n < 400; n++) {
      std::vector<Vec3> f = forces(u);
      double square = 0.0;
      for (const Vec3 &one : f) square += dot(one, one);
      value = std::sqrt(square);
      for (std::size_t i = 0; i < size; i++) u[i] = (-1.0 / value) * f[i];
    }
    return value;
  }
};

}    // namespace pore_case

#endif
