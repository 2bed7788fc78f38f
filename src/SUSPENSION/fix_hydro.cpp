/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_hydro.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_hydro_grid.h"
#include "fix_hydro_mean.h"
#include "force.h"
#include "hydro_tensors.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "spin_inertia.h"
#include "suspension_host.h"
#include "suspension_input.h"
#include "update.h"

#include <algorithm>
#include <string>

using namespace LAMMPS_NS;
using Hydro_NS::Vec3;
using Lubcontact_NS::get_vector;

namespace {

template <class L> std::unique_ptr<HydroLevel> make(LAMMPS *lmp, Fix *fix, int narg, char **arg)
{
  return std::make_unique<L>(lmp, fix, narg, arg);
}

struct Row {
  const char *name;
  std::unique_ptr<HydroLevel> (*make)(LAMMPS *, Fix *, int narg, char **arg);
};

constexpr Row LEVELS[] = {{"mean", make<HydroMean>}, {"grid", make<HydroGrid>}};

}    // namespace

/* ----------------------------------------------------------------------
   fix ID group hydro level keyword value ...
------------------------------------------------------------------------- */

static std::unique_ptr<HydroLevel> make_level(LAMMPS *lmp, Fix *fix, int narg, char **arg)
{
  std::string names;
  Suspension_NS::require_words(FLERR, lmp->error, "fix hydro", narg + 1,
                               "fix ID group hydro level ...");
  for (const Row &row : LEVELS) {
    if (row.name == std::string(arg[3])) return row.make(lmp, fix, narg, arg);
    names += (names.empty() ? "" : " or ") + std::string(row.name);
  }
  lmp->error->all(FLERR, 3, "Fix hydro level must be {}, but is {}", names, arg[3]);
  return nullptr;
}

/* ---------------------------------------------------------------------- */

FixHydro::FixHydro(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), level(make_level(lmp, this, narg, arg)),
    words(utils::join_words(std::vector<std::string>(arg + 3, arg + narg), " ")),
    inertia(new SpinInertia()), force_of_atom(nullptr), work(0.0), total{}, dragged(0.0),
    massless(0), step_power(0.0), stepped(false)
{
  vector_flag = 1;
  size_vector = Output::NUM;
  extvector = 0;
  global_freq = 1;
  peratom_flag = 1;
  size_peratom_cols = 6;
  peratom_freq = 1;
  dynamic_group_allow = 1;
  restart_global = restart_peratom = level->restarts();
  comm_forward = comm_reverse = level->comm_size();
  FixHydro::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  if (restart_peratom) atom->add_callback(Atom::RESTART);
  for (int i = 0; i < atom->nlocal; i++) FixHydro::set_arrays(i);
}

FixHydro::~FixHydro()
{
  atom->delete_callback(id, Atom::GROW);
  if (restart_peratom) atom->delete_callback(id, Atom::RESTART);
  memory->destroy(force_of_atom);
}

std::string FixHydro::settings_text() const
{
  std::string text;
  for (const std::string &word : utils::split_words(words))
    text += (text.empty() ? "" : " ") +
        (utils::strmatch(word, "^v_") ? level->background().value_of(word.substr(2)) : word);
  return text;
}

FixHydro *FixHydro::find(LAMMPS *lmp)
{
  const auto fixes = lmp->modify->get_fix_by_style("^hydro");
  return fixes.empty() ? nullptr : dynamic_cast<FixHydro *>(fixes.front());
}

int FixHydro::setmask()
{
  return FixConst::PRE_FORCE | FixConst::POST_FORCE;
}

void FixHydro::init()
{
  level->init();
  inertia->find(lmp);
  massless = Suspension_NS::groups_without_inertia(lmp);
}

void FixHydro::init_list(int /*id*/, NeighList *ptr)
{
  level->init_list(ptr);
}

/* ---------------------------------------------------------------------- */

// before others ask for stresslets
void FixHydro::setup_pre_force(int /*vflag*/)
{
  level->start();
}

void FixHydro::setup(int /*vflag*/)
{
  level->set_up();
  act(true);
  step_power = 0.0;
  stepped = false;
}

void FixHydro::post_force(int /*vflag*/)
{
  level->new_step();
  const double before = work;
  act(false);
  step_power = 0.5 * (before + work);
  stepped = true;
}

/* ----------------------------------------------------------------------
   velocities are those of the last half step, or of the full step in a set-up; see fluid_drag.h
------------------------------------------------------------------------- */

