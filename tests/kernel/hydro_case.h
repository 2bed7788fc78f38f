// Shared by the tests of the far field: the mobility of spheres in a periodic cell, from the
// headers on any number of ranks that share the grid, and from a sum over all waves.

#ifndef KERNEL_HYDRO_CASE_H
#define KERNEL_HYDRO_CASE_H

#include "hydro_layers.h"
#include "hydro_pairs.h"
#include "hydro_spline.h"
#include "hydro_wide.h"
#include "pore_cg.h"
#include "tools.h"

#ifdef SUSPENSION_FFTW
#include "hydro_solve.h"
#endif

#include <complex>
#include <memory>
#include <vector>

namespace hydro_case {

using namespace LAMMPS_NS::Hydro_NS;
using testing_tools::PI_;
using testing_tools::Random;
using Numbers = std::vector<double>;    // 11 of each sphere

struct Spheres {
  Cell cell;
  std::vector<Vec3> x;
  std::vector<double> radius;
  std::size_t size() const { return x.size(); }
};

inline Cell cubic(double edge)
{
  Cell c;
  c.xprd = c.yprd = c.zprd = edge;
  return c;
}

inline Vec3 image(const Cell &c, int i, int j, int k)
{
  return {i * c.xprd + j * c.xy + k * c.xz, j * c.yprd + k * c.yz, k * c.zprd};
}

// The tensors are written out here once more, by components: nothing of the headers.
using Matrix = double[3][3];

inline void matrix_of(const double *n, Matrix &c)
{
  const double r2 = std::sqrt(0.5), r6 = std::sqrt(1.0 / 6.0);
  const double s[3][3] = {{r2 * n[6] - r6 * n[7], r2 * n[8], r2 * n[9]},
                          {r2 * n[8], -r2 * n[6] - r6 * n[7], r2 * n[10]},
                          {r2 * n[9], r2 * n[10], 2.0 * r6 * n[7]}};
  const double t[3][3] = {{0.0, -n[5], n[4]}, {n[5], 0.0, -n[3]}, {-n[4], n[3], 0.0}};
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) c[a][b] = s[a][b] + 0.5 * t[a][b];
}

// velocity and gradient to 11 numbers
inline void numbers_of(const double *u, const Matrix &g, double *n)
{
  const double r2 = std::sqrt(0.5), r6 = std::sqrt(1.0 / 6.0);
  for (int a = 0; a < 3; a++) n[a] = u[a];
  n[3] = 0.5 * (g[2][1] - g[1][2]);
  n[4] = 0.5 * (g[0][2] - g[2][0]);
  n[5] = 0.5 * (g[1][0] - g[0][1]);
  n[6] = r2 * (g[0][0] - g[1][1]);
  n[7] = r6 * (2.0 * g[2][2] - g[0][0] - g[1][1]);
  n[8] = r2 * (g[0][1] + g[1][0]);
  n[9] = r2 * (g[0][2] + g[2][0]);
  n[10] = r2 * (g[1][2] + g[2][1]);
}

