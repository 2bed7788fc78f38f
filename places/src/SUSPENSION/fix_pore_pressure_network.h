/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The pressure of the fluid in the pores between neighbors, and its forces on the particles of this
// rank. All ranks hold the whole network, in the same order. Each finds the pores of its own
// particles, and computes its share of what takes long; sums are made in one order by whoever makes
// them, so that the number of ranks changes nothing.

#ifndef LMP_FIX_PORE_PRESSURE_NETWORK_H
#define LMP_FIX_PORE_PRESSURE_NETWORK_H

#include "fix_pore_pressure_solver.h"
#include "lmptype.h"
#include "pore_network_flow.h"
#include "radical_tessellation.h"

#include <functional>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class PoreNetwork : public PoreSolver {
 public:
  explicit PoreNetwork(LAMMPS *);
  static const char *const NO_LIBRARY;    // Voro++

  void init() override;
  int prepare(const PoreSettings &, const std::array<double, 3> &, double) override;
  bool has_pressure() const override { return is_known; }
  void flipped() override {}    // pores are found again by their particles
  void deposit(const Pore_NS::Cell &, int groupbits, const Fluid &, const Plates &,
               bool anew) override;    // pores are kept as long as they can be
  void advance(double dt, const Fluid &, const Plates &) override;
  void add_forces(const Fluid &, const Plates &) override;
  const std::vector<Lubcontact_NS::Vec3> &forces() const override { return pushed; }

  const Report &report() const override { return seen; }
  double dissipation() const override;
  std::vector<double> pressure_shares() const override;
  void measure_flow(const Lubcontact_NS::Vec3 &) override;
  std::vector<Layer> profile() const override;    // one layer, the whole cell
  double volume() const override { return box.xprd * box.yprd * box.zprd; }
  double wall_area() const override { return box.xprd * box.zprd; }
  State state() const override;
  void restore(const State &, const PoreSettings &) override;
  double memory_usage() const override;

 private:
  using Vec3 = Lubcontact_NS::Vec3;

  RadicalTessellation tessellation;
  double alpha;    // 0: auto
  Pore_NS::Cell box;
  Pore_NS::CellEdges edges;

  // all particles, in the order of their tags
  std::vector<tagint> tags;
  std::vector<Vec3> x;    // without jumps through the cell
  std::vector<Vec3> nudged;
  std::vector<double> radius, inverse_mass;
  enum Body : char { FREE, LOWER, UPPER };    // the plates
  std::vector<char> body;
  std::vector<int> index;    // of the atoms of this rank, where they are in those
  double solid;              // volume of the particles

  // the pores
  Pore_NS::Network net;
  bool flips;                       // since they were found
  std::uint64_t attempt;            // of breaking ties
  std::vector<double> positive;     // sign of each volume
  std::vector<double> distances;    // of the corners of each pore when it was made
  std::vector<Vec3> centers;
  Pore_NS::Flow flow;
  std::vector<double> rises;    // of the mean gradient, by links
  std::vector<Vec3> pull;       // its forces, by particles
  std::vector<double> p;
  bool is_known;               // this pressure, that is
  std::vector<Vec3> pushed;    // forces of the pressure on the atoms of this rank
  double mean_velocity;        // along y
  Report seen;

  // facets on the plates
  struct Hull {
    int pore, corner;
    Body plate;
    double conductance;    // to the fluid outside, if it is drained
    Vec3 area;             // outwards
  };
  bool has_plates, drains[2];    // lower, upper
  std::vector<Hull> hull;

  Pore_NS::Image nearest_image(const Pore_NS::CellEdges &, const Vec3 &) const;
  Vec3 on_upper(const std::vector<double> &of_pressure) const;
  void shape_hull(const Fluid &, double factor);
  void see_hull(const Fluid &);
  void gather_particles(int groupbits, const Plates &);
  std::vector<double> gather(int width,
                             const std::function<void(int i, double *values)> &pack) const;
  void gather_rows(double *rows, std::size_t number, int width) const;
  std::pair<int, int> share(std::size_t number) const;
  void follow_flip(const Pore_NS::CellEdges &before);
  void nudge();
  bool has_changed() const;
  void triangulate();
  bool find_pores();
  std::array<double, 6> distances_of(const Pore_NS::Pore &) const;
  void shape(const Fluid &);
  void solve(double dt, double storage, const std::vector<double> &rhs, double tolerance,
             const Plates &);
  double mean_pressure() const;
};

}    // namespace LAMMPS_NS

#endif
