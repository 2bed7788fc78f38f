// Elements of the pore pressure: exact for linear pressures and motions, symmetric, forces adjoint.

#include "pore_case.h"

using namespace pore_case;

namespace {

const Permeability LAW;
constexpr double VISCOSITY = 0.6;

Pores random_pores(Random &rnd, const Sides &sides, Bed &bed, const Permeability &law = LAW)
{
  const bool plates = sides.lower != Wall::PERIODIC;
  const Cell c =
      filled_cell(70, 0.5, {1.0, 1.3, 0.9}, plates ? 0.0 : 0.4, 0.2, plates ? 0.0 : -0.3);
  bed = random_bed(rnd, 70, 0.2, c, plates, 100);
  return Pores(grid_of(c, 1.3, sides.lower, sides.upper), law, VISCOSITY, bed);
}

TEST(PoreElement, MatrixOfACubeIsTheKnownOne)
{
  // trilinear Laplacian of a cube of edge h over h: 1/3, 0 to the next corner, -1/12, -1/12
  Grid g;
  g.nx = g.ny = g.nz = 2;
  g.cell.xprd = g.cell.yprd = g.cell.zprd = 3.0;
  const ElementMatrix m = element_matrix(g);
  const double h = 1.5, known[4] = {1.0 / 3.0, 0.0, -1.0 / 12.0, -1.0 / 12.0};
  for (int c = 0; c < CORNERS; c++)
    for (int d = 0; d < CORNERS; d++) {
      const int bits = c ^ d;
      EXPECT_NEAR(m.value[c][d], h * known[(bits & 1) + ((bits >> 1) & 1) + (bits >> 2)], 1e-15);
    }
}

TEST(PoreElement, EnergyOfALinearPressureIsExactInAnyParallelepiped)
{
  Random rnd(21);
  for (int trial = 0; trial < 20; trial++) {
    Grid g;
    g.cell = {{},
              rnd.uniform(0.5, 2.0),
              rnd.uniform(0.5, 2.0),
              rnd.uniform(0.5, 2.0),
              rnd.uniform(-1.0, 1.0),
              rnd.uniform(-1.0, 1.0),
              rnd.uniform(-1.0, 1.0)};
    const Cell &c = g.cell;
    const ElementMatrix m = element_matrix(g);
    const Vec3 slope = rnd.vector(1.0);
    double p[CORNERS], energy = 0.0;
    for (int n = 0; n < CORNERS; n++) {
      const double x = n & 1, y = (n >> 1) & 1, z = n >> 2;
      p[n] = dot(slope, {x * c.xprd + y * c.xy + z * c.xz, y * c.yprd + z * c.yz, z * c.zprd});
    }
    for (int n = 0; n < CORNERS; n++)
      for (int k = 0; k < CORNERS; k++) energy += p[n] * m.value[n][k] * p[k];
    EXPECT_NEAR(energy, g.volume() * dot(slope, slope), 1e-13);
  }
}

TEST(PoreOperator, DarcyIsSymmetricAndPositive)
{
  Random rnd(22);
  for (const Sides &sides : SIDES) {
    Bed bed;
    Pores pores = random_pores(rnd, sides, bed);
    for (double &m : pores.mobility) m *= rnd.log_uniform(1e-2, 1e2);    // contrast 1e4
    const Field constant(pores.grid.nodes(), 1.0);
    EXPECT_LT(largest_size(pores.darcy(constant)), 1e-13 * largest(pores.mobility));
    for (int trial = 0; trial < 10; trial++) {
      const Field p = random_field(rnd, pores.grid), q = random_field(rnd, pores.grid);
      const Field kp = pores.darcy(p), kq = pores.darcy(q);
      EXPECT_NEAR(scalar_product(q, kp), scalar_product(p, kq), 1e-12 * scalar_product(p, kp));
      EXPECT_GT(scalar_product(p, kp), 0.0);
    }
  }
}

TEST(PoreOperator, CheckerboardHasEnergy)
{
  // the gradients at the centers do not see it, K does
  Grid g;
  g.nx = g.ny = g.nz = 4;
  g.cell.xprd = g.cell.yprd = g.cell.zprd = 4.0;
  Field p(g.nodes()), y;
  for (int j = 0; j < 4; j++)
    for (int k = 0; k < 4; k++)
      for (int i = 0; i < 4; i++) p[g.index(i, j, k)] = (i + j + k) % 2 ? 1.0 : -1.0;
  for (const Vec3 &slope : gradients(g, p)) EXPECT_EQ(norm(slope), 0.0);
  apply_darcy(g, element_matrix(g), std::vector<double>(g.elements(), 1.0), p, y);
  EXPECT_GT(scalar_product(p, y), 64.0);
}

TEST(PoreOperator, AffineMotionHasItsOwnDivergence)
{
  Random rnd(24);
  for (const Sides &sides : SIDES) {
    if (sides.lower == Wall::PERIODIC) continue;
    Bed bed;
    const Pores pores = random_pores(rnd, sides, bed);
    const Grid &g = pores.grid;
    // shear between the plates, and dilation at the rate e with them
    const double e = 0.7, y0 = g.cell.origin.y, y1 = y0 + g.cell.yprd;
    std::vector<Vec3> shear, dilation;
    for (const Vec3 &x : bed.x) {
      shear.push_back({2.0 * x.y - 1.0, 0.0, 0.4 * x.y});
      dilation.push_back({1.3 * x.y, e * x.y, 0.0});
    }
    EXPECT_LT(largest_size(divergence(g, pores.motion(shear), {})), 1e-12);
    const Field d = divergence(g, pores.motion(dilation), {e * y0, e * y1});
    for (int j = 0; j < g.layers(); j++)
      for (int n = 0; n < g.layer_size(); n++)
        EXPECT_NEAR(d[j * g.layer_size() + n], e * node_share(g, j) * g.element_volume(), 1e-12);
  }
}

// velocities linear in the position, taken at each image, in tilted cells: rates that keep the
// volume
TEST(PoreOperator, AffineMotionWithoutChangeOfVolumeHasNoDivergenceInTiltedCells)
{
  Random rnd(25);
  for (double tilt : {0.0, 0.5}) {
    const Cell c = filled_cell(70, 0.5, {1.0, 1.3, 0.9}, tilt, 0.3 * tilt, -0.2 * tilt);
    const Bed bed = random_bed(rnd, 70, 0.1, c, false, 100);
    const Pores pores(grid_of(c, 1.3, Wall::PERIODIC, Wall::PERIODIC), LAW, VISCOSITY, bed);
    const Grid &g = pores.grid;
    const Vec3 row[3] = {{0.4, 1.1, -0.3}, {0.2, -0.9, 0.6}, {-1.2, 0.5, 0.5}};    // trace 0
    std::vector<Motion> motion(g.elements());
    for (std::size_t i = 0; i < bed.size(); i++) {
      for_each_reached(g, bed.x[i], [&](int e, int r, int a, const Vec3 &d) {
        const int ex = e % g.nx, ez = e / g.nx % g.nz, ey = e / (g.nx * g.nz);
        const Vec3 x = center(g, ex, ey, ez) +
            Vec3{d.x * c.xprd / g.nx + d.y * c.xy / g.ny + d.z * c.xz / g.nz,
                 d.y * c.yprd / g.ny + d.z * c.yz / g.nz, d.z * c.zprd / g.nz};
        const Vec3 v{dot(row[0], x), dot(row[1], x), dot(row[2], x)};
        add_to(motion[e].velocity, pores.stencils[i].weight[r][a], {v});
      });
    }
    // around the cell the velocity jumps: inner nodes only
    const Field y = divergence(g, motion, {});
    for (int j = 1; j < g.ny; j++)
      for (int k = 1; k < g.nz; k++)
        for (int i = 1; i < g.nx; i++) EXPECT_NEAR(y[g.index(i, j, k)], 0.0, 1e-12);
  }
}

TEST(PoreOperator, ForcesAreTheAdjointOfTheDivergence)
{
  Random rnd(26);
  for (const Sides &sides : SIDES) {
    Bed bed;
    const Pores pores = random_pores(rnd, sides, bed);
    for (int trial = 0; trial < 5; trial++) {
      const Field p = random_field(rnd, pores.grid);
      const std::vector<Vec3> f = pores.forces(p);
      const WallForce wall = wall_force(pores.grid, p);
      const WallVelocity plate{rnd.uniform(-1.0, 1.0), rnd.uniform(-1.0, 1.0)};
      std::vector<Vec3> v;
      double power = wall.lower * plate.lower + wall.upper * plate.upper, scale = 0.0;
      for (const Vec3 &force : f) {
        v.push_back(rnd.vector(1.0));
        power += dot(force, v.back());
        scale += norm(force);
      }
      const Field d = divergence(pores.grid, pores.motion(v), plate);
      EXPECT_NEAR(power, scalar_product(p, d), 1e-13 * scale);
    }
  }
}

TEST(PoreOperator, ForcesOnParticlesAndPlatesAddUpToZero)
{
  Random rnd(27);
  for (const Sides &sides : SIDES) {
    Bed bed;
    const Pores pores = random_pores(rnd, sides, bed);
    const Field p = random_field(rnd, pores.grid);
    const WallForce wall = wall_force(pores.grid, p);
    Vec3 sum{0.0, wall.lower + wall.upper, 0.0};
    double scale = 0.0;
    for (const Vec3 &f : pores.forces(p)) {
      sum = sum + f;
      scale += norm(f);
    }
    testing_tools::expect_near(sum, {0.0, 0.0, 0.0}, 1e-13 * scale);
  }
}

TEST(PoreOperator, PressureOfFreeSpheresIsBuoyancyOverTheSolidFraction)
{
  // uniform gradient: the forces on all, per volume of the cell, are the gradient
  Random rnd(28);
  Bed bed;
  const Pores pores = random_pores(rnd, SIDES[0], bed);
  const Vec3 slope{0.3, -0.2, 0.9};
  Vec3 sum;
  double largest_error = 0.0;
  const std::vector<Vec3> f = pores.forces(Field(pores.grid.nodes(), 4.0), slope);
  for (std::size_t i = 0; i < f.size(); i++) {
    sum = sum + f[i];
    const Vec3 alone = (-bed.volume(i) / 0.5) * slope;
    largest_error = std::fmax(largest_error, norm(f[i] - alone) / norm(alone));
  }
  testing_tools::expect_near((1.0 / pores.grid.volume()) * sum, -1.0 * slope, 1e-13);
  EXPECT_LT(largest_error, 0.35);    // phi of elements differs
}

TEST(PoreOperator, MeanOfAnElementIsThatOfItsTrilinearPressure)
{
  Random rnd(29);
  Bed bed;
  const Pores pores = random_pores(rnd, SIDES[1], bed);
  const Field p = random_field(rnd, pores.grid);
  const std::vector<double> means = element_means(pores.grid, p);
  const double gauss[2] = {0.5 - std::sqrt(1.0 / 12.0), 0.5 + std::sqrt(1.0 / 12.0)};
  for_each_element(pores.grid, [&](int e, const int *corner) {
    double sum = 0.0;
    for (double x : gauss)
      for (double y : gauss)
        for (double z : gauss)
          for (int c = 0; c < CORNERS; c++)
            sum += 0.125 * p[corner[c]] * (c & 1 ? x : 1.0 - x) * (c & 2 ? y : 1.0 - y) *
                (c & 4 ? z : 1.0 - z);
    EXPECT_NEAR(means[e], sum, 1e-14);
  });
}

TEST(PoreOperator, ParticlesShareThePressureAndItsFirstMoment)
{
  Random rnd(30);
  for (const Sides &sides : SIDES) {
    Bed bed;
    const Pores pores = random_pores(rnd, sides, bed);
    const Grid &g = pores.grid;
    const Field p = random_field(rnd, g);
    std::vector<double> integrals = element_means(g, p);
    for (double &value : integrals) value *= g.element_volume();
    double sum = 0.0, moment = 0.0, of_elements = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < bed.size(); i++) {
      const double share = share_of(pores.stencils[i], integrals);
      sum += share;
      moment += share * bed.x[i].y;
      scale += std::fabs(share);
    }
    EXPECT_NEAR(sum, mean_pressure(g, p) * g.volume(), 1e-13 * scale);
    if (!g.has_plates()) continue;    // where y is not periodic
    for (int j = 0; j < g.ny; j++)
      for (int n = 0; n < g.layer_size(); n++)
        of_elements += integrals[j * g.layer_size() + n] * center(g, 0, j, 0).y;
    EXPECT_NEAR(moment, of_elements, 1e-12 * scale);
  }
}