// Sum over all waves until the Gaussian of the narrowest force is below 1e-7 in it: the definition
// of the force coupling method, viscosity 1.
inline Numbers spectral_motion(const Spheres &s, const Numbers &loads, double smallest = 1e-7)
{
  using Complex = std::complex<double>;
  double narrow = 1e300;
  for (const double a : s.radius) narrow = std::fmin(narrow, a / std::sqrt(PI_));
  const double most = std::sqrt(-2.0 * std::log(smallest)) / narrow;
  const Cell &c = s.cell;
  const double edges[3] = {c.xprd, std::sqrt(c.xy * c.xy + c.yprd * c.yprd),
                           std::sqrt(c.xz * c.xz + c.yz * c.yz + c.zprd * c.zprd)};
  int top[3];
  for (int d = 0; d < 3; d++) top[d] = static_cast<int>(most * edges[d] / (2.0 * PI_)) + 1;
  const std::size_t n = s.size();
  std::vector<double> velocity(3 * n), gradient(9 * n);
  std::vector<Complex> phase(n);
  for (int i = 0; i <= top[0]; i++)
    for (int j = -top[1]; j <= top[1]; j++)
      for (int k = -top[2]; k <= top[2]; k++) {
        if (i == 0 && (j < 0 || (j == 0 && k <= 0))) continue;    // half of them
        const double kx = 2.0 * PI_ * i / c.xprd, ky = (2.0 * PI_ * j - kx * c.xy) / c.yprd;
        const double kz = (2.0 * PI_ * k - kx * c.xz - ky * c.yz) / c.zprd;
        const double wave[3] = {kx, ky, kz}, k2 = kx * kx + ky * ky + kz * kz;
        if (k2 > most * most) continue;
        Complex f[3] = {};
        for (std::size_t p = 0; p < n; p++) {
          const double a = s.radius[p], m = std::exp(-0.5 * k2 * a * a / PI_);
          const double d = std::exp(-0.5 * k2 * a * a / std::pow(6.0 * std::sqrt(PI_), 2.0 / 3.0));
          phase[p] = std::polar(1.0, -(kx * s.x[p].x + ky * s.x[p].y + kz * s.x[p].z));
          Matrix dipole;
          matrix_of(&loads[11 * p], dipole);
          for (int b = 0; b < 3; b++) {
            double along = 0.0;
            for (int q = 0; q < 3; q++) along += dipole[b][q] * wave[q];
            f[b] += phase[p] * Complex(m * loads[11 * p + b], -d * along);
          }
        }
        const Complex longitudinal = (kx * f[0] + ky * f[1] + kz * f[2]) / k2;
        for (int b = 0; b < 3; b++) f[b] = (f[b] - wave[b] * longitudinal) / k2;
        for (std::size_t p = 0; p < n; p++) {
          const double a = s.radius[p], m = std::exp(-0.5 * k2 * a * a / PI_);
          const double d = std::exp(-0.5 * k2 * a * a / std::pow(6.0 * std::sqrt(PI_), 2.0 / 3.0));
          for (int b = 0; b < 3; b++) {
            const Complex u = f[b] * std::conj(phase[p]);
            velocity[3 * p + b] += 2.0 * m * u.real();
            for (int q = 0; q < 3; q++) gradient[9 * p + 3 * b + q] -= 2.0 * d * wave[q] * u.imag();
          }
        }
      }
  const double volume = c.xprd * c.yprd * c.zprd;
  Numbers motion(loads.size());
  for (std::size_t p = 0; p < n; p++) {
    Matrix g;
    double u[3];
    for (int b = 0; b < 3; b++) {
      u[b] = velocity[3 * p + b] / volume;
      for (int q = 0; q < 3; q++) g[b][q] = gradient[9 * p + 3 * b + q] / volume;
    }
    numbers_of(u, g, &motion[11 * p]);
  }
  return motion;
}

inline Numbers random_loads(Random &rnd, const Spheres &s)
{
  Numbers loads(11 * s.size());
  for (std::size_t n = 0; n < loads.size(); n++) {
    const double a = s.radius[n / 11];
    loads[n] = rnd.uniform(-1.0, 1.0) * (n % 11 < 3 ? 6.0 * PI_ * a : 8.0 * PI_ * a * a * a);
  }
  return loads;
}

// error of b, rms over rms of a
inline double relative_error(const Numbers &a, const Numbers &b)
{
  double difference = 0.0, size = 0.0;
  for (std::size_t n = 0; n < a.size(); n++) {
    difference += (a[n] - b[n]) * (a[n] - b[n]);
    size += a[n] * a[n];
  }
  return std::sqrt(difference / size);
}

#ifdef SUSPENSION_FFTW

struct Settings {
  double width = 1.0, spacing = 0.9, pairs = 5.0;    // in widths but the first
  int points = 6;
  int ranks = 1;
};

