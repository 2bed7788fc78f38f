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

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {
struct Body;
struct Film;
struct Load;
struct PairCoeffs;
struct PairGeometry;
enum class FrictionLaw;
}    // namespace LAMMPS_NS::Lubcontact_NS

namespace LAMMPS_NS {

class PairLubcontact : public Pair {
 public:
  PairLubcontact(class LAMMPS *);
  ~PairLubcontact() override;

  static std::vector<PairLubcontact *> all(LAMMPS *);    // of this LAMMPS: several under hybrid

  void compute(int, int) override;
  double single(int, int, int, int, double, double, double, double &) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
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

  // energy by origin, in the steps that a compute power/partition asked for: turned into heat by the
  // step, and stored after it
  static constexpr int NUM_ORIGINS = 7;             // Lubcontact_NS::PowerOrigin
  double heat[NUM_ORIGINS], stored[NUM_ORIGINS];    // this rank's share
  bool power_of_step;                               // false in a set-up, which makes none
  bigint power_step;                                // step they belong to

  // pairs in range with their present load: i, j, weight, geometry, load
  using Visitor = std::function<void(int, int, double, const Lubcontact_NS::PairGeometry &,
                                     const Lubcontact_NS::Load &)>;
  void visit_pairs(const Visitor &) const;

  // of each particle, ghosts included: how many others are in range; stiffness of their contacts
  // where drag alone resists, a tangential spring weighing as much as given
  void count_partners(std::vector<double> &);
  void sum_stiffness_overdamped(double, std::vector<double> &);

  // stress by origin, in the steps that a compute stress/partition asked for
  static constexpr int NUM_PARTS = 5;             // Lubcontact_NS::Channel
  static constexpr int NUM_COMPONENTS = 9;        // xx yy zz xy xz yz yx zx zy of sum r_a F_b
  double partition[NUM_PARTS][NUM_COMPONENTS];    // this rank's share
  bigint partition_step;                          // step it belongs to

  // the same of each particle, for compute stress/partition/atom: half of a pair to either; with
  // newton the ghosts hold what belongs to their owners
  std::vector<std::array<double, NUM_PARTS * NUM_COMPONENTS>> partition_atom;
  bigint partition_atom_step;

  // for suspension_scene
  static const std::vector<std::string> EFFECTS;    // that can be left out
  bool uses(const std::string &) const;             // one of them
  void leave_out(const std::string &);              // from the next init() on
  struct Laws {                                     // their numbers; NaN: as they are
    double friction, critical, pull_off, repulsion, screening;
  };
  void switch_on(const Laws &, double);    // and all films; radius of the pull-off force
  void adopt_history(unsigned, const double *, int, int, double, double, double, double *) const;
  std::string settings_text(const std::vector<std::string> &) const;    // typed, without some
  std::string coeff_words(int, int, const std::vector<std::string> &) const;    // after g and kt
  std::string coeff_lines(const std::vector<std::string> &) const;    // pair_coeff of all types
  struct SurfaceForces {
    double critical, pull_off, repulsion;
  };
  SurfaceForces surface_forces(int, int, double) const;
  double viscosity() const;                        // NaN for a variable not yet evaluated
  unsigned effects() const { return instance; }    // of the last run: those of the history
  class FixNeighHistoryLubcontact *history() const { return fix_history; }    // or null
  bigint forget_history(int);    // of the particles in a group, from the next run on; records
  double dt_limit;         // at the last set-up, 0 before or since the coefficients have changed;
  double dt_limit_mass;    // mass of all particles then

 protected:
  // settings
  double eta;        // viscosity
  char *eta_name;    // equal-style variable that sets it, or null
  int eta_var;
  double hc;          // range over the effective radius
  int range_rule;     // Lubcontact_NS::Range
  int radius_rule;    // Lubcontact_NS::Radius
  int euler;          // gap integrator
  enum { SQUEEZE, SHEAR, ROLL, TWIST, NUM_MODES };
  int mode[NUM_MODES];    // films on or off
  double roll_coeff;

  // coefficients per pair of types, as given or mixed
  double **g, **kt, **asperity, **roughness, **friction;
  int **law;                             // Lubcontact_NS::FrictionLaw
  double **critical;                     // load of the law, force
  double **adhesion;                     // beyond the asperities, over the effective radius
  double **repulsion, **screening;       // force at closed gap; its length, 0: none
  Lubcontact_NS::PairCoeffs **coeffs;    // what the loop needs
  double **reach;                        // largest gap that acts, over the effective radius
  Lubcontact_NS::Film *film;

