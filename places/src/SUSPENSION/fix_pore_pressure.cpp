/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_pore_pressure.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_pore_pressure_settings.h"
#include "fix_rheometer_plates.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "restart_seal.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace LAMMPS_NS;
using Pore_NS::Wall;

/* ---------------------------------------------------------------------- */

FixPorePressure::FixPorePressure(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), settings(new PoreSettings()), plates(nullptr), dilation(nullptr),
    force_of_atom(nullptr), work(0.0), tilt{}, evaluated(false), warned(false), of_cell(0.0),
    resistance(0.0), even_k(0.0)
{
  parse(narg, arg);
  scalar_flag = 0;
  vector_flag = 1;
  size_vector = Output::NUM;
  array_flag = 1;
  size_array_rows = MAX(settings->elements[1], 1);
  size_array_rows_variable = settings->elements[1] == 0 && !settings->network;
  size_array_cols = Output::NUM_COLUMNS;
  extvector = extarray = 0;
  peratom_flag = 1;
  size_peratom_cols = 3;
  peratom_freq = 1;
  global_freq = 1;
  restart_global = 1;
  FixPorePressure::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  for (int i = 0; i < atom->nlocal; i++) FixPorePressure::set_arrays(i);
}

FixPorePressure::~FixPorePressure()
{
  atom->delete_callback(id, Atom::GROW);
  memory->destroy(force_of_atom);
}

FixPorePressure *FixPorePressure::find(LAMMPS *lmp)
{
  const auto fixes = lmp->modify->get_fix_by_style("^pore/pressure");
  return fixes.empty() ? nullptr : dynamic_cast<FixPorePressure *>(fixes.front());
}

int FixPorePressure::setmask()
{
  return FixConst::POST_FORCE;
}

/* ----------------------------------------------------------------------
   cell and fluid of this step
------------------------------------------------------------------------- */

struct FixPorePressure::Now {
  Pore_NS::Cell cell;
  PoreSolver::Fluid fluid;
  PoreSolver::Plates plates;
  int bits;
};

FixPorePressure::Now FixPorePressure::now(double dt)
{
  const PoreSettings &s = *settings;
  const double viscosity = evaluate();
  Now n{};
  const double *lo = domain->boxlo;
  const bool flat = domain->dimension == 2;
  n.cell = {{lo[0], lo[1], flat ? 0.0 : lo[2]},
            domain->xprd,
            domain->yprd,
            flat ? 1.0 : domain->zprd,
            domain->xy,
            flat ? 0.0 : domain->xz,
            flat ? 0.0 : domain->yz};
  n.bits = groupbit;
  if (plates) {
    double bottom, top;
    plates->measure_surfaces(bottom, top);
    n.cell.origin.y = bottom;
    n.cell.yprd = top - bottom;
    n.bits |= plates->plate_bits();
    add_plates(n, dt);
  }
  const double unit = 1.0 / force->nktv2p;    // LAMMPS' pressure to force/area
  n.fluid.viscosity = viscosity;
  n.fluid.storage = s.storage / unit;
  n.fluid.law = s.law;
  n.fluid.coupling = s.coupling;
  n.fluid.iterate = s.iterate;
  n.fluid.tolerance = s.tolerance;
  n.fluid.lower = n.fluid.upper = s.drained.value * unit;
  n.fluid.gradient = {s.gradient[0].value * unit, s.gradient[1].value * unit,
                      s.gradient[2].value * unit};
  return n;
}

/* ----------------------------------------------------------------------
   the upper one after a step in which all forces but those of the pressure act
------------------------------------------------------------------------- */

void FixPorePressure::add_plates(Now &n, double dt) const
{
  PoreSolver::Plates &p = n.plates;
  p.lower_bit = plates->plate_bit(0);
  p.upper_bit = plates->plate_bit(1);
  p.push_lower = settings->lower == Wall::IMPERMEABLE;
  p.push_upper = settings->upper == Wall::IMPERMEABLE;
  double mine[3] = {}, all[3];    // force along x and y, mass
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & p.upper_bit) {
      mine[0] += atom->f[i][0];
      mine[1] += atom->f[i][1];
      mine[2] += atom->rmass[i];
    }
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_SUM, world);
  p.mass = all[2];
  const bool moves = settings->coupling == PoreSolver::Coupling::IMPLICIT;
  if (moves) p.response = {plates->response(0, p.mass, dt), plates->response(1, p.mass, dt), 0.0};
  p.velocity = {moves ? plates->velocity_after(0, all[0], p.mass, dt) : plates->velocity(),
                moves ? plates->velocity_after(1, all[1], p.mass, dt) : plates->opening(), 0.0};
}

