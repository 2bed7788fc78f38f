/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Which pores there are and how they are connected: tetrahedra that fill a periodic cell.

#ifndef LMP_PORE_NETWORK_H
#define LMP_PORE_NETWORK_H

#include "pore_tetrahedron.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace LAMMPS_NS::Pore_NS {

using Image = std::array<int, 3>;    // how many edges of the cell away

struct Corner {
  int particle = 0;
  Image image{};
  bool operator<(const Corner &o) const
  {
    return std::tie(particle, image) < std::tie(o.particle, o.image);
  }
  bool operator==(const Corner &o) const { return particle == o.particle && image == o.image; }
};

inline Image difference(const Image &a, const Image &b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Image sum(const Image &a, const Image &b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// The same for all images of a pore or a facet: in order, the first one in the cell.
template <std::size_t N> std::array<Corner, N> canonical(std::array<Corner, N> corners)
{
  std::sort(corners.begin(), corners.end());
  const Image first = corners[0].image;
  for (Corner &c : corners) c.image = difference(c.image, first);
  return corners;
}

using Pore = std::array<Corner, 4>;    // canonical

inline std::array<Corner, 3> facet_opposite(const Pore &pore, int corner)
{
  std::array<Corner, 3> facet;
  for (int n = 0, at = 0; n < 4; n++)
    if (n != corner) facet[at++] = pore[n];
  return facet;
}

// Two pores with a facet in common. The first one is also the one with the smaller number.
struct Link {
  int pore[2];
  int opposite[2];    // corner of each that the other one has not
  Image image;        // where the second one is, seen from the first
};

struct Network {
  std::vector<Pore> pores;    // in order
  std::vector<Link> links;
  std::vector<std::array<int, 4>> link_of;    // of each pore, opposite to each corner; -1: none
  std::vector<int> first;                     // of each particle in `at`, and the end
  struct Place {
    int pore, corner;
  };
  std::vector<Place> at;
};

// Pores of so many particles: sorts and connects them. Returns how many facets belong to one pore
// only, or to more than two: none, if they fill the cell.
inline int connect(std::vector<Pore> pores, int particles, Network &net)
{
  net = {};
  std::sort(pores.begin(), pores.end());
  net.pores = std::move(pores);
  const int size = static_cast<int>(net.pores.size());
  struct Side {
    std::array<Corner, 3> facet;
    int pore, corner;
    bool operator<(const Side &o) const
    {
      return std::tie(facet, pore) < std::tie(o.facet, o.pore);
    }
  };
  std::vector<Side> sides;
  sides.reserve(4 * net.pores.size());
  for (int i = 0; i < size; i++)
    for (int n = 0; n < 4; n++) sides.push_back({canonical(facet_opposite(net.pores[i], n)), i, n});
  std::sort(sides.begin(), sides.end());

  int open = 0;
  net.link_of.assign(size, {-1, -1, -1, -1});
  for (std::size_t n = 0; n < sides.size();) {
    std::size_t end = n + 1;
    while (end < sides.size() && sides[end].facet == sides[n].facet) end++;
    if (end - n == 2) {
      const Side &a = sides[n], &b = sides[n + 1];
      const auto in_a = facet_opposite(net.pores[a.pore], a.corner),
                 in_b = facet_opposite(net.pores[b.pore], b.corner);
      net.link_of[a.pore][a.corner] = net.link_of[b.pore][b.corner] =
          static_cast<int>(net.links.size());
      net.links.push_back(
          {{a.pore, b.pore}, {a.corner, b.corner}, difference(in_a[0].image, in_b[0].image)});
    } else
      open += static_cast<int>(end - n);
    n = end;
  }

  net.first.assign(particles + 1, 0);
  for (const Pore &pore : net.pores)
    for (const Corner &c : pore) net.first[c.particle + 1]++;
  for (int k = 0; k < particles; k++) net.first[k + 1] += net.first[k];
  std::vector<int> next(net.first.begin(), net.first.end() - 1);
  net.at.resize(4 * net.pores.size());
  for (int i = 0; i < size; i++)
    for (int n = 0; n < 4; n++) net.at[next[net.pores[i][n].particle]++] = {i, n};
  return open;
}

// ---- pressures for other pores of the same particles

// Pores that are the same keep their pressure. The others fill the same cavities as those that they
// replace, and get the mean pressure there, so that no fluid is lost. volume: of each, positive
inline std::vector<double> carry_over(const std::vector<Pore> &before,
                                      const std::vector<double> &volume_before,
                                      const std::vector<double> &p, const std::vector<Pore> &now,
                                      const std::vector<double> &volume_now)
{
  struct Changed {
    const Pore *pore;
    double volume, p;
    std::size_t in_now;    // or NONE
  };
  static constexpr std::size_t NONE = -1;
  std::vector<double> carried(now.size(), 0.0);
  std::vector<Changed> changed;
  for (std::size_t a = 0, b = 0; a < before.size() || b < now.size();) {
    if (b == now.size() || (a < before.size() && before[a] < now[b])) {
      changed.push_back({&before[a], volume_before[a], p[a], NONE});
      a++;
    } else if (a == before.size() || now[b] < before[a]) {
      changed.push_back({&now[b], volume_now[b], 0.0, b});
      b++;
    } else
      carried[b++] = p[a++];
  }

  // cavities: changed pores with a facet in common
  std::vector<std::size_t> root(changed.size());
  for (std::size_t n = 0; n < root.size(); n++) root[n] = n;
  auto find = [&root](std::size_t n) {
    while (root[n] != n) n = root[n] = root[root[n]];
    return n;
  };
  std::vector<std::pair<std::array<Corner, 3>, std::size_t>> sides;
  for (std::size_t n = 0; n < changed.size(); n++)
    for (int corner = 0; corner < 4; corner++)
      sides.emplace_back(canonical(facet_opposite(*changed[n].pore, corner)), n);
  std::sort(sides.begin(), sides.end());
  for (std::size_t n = 1; n < sides.size(); n++)
    if (sides[n].first == sides[n - 1].first)
      root[find(sides[n].second)] = find(sides[n - 1].second);
  std::vector<double> fluid(changed.size(), 0.0), volume(changed.size(), 0.0);
  for (std::size_t n = 0; n < changed.size(); n++) {
    const bool is_new = changed[n].in_now != NONE;
    fluid[find(n)] += is_new ? 0.0 : changed[n].volume * changed[n].p;
    volume[find(n)] += is_new ? changed[n].volume : 0.0;
  }
  for (std::size_t n = 0; n < changed.size(); n++)
    if (changed[n].in_now != NONE && volume[find(n)] > 0.0)
      carried[changed[n].in_now] = fluid[find(n)] / volume[find(n)];
  return carried;
}

// ---- ties

// A vector within the cube of edge 2 that is the same for all images of a particle, on all ranks:
// regular arrangements have none of the ties then that images could decide differently.
inline Vec3 hashed_direction(std::uint64_t tag, std::uint64_t attempt)
{
  std::uint64_t state = tag * 0x9e3779b97f4a7c15ULL + attempt * 0xd1b54a32d192ed03ULL;
  auto next = [&state] {
    state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1.0;
  };
  const double x = next(), y = next();
  return {x, y, next()};
}

}    // namespace LAMMPS_NS::Pore_NS

#endif