TEST(PoreOperator, ClearFluidSharesWithNobody)
{
  // a single sphere, phi_min not reached: its own volume over that part of the elements
  Bed bed;
  bed.x = {{1.7, 2.2, 0.4}};
  bed.radius = {0.5};
  Grid g;
  g.nx = g.ny = g.nz = 3;
  g.cell.xprd = g.cell.yprd = g.cell.zprd = 4.5;
  const Pores pores(g, LAW, VISCOSITY, bed);
  const std::vector<double> integrals(g.elements(), 2.0 * g.element_volume());
  EXPECT_NEAR(share_of(pores.stencils[0], integrals), 2.0 * bed.volume(0) / LAW.phi_min, 1e-13);
}

TEST(PoreOperator, WallsPushOutwards)
{
  Grid g;
  g.nx = g.nz = 2;
  g.ny = 3;
  g.lower = Wall::IMPERMEABLE;
  g.upper = Wall::DRAINED;
  g.cell = {{}, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0};
  Field p(g.nodes(), 5.0);
  set_fixed(g, 7.0, 2.0, p);
  const WallForce f = wall_force(g, p);
  EXPECT_DOUBLE_EQ(f.lower, -40.0);    // impermeable: not set
  EXPECT_DOUBLE_EQ(f.upper, 16.0);
  EXPECT_DOUBLE_EQ(mean_pressure(g, p), (2.5 + 5.0 + 5.0 + 1.0) / 3.0);
}

}    // namespace
