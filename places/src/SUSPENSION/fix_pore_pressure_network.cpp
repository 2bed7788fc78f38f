/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_pore_pressure_network.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_pore_pressure_settings.h"
#include "suspension_host.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using Lubcontact_NS::Vec3;
using Pore_NS::Link;

static constexpr int MOST_ITERATIONS = 5000;

const char *const PoreNetwork::NO_LIBRARY =
    "needs the library Voro++, without which this SUSPENSION was built: install it (Debian: "
    "voro++-dev) and build again, or use solver grid";

/* ---------------------------------------------------------------------- */

PoreNetwork::PoreNetwork(LAMMPS *lmp) :
    PoreSolver(lmp), tessellation(lmp, "Fix pore/pressure solver network"),
    alpha(0.0), box{}, edges{}, solid(0.0), flips(false), attempt(0), is_known(false),
    mean_velocity(0.0), has_plates(false), drains{}
{
}

void PoreNetwork::init()
{
  tessellation.request_ghosts(Suspension_NS::measure_particles(lmp).largest);
}

int PoreNetwork::prepare(const PoreSettings &settings, const std::array<double, 3> &, double)
{
  alpha = settings.alpha;
  has_plates = !settings.plates.empty();
  drains[0] = settings.lower == Pore_NS::Wall::DRAINED;
  drains[1] = settings.upper == Pore_NS::Wall::DRAINED;
  return 1;
}

/* ----------------------------------------------------------------------
   what this rank does of so many rows
------------------------------------------------------------------------- */

std::pair<int, int> PoreNetwork::share(std::size_t number) const
{
  const auto part = [this, number](int rank) {
    return static_cast<int>(number * rank / comm->nprocs);
  };
  return {part(comm->me), part(comm->me + 1)};
}

void PoreNetwork::gather_rows(double *rows, std::size_t number, int width) const
{
  if (comm->nprocs == 1) return;
  std::vector<int> counts(comm->nprocs), starts(comm->nprocs + 1, 0);
  for (int rank = 0; rank < comm->nprocs; rank++) {
    starts[rank + 1] = width * static_cast<int>(number * (rank + 1) / comm->nprocs);
    counts[rank] = starts[rank + 1] - starts[rank];
  }
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, rows, counts.data(), starts.data(), MPI_DOUBLE,
                 world);
}

/* ---------------------------------------------------------------------- */

void PoreNetwork::deposit(const Pore_NS::Cell &cell, int groupbits, const Fluid &fluid,
                          const Plates &plates, bool /*anew*/)
{
  const Pore_NS::CellEdges before = edges;
  box = cell;
  edges = {{{cell.xprd, 0.0, 0.0}, {cell.xy, cell.yprd, 0.0}, {cell.xz, cell.yz, cell.zprd}}};
  gather_particles(groupbits, plates);
  if (!has_plates) follow_flip(before);
  nudge();
  if (has_changed()) triangulate();
  shape(fluid);
}

/* ----------------------------------------------------------------------
   volumes and throats at the present positions
------------------------------------------------------------------------- */

void PoreNetwork::shape(const Fluid &fluid)
{
  const std::size_t number = net.pores.size(), links = net.links.size();
  flow.shape.resize(number);
  centers.resize(number);
  for (std::size_t i = 0; i < number; i++) {
    flow.shape[i] = shape_of(net.pores[i], positive[i], x, edges);
    centers[i] = center_of(net.pores[i], nudged, radius, edges);
  }

  std::vector<double> throats(2 * links);    // conductance and permeability
  const auto [begin, end] = share(links);
  for (int n = begin; n < end; n++) {
    const Pore_NS::Throat t = throat_of(net, net.links[n], nudged, radius, edges, centers);
    throats[2 * n] = conductance_of(net, net.links[n], t, radius);
    throats[2 * n + 1] = throat_permeability(t);
  }
  gather_rows(throats.data(), links, 2);
  const double phi = solid / volume();
  const double factor = fluid.law.factor * (alpha > 0.0 ? alpha : Pore_NS::network_alpha(phi));
  flow.g.resize(links);
  seen.k_min = HUGE_VAL;
  seen.k_max = 0.0;
  for (std::size_t n = 0; n < links; n++) {
    flow.g[n] = factor / fluid.viscosity * throats[2 * n];
    seen.k_min = MIN(seen.k_min, factor * throats[2 * n + 1]);
    seen.k_max = MAX(seen.k_max, factor * throats[2 * n + 1]);
  }
  seen.outside = fluid;
  rises.resize(links);
  pull.assign(x.size(), Vec3());
  for (std::size_t n = 0; n < links; n++) {
    const Link &link = net.links[n];
    rises[n] = rise_of(link, centers, edges, fluid.gradient);
    const Vec3 third = (-rises[n] / 3.0) * area_of(flow, link);
    for (const Pore_NS::Corner &c : facet_opposite(net.pores[link.pore[0]], link.opposite[0]))
      pull[c.particle] = pull[c.particle] + third;
  }
  if (has_plates) shape_hull(fluid, factor);
  seen.explicit_step = network_explicit_step(net, flow, inverse_mass);
}