  double
      longest;    // distance of centers at which the style acts; under hybrid cutforce is not set
  double *max_radius;               // per type
  std::vector<double> stiffness;    // sum over the partners, at set-up
  std::vector<double> radii;        // of the last step, where they may change in a run
  std::string history_id, dummy_id;
  class FixNeighHistoryLubcontact *fix_history;
  class FixNeighHistoryPlace *history_place;    // until the size of the history is known
  bool reported;                                // the table of this run has been printed
  bool warned_dt;                               // that the step exceeds its limit, in this run
  bool partition_now, partition_atom_now, power_now;
  std::vector<class Compute *> clients;          // every compute stress/partition
  std::vector<class Compute *> atom_clients;     // every compute stress/partition/atom
  std::vector<class Compute *> power_clients;    // every compute power/partition

  // range voronoi: does a pair share a face? Per entry of the list; empty for other ranges
  std::vector<char> faces;
  std::vector<std::size_t> first_face;    // of each owned atom
  const char *faces_of(int i) const { return faces.empty() ? nullptr : &faces[first_face[i]]; }
  int set_range(int, char **);
  void require_voronoi(int);
  double ghosts_of_user,
      ghosts_raised;    // cut-off of ghosts before, and since, range voronoi asked
  void request_ghosts();
  void return_ghosts();
  void tessellate();
  [[noreturn]] void ghost_error(int, int, double) const;

  // one instance of the loop per combination of effects
  using Eval = void (PairLubcontact::*)();
  using Single = Lubcontact_NS::Load (PairLubcontact::*)(int, int,
                                                         const Lubcontact_NS::PairGeometry &,
                                                         const double *, double &);
  using Exchange = void (*)(const double *, double *);
  unsigned mask, instance;    // effects of the deck, and of the loop that covers them
  int size_history;
  int history_layout;    // which slots it has
  Eval eval;
  Single eval_single;
  Exchange exchange;
  void choose_effects();
  template <unsigned EXTENSIONS> void choose_extended();
  template <unsigned... MASK> void choose_among(std::integer_sequence<unsigned, MASK...>);
  struct Queue;
  template <unsigned MASK> void eval_effects();
  template <class E> void fill(Queue &);
  template <class E>
  Lubcontact_NS::Load step_alone(const Queue &, int, bool, Lubcontact_NS::PairGeometry &);
  template <class E> void flush(Queue &);
  void add_virial(Queue &) const;
  double share(int) const;
  Lubcontact_NS::Body body(int) const;
  template <unsigned MASK>
  Lubcontact_NS::Load single_effects(int, int, const Lubcontact_NS::PairGeometry &, const double *,
                                     double &);
  template <class E>
  void tally_pair(int, int, const Lubcontact_NS::PairCoeffs &, const Lubcontact_NS::PairGeometry &,
                  const Lubcontact_NS::Load &);

  template <class E>
  void tally_power(const Queue &, int, const double *, const Lubcontact_NS::PairGeometry &,
                   const Lubcontact_NS::Load &);

  void allocate();
  void materials(int, char **);
  void find_max_radius();
  void check_radii() const;
  void check_variable();
  unsigned choose_mask() const;
  void require_history();
  void update_viscosity();
  double effective_radius(double, double) const;
  struct Entry {    // of the neighbor list
    int owner, jj;
    bool swapped;    // the pair (i,j) is there as (j,i)
  };
  bool find_entry(int, int, Entry &) const;
  bool excluded(int, int) const;
  bool acts(int, int, double, double) const;
  const double *find_history(const Entry &, double *) const;
  void find_place();
  void leave_place();
  void follow_radii();
  void start_partition();
  void tally_partition(int, int, const Lubcontact_NS::PairGeometry &, const Lubcontact_NS::Load &);
  Lubcontact_NS::FrictionLaw friction_law(int, int, char **) const;
  void mix(int, int);
  void check_pair(int, int) const;
  double find_reach(int, int) const;
  std::array<double **, 9> numbers() const;
  void check_repulsion(double) const;
  void write_pair(FILE *, int, int) const;
  void check_box() const;
  void check_motion() const;
  double sum_stiffness(double, double);
  double time_step_limit() const;
  void check_host() const;
  double shear_rate() const;
  void report(double, double);
  [[noreturn]] void overlap_error(int, int, double) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
