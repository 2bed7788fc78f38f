/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "pair_lubcontact.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "compute.h"
#include "error.h"
#include "force.h"
#include "lubcontact_channels.h"
#include "lubcontact_power.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "suspension_host.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <limits>

using namespace LAMMPS_NS;
using Lubcontact_NS::Load;
using Lubcontact_NS::PairCoeffs;
using Lubcontact_NS::PairGeometry;
using Lubcontact_NS::Vec3;

static constexpr int SINGLE_EXTRA = 15;
static constexpr int MAX_HISTORY =
    Lubcontact_NS::Effects<Lubcontact_NS::NUM_COMBINATIONS - 1>::HISTORY_SIZE;

/* ---------------------------------------------------------------------- */

PairLubcontact::PairLubcontact(LAMMPS *lmp) :
    Pair(lmp), power_of_step(false), power_step(-1), partition_step(-1), partition_atom_step(-1),
    dt_limit(0.0), dt_limit_mass(0.0), eta(0.0), eta_name(nullptr), eta_var(-1), hc(0.0),
    range_rule(0), radius_rule(0), euler(0), mode{1, 1, 1, 1}, roll_coeff(0.6), g(nullptr),
    kt(nullptr), asperity(nullptr), roughness(nullptr), friction(nullptr), law(nullptr),
    critical(nullptr), adhesion(nullptr), repulsion(nullptr), screening(nullptr), coeffs(nullptr),
    reach(nullptr), film(new Lubcontact_NS::Film()), longest(0.0), max_radius(nullptr),
    fix_history(nullptr), history_place(nullptr), reported(false), warned_dt(false),
    partition_now(false), partition_atom_now(false), power_now(false), ghosts_of_user(0.0),
    ghosts_raised(0.0), mask(0), instance(0), size_history(0), history_layout(0), eval(nullptr),
    eval_single(nullptr), exchange(nullptr)
{
  static_assert(NUM_PARTS == Lubcontact_NS::NUM_CHANNELS, "one row of stress per channel");
  static_assert(NUM_ORIGINS == Lubcontact_NS::NUM_ORIGINS, "one row of power per origin");

  single_enable = 1;
  restartinfo = 1;
  writedata = 1;
  no_virial_fdotr_compute = 1;    // forces are tallied by origin in the loop
  centroidstressflag = CENTROID_NOTAVAIL;
  beyond_contact = 1;    // history lives at a gap, too
  nondefault_history_transfer = 1;
  comm_reverse = 1;    // sum of stiffness at set-up
  single_extra = SINGLE_EXTRA;
  svector = new double[single_extra];

  find_place();
}

/* ---------------------------------------------------------------------- */

std::vector<PairLubcontact *> PairLubcontact::all(LAMMPS *lmp)
{
  std::vector<PairLubcontact *> found;
  for (Pair *pair : Suspension_NS::all_lubcontact(lmp))
    found.push_back(dynamic_cast<PairLubcontact *>(pair));
  return found;
}

/* ---------------------------------------------------------------------- */

PairLubcontact::~PairLubcontact()
{
  if (copymode) return;

  leave_place();
  return_ghosts();
  delete[] svector;
  delete[] eta_name;
  delete[] max_radius;
  delete film;
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
    memory->destroy(g);
    memory->destroy(kt);
    memory->destroy(asperity);
    memory->destroy(roughness);
    memory->destroy(friction);
    memory->destroy(law);
    memory->destroy(critical);
    memory->destroy(adhesion);
    memory->destroy(repulsion);
    memory->destroy(screening);
    memory->destroy(coeffs);
    memory->destroy(reach);
  }
}

/* ----------------------------------------------------------------------
   LAMMPS looks for positions that are no numbers only when it rebuilds the list, which they never ask
   for; and they are out of range of everything
------------------------------------------------------------------------- */

static void check_positions(const Atom *atom, bigint step, Error *error)
{
  constexpr double LARGEST = std::numeric_limits<double>::max();
  const double *x = atom->nlocal ? atom->x[0] : nullptr;    // they are contiguous
  const int size = 3 * atom->nlocal;
  double wrong = 0.0;    // of the type of a position, so that the loop vectorizes
  for (int n = 0; n < size; n++) wrong = fabs(x[n]) <= LARGEST ? wrong : 1.0;
  if (wrong == 0.0) return;
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 3; d++)
      if (!(fabs(atom->x[i][d]) <= LARGEST))
        error->one(FLERR,
                   "Position {} of atom {} along {} at step {} is not a number: reduce the time "
                   "step, or look for what set its velocity or force",
                   atom->x[i][d], atom->tag[i], "xyz"[d], step);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::compute(int eflag, int vflag)
{
  check_positions(atom, update->ntimestep, error);
  ev_init(eflag, vflag);
  update_viscosity();
  if (neighbor->ago == 0) {
    check_radii();
    tessellate();
  }
  if (!atom->avec->comm_x_only) follow_radii();
  start_partition();
  (this->*eval)();
}

/* ----------------------------------------------------------------------
   is this step announced for a compute stress/partition or power/partition?
------------------------------------------------------------------------- */

