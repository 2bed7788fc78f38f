/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What fix deform/rheometer measures: the particles of its group, and their pressure and stress.

#ifndef LMP_DEFORM_STRESS_H
#define LMP_DEFORM_STRESS_H

#include "pointers.h"
#include "rheometer_flow.h"
#include "rheometer_mean.h"
#include "rheometer_servo.h"

#include <string>

namespace LAMMPS_NS {

class DeformStress : protected Pointers {
 public:
  DeformStress(LAMMPS *, class Fix *);
  ~DeformStress() override;

  void init();
  void announce(bigint step);    // it will be measured in this step
  void measure(Rheometer_NS::Flow, const Rheometer_NS::Gradient &);    // of the flow of now
  void set_viscosity(double eta) { scales.eta = eta; }

  // when last measured; the pressure is that of the particles and, if their fluid has to drain, of
  // the fluid
  double pressure() const { return pressure_now + fluid_now; }
  double particle_pressure() const { return pressure_now; }
  double stress() const { return stress_now; }

  // mean pressure of the fluid over -dilation, and the dilation under which was measured
  void drain(double drainage, double dilation);
  double drainage() const { return drainage_now; }
  double phi() const;
  const Rheometer_NS::Material &material() const { return scales; }

  // over the last unit of strain
  const Rheometer_NS::StrainMeans &means() const { return averages; }
  void add_to_means(double strain, double dt);
  void set_means(const Rheometer_NS::StrainMeans &means) { averages = means; }

  // sums over the group; numbers only: a restart file holds them
  struct Particles {
    double volume = 0.0, mass = 0.0, radius = 0.0, number = 0.0;
  };
  const Particles &particles() const { return sums; }
  void set_particles(const Particles &particles) { sums = particles; }

 private:
  Fix *fix;
  std::string virial_id;
  class Compute *pair_virial;
  class FixHydro *hydro;    // or null
  Particles sums;
  Rheometer_NS::Material scales;
  Rheometer_NS::StrainMeans averages;
  double pressure_now, stress_now;
  double fluid_now, drainage_now;    // pressure of the fluid

  void add_particle(int, bool, Particles &) const;
  void take_particles(const Particles &);
};

}    // namespace LAMMPS_NS

#endif
