/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Factor of the drag in a suspension. A new rule is a class and a row of the table in
// background_hindrance.cpp.

#ifndef LMP_BACKGROUND_HINDRANCE_H
#define LMP_BACKGROUND_HINDRANCE_H

#include "pointers.h"
#include "suspension_input.h"

#include <memory>

namespace LAMMPS_NS {

class BackgroundHindrance : protected Pointers {
 public:
  // by the words of a fix from arg[iarg] on; moves iarg behind them
  static std::unique_ptr<BackgroundHindrance> make(LAMMPS *, class Fix *, int narg, char **arg,
                                                   int &iarg);
  static std::unique_ptr<BackgroundHindrance> none(LAMMPS *, Fix *);

  void init() const;
  void new_step();
  double factor() const { return value; }    // of this step

  const Suspension_NS::InputNumber &number() const { return given; }
  virtual double kept() const { return 0.0; }    // what a restart file holds
  virtual void keep(double) {}

 protected:
  BackgroundHindrance(LAMMPS *lmp, Fix *owner) : Pointers(lmp), fix(owner), value(1.0) {}
  virtual double next_factor() = 0;    // with the number of this step

  Fix *fix;
  Suspension_NS::InputNumber given;

 private:
  double value;
};

}    // namespace LAMMPS_NS

#endif
