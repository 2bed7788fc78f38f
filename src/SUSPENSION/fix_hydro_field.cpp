/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_hydro_field.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "neigh_list.h"

#ifdef SUSPENSION_FFTW
#include "hydro_solve.h"
#endif

#include <algorithm>
#include <climits>
#include <cmath>
#include <numeric>

using namespace LAMMPS_NS;
using namespace Hydro_NS;

#ifdef SUSPENSION_FFTW
struct LAMMPS_NS::HydroTransforms {
  HydroTransforms(const Points &points, int rank, int ranks) : solver(points, rank, ranks) {}
  StokesSolver solver;
};
#else
struct LAMMPS_NS::HydroTransforms {};
#endif

const char *const HydroField::NO_LIBRARY =
    "needs the library FFTW, without which this SUSPENSION was built: install it (Debian: "
    "libfftw3-dev) and build again";

/* ---------------------------------------------------------------------- */

HydroField::HydroField(LAMMPS *lmp, Fix *owner) :
    Pointers(lmp), fix(owner), width(1.0), eta(1.0), grid{}
{
}

HydroField::~HydroField() = default;

bool HydroField::has_library()
{
#ifdef SUSPENSION_FFTW
  return true;
#else
  return false;
#endif
}

/* ---------------------------------------------------------------------- */

void HydroField::prepare(const Settings &settings, int groupbit, double mean_radius,
                         double viscosity, NeighList *list)
{
  width = settings.width * mean_radius;
  eta = viscosity;
  make_grid(settings);
  find_members(groupbit);
  find_brick();
  find_pairs(settings.reach * width, groupbit, list);
}

/* ----------------------------------------------------------------------
   Waves are resolved alike in all directions if the points are as close along the edges of the
   cell. A cell that flips is leaned by half of its width at most: a number of points for that
   stays the same while it shears.
------------------------------------------------------------------------- */

void HydroField::make_grid([[maybe_unused]] const Settings &settings)
{
  const double *lo = domain->boxlo, h = settings.spacing * width;
  lattice.cell = {{lo[0], lo[1], lo[2]},
                  domain->xprd,
                  domain->yprd,
                  domain->zprd,
                  domain->xy,
                  domain->xz,
                  domain->yz};
  const double lean = domain->triclinic ? MAX(fabs(domain->xy), 0.5 * domain->xprd) : 0.0;
  const double edges[3] = {
      domain->xprd, std::hypot(domain->yprd, lean),
      std::sqrt(domain->zprd * domain->zprd + domain->xz * domain->xz + domain->yz * domain->yz)};
  Points points;
  for (int d = 0; d < 3; d++) points[d] = good_number(edges[d] / h);
  lattice.nx = points[0];
  lattice.ny = points[1];
  lattice.nz = points[2];
  lattice.width = width;
  lattice.reach = settings.support * width;
  if (transforms && points == grid) return;
  grid = points;
#ifdef SUSPENSION_FFTW
  transforms.reset();    // first, for its memory
  transforms = std::make_unique<HydroTransforms>(points, comm->me, comm->nprocs);
#endif
}

/* ---------------------------------------------------------------------- */

void HydroField::find_members(int groupbit)
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  members.clear();
  bodies.resize(nall);
  of_sphere.assign(nlocal, Self{});
  missing.assign(nlocal, Self{});
  for (int i = 0; i < nall; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    bodies[i] = make_body(atom->radius[i], width);
    if (i >= nlocal) continue;
    members.push_back(i);
    of_sphere[i] = sphere_self(atom->radius[i], eta);
    missing[i] = of_sphere[i] - wide_self(bodies[i], width, eta);
  }
  load.assign(static_cast<std::size_t>(nall) * NUMBERS, 0.0);
  motion.assign(load.size(), 0.0);
}

/* ----------------------------------------------------------------------
   the list has pairs within its skin, too
------------------------------------------------------------------------- */

