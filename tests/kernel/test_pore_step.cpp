// A step of pressure and particles: Darcy's law, bounds, stability.

#ifdef SUSPENSION_FFTW

#include "pore_run.h"

using namespace pore_case;

namespace {

const Permeability LAW;
constexpr double VISCOSITY = 0.6;

Pores random_pores(Random &rnd, const Sides &sides, double phi, double h, Bed &bed,
                   const Permeability &law = LAW)
{
  const bool plates = sides.lower != Wall::PERIODIC;
  const Cell c =
      filled_cell(70, phi, {1.0, 1.3, 0.9}, plates ? 0.0 : 0.4, 0.2, plates ? 0.0 : -0.3);
  bed = random_bed(rnd, 70, 0.2, c, plates, 100);
  return Pores(grid_of(c, h, sides.lower, sides.upper), law, VISCOSITY, bed);
}

// equal spheres, touching, in columns of width 1 along y; the gap is as many spheres high
Pores stack(int spheres, int ny, const Permeability &law, Wall lower, Wall upper, Bed &bed)
{
  Grid g;
  g.ny = ny;
  g.lower = lower;
  g.upper = upper;
  g.cell = {{0.0, 2.0, 0.0}, 1.0, 1.0 * spheres, 1.0, 0.0, 0.0, 0.0};
  for (int n = 0; n < spheres; n++) {
    bed.x.push_back({0.3, 2.5 + n, 0.8});
    bed.radius.push_back(0.5);
  }
  return Pores(g, law, VISCOSITY, bed);
}

TEST(PoreStep, UniformBedFlowsByDarcysLaw)
{
  Bed bed;
  const double k = 0.02;
  const Pores pores =
      stack(12, 8, {Closure::CONSTANT, k, 1.0, 0.1}, Wall::DRAINED, Wall::DRAINED, bed);
  Field p(pores.grid.nodes(), 0.0);
  set_fixed(pores.grid, 5.0, 2.0, p);
  const std::vector<Motion> rest = pores.motion(std::vector<Vec3>(bed.size()));
  solve_darcy(pores, rest, {}, {}, 1e-13, p);
  const double flux = k / VISCOSITY * 3.0 / 12.0;
  const WallFlux out =
      wall_flux(pores.grid, imbalance(pores.grid, pores.matrix, pores.mobility, rest, {}, {}, p));
  EXPECT_NEAR(out.upper, flux, 1e-13);
  EXPECT_NEAR(out.lower, -flux, 1e-13);
  EXPECT_NEAR(mean_flux(pores.mobility, gradients(pores.grid, p)).y, flux, 1e-13);
  EXPECT_NEAR(dissipation(pores.grid, pores.matrix, pores.mobility, {}, p), flux * 3.0, 1e-13);
  // the weight of what flows is carried by the particles and the plates
  double sum = 0.0;
  for (const Vec3 &f : pores.forces(p)) sum += f.y;
  EXPECT_NEAR(sum, 3.0, 1e-12);
}

TEST(PoreStep, MeanGradientDrivesTheSameFlux)
{
  Random rnd(51);
  const double k = 0.02;
  Bed bed;
  const Pores pores = random_pores(rnd, SIDES[0], 0.5, 1.4, bed, {Closure::CONSTANT, k, 1.0, 0.1});
  const Vec3 slope{0.3, -0.8, 0.4};
  Field p(pores.grid.nodes(), 0.0);
  solve_darcy(pores, pores.motion(std::vector<Vec3>(bed.size())), {}, slope, 1e-12, p);
  EXPECT_LT(largest_size(p), 1e-12);
  testing_tools::expect_near(mean_flux(pores.mobility, gradients(pores.grid, p, slope)),
                             (-k / VISCOSITY) * slope, 1e-13);
}

TEST(PoreStep, RandomBedDissipatesWhatItsMeanGradientDoes)
{
  Random rnd(52);
  Bed bed;
  const Pores pores = random_pores(rnd, SIDES[0], 0.5, 1.2, bed);
  const Vec3 slope{0.3, -0.8, 0.4};
  Field p(pores.grid.nodes(), 0.0);
  solve_darcy(pores, pores.motion(std::vector<Vec3>(bed.size())), {}, slope, 1e-12, p);
  const Vec3 flux = mean_flux(pores.mobility, gradients(pores.grid, p, slope));
  const double power = dissipation(pores.grid, pores.matrix, pores.mobility, slope, p);
  EXPECT_NEAR(power, -pores.grid.volume() * dot(slope, flux), 1e-11 * power);
}

TEST(PoreStep, DilationHasItsParabolaAtOnce)
{
  // rigid motion u = e y over an impermeable plate: p = -(eta e/2k) (H^2 - y^2)
  const double k = 0.02, e = 0.3, H = 12.0;
  for (const Sides &sides : {SIDES[1], SIDES[2]})
    for (int ny : {6, 8, 11}) {
      Bed bed;
      const Pores pores =
          stack(12, ny, {Closure::CONSTANT, k, 1.0, 0.1}, sides.lower, sides.upper, bed);
      const bool below = sides.lower == Wall::IMPERMEABLE;
      std::vector<Vec3> v;
      for (const Vec3 &x : bed.x) v.push_back({0.0, e * (x.y - (below ? 2.0 : 14.0)), 0.0});
      Field p(pores.grid.nodes(), 0.0);
      solve_darcy(pores, pores.motion(v), {below ? 0.0 : -e * H, below ? e * H : 0.0}, {}, 1e-14,
                  p);
      for (int j = 0; j <= ny; j++) {
        const double y = (below ? j : ny - j) * H / ny;
        EXPECT_NEAR(p[j] / (-VISCOSITY * e / (2.0 * k)), H * H - y * y, 1e-10);
      }
    }
}

TEST(PoreStep, ForcesDissipateWhatFlows)
{
  Random rnd(53);
  for (const Sides &sides : SIDES) {
    Bed bed;
    const Pores pores = random_pores(rnd, sides, 0.5, 1.4, bed);
    std::vector<Vec3> v;
    for (std::size_t i = 0; i < bed.size(); i++) v.push_back(rnd.vector(1.0));
    // no plate closes in on a closed cell
    const bool open = pores.grid.has_fixed_nodes();
    const WallVelocity wall{open ? 0.3 : 0.0, open ? -0.7 : 0.0};
    Field p(pores.grid.nodes(), 0.0);
    solve_darcy(pores, pores.motion(v), wall, {}, 1e-14, p);
    const WallForce on = wall_force(pores.grid, p);
    double power = on.lower * wall.lower + on.upper * wall.upper;
    const std::vector<Vec3> f = pores.forces(p);
    for (std::size_t i = 0; i < v.size(); i++) power += dot(f[i], v[i]);
    const double lost = dissipation(pores.grid, pores.matrix, pores.mobility, {}, p);
    EXPECT_GT(lost, 0.0);
    EXPECT_NEAR(power, -lost, 1e-12 * lost);
  }
}

TEST(PoreStep, ForceThatFindsNoParticlesCompletesTheSum)
{
  // a layer with a free surface between plates
  Random rnd(54);
  Cell c = filled_cell(40, 0.45, {1.0, 1.5, 1.0}, 0.0, 0.0, 0.0);
  const Bed bed = random_bed(rnd, 40, 0.1, c, true, 100);
  c.yprd *= 2.0;
  const Pores pores(grid_of(c, 1.4, Wall::IMPERMEABLE, Wall::DRAINED), LAW, VISCOSITY, bed);
  const Field p = random_field(rnd, pores.grid);
  Vec3 sum = clear_force(pores.grid, LAW, pores.elements, gradients(pores.grid, p));
  EXPECT_GT(norm(sum), 0.1);
  const WallForce wall = wall_force(pores.grid, p);
  sum.y += wall.lower + wall.upper;
  for (const Vec3 &f : pores.forces(p)) sum = sum + f;
  testing_tools::expect_near(sum, {0.0, 0.0, 0.0}, 1e-12);
}

// P - A >= 0, for particles of different masses, dilute parts, and a plate that the pressure moves
TEST(PoreStep, ConstantSolverAndItsLocalFormBoundTheImplicitMatrix)
{
  Random rnd(55);
  for (const Sides &sides : SIDES)
    for (double phi : {0.02, 0.15, 0.55}) {
      Bed bed;
      Pores pores = random_pores(rnd, sides, phi, 1.4, bed);
      for (double &m : pores.mobility) m *= rnd.log_uniform(1e-4, 1.0);
      const Grid &g = pores.grid;
      std::vector<double> inverse;
      for (std::size_t i = 0; i < bed.size(); i++) inverse.push_back(rnd.log_uniform(0.1, 10.0));
      const double dt = 3.0, plate_mass = 20.0;
      const bool moved = sides.lower == Wall::DRAINED && sides.upper == Wall::IMPERMEABLE;
      const auto response = [&](const Field &p, std::vector<Motion> &motion, WallVelocity &wall) {
        std::vector<Vec3> a = pores.forces(p);
        for (std::size_t i = 0; i < a.size(); i++) a[i] = inverse[i] * a[i];
        motion = pores.motion(a);
        if (moved) wall.upper = wall_force(g, p).upper / plate_mass;
      };
      std::vector<double> bound = implicit_mobilities(pores.mobility, pores.bounds(inverse), dt);
      for (double &b : bound) b += moved ? dt * wall_bound(g, plate_mass) : 0.0;
      ConstantSolver solver(g);
      solver.set_cell(g);
      double closest = 1e99;
      for (int trial = 0; trial < 40; trial++) {
        // smooth fields come closest
        Field p = random_field(rnd, g), smooth, a, local;
        set_fixed(g, 0.0, 0.0, p);
        for (int pass = 0; pass < trial % 4; pass++) {
          solver.solve(p, 1.0, 0.0, smooth);
          p = smooth;
        }
        apply_implicit(g, pores.matrix, pores.mobility, dt, 0.0, response, p, a);
        apply_darcy(g, pores.matrix, bound, p, local);
        const double implicit = scalar_product(p, a), of_local = scalar_product(p, local);
        EXPECT_GE(of_local, implicit * (1.0 - 1e-12));
        closest = std::fmin(closest, of_local / implicit);
      }
      EXPECT_GE(closest, 1.0);
    }
}

TEST(PoreStep, BoundIsCloseForSmoothPressures)
{
  Bed bed;
  const Pores pores =
      stack(60, 40, {Closure::CONSTANT, 1e-4, 1.0, 0.1}, Wall::IMPERMEABLE, Wall::DRAINED, bed);
  const std::vector<double> inverse(60, 1.0 / 0.7);
  const auto response = [&](const Field &p, std::vector<Motion> &motion, WallVelocity &) {
    std::vector<Vec3> a = pores.forces(p);
    for (Vec3 &f : a) f = (1.0 / 0.7) * f;
    motion = pores.motion(a);
  };
  Field p, a, b;
  for (int j = 0; j <= 40; j++) p.push_back(std::cos(PI * j / 80.0));
  set_fixed(pores.grid, 0.0, 0.0, p);
  const double dt = 3.0;
  apply_implicit(pores.grid, pores.matrix, pores.mobility, dt, 0.0, response, p, a);
  apply_darcy(pores.grid, pores.matrix,
              implicit_mobilities(pores.mobility, pores.bounds(inverse), dt), p, b);
  EXPECT_NEAR(scalar_product(p, b) / scalar_product(p, a), 1.02, 0.02);
}

TEST(PoreStep, RepeatedStepsEndInDarcysLaw)
{
  // velocities that forces do not change: from any pressure to K p = -D v
  Random rnd(56);
  for (const Sides &sides : SIDES) {
    Bed bed;
    const Pores pores = random_pores(rnd, sides, 0.5, 1.4, bed);
    const std::vector<double> inverse(bed.size(), 0.0);
    LinearRun run(pores, 0.1, inverse);
    for (Vec3 &v : run.v) v = rnd.vector(1.0);
    Field expected(pores.grid.nodes(), 0.0);
    solve_darcy(pores, pores.motion(run.v), {}, {}, 1e-13, expected);
    for (int n = 0; n < 300; n++) run.step(std::vector<Vec3>(bed.size()));
    for (std::size_t n = 0; n < expected.size(); n++)
      EXPECT_NEAR(run.p[n], expected[n], 1e-9 * largest_size(expected));
  }
}

TEST(PoreStep, FullyImplicitStepIsBackwardEulerOfDarcysLaw)
{
  // P = A by conjugate gradients: K p_n+1 + S V (p_n+1 - p_n)/dt + D v_n+1/2 = 0
  Random rnd(57);
  for (const Sides &sides : SIDES)
    for (double storage : {0.0, 0.05}) {
      Bed bed;
      const Pores pores = random_pores(rnd, sides, 0.5, 1.4, bed);
      const Grid &g = pores.grid;
      const double dt = 0.7, s = node_storage(g, storage, dt);
      std::vector<Vec3> v, force;
      std::vector<double> inverse;
      for (std::size_t i = 0; i < bed.size(); i++) {
        v.push_back(rnd.vector(1.0));
        force.push_back(rnd.vector(2.0));
        inverse.push_back(rnd.uniform(0.3, 3.0));
      }
      Field p = random_field(rnd, g);
      std::vector<Vec3> ahead = pores.forces(p);
      for (std::size_t i = 0; i < v.size(); i++)
        ahead[i] = predicted(v[i], force[i], ahead[i], inverse[i], dt);
      const std::vector<Motion> motion = pores.motion(ahead);
      Field r = imbalance(g, pores.matrix, pores.mobility, motion, {}, {}, p);
      project(g, storage > 0.0, r);
      const auto response = [&](const Field &q, std::vector<Motion> &sums, WallVelocity &) {
        std::vector<Vec3> a = pores.forces(q);
        for (std::size_t i = 0; i < a.size(); i++) a[i] = inverse[i] * a[i];
        sums = pores.motion(a);
      };
      const auto apply = [&](const Field &q, Field &y) {
        apply_implicit(g, pores.matrix, pores.mobility, dt, s, response, q, y);
      };
      ConstantSolver solver(g);
      solver.set_cell(g);
      const double c = largest(implicit_mobilities(pores.mobility, pores.bounds(inverse), dt));
      const auto precondition = [&](const Field &q, Field &y) {
        solver.solve(q, c, s, y);
      };
      Field change(g.nodes(), 0.0);
      const Convergence found =
          conjugate_gradients(apply, precondition, same_on_all_ranks, r, 1e-13, 200, change);
      EXPECT_LT(found.iterations, 80);
      Field next(p);
      for (std::size_t n = 0; n < p.size(); n++) next[n] += change[n];
      const std::vector<Vec3> f = pores.forces(next);
      for (std::size_t i = 0; i < v.size(); i++)
        v[i] = predicted(v[i], force[i], f[i], inverse[i], dt);
      Field left = imbalance(g, pores.matrix, pores.mobility, pores.motion(v), {}, {}, next);
      for (int j = 0; j < g.layers(); j++)
        for (int n = 0; n < g.layer_size(); n++)
          left[j * g.layer_size() + n] -= s * node_share(g, j) * change[j * g.layer_size() + n];
      set_fixed(g, 0.0, 0.0, left);
      EXPECT_LT(largest_size(left), 1e-11 * largest_size(r));
    }
}

// Long runs of spheres on springs at 0.9 of the time step of the springs: energy is not gained, but
// that of leapfrog swings.
TEST(PoreStep, IsStableAtTheStepOfTheContactsForEveryDrag)
{
  Random rnd(58);
  const Cell c = filled_cell(50, 0.5, {1.0, 1.2, 0.9}, 0.2, 0.1, 0.0);
  const Bed bed = random_bed(rnd, 50, 0.2, c, false, 100);
  const Springs springs(bed, c, false, 1.25, 1.0);
  const double mass = 0.8, dt = 0.9 * 2.0 / std::sqrt(springs.largest(bed.size(), rnd) / mass);
  const Grid g = grid_of(c, 1.3, Wall::PERIODIC, Wall::PERIODIC);
  for (double drag :
       {1e-2, 1.0, 10.0, 1e2, 1e4, 1e8, 0.0}) {    // dt over the time of decay; 0: k = 0
    Permeability law;
    const double density = mass / bed.volume(0);
    // of the mean closure, which varies between the elements
    const double mean = permeability(law, 0.5, 0.5);
    law.factor = drag > 0.0 ? dt * VISCOSITY / (drag * density * 0.5 * mean) : 0.0;
    const Pores pores(g, law, VISCOSITY, bed);
    LinearRun run(pores, dt, std::vector<double>(bed.size(), 1.0 / mass));
    std::vector<Vec3> u(bed.size());
    double energy = 0.0, largest = 0.0;
    for (Vec3 &v : run.v) {
      v = rnd.vector(1.0);
      energy += 0.5 * mass * dot(v, v);
    }
    for (int n = 0; n < 1500; n++) {
      run.step(springs.forces(u));
      double now = springs.energy(u);
      for (std::size_t i = 0; i < bed.size(); i++) {
        now += 0.5 * mass * dot(run.v[i], run.v[i]);
        u[i] = u[i] + dt * run.v[i];
      }
      largest = std::fmax(largest, now);
      ASSERT_LT(now, 100.0 * energy) << "drag " << drag << ", step " << n;
    }
    EXPECT_LT(largest, 4.0 * energy) << "drag " << drag;
  }
}

TEST(PoreStep, ImpermeableBedDoesNotChangeTheVolumeOfElements)
{
  // k = 0: what K = 0 cannot let out is stopped within a few steps, everything else moves on
  Random rnd(59);
  Bed bed;
  const Pores pores =
      random_pores(rnd, SIDES[1], 0.5, 1.4, bed, {Closure::CONSTANT, 0.0, 1.0, 0.1});
  LinearRun run(pores, 0.1, std::vector<double>(bed.size(), 2.0));
  for (Vec3 &v : run.v) v = rnd.vector(1.0);
  const auto change = [&] {
    Field d = divergence(pores.grid, pores.motion(run.v), {}), smooth;
    run.solver.solve(d, 1.0, 0.0, smooth);
    return scalar_product(d, smooth);
  };
  const double start = change();
  for (int n = 0; n < 400; n++) run.step(std::vector<Vec3>(bed.size()));
  EXPECT_LT(change(), 1e-3 * start);
  double energy = 0.0;
  for (const Vec3 &v : run.v) energy += dot(v, v) / static_cast<double>(bed.size());
  EXPECT_GT(energy, 0.3);    // 1 at the start
}

TEST(PoreStep, ExplicitLimitIsSafeAndNotFarOff)
{
  Random rnd(60);
  Bed bed;
  const Pores pores = random_pores(rnd, SIDES[1], 0.5, 1.4, bed);
  const std::vector<double> inverse(bed.size(), 2.0);
  const double limit = explicit_step(pores.mobility, pores.bounds(inverse));
  const auto growth = [&](double dt) {
    std::vector<Vec3> v;
    for (std::size_t i = 0; i < bed.size(); i++) v.push_back(rnd.vector(1.0));
    double before = 0.0, after = 0.0;
    for (int n = 0; n < 60; n++) {
      Field p(pores.grid.nodes(), 0.0);
      solve_darcy(pores, pores.motion(v), {}, {}, 1e-10, p);
      const std::vector<Vec3> f = pores.forces(p);
      before = after = 0.0;
      for (std::size_t i = 0; i < v.size(); i++) {
        before += dot(v[i], v[i]);
        v[i] = predicted(v[i], {}, f[i], inverse[i], dt);
        after += dot(v[i], v[i]);
      }
    }
    return after / before;
  };
  EXPECT_LE(growth(0.99 * limit), 1.0);
  EXPECT_GT(growth(2.5 * limit), 1.0);
  // the design's number: 2 k rho phi/eta
  const double density = 0.5 / bed.volume(0);
  const double nominal = 2.0 * permeability(LAW, 0.5, 0.5) * density * 0.5 / VISCOSITY;
  EXPECT_LT(limit, nominal);
  EXPECT_GT(limit, 0.25 * nominal);    // the densest element
}

TEST(PoreStep, LayerWithAFreeSurfaceIsStable)
{
  // its upper part fades into clear fluid, which is several hundred times as permeable
  Random rnd(61);
  Cell c = filled_cell(60, 0.5, {1.0, 1.2, 1.0}, 0.0, 0.0, 0.0);
  const Bed bed = random_bed(rnd, 60, 0.2, c, true, 100);
  const Springs springs(bed, c, true, 1.25, 1.0);
  c.yprd *= 1.7;
  const double mass = 0.8, dt = 0.9 * 2.0 / std::sqrt(springs.largest(bed.size(), rnd) / mass);
  for (double factor : {1.0, 1e-4, 1e-8}) {
    const Pores pores(grid_of(c, 1.4, Wall::IMPERMEABLE, Wall::DRAINED),
                      {Closure::BEETSTRA, 0.0, factor, 0.01}, VISCOSITY, bed);
    EXPECT_GT(largest(pores.mobility) / pores.mobility[0], 200.0);
    LinearRun run(pores, dt, std::vector<double>(bed.size(), 1.0 / mass));
    std::vector<Vec3> u(bed.size());
    double start = 0.0;
    for (Vec3 &v : run.v) {
      v = rnd.vector(1.0);
      start += 0.5 * mass * dot(v, v);
    }
    for (int n = 0; n < 1000; n++) {
      run.step(springs.forces(u));
      double now = springs.energy(u);
      for (std::size_t i = 0; i < bed.size(); i++) {
        now += 0.5 * mass * dot(run.v[i], run.v[i]);
        u[i] = u[i] + dt * run.v[i];
      }
      ASSERT_LT(now, 4.0 * start) << factor << ", step " << n;
    }
  }
}

TEST(PoreStep, ConjugateGradientsTakeAContrastOfTenThousand)
{
  Random rnd(62);
  for (const Sides &sides : SIDES) {
    Bed bed;
    Pores pores = random_pores(rnd, sides, 0.5, 1.2, bed);
    for (double &m : pores.mobility) m *= rnd.log_uniform(1e-2, 1e2);
    std::vector<Vec3> v;
    for (std::size_t i = 0; i < bed.size(); i++) v.push_back(rnd.vector(1.0));
    Field p(pores.grid.nodes(), 0.0);
    const Convergence found = solve_darcy(pores, pores.motion(v), {}, {}, 1e-10, p);
    EXPECT_LE(found.residual, 1e-10);
    EXPECT_LT(found.iterations, 120);
  }
}

TEST(PoreStep, EmptyCellsAndSingleParticlesAreNoError)
{
  for (const Sides &sides : SIDES)
    for (int particles : {0, 1, 2}) {
      Grid g;
      g.nx = g.ny = g.nz = 5;
      g.lower = sides.lower;
      g.upper = sides.upper;
      g.cell.xprd = g.cell.yprd = g.cell.zprd = 7.5;
      Bed bed;
      for (int n = 0; n < particles; n++) {
        bed.x.push_back({3.0 + n, 3.3, 4.2});
        bed.radius.push_back(0.5);
      }
      const Pores pores(g, LAW, VISCOSITY, bed);
      LinearRun run(pores, 0.1, std::vector<double>(bed.size(), 2.0));
      for (Vec3 &v : run.v) v = {1.0, 0.5, 0.0};
      for (int n = 0; n < 50; n++) run.step(std::vector<Vec3>(bed.size()));
      EXPECT_TRUE(std::isfinite(largest_size(run.p)));
      for (const Vec3 &v : run.v) EXPECT_LE(norm(v), 1.2);
    }
}

}    // namespace

#endif