void FixPorePressure::prepare()
{
  auto heights = Suspension_NS::cell_heights(domain);
  if (plates) {
    double bottom, top;
    plates->measure_surfaces(bottom, top);
    heights[1] = top - bottom;
  }
  size_array_rows = field->prepare(*settings, heights, mean_diameter());
}

/* ----------------------------------------------------------------------
   A pressure that is known, from a restart file or the last run, has made the forces of this
   moment. The first one is that of half a step: velocities are those of the same moment as
   positions.
------------------------------------------------------------------------- */

void FixPorePressure::setup(int /*vflag*/)
{
  if (settings->even) return follow_layer(true);
  prepare();
  has_flipped();
  if (plates) plates->evaluate_targets();
  const double half = 0.5 * update->dt;
  Now n = now(half);
  n.fluid.mean = next_mean(n.fluid.storage, field->has_pressure());
  field->deposit(n.cell, n.bits, n.fluid, n.plates, true);
  if (!field->has_pressure()) field->advance(half, n.fluid, n.plates);
  field->add_forces(n.fluid, n.plates);
  keep_forces();
}

/* ----------------------------------------------------------------------
   Weights are made anew every so many steps since the neighbor lists were, which is done when a
   restart file is written, too: the run that continues it is then the same.
------------------------------------------------------------------------- */

void FixPorePressure::post_force(int /*vflag*/)
{
  if (settings->even) return follow_layer(false);
  Now n = now(update->dt);
  n.fluid.mean = next_mean(n.fluid.storage, false);
  if (has_flipped()) field->flipped();
  field->deposit(n.cell, n.bits, n.fluid, n.plates, neighbor->ago % settings->every == 0);
  field->advance(update->dt, n.fluid, n.plates);
  field->add_forces(n.fluid, n.plates);
  warn_of_lag();
  measure_work();
  keep_forces();
}

/* ----------------------------------------------------------------------
   since the last call
------------------------------------------------------------------------- */

bool FixPorePressure::has_flipped()
{
  const double now[3] = {domain->xy, domain->xz, domain->yz};
  const double edge[3] = {domain->xprd, domain->xprd, domain->yprd};
  bool jump = false;
  for (int d = 0; d < 3; d++) {
    if (fabs(now[d] - tilt[d]) > 0.5 * edge[d]) jump = true;
    tilt[d] = now[d];
  }
  return jump;
}

/* ----------------------------------------------------------------------
   the velocity is that of the last step, the work that of the mean force
------------------------------------------------------------------------- */

void FixPorePressure::measure_work()
{
  const auto &forces = field->forces();
  const Suspension_NS::CellFlow cell(domain);
  work = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const auto flow = cell.at(atom->x[i]);
    const double f[3] = {forces[i].x, forces[i].y, forces[i].z};
    for (int d = 0; d < 3; d++)
      work += 0.5 * (force_of_atom[i][d] + f[d]) * (atom->v[i][d] - flow[d]);
  }
}

void FixPorePressure::keep_forces()
{
  const auto &forces = field->forces();
  for (int i = 0; i < atom->nlocal; i++) {
    force_of_atom[i][0] = forces[i].x;
    force_of_atom[i][1] = forces[i].y;
    force_of_atom[i][2] = forces[i].z;
  }
}

void FixPorePressure::grow_arrays(int nmax)
{
  memory->grow(force_of_atom, nmax, 3, "pore/pressure:force");
  array_atom = force_of_atom;
}

void FixPorePressure::copy_arrays(int i, int j, int /*delflag*/)
{
  std::copy_n(force_of_atom[i], 3, force_of_atom[j]);
}

void FixPorePressure::set_arrays(int i)
{
  std::fill_n(force_of_atom[i], 3, 0.0);
}

int FixPorePressure::pack_exchange(int i, double *buf)
{
  std::copy_n(force_of_atom[i], 3, buf);
  return 3;
}

