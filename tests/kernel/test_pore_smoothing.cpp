// What the spacing of the grid does: waves are smoothed, the fluctuations of a random bed are
// resolved.

#ifdef SUSPENSION_FFTW

#include "pore_run.h"

using namespace pore_case;

namespace {

// mean of three directions of the flux over that of the mean permeability
double relative_flux(const Bed &bed, const Grid &g, double phi, int &iterations)
{
  const Permeability law;
  const Pores pores(g, law, 1.0, bed);
  const std::vector<Motion> rest(g.elements());
  double sum = 0.0;
  for (const Vec3 &slope : {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}}) {
    Field p(g.nodes(), 0.0);
    const Convergence found = solve_darcy(pores, rest, {}, slope, 1e-8, p);
    iterations = std::max(iterations, found.iterations);
    sum -= dot(slope, mean_flux(pores.mobility, gradients(g, p, slope))) / 3.0;
  }
  return sum / permeability(law, phi, 0.5);
}

TEST(PoreSmoothing, DragOfAWaveIsReducedByTheSpline)
{
  // many particles: the bed is a continuum
  Grid g;
  g.nx = g.nz = 1;
  g.ny = 12;
  g.cell = {{}, 1.0, 12.0, 1.0, 0.0, 0.0, 0.0};
  const double k = 0.03, viscosity = 0.6;
  Bed bed;
  for (int n = 0; n < 240; n++) {
    bed.x.push_back({0.5, (n + 0.5) / 20.0, 0.5});
    bed.radius.push_back(0.2);
  }
  const Pores pores(g, {Closure::CONSTANT, k, 1.0, 0.01}, viscosity, bed);
  for (int waves : {1, 2, 4}) {
    std::vector<Vec3> v;
    for (const Vec3 &x : bed.x) v.push_back({0.0, std::cos(2.0 * PI * waves * x.y / 12.0), 0.0});
    Field p(g.nodes(), 0.0);
    solve_darcy(pores, pores.motion(v), {}, {}, 1e-13, p);
    const double power = dissipation(g, pores.matrix, pores.mobility, {}, p);
    const double continuum = 0.5 * g.volume() * viscosity / k, x = PI * waves / 12.0;
    EXPECT_NEAR(power / continuum, std::pow(std::sin(x) / x, 6.0), 0.002) << waves;
  }
}

TEST(PoreSmoothing, RandomBedsAreSlightlyTooPermeable)
{
  Random rnd(71);
  const double phi = 0.55;
  const Cell c = filled_cell(350, phi, {1.0, 1.0, 1.0}, 0.0, 0.0, 0.0);
  const Bed bed = random_bed(rnd, 350, 0.0, c, false, 150);
  double before = 1.0;
  for (int n : {4, 5, 6, 7}) {    // elements per edge: spacing 1.73, 1.39, 1.16, 0.99
    int iterations = 0;
    const double flux =
        relative_flux(bed, grid_of(c, c.xprd / n, Wall::PERIODIC, Wall::PERIODIC), phi, iterations);
    EXPECT_GT(flux, before);
    EXPECT_LT(flux, n == 7 ? 1.06 : n == 6 ? 1.034 : 1.02);
    EXPECT_LE(iterations, n == 7 ? 22 : 15);
    before = flux;
  }
}

TEST(PoreSmoothing, TiltDoesNotChangeThePermeability)
{
  // the same bed twice along y, in a cell whose upper half is moved by an edge: slope 1/2
  Random rnd(72);
  const double phi = 0.55;
  const Cell c = filled_cell(180, phi, {1.0, 1.0, 1.0}, 0.0, 0.0, 0.0);
  const Bed one = random_bed(rnd, 180, 0.0, c, false, 150);
  Bed two = one;
  for (std::size_t i = 0; i < one.size(); i++) {
    two.x.push_back(one.x[i] + Vec3{0.0, c.yprd, 0.0});
    two.radius.push_back(one.radius[i]);
  }
  for (double h : {1.2, 1.5}) {
    int iterations = 0;
    Cell cell = c;
    cell.yprd *= 2.0;
    const double upright =
        relative_flux(two, grid_of(cell, h, Wall::PERIODIC, Wall::PERIODIC), phi, iterations);
    cell.xy = c.xprd;
    const double tilted =
        relative_flux(two, grid_of(cell, h, Wall::PERIODIC, Wall::PERIODIC), phi, iterations);
    EXPECT_NEAR(tilted / upright, 1.0, 0.004);
    EXPECT_NE(tilted, upright);
  }
}

}    // namespace

#endif
