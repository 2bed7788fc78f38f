/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "pair_lubcontact.h"

#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "error.h"
#include "fix.h"
#include "fix_neigh_history.h"
#include "force.h"
#include "lubcontact_channels.h"
#include "lubcontact_pair.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using lubcontact::Body;
using lubcontact::Load;
using lubcontact::PairCoeffs;
using lubcontact::PairGeometry;
using lubcontact::Vec3;

static constexpr int SINGLE_EXTRA = 14;

/* ---------------------------------------------------------------------- */

PairLubcontact::PairLubcontact(LAMMPS *lmp) :
    Pair(lmp), partition_step(-1), eta(0.0), eta_name(nullptr), eta_var(-1), hc(0.0), range_rule(0),
    radius_rule(0), euler(0), mode{1, 1, 1, 1}, roll_coeff(0.6), g(nullptr), kt(nullptr),
    asperity(nullptr), roughness(nullptr), friction(nullptr), coulomb(nullptr), coeffs(nullptr),
    reach(nullptr), film(new lubcontact::Film()), longest(0.0), max_radius(nullptr),
    fix_history(nullptr), reported(false), partition_now(false), mask(0), size_history(0),
    eval(nullptr), eval_single(nullptr), exchange(nullptr)
{
  static_assert(NUM_PARTS == lubcontact::NUM_CHANNELS, "one row of stress per channel");

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

  // lowest free number: a restarted script finds its history whatever pair styles either script had
  int number = 1;
  auto taken = [this](const std::string &id) {
    return modify->get_fix_by_id(id) != nullptr;
  };
  while (taken(fmt::format("NEIGH_HISTORY_LUBCONTACT{}", number)) ||
         taken(fmt::format("NEIGH_HISTORY_LUBCONTACT_DUMMY{}", number)))
    number++;
  history_id = fmt::format("NEIGH_HISTORY_LUBCONTACT{}", number);
  dummy_id = fmt::format("NEIGH_HISTORY_LUBCONTACT_DUMMY{}", number);

  // keeps the place of the history among the fixes until its size is known
  modify->add_fix(dummy_id + " all DUMMY");
}

/* ---------------------------------------------------------------------- */

PairLubcontact::~PairLubcontact()
{
  if (copymode) return;

  modify->delete_fix(fix_history ? history_id : dummy_id);
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
    memory->destroy(coulomb);
    memory->destroy(coeffs);
    memory->destroy(reach);
  }
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  update_viscosity();
  if (neighbor->ago == 0) check_radii();

  partition_now = false;
  for (const auto &client : clients)
    if (client->matchstep(update->ntimestep)) partition_now = true;
  if (partition_now) {
    memset(partition, 0, sizeof(partition));
    partition_step = update->ntimestep;
  }

  (this->*eval)();
}

/* ----------------------------------------------------------------------
   the loop: fetch, call, add, tally
------------------------------------------------------------------------- */

// All inlined: the functions of the kernel are long, but each is called once.

