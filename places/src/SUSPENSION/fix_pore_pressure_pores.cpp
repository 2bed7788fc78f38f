/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Particles and pores of the network of fix pore/pressure: gathered on all ranks, found, kept, and
// written to restart files.

#include "fix_pore_pressure_network.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_pore_pressure_settings.h"
#include "force.h"
#include "suspension_host.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace LAMMPS_NS;
using Lubcontact_NS::Vec3;
using Pore_NS::Image;
using Pore_NS::Pore;

// Pores are kept while no two of their corners have come nearer to or farther from each other than
// this; over the mean radius.
static constexpr double KEEP = 0.01;

// Displacements that break ties, over the radius: more than the 1e-11 to which Voro++ decides.
static constexpr double NUDGE = 1e-6;
// Tetrahedra between plates whose power center is farther outside than this, over the radius of the
// outermost particle, are so flat that nothing is missing without them.
static constexpr double OUTSIDE = 1.0;

static constexpr int MOST_ATTEMPTS = 8;

static constexpr std::size_t NUMBERS_OF_PORE = 16 + 1 + 6 + 1;

// how many edges of the cell away d is; between plates none along y
Image PoreNetwork::nearest_image(const Pore_NS::CellEdges &cell, const Vec3 &d) const
{
  const double nz = std::round(d.z / cell.edge[2].z);
  const Vec3 flat = d - nz * cell.edge[2];
  const double ny = has_plates ? 0.0 : std::round(flat.y / cell.edge[1].y);
  const double nx = std::round((flat.x - ny * cell.edge[1].x) / cell.edge[0].x);
  return {static_cast<int>(nx), static_cast<int>(ny), static_cast<int>(nz)};
}

/* ----------------------------------------------------------------------
   values of all particles, in order
------------------------------------------------------------------------- */

static std::vector<double> gather_all(MPI_Comm world, int nprocs, const std::vector<double> &mine)
{
  std::vector<int> counts(nprocs), starts(nprocs + 1, 0);
  const int size = static_cast<int>(mine.size());
  MPI_Allgather(&size, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  std::partial_sum(counts.begin(), counts.end(), starts.begin() + 1);
  std::vector<double> all(starts[nprocs]);
  MPI_Allgatherv(mine.data(), size, MPI_DOUBLE, all.data(), counts.data(), starts.data(),
                 MPI_DOUBLE, world);
  return all;
}

std::vector<double>
PoreNetwork::gather(int width, const std::function<void(int i, double *values)> &pack) const
{
  const int stride = width + 1;
  std::vector<double> mine(static_cast<std::size_t>(atom->nlocal) * stride),
      values(x.size() * width);
  for (int i = 0; i < atom->nlocal; i++) {
    mine[i * stride] = index[i];
    pack(i, &mine[i * stride + 1]);
  }
  const std::vector<double> all = gather_all(world, comm->nprocs, mine);
  for (std::size_t n = 0; n < all.size(); n += stride)
    std::copy_n(&all[n + 1], width, &values[static_cast<std::size_t>(all[n]) * width]);
  return values;
}

/* ----------------------------------------------------------------------
   Others than before: their pores are new. Those that have passed through the cell go on outside.
------------------------------------------------------------------------- */

void PoreNetwork::gather_particles(int groupbits, const Plates &plates)
{
  static constexpr int STRIDE = 7;
  int apart = 0, all_apart;
  for (int i = 0; i < atom->nlocal; i++) apart += (atom->mask[i] & groupbits) == 0;
  MPI_Allreduce(&apart, &all_apart, 1, MPI_INT, MPI_SUM, world);
  if (all_apart)
    error->all(FLERR,
               "Fix pore/pressure solver network needs all particles as walls of its pores, but {} "
               "are not in its group: use group all, or solver grid",
               all_apart);

  std::vector<double> mine;
  for (int i = 0; i < atom->nlocal; i++) {
    const Body part = atom->mask[i] & plates.lower_bit ? LOWER
        : atom->mask[i] & plates.upper_bit             ? UPPER
                                                       : FREE;
    for (const double value :
         {static_cast<double>(atom->tag[i]), atom->x[i][0], atom->x[i][1], atom->x[i][2],
          atom->radius[i], force->ftm2v / atom->rmass[i], static_cast<double>(part)})
      mine.push_back(value);
  }
  const std::vector<double> all = gather_all(world, comm->nprocs, mine);
  const std::size_t number = all.size() / STRIDE;
  std::vector<std::size_t> order(number);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&all](std::size_t a, std::size_t b) {
    return all[a * STRIDE] < all[b * STRIDE];
  });
  std::vector<tagint> now(number);
  for (std::size_t k = 0; k < number; k++) now[k] = static_cast<tagint>(all[order[k] * STRIDE]);
  const bool same = now == tags;
  if (!same) {
    net = {};
    p.clear();
    is_known = false;
  }
  tags = now;
  x.resize(number);
  radius.resize(number);
  inverse_mass.resize(number);
  body.resize(number);
  solid = 0.0;
  for (std::size_t k = 0; k < number; k++) {
    const double *values = &all[order[k] * STRIDE];
    const Vec3 here = Lubcontact_NS::get_vector(values + 1);
    x[k] = same ? here + shift(edges, nearest_image(edges, x[k] - here)) : here;
    radius[k] = values[4];
    body[k] = static_cast<char>(values[6]);
    inverse_mass[k] = body[k] == FREE ? values[5] : 0.0;    // plates move as a whole
    if (body[k] == FREE) solid += Suspension_NS::particle_volume(domain, radius[k]);
  }
  index.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++)
    index[i] =
        static_cast<int>(std::lower_bound(tags.begin(), tags.end(), atom->tag[i]) - tags.begin());
}

