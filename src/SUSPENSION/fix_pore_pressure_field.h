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

#include "pointers.h"
#include "pore_closure.h"
#include "pore_deposit.h"
#include "pore_operator.h"
#include "pore_step.h"

#include <memory>
#include <vector>

namespace LAMMPS_NS {

class PoreField : protected Pointers {
 public:
  enum class Coupling { IMPLICIT, EXPLICIT, OFF };

  // what the fluid is like in this step; pressures are force/area
  struct Fluid {
    double viscosity = 0.0, storage = 0.0;
    Pore_NS::Permeability law;
    Coupling coupling = Coupling::IMPLICIT;
    bool iterate = false;    // solver cg: to the tolerance in each step
    double tolerance = 1e-8;
    double lower = 0.0, upper = 0.0;    // given at drained plates
    double mean = 0.0;                  // of a periodic cell; it makes no forces
    Lubcontact_NS::Vec3 gradient;       // mean one
  };

  // Particles of plates move as their plate does. The lower one is at rest.
  struct Plates {
    int lower_bit = 0, upper_bit = 0;
    bool push_lower = false, push_upper = false;    // impermeable: the pressure itself acts on them
    Lubcontact_NS::Vec3 velocity;                   // of the upper one, by all but the pressure
    Lubcontact_NS::Vec3 response;                   // added by a force on it, over force and time
    double mass = 0.0;                              // of the particles of the upper one
  };

  explicit PoreField(LAMMPS *);
  ~PoreField() override;
  static bool has_library();    // FFTW
  static const char *const NO_LIBRARY;

  // numbers of elements and kinds of walls; a pressure of another size is forgotten
  void set_grid(const Pore_NS::Grid &);
  const Pore_NS::Grid &grid() const { return lattice; }
  bool has_pressure() const { return age > 0; }
  int solutions() const
  {
    return age;
  }    // since there was no pressure, counted while they iterate
  void forget() { age = 0; }

  // the particles of this step with these bits, in this cell; the pressure stays. Unless anew, they
  // keep the weights that they have in lattice coordinates
  void deposit(const Pore_NS::Cell &, int groupbits, const Fluid &, const Plates &, bool anew);

  // Pressure at the end of the step of length dt, in which the other forces act. The first ones are
  // iterated to the tolerance, and all where asked.
  void advance(double dt, const Fluid &, const Plates &);

  // of the pressure, on the particles as they were deposited: added to their forces
  void add_forces(const Fluid &, const Plates &);
  const std::vector<Lubcontact_NS::Vec3> &forces() const { return pushed; }    // by local index

  // what there is to know; valid after advance() or add_forces()
  struct Report {
    double mean = 0.0, largest = 0.0, lower = 0.0, upper = 0.0;    // pressures
    Pore_NS::WallFlux flux;                                        // volume/time
    double given_mean = 0.0;                                       // that of a periodic cell
    Fluid outside;                                                 // that has made the forces
    double total[3] = {};                                          // force on all particles
    Pore_NS::Convergence convergence;
    double k_min = 0.0, k_max = 0.0;
    double explicit_step = 0.0;
  };
  const Report &report() const { return seen; }
  double dissipation() const;    // power of the flow through the pores, when it is asked for
  // Velocities and flux of this moment; of the particles as they were deposited, if they still are
  // there.
  void measure_flow(const Lubcontact_NS::Vec3 &upper_plate);
  struct Layer {
    double y, p, phi, u_y, q_y;
  };
  std::vector<Layer> profile() const;    // by layers of elements

  const Pore_NS::Field &pressure() const { return p; }
  void take_pressure(const std::vector<double> &, int solutions);    // of a restart file
  double memory_usage() const;

 private:
  struct Particle {
    int i;
    double inverse_mass;    // of one that is free, or what of its mass a plate has
  };

  Pore_NS::Grid lattice;
  Pore_NS::WallVelocity wall;    // as motion
  Pore_NS::ElementMatrix matrix;
  Pore_NS::Field p;
  int age;
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
  void solve_constant(const Pore_NS::Field &r, double c, double s, Pore_NS::Field &change) const;
  void see(const Fluid &);
};

}    // namespace LAMMPS_NS

#endif