void HydroField::find_pairs(double cut, int groupbit, NeighList *list)
{
  const double *const *x = atom->x;
  const int *mask = atom->mask;
  pairs.clear();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    if (!(mask[i] & groupbit)) continue;
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      if (!(mask[j] & groupbit)) continue;
      const Vec3 d = Lubcontact_NS::get_vector(x[i]) - Lubcontact_NS::get_vector(x[j]);
      if (dot(d, d) < cut * cut)
        pairs.push_back({i, j, missing_response(d, bodies[i], bodies[j], width)});
    }
  }
}

/* ----------------------------------------------------------------------
   of all ranks, and how much they exchange
------------------------------------------------------------------------- */

void HydroField::find_brick()
{
  Brick mine;
  if (!members.empty()) {
    Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = -1.0 * low;
    for (const int i : members) {
      const Vec3 g = lattice_place(lattice, Lubcontact_NS::get_vector(atom->x[i]));
      low = {MIN(low.x, g.x), MIN(low.y, g.y), MIN(low.z, g.z)};
      high = {MAX(high.x, g.x), MAX(high.y, g.y), MAX(high.z, g.z)};
    }
    mine = brick_for(lattice, low, high);
  }
  const int ranks = comm->nprocs;
  bricks.resize(ranks);
  static_assert(sizeof(Brick) == 6 * sizeof(int), "exchanged as integers");
  MPI_Allgather(&mine, 6, MPI_INT, bricks.data(), 6, MPI_INT, world);

  const Share layers = share(grid[2], comm->me, ranks);
  sent.assign(ranks, 0);
  received.assign(ranks, 0);
  std::size_t out_size = 0, in_size = 0;
  for (int r = 0; r < ranks; r++) {
    const std::size_t there = numbers_in(mine, grid, share(grid[2], r, ranks));
    const std::size_t here = numbers_in(bricks[r], grid, layers);
    out_size += there;
    in_size += here;
    sent[r] = static_cast<int>(there);
    received[r] = static_cast<int>(here);
  }
  if (out_size > INT_MAX || in_size > INT_MAX)
    error->one(FLERR, "Fix hydro: a rank has {} points of the grid, too many: use more ranks",
               mine.points());
  sent_from.assign(ranks, 0);
  received_from.assign(ranks, 0);
  std::partial_sum(sent.begin(), sent.end() - 1, sent_from.begin() + 1);
  std::partial_sum(received.begin(), received.end() - 1, received_from.begin() + 1);
  field.resize(3 * mine.points());
  out.resize(out_size);
  in.resize(in_size);
}

/* ---------------------------------------------------------------------- */

void HydroField::apply(const double *loads, double *motions)
{
  const std::size_t size = static_cast<std::size_t>(atom->nlocal) * NUMBERS;
  std::copy_n(loads, size, load.data());
  comm->forward_comm(fix);
  std::fill(motion.begin(), motion.end(), 0.0);
  add_near();
  comm->reverse_comm(fix);
  add_far();
  for (const int i : members) add_self(missing[i], &load[i * NUMBERS], &motion[i * NUMBERS]);
  std::copy_n(motion.data(), size, motions);
}

void HydroField::add_near()
{
  const double factor = 1.0 / (8.0 * PI * eta);
  for (const Pair &p : pairs) {
    Motion of_i, of_j;
    add_pair(p.response, factor, get_load(&load[p.i * NUMBERS]), get_load(&load[p.j * NUMBERS]),
             of_i, of_j);
    add_motion(of_i, &motion[p.i * NUMBERS]);
    add_motion(of_j, &motion[p.j * NUMBERS]);
  }
}

/* ----------------------------------------------------------------------
   to the grid and back
------------------------------------------------------------------------- */

