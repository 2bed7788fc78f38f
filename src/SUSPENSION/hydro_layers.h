/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// From the bricks of all ranks, which hold what their spheres reach, to the layers in z of the grid
// that each rank solves for, and back. Both sides go through the rows of a brick in the same order,
// so that what is sent is values alone.

#ifndef LMP_HYDRO_LAYERS_H
#define LMP_HYDRO_LAYERS_H

#include "hydro_lattice.h"

#include <algorithm>
#include <array>

namespace LAMMPS_NS::Hydro_NS {

using Points = std::array<int, 3>;    // of the grid of a cell

// Of n in a row, one of several ranks has those from first to last - 1.
struct Share {
  int first, last;
  int number() const { return last - first; }
};

inline Share share(int n, int rank, int ranks)
{
  return {static_cast<int>(static_cast<long long>(n) * rank / ranks),
          static_cast<int>(static_cast<long long>(n) * (rank + 1) / ranks)};
}

inline int wrapped(int i, int n)
{
  const int rest = i % n;
  return rest < 0 ? rest + n : rest;
}

// Calls f(j, k) for the rows of a brick that are images of rows in some layers.
template <class F>
void for_each_row_in(const Brick &brick, const Points &points, const Share &layers, F &&f)
{
  for (int k = brick.low[2]; k < brick.low[2] + brick.size[2]; k++) {
    const int layer = wrapped(k, points[2]);
    if (layer < layers.first || layer >= layers.last) continue;
    for (int j = brick.low[1]; j < brick.low[1] + brick.size[1]; j++) f(j, k);
  }
}

// numbers to exchange
inline std::size_t numbers_in(const Brick &brick, const Points &points, const Share &layers,
                              int components)
{
  std::size_t rows = 0;
  for_each_row_in(brick, points, layers, [&](int, int) {
    rows++;
  });
  return components * rows * brick.size[0];
}

// What a brick has in some layers, row by row, the components of each in turn, and back.
inline void pack_brick(const Brick &brick, const Points &points, const Share &layers,
                       int components, const double *field, double *numbers)
{
  const int stride = padded(components);
  for_each_row_in(brick, points, layers, [&](int j, int k) {
    const double *row = field + stride * brick.index(brick.low[0], j, k);
    for (int c = 0; c < components; c++, numbers += brick.size[0])
      for (int i = 0; i < brick.size[0]; i++) numbers[i] = row[stride * i + c];
  });
}

inline void unpack_brick(const Brick &brick, const Points &points, const Share &layers,
                         int components, const double *numbers, double *field)
{
  const int stride = padded(components);
  for_each_row_in(brick, points, layers, [&](int j, int k) {
    double *row = field + stride * brick.index(brick.low[0], j, k);
    for (int c = 0; c < components; c++, numbers += brick.size[0])
      for (int i = 0; i < brick.size[0]; i++) row[stride * i + c] = numbers[i];
  });
}

// Calls f(number, points, from): pieces of the row of a brick, in turn, that are contiguous in a
// row of the grid, where they begin at from.
template <class F> void for_each_piece(const Brick &brick, int nx, F &&f)
{
  for (int n = 0, i = wrapped(brick.low[0], nx); n < brick.size[0]; i = 0) {
    const int piece = std::min(nx - i, brick.size[0] - n);
    f(n, piece, i);
    n += piece;
  }
}

// the same numbers, added to layers or taken from them, which have one component after the other
inline void add_to_layers(const Brick &brick, const Points &points, const Share &layers,
                          int components, const double *numbers, double *field)
{
  const int nx = points[0], ny = points[1];
  const std::size_t component = static_cast<std::size_t>(nx) * ny * layers.number();
  for_each_row_in(brick, points, layers, [&](int j, int k) {
    const int layer = wrapped(k, points[2]) - layers.first;
    double *row = field + (static_cast<std::size_t>(layer) * ny + wrapped(j, ny)) * nx;
    for (int c = 0; c < components; c++, row += component, numbers += brick.size[0])
      for_each_piece(brick, nx, [&](int from, int number, int to) {
        for (int n = 0; n < number; n++) row[to + n] += numbers[from + n];
      });
  });
}

inline void take_from_layers(const Brick &brick, const Points &points, const Share &layers,
                             int components, const double *field, double *numbers)
{
  const int nx = points[0], ny = points[1];
  const std::size_t component = static_cast<std::size_t>(nx) * ny * layers.number();
  for_each_row_in(brick, points, layers, [&](int j, int k) {
    const int layer = wrapped(k, points[2]) - layers.first;
    const double *row = field + (static_cast<std::size_t>(layer) * ny + wrapped(j, ny)) * nx;
    for (int c = 0; c < components; c++, row += component, numbers += brick.size[0])
      for_each_piece(brick, nx, [&](int to, int number, int from) {
        std::copy_n(row + from, number, numbers + to);
      });
  });
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
