/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What all headers of the pair law are made of, so that they are fit for a device, too: no memory
// but the arguments, no tables, no exceptions, of the standard library only functions of numbers.
// Each function is marked; a compiler for devices gets -DLUBCONTACT_FN="__host__ __device__". What
// only the compiler evaluates (series) or only the host calls (lubcontact_batch.h) is not.

#ifndef LUBCONTACT_DEFS_H
#define LUBCONTACT_DEFS_H

#ifndef LUBCONTACT_FN
#define LUBCONTACT_FN
#endif

namespace LAMMPS_NS::Lubcontact_NS {

static constexpr double PI = 3.14159265358979323846;

// Branch-free, unlike std::fmax a single instruction; the second argument if one is not a number.
LUBCONTACT_FN inline double larger(double a, double b)
{
  return a > b ? a : b;
}

LUBCONTACT_FN inline double smaller(double a, double b)
{
  return a < b ? a : b;
}

// Branch-free choice.
LUBCONTACT_FN inline double select(bool first, double a, double b)
{
  return first ? a : b;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
