/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_hydro_waves.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"

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
  HydroTransforms(const Points &points, int rank, int ranks, int components) :
      solver(points, rank, ranks, components)
  {
  }
  StokesSolver solver;
};
#else
struct LAMMPS_NS::HydroTransforms {};
#endif

/* ---------------------------------------------------------------------- */

HydroWaves::HydroWaves(LAMMPS *lmp, int numbers) :
    Pointers(lmp), order(0), components(numbers), to()
{
}

HydroWaves::~HydroWaves() = default;

/* ----------------------------------------------------------------------
   A cell that flips is leaned by half of its width at most: a number of points for that stays the
   same while it shears.
------------------------------------------------------------------------- */

void HydroWaves::fit(double spacing, int points_of_splines)
{
  const double *lo = domain->boxlo;
  const Hydro_NS::Cell cell = {{lo[0], lo[1], lo[2]},
                               domain->xprd,
                               domain->yprd,
                               domain->zprd,
                               domain->xy,
                               domain->xz,
                               domain->yz};
  const Points before = points();
  order = points_of_splines;
  grid = lattice_for(cell, spacing,
                     domain->triclinic ? MAX(fabs(domain->xy), 0.5 * domain->xprd) : 0.0);
  to = lattice_gradients(grid);
  if (transforms && points() == before) return;
#ifdef SUSPENSION_FFTW
  transforms.reset();    // first, for its memory
  transforms = std::make_unique<HydroTransforms>(points(), comm->me, comm->nprocs, components);
#endif
}

void HydroWaves::set_response(
    [[maybe_unused]] const std::function<WaveFactors(const WaveVector &)> &f)
{
#ifdef SUSPENSION_FFTW
  const double density = 1.0 / grid.point_volume();
  std::vector<double> undo[3];    // by the numbers of waves: what makes up for both splines
  for (int d = 0; d < 3; d++)
    for (int m = 0; m < points()[d]; m++) {
      const double spline = spline_wave(signed_wave(m, points()[d]), points()[d], order);
      undo[d].push_back(1.0 / (spline * spline));
    }
  const auto of = [&](int d, int number) {
    return undo[d][number < 0 ? number + points()[d] : number];
  };
  const auto response = [&](const WaveVector &wave) {
    const double both =
        density * of(0, wave.number[0]) * of(1, wave.number[1]) * of(2, wave.number[2]);
    const WaveFactors plain = f(wave);
    return WaveFactors{both * plain.across, both * plain.along};
  };
  transforms->solver.set_response(grid.cell, response);
#endif
}

Spline HydroWaves::spline(int i) const
{
  return spline_at(grid, Lubcontact_NS::get_vector(atom->x[i]), order);
}

/* ---------------------------------------------------------------------- */

void HydroWaves::reach_for(const std::vector<int> &atoms)
{
  Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = -1.0 * low;
  for (const int i : atoms) {
    const Vec3 g = lattice_place(grid, Lubcontact_NS::get_vector(atom->x[i]));
    low = {MIN(low.x, g.x), MIN(low.y, g.y), MIN(low.z, g.z)};
    high = {MAX(high.x, g.x), MAX(high.y, g.y), MAX(high.z, g.z)};
  }
  mine = atoms.empty() ? Brick{} : spline_brick(low, high, order);
  const int ranks = comm->nprocs;
  bricks.resize(ranks);
  static_assert(sizeof(Brick) == 6 * sizeof(int), "exchanged as integers");
  MPI_Allgather(&mine, 6, MPI_INT, bricks.data(), 6, MPI_INT, world);

  const Share layers = share(grid.nz, comm->me, ranks);
  sent.assign(ranks, 0);
  received.assign(ranks, 0);
  std::size_t out_size = 0, in_size = 0;
  for (int r = 0; r < ranks; r++) {
    const std::size_t there = numbers_in(mine, points(), share(grid.nz, r, ranks), components);
    const std::size_t here = numbers_in(bricks[r], points(), layers, components);
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
  field.resize(padded(components) * mine.points());
  out.resize(out_size);
  in.resize(in_size);
}

/* ---------------------------------------------------------------------- */

void HydroWaves::solve()
{
#ifdef SUSPENSION_FFTW
  StokesSolver &solver = transforms->solver;
  const int ranks = comm->nprocs;
  const auto exchange_points = [this](std::vector<double> &from, const std::vector<int> &number,
                                      const std::vector<int> &start, std::vector<double> &here,
                                      const std::vector<int> &number_here,
                                      const std::vector<int> &start_here) {
    if (comm->nprocs == 1)
      from.swap(here);
    else
      MPI_Alltoallv(from.data(), number.data(), start.data(), MPI_DOUBLE, here.data(),
                    number_here.data(), start_here.data(), MPI_DOUBLE, world);
  };
  for (int r = 0; r < ranks; r++)
    pack_brick(mine, points(), share(grid.nz, r, ranks), components, field.data(),
               out.data() + sent_from[r]);
  exchange_points(out, sent, sent_from, in, received, received_from);
  std::fill_n(solver.field(), components * solver.points(), 0.0);
  for (int r = 0; r < ranks; r++)
    add_to_layers(bricks[r], points(), solver.layers(), components, in.data() + received_from[r],
                  solver.field());

  const auto exchange = [&](const std::vector<int> &number, const std::vector<int> &from) {
    if (ranks == 1) return solver.exchange_alone();
    std::vector<int> starts(ranks), starts_from(ranks);
    std::partial_sum(number.begin(), number.end() - 1, starts.begin() + 1);
    std::partial_sum(from.begin(), from.end() - 1, starts_from.begin() + 1);
    MPI_Alltoallv(solver.outbox(), number.data(), starts.data(), MPI_DOUBLE_COMPLEX, solver.inbox(),
                  from.data(), starts_from.data(), MPI_DOUBLE_COMPLEX, world);
  };
  solver.to_waves();
  exchange(solver.of_forces(), solver.of_waves());
  solver.respond();
  exchange(solver.of_waves(), solver.of_forces());
  solver.to_velocities();

  for (int r = 0; r < ranks; r++)
    take_from_layers(bricks[r], points(), solver.layers(), components, solver.field(),
                     in.data() + received_from[r]);
  exchange_points(in, received, received_from, out, sent, sent_from);
  for (int r = 0; r < ranks; r++)
    unpack_brick(mine, points(), share(grid.nz, r, ranks), components, out.data() + sent_from[r],
                 field.data());
#endif
}

/* ---------------------------------------------------------------------- */

double HydroWaves::memory_usage() const
{
  double bytes =
      static_cast<double>((field.capacity() + out.capacity() + in.capacity()) * sizeof(double));
#ifdef SUSPENSION_FFTW
  if (transforms) bytes += transforms->solver.memory_usage();
#endif
  return bytes;
}