/* ----------------------------------------------------------------------
   a cell whose tilt has jumped has other edges, but the same images of its particles
------------------------------------------------------------------------- */

void PoreNetwork::follow_flip(const Pore_NS::CellEdges &before)
{
  if (net.pores.empty()) return;
  Image turned[3];
  bool same = true;
  for (int d = 0; d < 3; d++) {
    turned[d] = nearest_image(edges, before.edge[d]);
    for (int e = 0; e < 3; e++) same = same && turned[d][e] == (d == e);
  }
  if (same) return;
  for (Pore &pore : net.pores)
    for (Pore_NS::Corner &c : pore) {
      Image image{};
      for (int d = 0; d < 3; d++)
        for (int e = 0; e < 3; e++) image[e] += c.image[d] * turned[d][e];
      c.image = image;
    }
  flips = true;
}

/* ---------------------------------------------------------------------- */

void PoreNetwork::nudge()
{
  nudged.resize(x.size());
  for (std::size_t k = 0; k < x.size(); k++)
    nudged[k] = x[k] + (NUDGE * radius[k]) * Pore_NS::hashed_direction(tags[k], attempt);
}

std::array<double, 6> PoreNetwork::distances_of(const Pore &pore) const
{
  const Pore_NS::Tetrahedron t = corners_of(pore, x, edges);
  return {norm(t[1] - t[0]), norm(t[2] - t[0]), norm(t[3] - t[0]),
          norm(t[2] - t[1]), norm(t[3] - t[1]), norm(t[3] - t[2])};
}

bool PoreNetwork::has_changed() const
{
  if (net.pores.empty() || flips) return true;
  const double mean =
      std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
  for (std::size_t i = 0; i < net.pores.size(); i++) {
    const auto now = distances_of(net.pores[i]);
    for (int n = 0; n < 6; n++)
      if (fabs(now[n] - distances[6 * i + n]) > KEEP * mean) return true;
  }
  return false;
}

/* ----------------------------------------------------------------------
   pores of the present positions, with the pressures of those before
------------------------------------------------------------------------- */

