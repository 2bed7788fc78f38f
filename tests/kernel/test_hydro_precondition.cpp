// The approximate inverse of the mobility: symmetric, positive, and what it saves.

#include "hydro_case.h"
#include "hydro_precondition.h"

#ifdef SUSPENSION_FFTW

using namespace hydro_case;

namespace {

using LAMMPS_NS::Pore_NS::scalar_product;

// spheres in a face-centered cubic lattice, moved by random steps
Spheres shaken_lattice(int edge, double phi, double step)
{
  Random rnd(71);
  const double a = std::cbrt(4.0 * 4.0 / 3.0 * PI_ / phi);
  Spheres s{cubic(edge * a), {}, {}};
  const Vec3 basis[4] = {{0.0, 0.0, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}, {0.5, 0.5, 0.0}};
  for (int i = 0; i < edge; i++)
    for (int j = 0; j < edge; j++)
      for (int k = 0; k < edge; k++)
        for (const Vec3 &b : basis) {
          const Vec3 site{i + b.x, j + b.y, k + b.z};
          s.x.push_back(a * site + rnd.vector(step));
          s.radius.push_back(1.0);
        }
  return s;
}

// as fix hydro does it, on one rank
class GridPreconditioner {
 public:
  explicit GridPreconditioner(const Spheres &all) : spheres(all)
  {
    const Cell &c = all.cell;
    double mean_radius = 0.0, volume = 0.0, resistance = 0.0;
    for (const double a : all.radius) {
      mean_radius += a / static_cast<double>(all.size());
      volume += 4.0 / 3.0 * PI_ * a * a * a;
      resistance += 6.0 * PI_ * a;
    }
    const double h = COARSE_SPACING * mean_radius;
    lattice = lattice_for(c, h, c.xy);
    const Points points = {lattice.nx, lattice.ny, lattice.nz};
    gradients = lattice_gradients(lattice);
    solver = std::make_unique<StokesSolver>(points, 0, 1);
    Vec3 low{1e300, 1e300, 1e300}, high = -1.0 * low;
    for (const Vec3 &x : all.x) {
      const Vec3 g = lattice_place(lattice, x);
      low = {std::fmin(low.x, g.x), std::fmin(low.y, g.y), std::fmin(low.z, g.z)};
      high = {std::fmax(high.x, g.x), std::fmax(high.y, g.y), std::fmax(high.z, g.z)};
      splines.push_back(spline_at(lattice, x, COARSE_POINTS));
    }
    brick = spline_brick(low, high, COARSE_POINTS);
    weights.assign(all.size(), 1.0);

    const Screening screening{volume / lattice.volume()};
    const auto respond_with = [&](const auto &factors) {
      solver->set_response(c, [&](const WaveVector &wave) {
        double t = static_cast<double>(lattice.points()) / resistance;
        for (int d = 0; d < 3; d++) {
          const double one = spline_wave(wave.number[d], points[d], COARSE_POINTS);
          t /= one * one;
        }
        const WaveFactors f = factors(std::sqrt(wave.square) * mean_radius);
        return WaveFactors{t * f.across, t * f.along};
      });
    };
    respond_with([&](double k) {
      return WaveFactors{screening.smoothing(k), screening.smoothing(k)};
    });
    std::vector<Load> of_resistance;
    for (const double a : all.radius) of_resistance.push_back({{6.0 * PI_ * a, 0.0, 0.0}, {}});
    const std::vector<Motion> density = through_grid(of_resistance);
    for (std::size_t i = 0; i < all.size(); i++) {
      densities.push_back(density[i].velocity.x);
      weights[i] = coarse_weight(densities[i]);
    }
    respond_with([&](double k) {
      return screening.factors(k);
    });
  }

