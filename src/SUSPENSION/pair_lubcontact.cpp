/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "pair_lubcontact.h"
#include "pair_lubcontact_count.h"

#include "atom.h"
#include "atom_vec.h"
#include "citeme.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "input.h"
#include "lubcontact_checks.h"
#include "lubcontact_loop.h"
#include "lubcontact_pairs.h"
#include "lubcontact_report.h"
#include "lubcontact_stiffness.h"
#include "lubcontact_tally.h"
#include "lubcontact_type_coeffs.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "suspension_host.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using Lubcontact_NS::Load;
using Lubcontact_NS::PairGeometry;
using Lubcontact_NS::Vec3;

static constexpr char CITE_LUBCONTACT[] =
    "pair style lubcontact: doi:10.1103/PhysRevFluids.4.064302\n\n"
    "@Article{Chevremont2019,\n"
    " author =  {W. Chevremont and B. Chareyre and H. Bodiguel},\n"
    " title =   {Quantitative Study of the Rheology of Frictional Suspensions:\n"
    "            Influence of Friction Coefficient in a Large Range of Viscous Numbers},\n"
    " journal = {Physical Review Fluids},\n"
    " year =    2019,\n"
    " volume =  4,\n"
    " pages =   064302\n"
    "}\n\n";

static constexpr int SINGLE_EXTRA = 15;
static constexpr int MAX_HISTORY =
    Lubcontact_NS::Effects<Lubcontact_NS::NUM_COMBINATIONS - 1>::HISTORY_SIZE;

/* ---------------------------------------------------------------------- */

PairLubcontact::PairLubcontact(LAMMPS *lmp) :
    Pair(lmp), given(new Lubcontact_NS::Settings()), viscosity_index(-1),
    coeffs(new LubcontactTypeCoeffs(lmp)), film(new Lubcontact_NS::Film()),
    pairs(new LubcontactPairs(lmp)), sums(new LubcontactTally(lmp)),
    instance(new LubcontactInstance()), longest(0.0), counted(new PartnerCount()), dt_limit(0.0),
    dt_limit_mass(0.0), reported(false), warned_dt(false)
{
  if (lmp->citeme) lmp->citeme->add(CITE_LUBCONTACT);
  single_enable = 1;
  restartinfo = 1;
  writedata = 1;
  no_virial_fdotr_compute = 1;    // forces are tallied by origin in the loop
  centroidstressflag = CENTROID_NOTAVAIL;
  beyond_contact = 1;    // history lives at a gap, too
  nondefault_history_transfer = 1;
  comm_reverse = 1;    // sums over the partners
  single_extra = SINGLE_EXTRA;
  svector = new double[single_extra];
}

/* ---------------------------------------------------------------------- */

PairLubcontact::~PairLubcontact()
{
  if (copymode) return;

  delete[] svector;
  memory->destroy(cutsq);
  setflag = nullptr;    // of the coefficients
}

/* ---------------------------------------------------------------------- */

std::vector<PairLubcontact *> PairLubcontact::all(LAMMPS *lmp)
{
  std::vector<PairLubcontact *> found;
  for (Pair *pair : Suspension_NS::all_lubcontact(lmp))
    found.push_back(dynamic_cast<PairLubcontact *>(pair));
  return found;
}

