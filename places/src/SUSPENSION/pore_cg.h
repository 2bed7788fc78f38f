/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Conjugate gradients with a preconditioner: M.R. Hestenes, E. Stiefel, J. Res. Nat. Bur. Stand.
// 49, 409 (1952). The matrix may be singular if the right side, and what the preconditioner
// returns, are not.

#ifndef LMP_PORE_CG_H
#define LMP_PORE_CG_H

#include <cmath>
#include <cstddef>
#include <vector>

namespace LAMMPS_NS::Pore_NS {

struct Convergence {
  int iterations = 0;
  double residual = 0.0;    // over that of p = 0
  bool positive = true;     // the preconditioner, as far as it was seen
};

// r.r, or r.P^-1 r: if P is near to A, the latter is the square of the error, e.A e.
enum class Measure { RESIDUAL, PRECONDITIONED };

inline double scalar_product(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); n++) sum += a[n] * b[n];
  return sum;
}

// Solves A p = rhs from the p given, until the residual is tolerance times the right side, or after
// the most iterations.
//   apply(p, y): y = A p;   precondition(r, z): z = P^-1 r, any multiple of it
//   product(a, b): scalar product, the same number on all ranks, so that all stop together
template <class Apply, class Precondition, class Product>
Convergence solve_by_products(const Apply &apply, const Precondition &precondition,
                              const Product &product, const std::vector<double> &rhs,
                              double tolerance, int most, std::vector<double> &p,
                              Measure measure = Measure::RESIDUAL)
{
  const std::size_t size = rhs.size();
  const bool plain = measure == Measure::RESIDUAL;
  std::vector<double> r(size), z, d, y;
  Convergence found;
  if (!plain) precondition(rhs, z);
  const double whole = product(rhs, plain ? rhs : z);
  if (!plain && whole < 0.0) {
    found.positive = false;
    return found;
  }
  if (!(whole > 0.0)) {
    p.assign(size, 0.0);
    return found;
  }
  apply(p, y);
  for (std::size_t n = 0; n < size; n++) r[n] = rhs[n] - y[n];
  double rz = 0.0;
  for (;; found.iterations++) {
    if (!plain) precondition(r, z);
    const double square = product(r, plain ? r : z);
    found.residual = std::sqrt(square / whole);
    if (!(found.residual > tolerance) && square >= 0.0) return found;
    if (found.iterations == most) return found;
    if (plain) precondition(r, z);
    const double next = plain ? product(r, z) : square;
    found.positive = !(next < 0.0);
    if (!found.positive) return found;
    if (found.iterations == 0)
      d = z;
    else
      for (std::size_t n = 0; n < size; n++) d[n] = z[n] + next / rz * d[n];
    rz = next;
    apply(d, y);
    const double step = rz / product(d, y);
    if (!std::isfinite(step)) return found;    // nothing is left that A or P see
    for (std::size_t n = 0; n < size; n++) {
      p[n] += step * d[n];
      r[n] -= step * y[n];
    }
  }
}

// The same if every rank has all of p.
//   agree(value): that of one rank on all of them
template <class Apply, class Precondition, class Agree>
Convergence conjugate_gradients(const Apply &apply, const Precondition &precondition,
                                const Agree &agree, const std::vector<double> &rhs,
                                double tolerance, int most, std::vector<double> &p)
{
  const auto product = [&](const std::vector<double> &a, const std::vector<double> &b) {
    return agree(scalar_product(a, b));
  };
  return solve_by_products(apply, precondition, product, rhs, tolerance, most, p);
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
