/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The radical (power) tessellation of the particles, in any cell of LAMMPS, on any number of ranks:
// each rank makes the cells of its own particles, from ghosts that reach as far as it takes. Dual
// of the regular triangulation of D. Marzougui, B. Chareyre, J. Chauchat, Granular Matter 17, 297
// (2015). Cells: C.H. Rycroft, Voro++, Chaos 19, 041111 (2009).
// The face of two spheres is in the plane of equal tangents, which separates spheres of any sizes
// that do not overlap, so that two spheres that touch always share one.

#ifndef LMP_RADICAL_TESSELLATION_H
#define LMP_RADICAL_TESSELLATION_H

#include "lubcontact_vec3.h"
#include "pointers.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class NeighList;

// Which entries of a neighbor list share a face, until the list is built again.
class FaceFlags {
 public:
  const char *all() const { return flags.empty() ? nullptr : flags.data(); }
  void clear() { flags.clear(); }
  const char *of(int i) const { return flags.empty() ? nullptr : &flags[first[i]]; }
  double memory_usage() const { return flags.capacity() + first.capacity() * sizeof(first[0]); }

 private:
  friend class RadicalTessellation;
  std::vector<char> flags;
  std::vector<std::size_t> first;    // of each owned atom; NONE without a list
  static constexpr std::size_t NONE = -1;
};

class RadicalTessellation : protected Pointers {
 public:
  // who: for messages, "Pair style lubcontact range voronoi"
  RadicalTessellation(LAMMPS *, const std::string &who);
  ~RadicalTessellation() override;
  RadicalTessellation(const RadicalTessellation &) = delete;
  RadicalTessellation &operator=(const RadicalTessellation &) = delete;

  static bool has_library();    // Voro++; all others are errors without it
  static const char *const NO_LIBRARY;

  // ghost atoms out to a distance that decides the faces of dense suspensions; and as before,
  // unless comm_modify has set another since
  void request_ghosts(double largest_radius);
  void return_ghosts();

  // A cell with its neighbors and the areas of the faces, in 2d lengths; neighbors are negative
  // where it ends at a boundary. Faces that ghosts do not reach far enough to decide are errors
  // when asked for.
  struct Cell {
    int owner;    // local index
    std::vector<int> neighbors;
    std::vector<double> areas;
    std::function<void(std::size_t)> require_sure;    // of face n
    // The three neighbors that meet at each vertex inside: with the owner, a tetrahedron of the
    // dual.
    // False if more than three do, a tie. Vertices that ghosts do not decide are errors.
    std::function<bool(std::vector<std::array<int, 3>> &)> get_vertices;
  };
  // For tetrahedra all atoms, ghosts too, are displaced to break ties, and where y is not periodic
  // cells end at two planes, the same on all ranks.
  struct Displaced {
    std::vector<Lubcontact_NS::Vec3> by;
    double lowest, highest;    // y of the planes
  };
  // of the owned atoms
  void each_cell(const std::function<void(const Cell &)> &,
                 const Displaced *displaced = nullptr) const;

  void mark_faces(const NeighList *, FaceFlags &) const;

 private:
  const std::string who;
  double ghosts_of_user, ghosts_raised;    // cut-off of ghosts before, and since, this one asked
};

}    // namespace LAMMPS_NS

#endif
