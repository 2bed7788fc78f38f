/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What pairs of spheres do to each other, eight at once: the function of hydro_tensors.h in a loop
// that the compiler turns into vector instructions. Structure of arrays, one lane per pair.

#ifndef LMP_HYDRO_PAIRS_H
#define LMP_HYDRO_PAIRS_H

#include "each_processor.h"
#include "hydro_tensors.h"

#include <initializer_list>
#include <vector>

namespace LAMMPS_NS::Hydro_NS {

struct PairBlock {
  static constexpr int WIDTH = 8;
  using Lane = double[WIDTH];

  int number = 0;    // of pairs; the rest do nothing
  int i[WIDTH] = {}, j[WIDTH] = {};
  Lane x[3] = {}, mm[2] = {}, md[3] = {}, dm[3] = {}, dd[5] = {};
};

inline void add_to(std::vector<PairBlock> &blocks, int i, int j, const PairResponse &r)
{
  if (blocks.empty() || blocks.back().number == PairBlock::WIDTH) blocks.emplace_back();
  PairBlock &b = blocks.back();
  const int l = b.number++;
  b.i[l] = i;
  b.j[l] = j;
  const auto put = [l](PairBlock::Lane *to, std::initializer_list<double> values) {
    for (const double value : values) (*to++)[l] = value;
  };
  put(b.x, {r.x.x, r.x.y, r.x.z});
  put(b.mm, {r.mm_p, r.mm_h});
  put(b.md, {r.md_p, r.md_h, r.md_hh});
  put(b.dm, {r.dm_p, r.dm_h, r.dm_hh});
  put(b.dd, {r.dd_p, r.dd_h, r.dd_pp, r.dd_hh, r.dd_hhh});
}

// twelve numbers of each pair, of loads or of motions
using TwelveLanes = PairBlock::Lane[12];

inline void put_twelve(const Vec3 &a, const Tensor &t, TwelveLanes &to, int l)
{
  const Vec3 rows[4] = {a, t.x, t.y, t.z};
  for (int m = 0; m < 4; m++) {
    to[3 * m][l] = rows[m].x;
    to[3 * m + 1][l] = rows[m].y;
    to[3 * m + 2][l] = rows[m].z;
  }
}

inline Load load_of(const TwelveLanes &n, int l)
{
  return {
      {n[0][l], n[1][l], n[2][l]},
      {{n[3][l], n[4][l], n[5][l]}, {n[6][l], n[7][l], n[8][l]}, {n[9][l], n[10][l], n[11][l]}}};
}

inline void add_motion_of(const TwelveLanes &n, int l, Motion &sum)
{
  const Load m = load_of(n, l);
  sum.velocity = sum.velocity + m.force;
  sum.gradient = sum.gradient + m.dipole;
}

inline void respond(const PairBlock &b, int l, double factor, const TwelveLanes &load_i,
                    const TwelveLanes &load_j, TwelveLanes &motion_i, TwelveLanes &motion_j)
{
  const PairResponse r{{b.x[0][l], b.x[1][l], b.x[2][l]},
                       b.mm[0][l],
                       b.mm[1][l],
                       b.md[0][l],
                       b.md[1][l],
                       b.md[2][l],
                       b.dm[0][l],
                       b.dm[1][l],
                       b.dm[2][l],
                       b.dd[0][l],
                       b.dd[1][l],
                       b.dd[2][l],
                       b.dd[3][l],
                       b.dd[4][l]};
  Motion of_i, of_j;
  add_pair(r, factor, load_of(load_i, l), load_of(load_j, l), of_i, of_j);
  put_twelve(of_i.velocity, of_i.gradient, motion_i, l);
  put_twelve(of_j.velocity, of_j.gradient, motion_j, l);
}

// factor: 1/(8 pi eta); loads and motions of atoms
[[LUBCONTACT_EACH_PROCESSOR gnu::flatten, gnu::noinline, maybe_unused]] static void
add_pairs(const std::vector<PairBlock> &blocks, double factor, const Load *loads, Motion *motions)
{
  TwelveLanes load_i = {}, load_j = {}, motion_i, motion_j;
  for (const PairBlock &b : blocks) {
    for (int l = 0; l < b.number; l++) {
      put_twelve(loads[b.i[l]].force, loads[b.i[l]].dipole, load_i, l);
      put_twelve(loads[b.j[l]].force, loads[b.j[l]].dipole, load_j, l);
    }
    for (int l = 0; l < PairBlock::WIDTH; l++)
      respond(b, l, factor, load_i, load_j, motion_i, motion_j);
    for (int l = 0; l < b.number; l++) {
      add_motion_of(motion_i, l, motions[b.i[l]]);
      add_motion_of(motion_j, l, motions[b.j[l]]);
    }
  }
}

}    // namespace LAMMPS_NS::Hydro_NS

#endif