template <unsigned MASK> [[gnu::flatten]] void PairLubcontact::eval_effects()
{
  using E = lubcontact::Effects<MASK>;
  constexpr int SIZE = E::HISTORY_SIZE;
  constexpr bool TORQUE = E::turns || E::twist;
  const bool advance = !update->setupflag;      // a set-up sees the history of the last step
  const bool guard = update->whichflag != 2;    // a minimization may separate anything
  const bool newton = force->newton_pair;
  const bool tally = evflag || partition_now;
  const int nlocal = atom->nlocal;
  const double dt = update->dt;
  const lubcontact::Film fluid = *film;
  const auto rule = static_cast<lubcontact::Radius>(radius_rule);
  const int *type = atom->type;
  const double *radius = atom->radius;
  const double *const *x = atom->x, *const *v = atom->v, *const *omega = atom->omega;
  double **f = atom->f, **torque = atom->torque;

  auto vector = [](const double *a) {
    return Vec3{a[0], a[1], a[2]};
  };
  auto add = [](const Vec3 &a, double *sum) {
    sum[0] += a.x;
    sum[1] += a.y;
    sum[2] += a.z;
  };

  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int *jlist = list->firstneigh[i];
    const int jnum = list->numneigh[i];
    int *known = SIZE ? fix_history->firstflag[i] : nullptr;
    double *histories = SIZE ? fix_history->firstvalue[i] : nullptr;
    const Body body_i{vector(x[i]), vector(v[i]), vector(omega[i]), radius[i]};
    const PairCoeffs *coeffs_i = coeffs[type[i]];
    const double *reach_i = reach[type[i]];
    Vec3 force_on, torque_on;

    for (int jj = 0; jj < jnum; jj++) {
      const int j = jlist[jj] & NEIGHMASK;
      if (force->special_lj[sbmask(jlist[jj])] == 0.0) continue;

      // a is at most the mean radius: most pairs out of range need no division
      const int jtype = type[j];
      const double radsum = body_i.radius + radius[j];
      const double most = radsum * (1.0 + 0.5 * reach_i[jtype]);
      const Vec3 d = body_i.x - vector(x[j]);
      if (dot(d, d) >= most * most) {
        if (SIZE) known[jj] = 0;
        continue;
      }
      const Body body_j{vector(x[j]), vector(v[j]), vector(omega[j]), radius[j]};
      const double a = lubcontact::effective_radius(rule, body_i.radius, body_j.radius);
      const PairGeometry geometry =
          lubcontact::pair_geometry(body_i.x, body_j.x, body_i.radius, body_j.radius, a);
      if (geometry.un >= reach_i[jtype] * a) {
        if (SIZE) known[jj] = 0;
        continue;
      }
      if (!(geometry.un > -a) && guard) overlap_error(i, j, geometry.un / a);

      const PairCoeffs &c = coeffs_i[jtype];
      double *history = SIZE ? histories + SIZE * jj : nullptr;
      if (SIZE) {
        if (!known[jj]) {
          lubcontact::first_history<E>(c, geometry, history);
          known[jj] = 1;
        } else if (advance) {
          lubcontact::next_history<E>(c, fluid, geometry, body_i, body_j, dt, history, history);
        }
      }

      const Load load = lubcontact::pair_load<E>(c, fluid, geometry, history);
      const Vec3 force_i = lubcontact::force_on_i(load, geometry);
      force_on = force_on + force_i;
      if (TORQUE) torque_on = torque_on + lubcontact::torque_on_i(load, geometry);
      if (newton || j < nlocal) {
        add(-1.0 * force_i, f[j]);
        if (TORQUE) add(lubcontact::torque_on_j(load, geometry), torque[j]);
      }
      if (tally) tally_pair<E>(i, j, c, geometry, load);
    }
    add(force_on, f[i]);
    if (TORQUE) add(torque_on, torque[i]);
  }
}

/* ----------------------------------------------------------------------
   energy, virial and stress by origin, in the steps that need them
------------------------------------------------------------------------- */

template <class E>
[[gnu::noinline]] void PairLubcontact::tally_pair(int i, int j, const PairCoeffs &c,
                                                  const PairGeometry &geometry, const Load &load)
{
  if (evflag) {
    const double energy = eflag_either ? lubcontact::pair_energy<E>(c, geometry, load) : 0.0;
    const Vec3 force_i = lubcontact::force_on_i(load, geometry), d = geometry.r * geometry.n;
    ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, energy, 0.0, force_i.x, force_i.y,
                 force_i.z, d.x, d.y, d.z);
  }
  // a pair across ranks is seen twice without newton: half from each
  if (partition_now)
    tally_partition(force->newton_pair || j < atom->nlocal ? 1.0 : 0.5, geometry, load);
}

/* ----------------------------------------------------------------------
   sum of r_a F_b by origin
------------------------------------------------------------------------- */

void PairLubcontact::tally_partition(double weight, const PairGeometry &geometry, const Load &load)
{
  using namespace lubcontact;
  const ShearSplit parts = split(load);
  Vec3 force_of[NUM_CHANNELS];
  force_of[CONTACT_NORMAL] = load.contact * geometry.n;
  force_of[LUBRICATION_NORMAL] = load.film * geometry.n;
  force_of[CONTACT_TANGENTIAL] = parts.contact * load.shear;
  force_of[LUBRICATION_TANGENTIAL] = (1.0 - parts.contact) * load.shear;

  const Vec3 d = (weight * geometry.r) * geometry.n;
  for (int m = 0; m < NUM_CHANNELS; m++) {
    const Vec3 &f = force_of[m];
    const double product[NUM_COMPONENTS] = {d.x * f.x, d.y * f.y, d.z * f.z, d.x * f.y, d.x * f.z,
                                            d.y * f.z, d.y * f.x, d.z * f.x, d.z * f.y};
    for (int n = 0; n < NUM_COMPONENTS; n++) partition[m][n] += product[n];
  }
}

/* ----------------------------------------------------------------------
   table of all combinations of effects; the style keeps the one it needs
------------------------------------------------------------------------- */

