/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifdef PAIR_CLASS
// clang-format off
PairStyle(lubcontact,PairLubcontact);
// clang-format on
#else

#ifndef LMP_PAIR_LUBCONTACT_H
#define LMP_PAIR_LUBCONTACT_H

#include "pair.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {
struct Film;
struct Law;
struct Load;
struct PairGeometry;
struct Settings;
}    // namespace LAMMPS_NS::Lubcontact_NS

namespace LAMMPS_NS {
struct LubcontactInstance;
struct PartnerCount;
class LubcontactPairs;
class LubcontactTally;
class LubcontactTypeCoeffs;

// LAMMPS' side of the pair law: it fetches and delegates. What it has belongs to objects of their
// own.
class PairLubcontact : public Pair {
 public:
  PairLubcontact(class LAMMPS *);
  ~PairLubcontact() override;
  static std::vector<PairLubcontact *> all(LAMMPS *);    // of this LAMMPS: several under hybrid
  static std::vector<PairLubcontact *> require(LAMMPS *, const std::string &who);    // at least one

  void compute(int, int) override;
  double single(int, int, int, int, double, double, double, double &) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  void init_list(int, class NeighList *) override;
  double init_one(int, int) override;
  void setup() override;
  void reset_dt() override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  void write_data(FILE *) override;
  void write_data_all(FILE *) override;
  void *extract(const char *, int &) override;
  void transfer_history(double *, double *, int, int) override;
  int pack_reverse_comm(int, int, double *) override;
  void unpack_reverse_comm(int, int *, double *) override;
  double memory_usage() override;

  // what the user has given: arguments of pair_style, coefficients of the pairs of types that have
  // any
  const Lubcontact_NS::Settings &settings() const { return *given; }
  Lubcontact_NS::Law law() const;
  void adopt(const Lubcontact_NS::Law &);    // instead, from the next run on
  double viscosity() const;                  // pressure*time; NaN for a variable not yet evaluated
  std::string viscosity_word() const;        // as typed: a number or v_name

  // pairs in range with their present load: i, j, weight (1/2 where two see them), geometry, load
  using Visitor = std::function<void(int, int, double, const Lubcontact_NS::PairGeometry &,
                                     const Lubcontact_NS::Load &)>;
  void visit_pairs(const Visitor &) const;

  // of each particle: how many others are in range, once the forces of a step are known; stiffness
  // of their contacts as lubcontact_stiffness.h has it, spin saying how easily particles turn
  const std::vector<double> &count_partners();
  void sum_stiffness(double spin, std::vector<double> &);

  const LubcontactTally &tally() const { return *sums; }    // stress and power by origin
  LubcontactPairs &neighbors() const { return *pairs; }     // with their history

  // largest stable time step at the last set-up, and mass of all particles then; 0: not known
  double step_limit() const { return dt_limit; }
  double step_limit_mass() const { return dt_limit_mass; }
  unsigned effects() const;    // of the history of the last run: those of the instance of the loop

 private:
  std::unique_ptr<Lubcontact_NS::Settings> given;
  std::string viscosity_variable;    // empty for a number
  int viscosity_index;
  std::unique_ptr<LubcontactTypeCoeffs> coeffs;
  std::unique_ptr<Lubcontact_NS::Film> film;
  std::unique_ptr<LubcontactPairs> pairs;
  std::unique_ptr<LubcontactTally> sums;
  std::unique_ptr<LubcontactInstance> instance;

  std::vector<double> max_radius;     // by type
  double longest;                     // distance of centers at which the style acts
  std::vector<double> of_partners;    // sum over the partners of each atom
  std::unique_ptr<PartnerCount> counted;
  double dt_limit, dt_limit_mass;
  bool reported;     // the table of this run has been printed
  bool warned_dt;    // that the step exceeds its limit, in this run

  void allocate();
  void check_variable();
  void update_viscosity();
  double sum_over_partners(double spin);
  void count_all_partners();
  void count_changes();
};

}    // namespace LAMMPS_NS

#endif
#endif
