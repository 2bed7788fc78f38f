/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What a force density on the points of a periodic cell of any shape does there, by Fourier
// transforms: hydro_waves.h says what becomes of a wave. Transforms: M. Frigo, S.G. Johnson, Proc.
// IEEE 93, 216 (2005); their plans are estimated, not measured: each run then computes the same.
//
// A field may have a companion f' and stands for f + lap f' then; so does the response have that of
// lap u.
//
// Several ranks share the grid: each has some layers in z of the force, and some rows in y of its
// waves. Between the two all ranks exchange what they have of each other's.

#ifndef LMP_HYDRO_SOLVE_H
#define LMP_HYDRO_SOLVE_H

#include "hydro_layers.h"
#include "hydro_waves.h"

#include <array>
#include <complex>
#include <fftw3.h>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace LAMMPS_NS::Hydro_NS {

class StokesSolver {
 public:
  using Complex = std::complex<double>;

  StokesSolver(const std::array<int, 3> &points, int rank, int ranks, int components = VECTOR);

  Share layers() const { return share(nz, me, ranks); }
  std::size_t points() const { return static_cast<std::size_t>(nx) * ny * layers().number(); }

  // the components in the layers of this rank, one array after the other: forces, then velocities
  double *field() { return real.get(); }
  const double *field() const { return real.get(); }

  // What respond() multiplies waves by: f(wave), over the volume of a point. The shortest waves,
  // which have no sign, are left out.
  template <class F> void set_response(const Cell &cell, F &&f);

  // In this order, with an exchange of all ranks after each of the first two: what is in outbox()
  // goes to the inbox() of others, as many numbers for each rank as
  // of_forces() or of_waves() says.
  void to_waves();
  void respond();
  void to_velocities();

  const Complex *outbox() const { return out.data(); }
  Complex *inbox() { return in.data(); }
  void exchange_alone() { out.swap(in); }    // of a rank that is the only one
  const std::vector<int> &of_forces() const { return of_planes; }    // exchanged for waves
  const std::vector<int> &of_waves() const { return of_columns; }

  double memory_usage() const;

 private:
  struct Free {
    void operator()(void *p) const { fftw_free(p); }
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
  };
  using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, Free>;

  int nx, ny, nz, me, ranks, components;
  int half;    // waves along x
  std::unique_ptr<double, Free> real;
  std::unique_ptr<fftw_complex, Free> plane, column;    // layers in z; rows in y, z next
  std::vector<Complex> out, in;
  Cell edges;
  std::vector<WaveFactors> factors;
  std::vector<int> of_planes, of_columns;    // numbers that go to each rank, or come from it
  Plan forward, backward, along_z, back_along_z;

  Share rows() const { return share(ny, me, ranks); }
  std::size_t plane_size() const { return static_cast<std::size_t>(ny) * half; }

  template <class F> void for_each_plane_row(F &&) const;
  template <class F> void for_each_column_row(F &&) const;
  template <class F> void for_each_wave(F &&) const;
};

inline StokesSolver::StokesSolver(const std::array<int, 3> &number, int rank, int all, int values) :
    nx(number[0]), ny(number[1]), nz(number[2]), me(rank), ranks(all), components(values),
    half(nx / 2 + 1)
{
  const int layer = nx * ny, mine = layers().number(), my_rows = rows().number();
  const std::size_t planes = components * mine * plane_size();
  const std::size_t columns = static_cast<std::size_t>(components) * my_rows * nz * half;
  real.reset(fftw_alloc_real(components * points() + 1));
  plane.reset(fftw_alloc_complex(planes + 1));
  column.reset(fftw_alloc_complex(columns + 1));
  if (!real || !plane || !column) throw std::bad_alloc();
  out.resize(std::max(planes, columns) + 1);
  in.resize(out.size());
  for (int r = 0; r < ranks; r++) {
    of_planes.push_back(components * mine * share(ny, r, ranks).number() * half);
    of_columns.push_back(components * my_rows * share(nz, r, ranks).number() * half);
  }
  if (mine > 0) {
    const int n[2] = {ny, nx};
    forward.reset(fftw_plan_many_dft_r2c(2, n, components * mine, real.get(), nullptr, 1, layer,
                                         plane.get(), nullptr, 1, ny * half, FFTW_ESTIMATE));
    backward.reset(fftw_plan_many_dft_c2r(2, n, components * mine, plane.get(), nullptr, 1,
                                          ny * half, real.get(), nullptr, 1, layer, FFTW_ESTIMATE));
  }
  if (my_rows > 0) {
    const fftw_iodim length = {nz, half, half};
    const fftw_iodim many[2] = {{components * my_rows, nz * half, nz * half}, {half, 1, 1}};
    const auto plan = [&](int sign) {
      return fftw_plan_guru_dft(1, &length, 2, many, column.get(), column.get(), sign,
                                FFTW_ESTIMATE);
    };
    along_z.reset(plan(FFTW_FORWARD));
    back_along_z.reset(plan(FFTW_BACKWARD));
  }
}