template <std::size_t... MASK> void PairLubcontact::choose_effects(std::index_sequence<MASK...>)
{
  static constexpr Eval evals[] = {&PairLubcontact::eval_effects<MASK>...};
  static constexpr Single singles[] = {&PairLubcontact::single_effects<MASK>...};
  static constexpr Exchange exchanges[] = {
      &lubcontact::exchange_history<lubcontact::Effects<MASK>>...};
  static constexpr int sizes[] = {lubcontact::Effects<MASK>::HISTORY_SIZE...};
  eval = evals[mask];
  eval_single = singles[mask];
  exchange = exchanges[mask];
  size_history = sizes[mask];
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::init_style()
{
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "Pair style lubcontact needs finite-size spheres; use: atom_style sphere");
  if (comm->ghost_velocity == 0)
    error->all(FLERR,
               "Pair style lubcontact needs velocities of ghost atoms; add: comm_modify vel yes");
  check_variable();
  mask = choose_mask();
  choose_effects(std::make_index_sequence<lubcontact::NUM_COMBINATIONS>());

  if (update->whichflag == 2 && size_history)
    error->all(FLERR,
               "Pair style lubcontact can be minimized only as frictionless elastic contact; use: "
               "squeeze no shear no roll no twist no, and friction none");

  neighbor->add_request(this,
                        NeighConst::REQ_DEFAULT | (size_history ? NeighConst::REQ_HISTORY : 0));
  require_history();
  find_max_radius();
  longest = 0.0;    // init_one() comes next
  clients = modify->get_compute_by_style("^stress/partition");
}

/* ----------------------------------------------------------------------
   fix that carries the history, of the size that the effects need
------------------------------------------------------------------------- */

void PairLubcontact::require_history()
{
  if (fix_history && fix_history->get_dnum() != size_history) {
    if (comm->me == 0)
      error->warning(FLERR, "Pair style lubcontact now has other effects: its history is dropped");
    modify->replace_fix(history_id, dummy_id + " all DUMMY", 1);
    fix_history = nullptr;
  }
  if (!fix_history && size_history) {
    fix_history = dynamic_cast<FixNeighHistory *>(modify->replace_fix(
        dummy_id, fmt::format("{} all NEIGH_HISTORY/LUBCONTACT {}", history_id, size_history), 1));
    if (!fix_history) error->all(FLERR, "Could not find pair fix neigh history ID {}", history_id);
    fix_history->pair = this;
  }
}

/* ---------------------------------------------------------------------- */

double PairLubcontact::effective_radius(double ri, double rj) const
{
  return lubcontact::effective_radius(static_cast<lubcontact::Radius>(radius_rule), ri, rj);
}

/* ----------------------------------------------------------------------
   parity of the history under exchange of i and j
------------------------------------------------------------------------- */

void PairLubcontact::transfer_history(double *source, double *target, int, int)
{
  exchange(source, target);
}

/* ----------------------------------------------------------------------
   history of (i,j), copied to buffer if it is kept as (j,i); null if the pair has none
------------------------------------------------------------------------- */

const double *PairLubcontact::find_history(int i, int j, double *buffer) const
{
  if (!fix_history) return nullptr;
  for (int swap = 0; swap < 2; swap++) {
    const int owner = swap ? j : i, partner = swap ? i : j;
    if (owner >= atom->nlocal) continue;
    for (int jj = 0; jj < list->numneigh[owner]; jj++) {
      if ((list->firstneigh[owner][jj] & NEIGHMASK) != partner) continue;
      if (!fix_history->firstflag[owner][jj]) return nullptr;
      const double *found = fix_history->firstvalue[owner] + size_history * jj;
      if (!swap) return found;
      exchange(found, buffer);
      return buffer;
    }
  }
  return nullptr;
}

/* ---------------------------------------------------------------------- */

template <unsigned MASK>
Load PairLubcontact::single_effects(int i, int j, const PairGeometry &geometry, double &energy)
{
  using E = lubcontact::Effects<MASK>;
  const PairCoeffs &c = coeffs[atom->type[i]][atom->type[j]];
  double buffer[E::HISTORY_SIZE + 1];
  const double *history = find_history(i, j, buffer);
  if (!history) {
    lubcontact::first_history<E>(c, geometry, buffer);
    history = buffer;
  }
  const Load load = lubcontact::pair_load<E>(c, *film, geometry, history);
  energy = lubcontact::pair_energy<E>(c, geometry, load);
  return load;
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
      lubcontact::pair_geometry({xi[0], xi[1], xi[2]}, {xj[0], xj[1], xj[2]}, ri, rj, a);
  fforce = 0.0;
  for (int m = 0; m < SINGLE_EXTRA; m++) svector[m] = 0.0;
  svector[0] = svector[1] = geometry.un;
  if (geometry.un >= reach[itype][jtype] * a) return 0.0;

  double energy;
  const Load load = (this->*eval_single)(i, j, geometry, energy);
  const lubcontact::ShearSplit parts = lubcontact::split(load);
  const double shear = lubcontact::norm(load.shear);
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
                                       static_cast<double>(parts.state)};
  memcpy(svector, values, sizeof(values));
  fforce = (load.contact + load.film) / geometry.r;
  return energy;
}

/* ---------------------------------------------------------------------- */

double PairLubcontact::memory_usage()
{
  const double n = atom->ntypes + 1.0;
  return Pair::memory_usage() + n * n * (6 * sizeof(double) + sizeof(int) + sizeof(PairCoeffs));
}