/* ----------------------------------------------------------------------
   velocities relative to the deforming cell, at the end of the step but for the pressure
------------------------------------------------------------------------- */

void PoreNetwork::advance(double dt, const Fluid &fluid, const Plates &plates)
{
  const double step = fluid.coupling == Coupling::IMPLICIT ? dt : 0.0;
  const Suspension_NS::CellFlow flow_of_cell(domain);
  const std::vector<double> velocities = gather(3, [this, step, &flow_of_cell](int i, double *v) {
    const auto cell = flow_of_cell.at(atom->x[i]);
    const double added = step * inverse_mass[index[i]];
    for (int d = 0; d < 3; d++) v[d] = atom->v[i][d] - cell[d] + added * atom->f[i][d];
  });
  std::vector<Vec3> v(x.size());
  for (std::size_t k = 0; k < x.size(); k++)
    v[k] = Lubcontact_NS::get_vector(&velocities[3 * k]) + (step * inverse_mass[k]) * pull[k];

  if (has_plates) {
    Vec3 push;
    for (std::size_t k = 0; k < x.size(); k++)
      if (body[k] == UPPER) push = push + pull[k];
    const Vec3 upper =
        plates.velocity + step * Vec3{plates.response.x * push.x, plates.response.y * push.y, 0.0};
    for (std::size_t k = 0; k < x.size(); k++)
      if (body[k] != FREE) v[k] = body[k] == UPPER ? upper : Vec3();
  }

  const double storage = fluid.storage / dt;
  std::vector<double> rhs(net.pores.size());
  for (std::size_t i = 0; i < rhs.size(); i++)
    rhs[i] = storage * flow.shape[i].volume * p[i] - growth(net, flow, v, static_cast<int>(i));
  for (std::size_t n = 0; n < net.links.size(); n++) {
    rhs[net.links[n].pore[0]] += flow.g[n] * rises[n];
    rhs[net.links[n].pore[1]] -= flow.g[n] * rises[n];
  }
  for (const Hull &facet : hull)
    rhs[facet.pore] += facet.conductance * (facet.plate == UPPER ? fluid.upper : fluid.lower);
  solve(step, storage, rhs, fluid.tolerance, plates);
  is_known = true;
}

/* ----------------------------------------------------------------------
   A p = rhs, from the pressure before; the mean over the cell is none, and that between closed
   plates, too, unless the fluid is stored
------------------------------------------------------------------------- */

void PoreNetwork::solve(double dt, double storage, const std::vector<double> &rhs, double tolerance,
                        const Plates &plates)
{
  const auto [first, last] = share(rhs.size());
  const auto [begin, end] = share(x.size());
  const int from = first, to = last, head = begin, tail = end;
  const Pore_NS::ImplicitMatrix a = implicit_matrix(net, flow, dt, storage, inverse_mass);
  std::vector<Vec3> acceleration(x.size());
  const bool moves = has_plates && (plates.response.x > 0.0 || plates.response.y > 0.0);
  auto apply = [&](const std::vector<double> &q, std::vector<double> &y) {
    if (dt > 0.0) {
      for (int k = head; k < tail; k++) acceleration[k] = acceleration_of(a, q, k);
      gather_rows(&acceleration[0].x, acceleration.size(), 3);
      if (moves) {
        const Vec3 push = on_upper(q);
        const Vec3 upper = {plates.response.x * push.x, plates.response.y * push.y, 0.0};
        for (std::size_t k = 0; k < x.size(); k++)
          if (body[k] == UPPER) acceleration[k] = upper;
      }
    }
    y.resize(q.size());
    for (int i = from; i < to; i++) y[i] = implicit_row(a, q, acceleration, i);
    gather_rows(y.data(), y.size(), 1);
  };
  auto precondition = [&](const std::vector<double> &r, std::vector<double> &z) {
    z.resize(r.size());
    for (std::size_t i = 0; i < r.size(); i++) z[i] = r[i] / a.rows[i].diagonal;
  };
  auto agree = [this](double value) {
    if (comm->nprocs > 1) MPI_Bcast(&value, 1, MPI_DOUBLE, 0, world);
    return value;
  };
  seen.convergence =
      Pore_NS::conjugate_gradients(apply, precondition, agree, rhs, tolerance, MOST_ITERATIONS, p);
  if (!has_plates || (!drains[0] && !drains[1] && !(storage > 0.0))) {
    const double mean = mean_pressure();
    for (double &value : p) value -= mean;
  }
  MPI_Bcast(p.data(), static_cast<int>(p.size()), MPI_DOUBLE, 0, world);    // to the last bit
}