using Solvers = std::vector<std::unique_ptr<StokesSolver>>;

// what MPI does between ranks
inline void exchange_of_ranks(const Solvers &solvers,
                              const std::vector<int> &(StokesSolver::*numbers)() const)
{
  std::vector<const StokesSolver::Complex *> next;
  for (const auto &solver : solvers) next.push_back(solver->outbox());
  for (std::size_t to = 0; to < solvers.size(); to++) {
    StokesSolver::Complex *inbox = solvers[to]->inbox();
    for (std::size_t from = 0; from < solvers.size(); from++) {
      const int number = ((*solvers[from]).*numbers)()[to];
      inbox = std::copy_n(next[from], number, inbox);
      next[from] += number;
    }
  }
}

// Mobility from the headers: spread, solve, interpolate, pairs, self. Ranks have spheres in turn.
class GridMobility {
 public:
  GridMobility(const Spheres &all, const Settings &use, double eta = 1.0) :
      spheres(all), settings(use), viscosity(eta)
  {
    const double h = use.spacing * use.width;
    const Cell &c = all.cell;
    lattice = lattice_for(c, h, c.xy);
    points = {lattice.nx, lattice.ny, lattice.nz};
    for (const double a : all.radius) bodies.push_back(make_body(a, use.width));
    for (int r = 0; r < use.ranks; r++) {
      solvers.push_back(std::make_unique<StokesSolver>(points, r, use.ranks, WITH_COMPANION));
      solvers.back()->set_response(c, [&](const WaveVector &wave) {
        double spline = 1.0;
        for (int d = 0; d < 3; d++) spline *= spline_wave(wave.number[d], points[d], use.points);
        const WaveFactors f = gaussian_factors(wave, eta, use.width);
        const double both = 1.0 / (lattice.point_volume() * spline * spline);
        return WaveFactors{both * f.across, both * f.along};
      });
      Vec3 low{1e300, 1e300, 1e300}, high = -1.0 * low;
      for (std::size_t i = r; i < all.size(); i += use.ranks) {
        const Vec3 g = lattice_place(lattice, all.x[i]);
        low = {std::fmin(low.x, g.x), std::fmin(low.y, g.y), std::fmin(low.z, g.z)};
        high = {std::fmax(high.x, g.x), std::fmax(high.y, g.y), std::fmax(high.z, g.z)};
      }
      bricks.push_back(spline_brick(low, high, use.points));
    }
    find_pairs();
  }

  Numbers operator()(const Numbers &loads) const
  {
    const std::size_t n = spheres.size();
    std::vector<Load> load(n);
    std::vector<Motion> motion(n);
    for (std::size_t i = 0; i < n; i++) load[i] = get_load(&loads[11 * i]);
    far(load, motion);
    add_pairs(pairs, 1.0 / (8.0 * PI_ * viscosity), load.data(), motion.data());
    for (const Image &p : images) {    // counted for both of the pair
      Motion unused;
      add_pair(p.response, 1.0 / (8.0 * PI_ * viscosity), load[p.i], load[p.i], motion[p.i],
               unused);
    }
    Numbers result(loads.size());
    for (std::size_t i = 0; i < n; i++) {
      add_motion(motion[i], &result[11 * i]);
      add_self(sphere_self(spheres.radius[i], viscosity) -
                   wide_self(bodies[i], settings.width, viscosity),
               &loads[11 * i], &result[11 * i]);
    }
    return result;
  }

  Points points;

 private:
  struct Image {
    std::size_t i;
    PairResponse response;
  };
  const Spheres spheres;
  Settings settings;
  double viscosity;
  Lattice lattice;
  std::vector<Body> bodies;
  std::vector<Brick> bricks;
  Solvers solvers;
  std::vector<PairBlock> pairs;    // of different spheres
  std::vector<Image> images;       // of one with itself, in both ways