  Numbers operator()(const Numbers &motions) const
  {
    Numbers loads = alone(motions);
    std::vector<Load> spread_loads;
    for (std::size_t i = 0; i < spheres.size(); i++) {
      double load[NUMBERS];
      std::copy_n(&loads[11 * i], 11, load);
      weigh_coarse(weights[i], load);
      spread_loads.push_back(get_load(load));
    }
    const std::vector<Motion> found = through_grid(spread_loads);
    for (std::size_t i = 0; i < spheres.size(); i++) {
      double motion[NUMBERS] = {};
      add_motion(found[i], motion);
      weigh_coarse(weights[i], motion);
      add_resistance(sphere_self(spheres.radius[i], 1.0), motion, &loads[11 * i]);
    }
    return loads;
  }

  Numbers alone(const Numbers &motions) const
  {
    Numbers loads(motions.size());
    for (std::size_t i = 0; i < spheres.size(); i++)
      add_resistance(sphere_self(spheres.radius[i], 1.0), &motions[11 * i], &loads[11 * i]);
    return loads;
  }

  std::vector<double> densities;    // over the mean

 private:
  const Spheres spheres;
  Lattice lattice;
  LatticeGradients gradients;
  Brick brick;
  std::unique_ptr<StokesSolver> solver;
  std::vector<Spline> splines;
  std::vector<double> weights;

