/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Exact solution of (c K1 + s) p = r, K1 being K with k/eta = 1 everywhere, by Fourier transforms:
// along x and z, along y, too, if it is periodic; between plates sines or cosines along y. An
// impermeable plate is the mirror plane of an even function: its rows, half those of inner nodes,
// are doubled. s is a storage per inner node, half of it at the plates.
// Transforms: M. Frigo, S.G. Johnson, Proc. IEEE 93, 216 (2005). Plans are estimated, not measured:
// each rank and each run then computes the same.

#ifndef LMP_PORE_SOLVE_H
#define LMP_PORE_SOLVE_H

#include "pore_operator.h"

#include <fftw3.h>
#include <memory>
#include <new>

namespace LAMMPS_NS::Pore_NS {

class ConstantSolver {
 public:
  // for this number of elements and these walls; the cell may change
  explicit ConstantSolver(const Grid &);

  // for this cell
  void set_cell(const Grid &);

  // p from r, 0 at the nodes where the pressure is given; without such nodes and s, the mean of r
  // is left out and that of p is 0. 0 if c is 0, which is a cell without particles and k
  void solve(const Field &r, double c, double s, Field &p) const;

 private:
  struct Free {
    void operator()(void *p) const { fftw_free(p); }
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
  };
  using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, Free>;

  int nx, ny, nz;
  Wall lower, upper;
  int rows, first;               // layers with unknown pressure, the first of them
  bool mirrored;                 // layers are taken from the upper plate on
  double norm;                   // of a transform there and back
  std::vector<double> symbol;    // of K1, as the transform is ordered
  std::unique_ptr<double, Free> real;
  std::unique_ptr<fftw_complex, Free> waves;
  Plan along_y, back_along_y, forward, backward;

  std::size_t layer_of(int row) const
  {
    return static_cast<std::size_t>(first + (mirrored ? rows - 1 - row : row));
  }
  // impermeable plates are at the ends of the rows
  bool is_wall(int row) const
  {
    const auto layer = layer_of(row);
    return lower != Wall::PERIODIC && (layer == 0 || layer == static_cast<std::size_t>(ny));
  }
};

inline ConstantSolver::ConstantSolver(const Grid &g) :
    nx(g.nx), ny(g.ny), nz(g.nz), lower(g.lower), upper(g.upper),
    rows(g.layers() - (g.lower == Wall::DRAINED) - (g.upper == Wall::DRAINED)),
    first(g.lower == Wall::DRAINED), mirrored(lower == Wall::DRAINED && upper != Wall::DRAINED),
    norm(static_cast<double>(nx) * nz * (g.has_plates() ? 2 * ny : ny))
{
  if (rows == 0) return;    // between two drained plates
  const int size = nx * nz, half = nx / 2 + 1, columns = nz * half;
  real.reset(fftw_alloc_real(static_cast<std::size_t>(rows) * size));
  waves.reset(fftw_alloc_complex(static_cast<std::size_t>(rows) * columns));
  if (!real || !waves) throw std::bad_alloc();

  if (!g.has_plates()) {
    const int n[3] = {ny, nz, nx};
    forward.reset(fftw_plan_dft_r2c(3, n, real.get(), waves.get(), FFTW_ESTIMATE));
    backward.reset(fftw_plan_dft_c2r(3, n, waves.get(), real.get(), FFTW_ESTIMATE));
    return;
  }
  fftw_r2r_kind there = FFTW_REDFT01, back = FFTW_REDFT10;
  if (lower == upper) there = back = lower == Wall::DRAINED ? FFTW_RODFT00 : FFTW_REDFT00;
  double *r = real.get();
  const auto transform = [&](fftw_r2r_kind kind) {
    return fftw_plan_many_r2r(1, &rows, size, r, nullptr, size, 1, r, nullptr, size, 1, &kind,
                              FFTW_ESTIMATE);
  };
  along_y.reset(transform(there));
  back_along_y.reset(transform(back));
  const int n[2] = {nz, nx};
  forward.reset(fftw_plan_many_dft_r2c(2, n, rows, r, nullptr, 1, size, waves.get(), nullptr, 1,
                                       columns, FFTW_ESTIMATE));
  backward.reset(fftw_plan_many_dft_c2r(2, n, rows, waves.get(), nullptr, 1, columns, r, nullptr, 1,
                                        size, FFTW_ESTIMATE));
}

// Along one axis, spacing 1: stiffness 2 - 2 cos q, mass (4 + 2 cos q)/6; sin q of the product of a
// slope and a value.
inline void ConstantSolver::set_cell(const Grid &g)
{
  struct Wave {
    double stiffness, mass, mixed;
  };
  const auto wave = [](double q) {
    return Wave{2.0 - 2.0 * std::cos(q), (4.0 + 2.0 * std::cos(q)) / 6.0, std::sin(q)};
  };
  const auto waves_of = [&](int n) {
    std::vector<Wave> all(n);
    for (int m = 0; m < n; m++) all[m] = wave(2.0 * PI * m / n);
    return all;
  };
  const Metric m = metric(g);
  const double volume = g.element_volume();
  const auto product = [&](int a, int b) {
    return volume * dot(m.along[a], m.along[b]);
  };
  const double xx = product(0, 0), yy = product(1, 1), zz = product(2, 2);
  const double xy = 2.0 * product(0, 1), xz = 2.0 * product(0, 2), yz = 2.0 * product(1, 2);
  const std::vector<Wave> x = waves_of(nx), z = waves_of(nz);

  symbol.clear();
  for (int j = 0; j < rows; j++) {
    double q = 2.0 * PI * j / ny;
    if (lower != Wall::PERIODIC) {
      q = PI * j / ny;
      if (lower != upper) q = PI * (j + 0.5) / ny;
      if (lower == Wall::DRAINED && upper == Wall::DRAINED) q = PI * (j + 1) / ny;
    }
    const Wave y = wave(q);
    for (int k = 0; k < nz; k++)
      for (int i = 0; i < nx / 2 + 1; i++)
        symbol.push_back(
            xx * x[i].stiffness * y.mass * z[k].mass + yy * x[i].mass * y.stiffness * z[k].mass +
            zz * x[i].mass * y.mass * z[k].stiffness + xy * x[i].mixed * y.mixed * z[k].mass +
            xz * x[i].mixed * y.mass * z[k].mixed + yz * x[i].mass * y.mixed * z[k].mixed);
  }
}

inline void ConstantSolver::solve(const Field &r, double c, double s, Field &p) const
{
  p.assign(r.size(), 0.0);
  if (rows == 0) return;
  const auto size = static_cast<std::ptrdiff_t>(nx) * nz;
  for (int row = 0; row < rows; row++) {
    const double factor = is_wall(row) ? 2.0 : 1.0;
    const double *from = &r[layer_of(row) * size];
    std::transform(from, from + size, real.get() + row * size, [=](double a) {
      return factor * a;
    });
  }
  if (along_y) fftw_execute(along_y.get());
  fftw_execute(forward.get());
  for (std::size_t n = 0; n < symbol.size(); n++) {
    const double lambda = c * symbol[n] + s;
    const double factor = lambda > 0.0 ? 1.0 / (lambda * norm) : 0.0;    // 0: the constant
    waves.get()[n][0] *= factor;
    waves.get()[n][1] *= factor;
  }
  fftw_execute(backward.get());
  if (back_along_y) fftw_execute(back_along_y.get());
  for (int row = 0; row < rows; row++)
    std::copy_n(real.get() + row * size, size, &p[layer_of(row) * size]);
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