  void find_pairs()
  {
    const double cut = settings.pairs * settings.width;
    const Cell &c = spheres.cell;
    const int mx = static_cast<int>((cut + std::fabs(c.xy) + std::fabs(c.xz)) / c.xprd) + 2;
    const int my = static_cast<int>((cut + std::fabs(c.yz)) / c.yprd) + 2;
    const int mz = static_cast<int>(cut / c.zprd) + 2;
    for (std::size_t i = 0; i < spheres.size(); i++)
      for (std::size_t j = 0; j <= i; j++)
        for (int kx = -mx; kx <= mx; kx++)
          for (int ky = -my; ky <= my; ky++)
            for (int kz = -mz; kz <= mz; kz++) {
              const Vec3 x = spheres.x[i] - spheres.x[j] + image(c, kx, ky, kz);
              if (dot(x, x) > cut * cut || (i == j && kx == 0 && ky == 0 && kz == 0)) continue;
              const PairResponse r = missing_response(x, bodies[i], bodies[j], settings.width);
              if (i == j)
                images.push_back({i, r});
              else
                add_to(pairs, static_cast<int>(i), static_cast<int>(j), r);
            }
  }

  // ranks in turn: all do the one thing before the first does the next
  void far(const std::vector<Load> &load, std::vector<Motion> &motion) const
  {
    const int ranks = settings.ranks;
    const LatticeGradients to = lattice_gradients(lattice);
    const auto on_grid = [&](std::size_t i) {
      return spline_at(lattice, spheres.x[i], settings.points);
    };
    const auto of_laplacian = [&](std::size_t i) {
      return OfLaplacian{bodies[i].c_force, bodies[i].c_dipole};
    };
    std::vector<Numbers> fields;
    for (int r = 0; r < ranks; r++) {
      Numbers field(padded(WITH_COMPANION) * bricks[r].points());
      for (std::size_t i = r; i < load.size(); i += ranks)
        spread<WITH_COMPANION>(on_grid(i), to, bricks[r], of_laplacian(i), load[i], field.data());
      fields.push_back(field);
    }
    for (int rank = 0; rank < ranks; rank++) {
      StokesSolver &solver = *solvers[rank];
      std::fill_n(solver.field(), WITH_COMPANION * solver.points(), 0.0);
      for (int r = 0; r < ranks; r++) {
        Numbers sent(numbers_in(bricks[r], points, solver.layers(), WITH_COMPANION));
        pack_brick(bricks[r], points, solver.layers(), WITH_COMPANION, fields[r].data(),
                   sent.data());
        add_to_layers(bricks[r], points, solver.layers(), WITH_COMPANION, sent.data(),
                      solver.field());
      }
    }
    solve();
    for (int from = 0; from < ranks; from++) {
      const StokesSolver &solver = *solvers[from];
      for (int r = 0; r < ranks; r++) {
        Numbers sent(numbers_in(bricks[r], points, solver.layers(), WITH_COMPANION));
        take_from_layers(bricks[r], points, solver.layers(), WITH_COMPANION, solver.field(),
                         sent.data());
        unpack_brick(bricks[r], points, solver.layers(), WITH_COMPANION, sent.data(),
                     fields[r].data());
      }
    }
    for (int r = 0; r < ranks; r++)
      for (std::size_t i = r; i < load.size(); i += ranks)
        motion[i] = interpolate<WITH_COMPANION>(on_grid(i), to, bricks[r], of_laplacian(i),
                                                fields[r].data());
  }

  void solve() const
  {
    for (const auto &solver : solvers) solver->to_waves();
    exchange_of_ranks(solvers, &StokesSolver::of_forces);
    for (const auto &solver : solvers) solver->respond();
    exchange_of_ranks(solvers, &StokesSolver::of_waves);
    for (const auto &solver : solvers) solver->to_velocities();
  }
};

#endif

}    // namespace hydro_case

#endif
