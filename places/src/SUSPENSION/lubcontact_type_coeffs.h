/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Coefficients of pair style lubcontact by pair of types: typed, mixed, checked, stored, printed.
// All of it are loops over the table in lubcontact_coeffs.h.

#ifndef LMP_LUBCONTACT_TYPE_COEFFS_H
#define LMP_LUBCONTACT_TYPE_COEFFS_H

#include "lubcontact_coeffs.h"
#include "lubcontact_law.h"
#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

class LubcontactTypeCoeffs : protected Pointers {
 public:
  explicit LubcontactTypeCoeffs(LAMMPS *);
  ~LubcontactTypeCoeffs() override;
  LubcontactTypeCoeffs(const LubcontactTypeCoeffs &) = delete;
  LubcontactTypeCoeffs &operator=(const LubcontactTypeCoeffs &) = delete;

  void create();                                 // once the number of types is known
  int **given() const { return set_by_user; }    // LAMMPS' setflag
  double **column(const char *name) const;       // for fix adapt and others, null: no such one

  Lubcontact_NS::TypeCoeffs of(int i, int j) const;
  void put(int i, int j, const Lubcontact_NS::TypeCoeffs &);    // for (j,i), too

  // what the words of pair_coeff behind the types mean; origin is appended to messages
  Lubcontact_NS::TypeCoeffs parse(int narg, char **arg, double reach,
                                  const std::string &origin = "") const;
  void mix(int i, int j);    // from the like pairs
  void check(int i, int j,
             const Lubcontact_NS::Settings &) const;    // what fix adapt may have changed

  // those that the user has given, or the mixed ones, too, once a run has begun
  Lubcontact_NS::Law law(const Lubcontact_NS::Settings &, bool mixed) const;
  void adopt(const Lubcontact_NS::Law &);

  void append(std::string &bytes) const;    // to a restart file
  void take(std::string &bytes);            // from its front
  double memory_usage() const;

 private:
  int **set_by_user, **friction_law;
  double **columns[Lubcontact_NS::NUM_COLUMNS];
  int ntypes;
};

// words of pair_coeff that say the same: all, or from the third on
std::string coeff_words(const Lubcontact_NS::TypeCoeffs &);
std::string surface_words(const Lubcontact_NS::TypeCoeffs &);

// words of pair_style behind its name; the viscosity as a number or v_name
std::string style_words(const Lubcontact_NS::Settings &, const std::string &viscosity);

// place of this word in the input line, for the mark under it: hybrid shifts words, a data file has
// no line
int place_of(class Input *, const char *word);

}    // namespace LAMMPS_NS

#endif