int FixPorePressure::unpack_exchange(int nlocal, double *buf)
{
  std::copy_n(buf, 3, force_of_atom[nlocal]);
  return 3;
}

/* ---------------------------------------------------------------------- */

double FixPorePressure::compute_vector(int n)
{
  if (settings->even) return layer_output(n);
  if (n == Output::LOWER_FLUX || n == Output::UPPER_FLUX) measure_flow();
  const PoreSolver::Report &r = field->report();
  const double unit = force->nktv2p;
  switch (n) {
    case Output::LOWER:
      return r.lower * unit;
    case Output::UPPER:
      return r.upper * unit;
    case Output::MEAN:
      return r.mean * unit;
    case Output::LARGEST:
      return r.largest * unit;
    case Output::LOWER_FLUX:
      return r.flux.lower / field->wall_area();
    case Output::UPPER_FLUX:
      return r.flux.upper / field->wall_area();
    case Output::DISSIPATION:
      return (field->dissipation() / field->volume() + layer_heat()) * unit;
    case Output::FX:
    case Output::FY:
    case Output::FZ:
      return r.total[n - Output::FX];
    case Output::ITERATIONS:
      return r.convergence.iterations;
    case Output::RESIDUAL:
      return r.convergence.residual;
    case Output::K_MIN:
      return r.k_min;
    case Output::K_MAX:
      return r.k_max;
    case Output::POWER:
      return acts() ? mean_power() : 0.0;
    default:
      return r.explicit_step > 0.0 ? update->dt / r.explicit_step : 0.0;
  }
}

double FixPorePressure::compute_array(int i, int j)
{
  if (settings->even) return i == 0 ? layer_profile(j) : 0.0;
  measure_flow();
  const auto layers = field->profile();
  if (i >= static_cast<int>(layers.size())) return 0.0;
  const double unit = force->nktv2p;
  const double values[] = {layers[i].y, layers[i].p * unit, layers[i].phi, layers[i].u_y,
                           layers[i].q_y};
  return values[j];
}

void FixPorePressure::measure_flow()
{
  field->measure_flow(plates ? Lubcontact_NS::Vec3{plates->velocity(), plates->opening(), 0.0}
                             : Lubcontact_NS::Vec3());
}

bool FixPorePressure::acts() const
{
  return settings->coupling != PoreSolver::Coupling::OFF;
}

double FixPorePressure::memory_usage()
{
  return field->memory_usage() + 3.0 * atom->nmax * sizeof(double);
}

/* ----------------------------------------------------------------------
   a head with its seal, which says how much follows; the pressure, and its seal
------------------------------------------------------------------------- */

static constexpr std::size_t HEAD = 1 + PoreSolver::State::HEAD + 4;

static double seal_of(const double *values, std::size_t number)
{
  return Suspension_NS::seal(values, number * sizeof(double));
}

void FixPorePressure::write_restart(FILE *fp)
{
  if (comm->me) return;
  const PoreSolver::State state = field->state();
  const std::vector<double> &p = state.values;
  std::vector<double> record = {static_cast<double>(p.size())};
  record.insert(record.end(), state.head.begin(), state.head.end());
  for (const double value : {mean.pressure, mean.cell, mean.volume, mean.squares})
    record.push_back(value);
  record.push_back(seal_of(record.data(), HEAD));
  record.insert(record.end(), p.begin(), p.end());
  record.push_back(seal_of(p.data(), p.size()));
  const int size = static_cast<int>(record.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(record.data(), sizeof(double), record.size(), fp);
}

void FixPorePressure::restart(char *buffer)
{
  const auto *head = reinterpret_cast<const double *>(buffer), *p = head + HEAD + 1;
  const bool sealed = seal_of(head, HEAD) == head[HEAD];
  const std::size_t number = sealed ? static_cast<std::size_t>(head[0]) : 0;
  if (!sealed || seal_of(p, number) != p[number])
    error->all(FLERR,
               "The part of fix pore/pressure in the restart file is damaged: use another one");
  PoreSolver::State state;
  std::copy_n(head + 1, PoreSolver::State::HEAD, state.head.begin());
  state.values.assign(p, p + number);
  const double *rest = head + 1 + PoreSolver::State::HEAD;
  mean = {rest[0], rest[1], rest[2], rest[3]};
  field->restore(state, *settings);
}
