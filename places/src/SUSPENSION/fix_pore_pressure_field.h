/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The pressure of the pore fluid on a grid, and its forces on the particles of this rank. All ranks
// hold the whole grid: sums over particles are reduced, the solution is the same everywhere.

#ifndef LMP_FIX_PORE_PRESSURE_FIELD_H
#define LMP_FIX_PORE_PRESSURE_FIELD_H

#include "fix_pore_pressure_solver.h"
#include "pore_deposit.h"
#include "pore_operator.h"
#include "pore_step.h"

#include <memory>
#include <optional>
#include <vector>

namespace LAMMPS_NS {

class PoreField : public PoreSolver {
 public:
  explicit PoreField(LAMMPS *);
  ~PoreField() override;
  static bool has_library();    // FFTW
  static const char *const NO_LIBRARY;

  // numbers of elements and kinds of walls; a pressure of another size is forgotten
  void set_grid(const Pore_NS::Grid &);
  const Pore_NS::Grid &grid() const { return lattice; }
  int prepare(const PoreSettings &, const std::array<double, 3> &, double) override;
  bool has_pressure() const override { return age > 0; }
  void flipped() override { age = 0; }    // nodes are not mapped onto nodes
  // unless anew, particles keep the weights that they have in lattice coordinates
  void deposit(const Pore_NS::Cell &, int groupbits, const Fluid &, const Plates &,
               bool anew) override;
  // the first pressures are iterated to the tolerance, and all where asked
  void advance(double dt, const Fluid &, const Plates &) override;
  void add_forces(const Fluid &, const Plates &) override;
  const std::vector<Lubcontact_NS::Vec3> &forces() const override { return pushed; }
  std::vector<double> pressure_shares() const override;
  const Report &report() const override { return seen; }
  double dissipation() const override;
  void measure_flow(const Lubcontact_NS::Vec3 &upper_plate) override;
  std::vector<Layer> profile() const override;    // by layers of elements
  double volume() const override { return lattice.volume(); }
  double wall_area() const override { return lattice.wall_area(); }
  State state() const override;
  void restore(const State &, const PoreSettings &) override;
  double memory_usage() const override;

 private:
  struct Particle {
    int i;
    double inverse_mass;    // of one that is free, or what of its mass a plate has
  };

  Pore_NS::Grid lattice;
  Pore_NS::WallVelocity wall;    // as motion
  Pore_NS::ElementMatrix matrix;
  Pore_NS::Field p;
  std::optional<Lubcontact_NS::Vec3> given_gradient;    // of the last step of this run of LAMMPS
  int age;            // solutions since there was no pressure, counted while they iterate
  double made_for;    // spacing asked for when the grid was made; -1: there is none
  Plates of_deposit;
  int nlocal;               // of the stencils
  double yield_of_plate;    // mass over that of the particles times what moves it: of the stencils
  bool fresh;               // the stencils are of this step
  bool measured;            // motion and flux since the deposit
  std::vector<Pore_NS::Element> elements;
  std::vector<Pore_NS::Motion> motion;
  std::vector<double> mobility, bound;
  std::vector<Particle> particles;
  std::vector<Pore_NS::Stencil> stencils;     // of the particles
  std::vector<Pore_NS::Lanes> of_pores;       // forces of the flow through the pores on them
  std::vector<Lubcontact_NS::Vec3> pushed;    // all forces of the pressure, by local index
  std::unique_ptr<struct PoreTransforms> transforms;
  Report seen;

  Lubcontact_NS::Vec3 force_on_plate(const Pore_NS::Field &of_pressure,
                                     const std::vector<Pore_NS::Lanes> &gradient,
                                     const Plates &) const;
  void make_stencils(int groupbits, const Fluid &, const Plates &);
  template <class Velocity>
  void sum_motion(const Velocity &, const Lubcontact_NS::Vec3 &upper, const Plates &,
                  std::vector<Pore_NS::Motion> &sums, Pore_NS::WallVelocity &) const;
  void predict_motion(double dt, const Fluid &, const Plates &);
  void respond(const Pore_NS::Field &, const Plates &, std::vector<Pore_NS::Motion> &sums,
               Pore_NS::WallVelocity &) const;
  bool jumps(const Fluid &) const;
  void solve_constant(const Pore_NS::Field &r, double c, double s, Pore_NS::Field &change) const;
  void see(const Fluid &);
};

}    // namespace LAMMPS_NS

#endif
