/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix pore/pressure asks of whatever holds the pressure: a grid, or the network of the pores.

#ifndef LMP_FIX_PORE_PRESSURE_SOLVER_H
#define LMP_FIX_PORE_PRESSURE_SOLVER_H

#include "pointers.h"
#include "pore_cg.h"
#include "pore_closure.h"
#include "pore_grid.h"

#include <array>
#include <vector>

namespace LAMMPS_NS {
struct PoreSettings;

class PoreSolver : protected Pointers {
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

  // what there is to know; valid after advance() or add_forces()
  struct Report {
    double mean = 0.0, largest = 0.0, lower = 0.0, upper = 0.0;    // pressures
    struct {
      double lower = 0.0, upper = 0.0;
    } flux;                     // volume/time out of drained plates
    double given_mean = 0.0;    // that of a periodic cell
    Fluid outside;              // that has made the forces
    double total[3] = {};       // force on all particles
    Pore_NS::Convergence convergence;
    double k_min = 0.0, k_max = 0.0;
    double explicit_step = 0.0;
    double plate_lag = 1.0;    // steps by which a plate makes one solution a step lag
  };

  struct Layer {
    double y, p, phi, u_y, q_y;
  };

  explicit PoreSolver(LAMMPS *lmp) : Pointers(lmp) {}

  virtual void init() {}    // before the ghosts of a run are chosen
  // before a run; heights of the cell or the gap. Returns the number of layers of the profile
  virtual int prepare(const PoreSettings &, const std::array<double, 3> &heights,
                      double mean_diameter) = 0;
  virtual bool has_pressure() const = 0;
  virtual void flipped() = 0;    // the tilt of the cell, since the last step

  // the particles of this step with these bits, in this cell; the pressure stays. Unless anew, what
  // hardly changes may be that of the last time
  virtual void deposit(const Pore_NS::Cell &, int groupbits, const Fluid &, const Plates &,
                       bool anew) = 0;
  // pressure at the end of the step of length dt, in which the other forces act
  virtual void advance(double dt, const Fluid &, const Plates &) = 0;
  // of the pressure, on the particles as they were deposited: added to their forces
  virtual void add_forces(const Fluid &, const Plates &) = 0;
  virtual const std::vector<Lubcontact_NS::Vec3> &forces() const = 0;    // by local index

  // by local index: what of the integral of the pressure, the given mean included, each particle
  // stands for; all together have all of it but that of clear fluid
  virtual std::vector<double> pressure_shares() const = 0;

  virtual const Report &report() const = 0;
  virtual double dissipation() const = 0;    // power of the flow through the pores
  // Velocities and flux of this moment; of the particles as they were deposited, if they still are
  // there.
  virtual void measure_flow(const Lubcontact_NS::Vec3 &upper_plate) = 0;
  virtual std::vector<Layer> profile() const = 0;
  virtual double volume() const = 0;
  virtual double wall_area() const = 0;

  // of a restart file: what says how many values there are, and which
  struct State {
    static constexpr std::size_t HEAD = 7;
    std::array<double, HEAD> head{};
    std::vector<double> values;
  };
  virtual State state() const = 0;
  virtual void restore(const State &, const PoreSettings &) = 0;    // nothing, if it is of another
  virtual double memory_usage() const = 0;
};

}    // namespace LAMMPS_NS

#endif