std::vector<PairLubcontact *> PairLubcontact::require(LAMMPS *lmp, const std::string &who)
{
  const auto found = all(lmp);
  if (found.empty())
    lmp->error->all(FLERR, "{} splits the forces of pair_style lubcontact, which is not defined",
                    who);
  return found;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::allocate()
{
  if (allocated) return;
  allocated = 1;
  coeffs->create();
  setflag = coeffs->given();
  memory->create(cutsq, atom->ntypes + 1, atom->ntypes + 1, "pair:cutsq");
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::compute(int eflag, int vflag)
{
  lubcontact_checks::check_positions(lmp);
  ev_init(eflag, vflag);
  update_viscosity();
  if (neighbor->ago == 0) {
    lubcontact_checks::check_radii(lmp, max_radius);
    pairs->find_faces(*given);
  }
  if (!atom->avec->comm_x_only) pairs->follow_radii(instance->effects & Lubcontact_NS::SQUEEZE);
  sums->start_step();

  // the virial instead of what ev_tally_xyz() sums: the same bits, whatever else this step asks for
  double cell_virial[6];
  LubcontactStep step{*pairs,
                      *sums,
                      *film,
                      given->euler,
                      pairs->range().plastic,
                      vflag_global ? cell_virial : nullptr,
                      counted->of_next_step(neighbor->ago == 0),
                      nullptr,
                      nullptr,
                      eflag_either != 0};
  if (eflag_either || vflag_atom)
    step.tally_atoms = [this](int i, int j, double energy, const Vec3 &f, const Vec3 &d) {
      ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, energy, 0.0, f.x, f.y, f.z, d.x, d.y,
                   d.z);
    };
  if (film->residual && vflag_atom)
    step.tally_stresslet = [this](int i, int j, const Lubcontact_NS::SymmetricTensor &s) {
      v_tally_tensor(i, j, atom->nlocal, force->newton_pair, -s.xx, -s.yy, -s.zz, -s.xy, -s.xz,
                     -s.yz);
    };
  instance->loop(lmp, step);
  if (vflag_global) std::copy_n(cell_virial, 6, virial);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::init_style()
{
  Suspension_NS::require_spheres(lmp, "Pair style lubcontact");
  Suspension_NS::require_verlet(lmp,
                                "Pair style lubcontact");    // half steps would advance histories
  if (comm->ghost_velocity == 0)
    error->all(FLERR,
               "Pair style lubcontact needs velocities of ghost atoms; add: comm_modify vel yes");
  lubcontact_checks::check_factors(lmp);
  check_variable();
  const bool residual = given->range == Lubcontact_NS::Range::RESIDUAL;
  const unsigned effects = present_effects(coeffs->law(*given, false));
  if (residual && (effects & Lubcontact_NS::RESTITUTION))
    error->all(FLERR,
               "Pair style lubcontact restitution is for dry grains and cannot act beside range "
               "residual: leave it out of pair_coeff");
  lubcontact_checks::check_residual(lmp, *given);
  *instance = find_instance(effects, residual);
  const int size = instance->history.size;
  if (comm->style == Comm::TILED && force->newton_pair && size)
    error->all(FLERR,
               "Pair style lubcontact with comm_style tiled needs newton off for pairs, because "
               "LAMMPS cannot send the history of ghosts back between tiles; add before the box is "
               "made: newton off");
  if (update->whichflag == 2 && size)
    error->all(FLERR,
               "Pair style lubcontact supports minimization only for frictionless elastic contact; "
               "use: squeeze no shear no roll no twist no, friction none, no adhesion and no "
               "restitution");

  neighbor->add_request(this, NeighConst::REQ_DEFAULT | (size ? NeighConst::REQ_HISTORY : 0));
  pairs->history().require(this, instance->history);
  pairs->range().resize(atom->ntypes);
  max_radius = lubcontact_checks::find_max_radius(lmp);
  pairs->request_ghosts(*given, *std::max_element(max_radius.begin(), max_radius.end()));
  longest = 0.0;    // init_one() comes next
  *counted = {};
  sums->find_clients();
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::init_list(int id, NeighList *ptr)
{
  Pair::init_list(id, ptr);
  pairs->take_list(ptr);
}

/* ---------------------------------------------------------------------- */

double PairLubcontact::init_one(int i, int j)
{
  if (setflag[i][j] == 0) {
    coeffs->mix(i, j);
    did_mix = true;
  }
  coeffs->check(i, j, *given);
  const auto c = coeffs->of(i, j);
  for (const auto &row : Lubcontact_NS::EFFECTS)    // fix adapt comes after the choice of a loop
    if (!row.is_film() && row.is_present(c) && !(instance->effects & row.bit))
      error->all(FLERR,
                 "Pair style lubcontact types {} {}: there is no {} that could be changed: give it "
                 "to pair_coeff first",
                 i, j, row.name);
  coeffs->put(i, j, c);    // and for (j,i)
  pairs->range().set(i, j, *given, c);

  const double ri = max_radius[i], rj = max_radius[j];
  double end = ri + rj;
  if (ri > 0.0 && rj > 0.0)
    end += pairs->range().reach_a_of(i, j) * Lubcontact_NS::effective_radius(given->radius, ri, rj);
  longest = MAX(longest, end);
  return end;
}

/* ----------------------------------------------------------------------
   reads the history and never changes it; fforce is the normal force over r
------------------------------------------------------------------------- */

double PairLubcontact::single(int i, int j, int itype, int jtype, double /*rsq*/,
                              double /*factor_coul*/, double /*factor_lj*/, double &fforce)
{
  const double a = Lubcontact_NS::effective_radius(given->radius, atom->radius[i], atom->radius[j]);
  const PairGeometry geometry = pairs->geometry(i, j, a);
  fforce = 0.0;
  for (int m = 0; m < SINGLE_EXTRA; m++) svector[m] = 0.0;
  svector[0] = svector[1] = geometry.un;
  if (geometry.un >= pairs->range().reach_a_of(itype, jtype) * a) return 0.0;
  LubcontactPairs::Entry entry;
  if (!pairs->find_entry(i, j, entry) || pairs->acting(entry.owner, entry.n) == 0.0) return 0.0;

  double energy, buffer[MAX_HISTORY];
  const Load load = instance->single(pairs->range().of(itype, jtype), *film, geometry,
                                     pairs->find_history(entry, buffer), energy);
  const Lubcontact_NS::ShearSplit parts = Lubcontact_NS::split(load);
  const double shear = Lubcontact_NS::norm(load.shear);
  const double values[SINGLE_EXTRA] = {load.u,
                                       geometry.un,
                                       geometry.un - load.u,
                                       load.contact,
                                       load.film,
                                       load.shear.x,
                                       load.shear.y,
                                       load.shear.z,
                                       parts.contact * shear,
                                       (1.0 - parts.contact) * shear,
                                       load.couple.x,
                                       load.couple.y,
                                       load.couple.z,
                                       static_cast<double>(parts.state),
                                       load.repulsion};
  memcpy(svector, values, sizeof(values));
  fforce = load.normal / geometry.r;
  return energy;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::visit_pairs(const Visitor &visit) const
{
  pairs->visit(instance->covering, *film, visit);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::setup()
{
  using Lubcontact_NS::SPIN_OF_INERTIA;
  lubcontact_checks::check_box(lmp, longest);
  update_viscosity();
  pairs->find_faces(*given);
  const double number = sum_over_partners(SPIN_OF_INERTIA);
  std::vector<double> stiffness = of_partners;
  const auto everyone = all(lmp);    // a particle feels the springs of every sub-style
  for (PairLubcontact *other : everyone) {
    if (other == this) continue;
    other->pairs->find_faces(*other->given);    // its own set-up may come later
    other->sum_over_partners(SPIN_OF_INERTIA);
    for (int i = 0; i < atom->nlocal; i++) stiffness[i] += other->of_partners[i];
  }
  dt_limit = lubcontact_checks::step_limit(lmp, stiffness);
  const auto particles = Suspension_NS::measure_particles(lmp);
  dt_limit_mass = particles.mass;
  warned_dt = this != everyone.front();    // one speaks for all
  reset_dt();
  lubcontact_checks::check_restitution(lmp, instance->effects);
  lubcontact_checks::check_skin(lmp, *std::max_element(max_radius.begin(), max_radius.end()));
  if (!reported) {
    const Lubcontact_NS::Law acting = coeffs->law(*given, true);
    lubcontact_checks::check_hybrid(lmp, this, acting);
    lubcontact_checks::check_coefficients(lmp, acting, !viscosity_variable.empty());
    lubcontact_checks::check_motion(lmp, instance->effects);
    if (particles.number > 0.0) {
      lubcontact_checks::check_repulsion(lmp, acting, particles.smallest);
      lubcontact_checks::check_sizes(lmp, *given, particles.smallest, particles.largest);
    }
    double sum;
    MPI_Allreduce(&number, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    report_lubcontact(lmp, acting, viscosity_variable,
                      {instance->effects, instance->history.size, sum, dt_limit, particles});
  }
  reported = dt_limit_mass > 0.0;    // again when there are particles
}

/* ----------------------------------------------------------------------
   also when fix dt/reset has changed the step; not between runs, when the limit may be an old one
------------------------------------------------------------------------- */

void PairLubcontact::reset_dt()
{
  if (warned_dt || update->whichflag == 0 || dt_limit <= 0.0 || update->dt <= dt_limit) return;
  warned_dt = true;
  if (comm->me == 0)
    error->warning(FLERR,
                   "Time step {} exceeds {:.4g}, the stability limit of the contact springs in the "
                   "state at the start of the run: reduce it, or soften the contact",
                   update->dt, dt_limit);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::check_variable()
{
  if (viscosity_variable.empty()) return;
  viscosity_index = input->variable->find(viscosity_variable.c_str());
  if (viscosity_index < 0)
    error->all(FLERR, "Variable {} for the viscosity of pair style lubcontact does not exist",
               viscosity_variable);
  if (!input->variable->equalstyle(viscosity_index))
    error->all(FLERR, "Variable {} for the viscosity of pair style lubcontact is not equal-style",
               viscosity_variable);
}

void PairLubcontact::update_viscosity()
{
  if (!viscosity_variable.empty()) {
    modify->clearstep_compute();
    given->viscosity = input->variable->compute_equal(viscosity_index);
    modify->addstep_compute(update->ntimestep + 1);
    if (!(given->viscosity >= 0.0))
      error->all(FLERR, "Viscosity of pair style lubcontact must be >= 0, but variable {} is {}",
                 viscosity_variable, given->viscosity);
  }
  *film = film_of(*given);
  if (film->residual) film->strain = Suspension_NS::cell_strain(domain);
}

double PairLubcontact::viscosity() const
{
  return given->viscosity;
}

std::string PairLubcontact::viscosity_word() const
{
  return viscosity_variable.empty() ? fmt::format("{}", given->viscosity)
                                    : "v_" + viscosity_variable;
}

/* ---------------------------------------------------------------------- */

Lubcontact_NS::Law PairLubcontact::law() const
{
  return coeffs->law(*given, false);
}

void PairLubcontact::adopt(const Lubcontact_NS::Law &law)
{
  *given = law.settings;
  viscosity_variable.clear();
  coeffs->adopt(law);
  allocate();
  dt_limit = 0.0;
  reported = true;    // not what the user asked for
}

unsigned PairLubcontact::effects() const
{
  return instance->covering;
}

/* ----------------------------------------------------------------------
   parity of the history under exchange of i and j
------------------------------------------------------------------------- */

void PairLubcontact::transfer_history(double *source, double *target, int, int)
{
  pairs->history().exchange(source, target);
}

/* ---------------------------------------------------------------------- */

void *PairLubcontact::extract(const char *name, int &dim)
{
  dim = 0;
  if (strcmp(name, "eta") == 0) return viscosity_variable.empty() ? &given->viscosity : nullptr;
  if (strcmp(name, "rollcoeff") == 0) return &given->roll_coeff;
  // range voronoi: which pairs share a face, as long as a list lives
  if (strcmp(name, "faces") == 0) return const_cast<char *>(pairs->faces().all());
  dim = 2;
  return coeffs->column(name);
}

/* ---------------------------------------------------------------------- */

double PairLubcontact::memory_usage()
{
  return Pair::memory_usage() + coeffs->memory_usage() + pairs->memory_usage() +
      sums->memory_usage() + counted->memory_usage() +
      static_cast<double>(of_partners.capacity() * sizeof(double));
}