  std::vector<Motion> through_grid(const std::vector<Load> &loads) const
  {
    Numbers field(padded(VECTOR) * brick.points());
    for (std::size_t i = 0; i < loads.size(); i++)
      spread<VECTOR>(splines[i], gradients, brick, {}, loads[i], field.data());
    const Points points = {lattice.nx, lattice.ny, lattice.nz};
    Numbers sent(numbers_in(brick, points, solver->layers(), VECTOR));
    pack_brick(brick, points, solver->layers(), VECTOR, field.data(), sent.data());
    std::fill_n(solver->field(), 3 * solver->points(), 0.0);
    add_to_layers(brick, points, solver->layers(), VECTOR, sent.data(), solver->field());
    solver->to_waves();
    solver->exchange_alone();
    solver->respond();
    solver->exchange_alone();
    solver->to_velocities();
    take_from_layers(brick, points, solver->layers(), VECTOR, solver->field(), sent.data());
    unpack_brick(brick, points, solver->layers(), VECTOR, sent.data(), field.data());
    std::vector<Motion> motions;
    for (const Spline &s : splines)
      motions.push_back(interpolate<VECTOR>(s, gradients, brick, {}, field.data()));
    return motions;
  }
};

Numbers random_motions(Random &rnd, const Spheres &s)
{
  Numbers motions(11 * s.size());
  for (double &value : motions) value = rnd.uniform(-1.0, 1.0);
  return motions;
}

// of D^1/2 P^-1 D^1/2: C. Lanczos, J. Res. Nat. Bur. Stand. 45, 255 (1950), and bisection by signs
// of the pivots
double smallest_eigenvalue(const Spheres &s, const GridPreconditioner &p)
{
  const std::size_t size = 11 * s.size();
  Numbers scale(size), before(size), diagonal, beside = {0.0};
  for (std::size_t n = 0; n < size; n++) {
    const Self self = sphere_self(s.radius[n / 11], 1.0);
    scale[n] = std::sqrt(n % 11 < 3 ? self.translation : n % 11 < 6 ? self.rotation : self.strain);
  }
  Random rnd(72);
  Numbers a = random_motions(rnd, s);
  double length = std::sqrt(scalar_product(a, a));
  for (double &value : a) value /= length;
  for (int step = 0; step < 50; step++) {
    Numbers in(size);
    for (std::size_t n = 0; n < size; n++) in[n] = scale[n] * a[n];
    Numbers next = p(in);
    for (std::size_t n = 0; n < size; n++) next[n] = scale[n] * next[n] - beside.back() * before[n];
    diagonal.push_back(scalar_product(next, a));
    for (std::size_t n = 0; n < size; n++) next[n] -= diagonal.back() * a[n];
    length = std::sqrt(scalar_product(next, next));
    beside.push_back(length);
    before = a;
    for (std::size_t n = 0; n < size; n++) a[n] = next[n] / length;
  }
  double low = -100.0, high = 100.0;
  for (int round = 0; round < 60; round++) {
    const double x = 0.5 * (low + high);
    bool below = false;
    double pivot = 1.0;
    for (std::size_t n = 0; n < diagonal.size(); n++) {
      pivot = diagonal[n] - x - beside[n] * beside[n] / pivot;
      below = below || pivot < 0.0;
    }
    (below ? high : low) = x;
  }
  return low;
}

int iterations(const Spheres &s, bool with_grid)
{
  const GridMobility m(s, Settings());
  const GridPreconditioner p(s);
  Random rnd(73);
  const Numbers right = random_motions(rnd, s);
  Numbers x(right.size(), 0.0);
  const auto found = LAMMPS_NS::Pore_NS::solve_by_products(
      [&](const Numbers &a, Numbers &b) {
        b = m(a);
      },
      [&](const Numbers &a, Numbers &b) {
        b = with_grid ? p(a) : p.alone(a);
      },
      scalar_product, right, 0.01, 500, x, LAMMPS_NS::Pore_NS::Measure::PRECONDITIONED);
  EXPECT_LE(found.residual, 0.01);
  return found.iterations;
}

TEST(HydroPrecondition, Symmetric)
{
  Random rnd(74);
  Spheres s = shaken_lattice(2, 0.4, 0.2);
  s.cell.xy = 0.4 * s.cell.xprd;
  s.cell.yz = -0.2 * s.cell.yprd;
  for (std::size_t i = 0; i < s.size(); i += 3) s.radius[i] = 0.6;
  const GridPreconditioner p(s);
  for (int trial = 0; trial < 5; trial++) {
    const Numbers a = random_motions(rnd, s), b = random_motions(rnd, s);
    const double ab = scalar_product(a, p(b)), ba = scalar_product(b, p(a));
    EXPECT_NEAR(ab, ba, 1e-13 * scalar_product(a, p(a)));
  }
}

TEST(HydroPrecondition, Positive)
{
  for (const double phi : {0.02, 0.1, 0.3, 0.5}) {
    const Spheres s = shaken_lattice(3, phi, phi > 0.4 ? 0.1 : 0.3);
    EXPECT_GT(smallest_eigenvalue(s, GridPreconditioner(s)), 0.1) << phi;
  }
}

// a drop, and a layer, in a large cell
TEST(HydroPrecondition, PositiveWhereSpheresGather)
{
  Spheres drop = shaken_lattice(4, 0.45, 0.1), layer = drop;
  drop.cell = cubic(2.5 * drop.cell.xprd);
  layer.cell.zprd *= 4.0;
  for (const Spheres &s : {drop, layer})
    EXPECT_GT(smallest_eigenvalue(s, GridPreconditioner(s)), 0.1);
}

// the mean over the spheres of an even suspension is that of the cell
TEST(HydroPrecondition, DensityOfSpheres)
{
  Spheres s = shaken_lattice(3, 0.3, 0.1);
  s.cell.xy = 0.2 * s.cell.xprd;    // a cell of the same volume
  for (const double density : GridPreconditioner(shaken_lattice(3, 0.3, 0.0)).densities)
    EXPECT_NEAR(density, 1.0, 0.01);
  double mean = 0.0;
  for (const double density : GridPreconditioner(s).densities) mean += density;
  EXPECT_NEAR(mean / static_cast<double>(s.size()), 1.0, 0.1);
}

// 22 and 39 with spheres alone, 10 and 11 with the grid
TEST(HydroPrecondition, IterationsDoNotGrowWithTheCell)
{
  const Spheres small = shaken_lattice(2, 0.5, 0.1), large = shaken_lattice(4, 0.5, 0.1);
  const int with_small = iterations(small, true), with_large = iterations(large, true);
  EXPECT_LE(with_large, with_small + 2);
  EXPECT_LE(2 * with_small, iterations(small, false));
  EXPECT_LE(3 * with_large, iterations(large, false));
}

}    // namespace

#endif