void FixHydro::act(bool full)
{
  const double dt = update->dt * force->ftm2v;
  work = 0.0;
  dragged = 0.0;
  std::fill_n(total, 6, 0.0);
  // damps what acts on v; the mean force of the fluid in this step. Without inertia it balances
  // all others, which move the particle in the next step
  auto damp = [&](bool moves, double coefficient, double mass, const Vec3 &v, const Vec3 &target,
                  const Vec3 &flow, double *f) {
    const Vec3 others = get_vector(f);
    if (!moves) {
      work += dot(others, v - flow);
      return -1.0 * others;
    }
    const auto step = Fluid_NS::drag_step(full, dt, mass, coefficient, others, v, target);
    Lubcontact_NS::put_vector(step.force, f);
    work -= dot(step.force - others, step.v_full - flow);
    return step.force - others;
  };
  forget_forces(full || neighbor->ago == 0);
  HydroLevel::Pull p;
  for (const int i : level->dragged()) {
    if (!level->pull(i, p)) continue;
    const bool moves = !(atom->mask[i] & massless);
    const Vec3 f = damp(moves, p.drag.translation, atom->rmass[i], get_vector(atom->v[i]),
                        p.target.velocity, p.flow.velocity, atom->f[i]);
    const Vec3 t = damp(moves, p.drag.rotation, inertia->of(atom, i), get_vector(atom->omega[i]),
                        p.target.spin, p.flow.spin, atom->torque[i]);
    Lubcontact_NS::add_vector(f, total);
    Lubcontact_NS::add_vector(t, total + 3);
    Lubcontact_NS::put_vector(f, force_of_atom[i]);
    Lubcontact_NS::put_vector(t, force_of_atom[i] + 3);
    dragged += 1.0;
  }
  had_force = level->dragged();
}

/* ----------------------------------------------------------------------
   of all particles, or those that had one while none of them changed its place
------------------------------------------------------------------------- */

void FixHydro::forget_forces(bool all)
{
  if (!all)
    for (const int i : had_force) std::fill_n(force_of_atom[i], 6, 0.0);
  else if (atom->nlocal > 0)
    std::fill_n(*force_of_atom, 6 * atom->nlocal, 0.0);
}

// xx yy zz xy xz yz yx zx zy
static std::array<double, 9> components(const double *five)
{
  const Hydro_NS::Tensor s = Hydro_NS::get_strain(five);
  return {s.x.x, s.y.y, s.z.z, s.x.y, s.x.z, s.y.z, s.x.y, s.x.z, s.y.z};
}

/* ----------------------------------------------------------------------
   the stress is -S/V, tension positive, in the order xx yy zz xy xz yz
------------------------------------------------------------------------- */

double FixHydro::compute_vector(int n)
{
  if (n == Output::ITERATIONS) return level->iterations();
  if (n == Output::RESIDUAL) return level->residual();
  if (n == Output::SOLUTIONS) return level->solutions();
  if (n == Output::PHI) return level->phi();
  if (n == Output::DRAGGED) return sum_of_ranks(dragged);
  if (n == Output::HEAT) return sum_of_ranks(work + level->stresslet_heat());
  if (n >= Output::FORCE) return sum_of_ranks(total[n - Output::FORCE]);
  double mine[5], all[5];
  level->sum_stresslets(mine);
  MPI_Allreduce(mine, all, 5, MPI_DOUBLE, MPI_SUM, world);
  return -force->nktv2p * components(all)[n - Output::STRESS] / Suspension_NS::cell_volume(domain);
}

double FixHydro::sum_of_ranks(double mine) const
{
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixHydro::add_stresslets(double *nine) const
{
  double sum[5];
  level->sum_stresslets(sum);
  const auto parts = components(sum);
  for (int n = 0; n < 9; n++) nine[n] += parts[n];
}

std::vector<std::array<double, 9>> FixHydro::stresslets() const
{
  std::vector<std::array<double, 9>> of_atom(atom->nlocal);
  double s[5];
  for (int i = 0; i < atom->nlocal; i++) {
    of_atom[i].fill(0.0);
    if (!(atom->mask[i] & groupbit)) continue;
    level->stresslet(i, s);
    of_atom[i] = components(s);
  }
  return of_atom;
}

double FixHydro::stresslet_power() const
{
  double e[5], five[5], sum = 0.0;
  level->find_strain(e);
  level->sum_stresslets(five);
  for (int k = 0; k < 5; k++) sum -= five[k] * e[k];
  return sum;
}

double FixHydro::force_of_fluid(int d)
{
  return sum_of_ranks(total[d]);
}

double FixHydro::torque(int d)
{
  return sum_of_ranks(total[3 + d]);
}

double FixHydro::mean_power()
{
  return stepped ? sum_of_ranks(step_power + level->mean_stresslet_heat()) : 0.0;
}

double FixHydro::memory_usage()
{
  return level->memory_usage() + 6.0 * atom->nmax * sizeof(double);
}