void PoreNetwork::triangulate()
{
  struct Before {
    Pore pore;
    double volume, p;
  };
  std::vector<Before> before;
  for (std::size_t i = 0; i < net.pores.size(); i++)
    before.push_back({Pore_NS::canonical(net.pores[i]),
                      fabs(shape_of(net.pores[i], 1.0, x, edges).volume), p[i]});
  std::sort(before.begin(), before.end(), [](const Before &a, const Before &b) {
    return a.pore < b.pore;
  });

  for (int n = 0; !find_pores(); n++) {
    if (n == MOST_ATTEMPTS)
      error->all(FLERR,
                 "Fix pore/pressure solver network cannot divide the cell into pores: particles "
                 "that overlap by more than a radius, or a cell of less than 4 diameters; use: "
                 "solver grid");
    attempt++;
    nudge();
  }
  flips = false;

  const std::size_t number = net.pores.size();
  positive.resize(number);
  distances.resize(6 * number);
  std::vector<Pore> old;
  std::vector<double> old_volume, old_p, volume_now(number);
  for (std::size_t i = 0; i < number; i++) {
    positive[i] = std::copysign(1.0, shape_of(net.pores[i], 1.0, nudged, edges).volume);
    volume_now[i] = fabs(shape_of(net.pores[i], 1.0, x, edges).volume);
    const auto now = distances_of(net.pores[i]);
    std::copy(now.begin(), now.end(), &distances[6 * i]);
  }
  for (const Before &one : before) {
    old.push_back(one.pore);
    old_volume.push_back(one.volume);
    old_p.push_back(one.p);
  }
  p = carry_over(old, old_volume, old_p, net.pores, volume_now);
}

/* ----------------------------------------------------------------------
   Each rank finds those whose corner with the lowest tag it owns. True if they fill the cell, and
   if the cells of all four corners have found each of them.
------------------------------------------------------------------------- */

bool PoreNetwork::find_pores()
{
  const int nall = atom->nlocal + atom->nghost;
  RadicalTessellation::Displaced displaced = {std::vector<Vec3>(nall), HUGE_VAL, -HUGE_VAL};
  for (std::size_t k = 0; k < x.size(); k++) {
    displaced.lowest = std::fmin(displaced.lowest, x[k].y - OUTSIDE * radius[k]);
    displaced.highest = std::fmax(displaced.highest, x[k].y + OUTSIDE * radius[k]);
  }
  std::vector<Pore_NS::Corner> corner(nall);
  for (int j = 0; j < nall; j++) {
    const auto found = std::lower_bound(tags.begin(), tags.end(), atom->tag[j]);
    const int k = static_cast<int>(found - tags.begin());
    displaced.by[j] = nudged[k] - x[k];
    corner[j] = {k, nearest_image(edges, Lubcontact_NS::get_vector(atom->x[j]) - x[k])};
  }

  std::vector<double> mine;
  std::vector<std::array<int, 3>> vertices;
  double counts[2] = {}, all_counts[2];    // pores of all cells; ties
  tessellation.each_cell(
      [&](const RadicalTessellation::Cell &cell) {
        if (!cell.get_vertices(vertices)) counts[1] += 1.0;
        for (const auto &others : vertices) {
          if (*std::min_element(others.begin(), others.end()) < 0) continue;
          counts[0] += 1.0;
          const Pore pore = Pore_NS::canonical(
              Pore{corner[cell.owner], corner[others[0]], corner[others[1]], corner[others[2]]});
          if (pore[0].particle != corner[cell.owner].particle) continue;
          for (const Pore_NS::Corner &c : pore) {
            mine.push_back(c.particle);
            mine.insert(mine.end(), c.image.begin(), c.image.end());
          }
        }
      },
      &displaced);
  MPI_Allreduce(counts, all_counts, 2, MPI_DOUBLE, MPI_SUM, world);
  const std::vector<double> all = gather_all(world, comm->nprocs, mine);
  std::vector<Pore> pores(all.size() / 16);
  for (std::size_t n = 0; n < all.size(); n += 4) {
    Pore_NS::Corner &c = pores[n / 16][n % 16 / 4];
    c.particle = static_cast<int>(all[n]);
    for (int d = 0; d < 3; d++) c.image[d] = static_cast<int>(all[n + 1 + d]);
  }
  std::sort(pores.begin(), pores.end());    // twice: those with two images of one particle
  pores.erase(std::unique(pores.begin(), pores.end()), pores.end());

  const double found = 4.0 * static_cast<double>(pores.size());
  const int open = connect(pores, static_cast<int>(x.size()), net);
  if (all_counts[0] != found || all_counts[1] > 0.0) return false;
  if (has_plates) return open > 0;
  if (open > 0) return false;
  double filled = 0.0;
  for (const Pore &pore : net.pores) filled += fabs(shape_of(pore, 1.0, nudged, edges).volume);
  static constexpr double ROUNDING = 1e-9;
  return fabs(filled - volume()) < ROUNDING * volume();
}