void PairLubcontact::start_partition()
{
  auto announced = [this](const std::vector<Compute *> &computes) {
    bool any = false;
    for (const auto &compute : computes)
      if (compute->matchstep(update->ntimestep)) any = true;
    return any;
  };
  power_now = announced(power_clients);
  partition_now = power_now || announced(clients);    // the power put in is of the stress
  if (partition_now) {
    memset(partition, 0, sizeof(partition));
    partition_step = update->ntimestep;
  }
  partition_atom_now = announced(atom_clients);
  if (partition_atom_now) {
    partition_atom.assign(atom->nlocal + atom->nghost, {});
    partition_atom_step = update->ntimestep;
  }
  if (power_now) {
    memset(heat, 0, sizeof(heat));
    memset(stored, 0, sizeof(stored));
    power_step = update->ntimestep;
    power_of_step = !update->setupflag;
  }
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::init_style()
{
  Suspension_NS::require_spheres(lmp, "Pair style lubcontact");
  if (comm->ghost_velocity == 0)
    error->all(FLERR,
               "Pair style lubcontact needs velocities of ghost atoms; add: comm_modify vel yes");
  check_variable();
  mask = choose_mask();
  instance = Lubcontact_NS::covering(mask);
  choose_effects();
  check_host();

  if (update->whichflag == 2 && size_history)
    error->all(FLERR,
               "Pair style lubcontact can be minimized only as frictionless elastic contact; use: "
               "squeeze no shear no roll no twist no, friction none, and no adhesion");

  neighbor->add_request(this,
                        NeighConst::REQ_DEFAULT | (size_history ? NeighConst::REQ_HISTORY : 0));
  require_history();
  find_max_radius();
  request_ghosts();
  longest = 0.0;    // init_one() comes next
  clients = modify->get_compute_by_style("^stress/partition$");
  atom_clients = modify->get_compute_by_style("^stress/partition/atom");
  power_clients = modify->get_compute_by_style("^power/partition$");
}

/* ----------------------------------------------------------------------
   what LAMMPS cannot do for a style whose pairs have a history: half steps of rRESPA, which would
   advance it several times a step, and the way back of ghosts between tiles
------------------------------------------------------------------------- */

void PairLubcontact::check_host() const
{
  Suspension_NS::require_verlet(lmp, "Pair style lubcontact");
  if (comm->style == Comm::TILED && force->newton_pair && size_history)
    error->all(FLERR,
               "Pair style lubcontact with comm_style tiled needs newton off for pairs, because "
               "LAMMPS cannot send the history of ghosts back between tiles; add before the box is "
               "made: newton off");
}

/* ----------------------------------------------------------------------
   the instance of the loop for the effects in use
------------------------------------------------------------------------- */

void PairLubcontact::choose_effects()
{
  using Lubcontact_NS::ADHESION, Lubcontact_NS::REPULSION;
  const unsigned extensions = mask & (ADHESION | REPULSION);
  if (extensions == 0) choose_extended<0>();
  if (extensions == ADHESION) choose_extended<ADHESION>();
  if (extensions == REPULSION) choose_extended<REPULSION>();
  if (extensions == (ADHESION | REPULSION)) choose_extended<ADHESION | REPULSION>();
}

/* ----------------------------------------------------------------------
   unless comm_modify has set another since
------------------------------------------------------------------------- */

void PairLubcontact::return_ghosts()
{
  if (ghosts_raised > 0.0 && comm->cutghostuser == ghosts_raised)
    comm->cutghostuser = ghosts_of_user;
  ghosts_raised = 0.0;
}

/* ---------------------------------------------------------------------- */

double PairLubcontact::effective_radius(double ri, double rj) const
{
  return Lubcontact_NS::effective_radius(static_cast<Lubcontact_NS::Radius>(radius_rule), ri, rj);
}

/* ----------------------------------------------------------------------
   reads the history and never changes it; fforce is the normal force over r
------------------------------------------------------------------------- */

double PairLubcontact::single(int i, int j, int itype, int jtype, double /*rsq*/,
                              double /*factor_coul*/, double /*factor_lj*/, double &fforce)
{
  const double *xi = atom->x[i], *xj = atom->x[j];
  const double ri = atom->radius[i], rj = atom->radius[j];
  const double a = effective_radius(ri, rj);
  const PairGeometry geometry =
      Lubcontact_NS::pair_geometry({xi[0], xi[1], xi[2]}, {xj[0], xj[1], xj[2]}, ri, rj, a);
  fforce = 0.0;
  for (int m = 0; m < SINGLE_EXTRA; m++) svector[m] = 0.0;
  svector[0] = svector[1] = geometry.un;
  if (geometry.un >= reach[itype][jtype] * a) return 0.0;
  Entry entry;
  if (!find_entry(i, j, entry) || !acts(entry.owner, entry.jj, geometry.un, a)) return 0.0;

  double energy, buffer[MAX_HISTORY];
  const Load load = (this->*eval_single)(i, j, geometry, find_history(entry, buffer), energy);
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

double PairLubcontact::memory_usage()
{
  const double n = atom->ntypes + 1.0;
  return Pair::memory_usage() + n * n * (10 * sizeof(double) + sizeof(int) + sizeof(PairCoeffs)) +
      partition_atom.capacity() * sizeof(partition_atom[0]) + faces.capacity() +
      first_face.capacity() * sizeof(first_face[0]) + radii.capacity() * sizeof(double);
}