/* ---------------------------------------------------------------------- */

void PoreNetwork::add_forces(const Fluid &fluid, const Plates &)
{
  pushed.assign(atom->nlocal, Vec3());
  double mine[3] = {};
  for (int i = 0; i < atom->nlocal; i++) {
    const int k = index[i];
    pushed[i] = pull[k] + pore_force(net, flow, p, k);
    Lubcontact_NS::add_vector(pushed[i], mine);
    if (fluid.coupling != Coupling::OFF) Lubcontact_NS::add_vector(pushed[i], atom->f[i]);
  }
  MPI_Allreduce(mine, seen.total, 3, MPI_DOUBLE, MPI_SUM, world);
  seen.given_mean = fluid.mean;
  seen.mean = seen.lower = seen.upper = (has_plates ? mean_pressure() : 0.0) + fluid.mean;
  if (has_plates) see_hull(fluid);
  seen.largest = 0.0;
  for (const double value : p) seen.largest = MAX(seen.largest, fabs(value + fluid.mean));
}

double PoreNetwork::mean_pressure() const
{
  double sum = 0.0, filled = 0.0;
  for (std::size_t i = 0; i < p.size(); i++) {
    sum += flow.shape[i].volume * p[i];
    filled += flow.shape[i].volume;
  }
  return sum / filled;
}

double PoreNetwork::dissipation() const
{
  if (net.pores.empty()) return 0.0;
  double power = network_dissipation(net, flow, p, rises);
  for (const Hull &facet : hull) {
    const double drop =
        p[facet.pore] - (facet.plate == UPPER ? seen.outside.upper : seen.outside.lower);
    power += facet.conductance * drop * drop;
  }
  return power;
}

/* ---------------------------------------------------------------------- */

std::vector<double> PoreNetwork::pressure_shares() const
{
  std::vector<double> shares(atom->nlocal, 0.0), all(p);
  if (static_cast<int>(index.size()) != atom->nlocal) return shares;
  for (double &of_pore : all) of_pore += seen.given_mean;
  for (int i = 0; i < atom->nlocal; i++) shares[i] = share_of(net, flow, all, index[i]);
  return shares;
}

/* ---------------------------------------------------------------------- */

void PoreNetwork::measure_flow(const Vec3 &)
{
  const Suspension_NS::CellFlow flow_of_cell(domain);
  double mine[2] = {}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    const double mass = Suspension_NS::particle_volume(domain, atom->radius[i]);
    mine[0] += mass * (atom->v[i][1] - flow_of_cell.at(atom->x[i])[1]);
    mine[1] += mass;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  mean_velocity = all[1] > 0.0 ? all[0] / all[1] : 0.0;
}

std::vector<PoreSolver::Layer> PoreNetwork::profile() const
{
  Layer cell = {box.origin.y + 0.5 * box.yprd, seen.mean, solid / volume(), mean_velocity, 0.0};
  for (std::size_t n = 0; n < net.links.size(); n++) {
    const Link &link = net.links[n];
    const double along = rise_of(link, centers, edges, {0.0, 1.0, 0.0});
    cell.q_y += flow.g[n] * (p[link.pore[0]] - p[link.pore[1]] - rises[n]) * along / volume();
  }
  return {cell};
}