// Rows of waves along x in the order in which they are exchanged: for each rank, component, layer
// and row.
template <class F> void StokesSolver::for_each_plane_row(F &&f) const
{
  for (int r = 0; r < ranks; r++) {
    const Share theirs = share(ny, r, ranks);
    for (int c = 0; c < components; c++)
      for (int k = 0; k < layers().number(); k++)
        for (int j = theirs.first; j < theirs.last; j++)
          f(((static_cast<std::size_t>(c) * layers().number() + k) * ny + j) * half);
  }
}

template <class F> void StokesSolver::for_each_column_row(F &&f) const
{
  for (int r = 0; r < ranks; r++) {
    const Share theirs = share(nz, r, ranks);
    for (int c = 0; c < components; c++)
      for (int k = theirs.first; k < theirs.last; k++)
        for (int j = 0; j < rows().number(); j++)
          f(((static_cast<std::size_t>(c) * rows().number() + j) * nz + k) * half);
  }
}

inline void StokesSolver::to_waves()
{
  if (forward) fftw_execute(forward.get());
  Complex *to = out.data();
  const auto *from = reinterpret_cast<const Complex *>(plane.get());
  for_each_plane_row([&](std::size_t row) {
    to = std::copy_n(from + row, half, to);
  });
}

inline void StokesSolver::to_velocities()
{
  const Complex *from = in.data();
  auto *to = reinterpret_cast<Complex *>(plane.get());
  for_each_plane_row([&](std::size_t row) {
    std::copy_n(from, half, to + row);
    from += half;
  });
  if (backward) fftw_execute(backward.get());
}

// Calls f(wave, n) for the waves of this rank in the order in which it has them.
template <class F> void StokesSolver::for_each_wave(F &&f) const
{
  const double to_x = 2.0 * PI / edges.xprd, to_y = 1.0 / edges.yprd, to_z = 1.0 / edges.zprd;
  const Share mine = rows();
  std::size_t n = 0;
  for (int j = mine.first; j < mine.last; j++)
    for (int k = 0; k < nz; k++)
      for (int i = 0; i < half; i++, n++) {
        WaveVector w{{}, 0.0, {signed_wave(i, nx), signed_wave(j, ny), signed_wave(k, nz)}};
        w.k.x = to_x * w.number[0];
        w.k.y = (2.0 * PI * w.number[1] - w.k.x * edges.xy) * to_y;
        w.k.z = (2.0 * PI * w.number[2] - w.k.x * edges.xz - w.k.y * edges.yz) * to_z;
        w.square = dot(w.k, w.k);
        f(w, n);
      }
}

template <class F> void StokesSolver::set_response(const Cell &cell, F &&f)
{
  edges = cell;
  factors.resize(static_cast<std::size_t>(rows().number()) * nz * half);
  const double norm = 1.0 / (static_cast<double>(nx) * ny * nz);
  const auto shortest = [](int m, int all) {
    return 2 * m == -all;
  };
  for_each_wave([&](const WaveVector &w, std::size_t n) {
    factors[n] = {0.0, 0.0};
    if (shortest(w.number[0], nx) || shortest(w.number[1], ny) || shortest(w.number[2], nz)) return;
    const WaveFactors found = f(w);
    factors[n] = {norm * found.across, norm * found.along};
  });
}

inline void StokesSolver::respond()
{
  auto *wave = reinterpret_cast<Complex *>(column.get());
  const Complex *from = in.data();
  for_each_column_row([&](std::size_t row) {
    std::copy_n(from, half, wave + row);
    from += half;
  });
  if (along_z) fftw_execute(along_z.get());
  const std::size_t component = factors.size();
  const bool companion = components == WITH_COMPANION;
  for_each_wave([&](const WaveVector &w, std::size_t n) {
    Complex &x = wave[n], &y = wave[n + component], &z = wave[n + 2 * component];
    const WaveFactors &f = factors[n];
    Complex *other = companion ? wave + n + 3 * component : nullptr;
    if (companion) {
      x -= w.square * other[0];
      y -= w.square * other[component];
      z -= w.square * other[2 * component];
    }
    const Complex along = w.square > 0.0
        ? (f.along - f.across) / w.square * (w.k.x * x + w.k.y * y + w.k.z * z)
        : 0.0;
    x = f.across * x + w.k.x * along;
    y = f.across * y + w.k.y * along;
    z = f.across * z + w.k.z * along;
    if (companion) {
      other[0] = -w.square * x;
      other[component] = -w.square * y;
      other[2 * component] = -w.square * z;
    }
  });
  if (back_along_z) fftw_execute(back_along_z.get());
  Complex *to = out.data();
  for_each_column_row([&](std::size_t row) {
    to = std::copy_n(wave + row, half, to);
  });
}

inline double StokesSolver::memory_usage() const
{
  return static_cast<double>(components * points() * sizeof(double) +
                             4 * in.size() * sizeof(Complex) +
                             factors.size() * sizeof(WaveFactors));
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