/* ----------------------------------------------------------------------
   numbers of particles and pores, the attempt and the cell; then the particles, and the pores
------------------------------------------------------------------------- */

PoreSolver::State PoreNetwork::state() const
{
  State s;
  if (!is_known) return s;
  s.head = {-1.0, static_cast<double>(x.size()), static_cast<double>(net.pores.size()),
            static_cast<double>(attempt)};
  for (const Vec3 &edge : edges.edge)
    for (const double value : {edge.x, edge.y, edge.z}) s.values.push_back(value);
  for (std::size_t k = 0; k < x.size(); k++)
    for (const double value : {static_cast<double>(tags[k]), x[k].x, x[k].y, x[k].z})
      s.values.push_back(value);
  for (std::size_t i = 0; i < net.pores.size(); i++) {
    for (const Pore_NS::Corner &c : net.pores[i]) {
      s.values.push_back(c.particle);
      s.values.insert(s.values.end(), c.image.begin(), c.image.end());
    }
    s.values.push_back(positive[i]);
    s.values.insert(s.values.end(), &distances[6 * i], &distances[6 * i] + 6);
    s.values.push_back(p[i]);
  }
  return s;
}

void PoreNetwork::restore(const State &s, const PoreSettings &settings)
{
  if (s.head[0] != -1.0) return;    // of a grid
  const auto particles = static_cast<std::size_t>(s.head[1]),
             pores = static_cast<std::size_t>(s.head[2]);
  if (s.values.size() != 9 + 4 * particles + NUMBERS_OF_PORE * pores) return;
  attempt = static_cast<std::uint64_t>(s.head[3]);
  const double *value = s.values.data();
  for (Vec3 &edge : edges.edge) {
    edge = Lubcontact_NS::get_vector(value);
    value += 3;
  }
  tags.resize(particles);
  x.resize(particles);
  for (std::size_t k = 0; k < particles; k++, value += 4) {
    tags[k] = static_cast<tagint>(value[0]);
    x[k] = Lubcontact_NS::get_vector(value + 1);
  }
  std::vector<Pore> saved(pores);
  positive.resize(pores);
  distances.resize(6 * pores);
  p.resize(pores);
  for (std::size_t i = 0; i < pores; i++) {
    for (Pore_NS::Corner &c : saved[i]) {
      c.particle = static_cast<int>(*value++);
      for (int &n : c.image) n = static_cast<int>(*value++);
    }
    positive[i] = *value++;
    std::copy_n(value, 6, &distances[6 * i]);
    p[i] = value[6];
    value += 7;
  }
  const int open = connect(saved, static_cast<int>(particles), net);
  is_known = settings.plates.empty() ? open == 0 : open > 0;
}

/* ---------------------------------------------------------------------- */

double PoreNetwork::memory_usage() const
{
  static constexpr std::size_t NUMBERS_OF_PARTICLE = 40;
  return static_cast<double>(net.pores.size() *
                                 (sizeof(Pore) + sizeof(Pore_NS::PoreShape) + sizeof(Vec3) +
                                  4 * sizeof(int) + 4 * sizeof(Pore_NS::Network::Place) +
                                  20 * sizeof(double)) +
                             net.links.size() * (sizeof(Pore_NS::Link) + 2 * sizeof(double)) +
                             x.size() * NUMBERS_OF_PARTICLE * sizeof(double));
}