void HydroField::add_far()
{
#ifdef SUSPENSION_FFTW
  StokesSolver &solver = transforms->solver;
  const int ranks = comm->nprocs;
  const Brick &mine = bricks[comm->me];
  Stencil stencil(lattice);
  std::fill(field.begin(), field.end(), 0.0);
  for (const int i : members)
    spread(stencil, lattice, mine, Lubcontact_NS::get_vector(atom->x[i]), bodies[i],
           get_load(&load[i * NUMBERS]), field.data());

  for (int r = 0; r < ranks; r++)
    pack_brick(mine, grid, share(grid[2], r, ranks), field.data(), out.data() + sent_from[r]);
  MPI_Alltoallv(out.data(), sent.data(), sent_from.data(), MPI_DOUBLE, in.data(), received.data(),
                received_from.data(), MPI_DOUBLE, world);
  std::fill_n(solver.field(), 3 * solver.points(), 0.0);
  for (int r = 0; r < ranks; r++)
    add_to_layers(bricks[r], grid, solver.layers(), in.data() + received_from[r], solver.field());

  const auto exchange = [&](const std::vector<int> &to, const std::vector<int> &from) {
    std::vector<int> starts_to(ranks), starts_from(ranks);
    std::partial_sum(to.begin(), to.end() - 1, starts_to.begin() + 1);
    std::partial_sum(from.begin(), from.end() - 1, starts_from.begin() + 1);
    MPI_Alltoallv(solver.outbox(), to.data(), starts_to.data(), MPI_DOUBLE_COMPLEX, solver.inbox(),
                  from.data(), starts_from.data(), MPI_DOUBLE_COMPLEX, world);
  };
  solver.to_waves();
  exchange(solver.of_forces(), solver.of_waves());
  solver.respond(lattice.cell, eta);
  exchange(solver.of_waves(), solver.of_forces());
  solver.to_velocities();

  for (int r = 0; r < ranks; r++)
    take_from_layers(bricks[r], grid, solver.layers(), solver.field(),
                     in.data() + received_from[r]);
  MPI_Alltoallv(in.data(), received.data(), received_from.data(), MPI_DOUBLE, out.data(),
                sent.data(), sent_from.data(), MPI_DOUBLE, world);
  for (int r = 0; r < ranks; r++)
    unpack_brick(mine, grid, share(grid[2], r, ranks), out.data() + sent_from[r], field.data());
  for (const int i : members)
    add_motion(interpolate(stencil, lattice, mine, Lubcontact_NS::get_vector(atom->x[i]), bodies[i],
                           field.data()),
               &motion[i * NUMBERS]);
#endif
}

/* ---------------------------------------------------------------------- */

int HydroField::pack_loads(int n, const int *list, double *buf) const
{
  for (int k = 0; k < n; k++) std::copy_n(&load[list[k] * NUMBERS], NUMBERS, buf + k * NUMBERS);
  return n * NUMBERS;
}

void HydroField::unpack_loads(int n, int first, const double *buf)
{
  std::copy_n(buf, n * NUMBERS, load.begin() + first * NUMBERS);
}

int HydroField::pack_motions(int n, int first, double *buf) const
{
  std::copy_n(motion.begin() + first * NUMBERS, n * NUMBERS, buf);
  return n * NUMBERS;
}

void HydroField::unpack_motions(int n, const int *list, const double *buf)
{
  for (int k = 0; k < n; k++)
    for (int m = 0; m < NUMBERS; m++) motion[list[k] * NUMBERS + m] += buf[k * NUMBERS + m];
}

/* ---------------------------------------------------------------------- */

double HydroField::memory_usage() const
{
  double bytes = static_cast<double>(
      pairs.capacity() * sizeof(Pair) + bodies.capacity() * sizeof(Body) +
      2 * missing.capacity() * sizeof(Self) +
      (load.capacity() + motion.capacity() + field.capacity() + out.capacity() + in.capacity()) *
          sizeof(double));
#ifdef SUSPENSION_FFTW
  if (transforms) bytes += transforms->solver.memory_usage();
#endif
  return bytes;
}
