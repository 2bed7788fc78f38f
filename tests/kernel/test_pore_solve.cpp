// The solver with one permeability is exact, for all boundaries and cells.

#ifdef SUSPENSION_FFTW

#include "pore_case.h"
#include "pore_solve.h"

using namespace pore_case;

namespace {

Grid any_grid(Random &rnd, const Sides &sides, int nx, int ny, int nz)
{
  Grid g;
  g.nx = nx;
  g.ny = ny;
  g.nz = nz;
  g.lower = sides.lower;
  g.upper = sides.upper;
  g.cell = {{},
            rnd.uniform(0.5, 2.0) * nx,
            rnd.uniform(0.5, 2.0) * ny,
            rnd.uniform(0.5, 2.0) * nz,
            0.0,
            0.0,
            0.0};
  g.cell.xz = rnd.uniform(-0.5, 0.5) * g.cell.xprd;
  if (!g.has_plates()) {
    g.cell.xy = rnd.uniform(-0.5, 0.5) * g.cell.xprd;
    g.cell.yz = rnd.uniform(-0.5, 0.5) * g.cell.yprd;
  }
  return g;
}

constexpr int SIZES[][3] = {{6, 7, 5}, {8, 4, 4}, {1, 9, 1}, {2, 2, 3},
                            {5, 1, 1}, {3, 6, 1}, {1, 1, 1}};

// c K1 p + s p
Field apply_constant(const Grid &g, double c, double s, const Field &p)
{
  Field y;
  apply_darcy(g, element_matrix(g), std::vector<double>(g.elements(), c), p, y);
  for (int j = 0; j < g.layers(); j++)
    for (int n = 0; n < g.layer_size(); n++)
      y[j * g.layer_size() + n] += s * node_share(g, j) * p[j * g.layer_size() + n];
  return y;
}

TEST(PoreSolver, InvertsTheMatrixExactly)
{
  Random rnd(31);
  for (const Sides &sides : SIDES)
    for (const auto &n : SIZES)
      for (double s : {0.0, 0.3}) {
        Grid g = any_grid(rnd, sides, n[0], n[1], n[2]);
        ConstantSolver solver(g);
        for (int trial = 0; trial < 3; trial++) {
          solver.set_cell(g);
          Field r = random_field(rnd, g), p;
          project(g, s > 0.0, r);
          solver.solve(r, 0.7, s, p);
          Field y = apply_constant(g, 0.7, s, p);
          set_fixed(g, 0.0, 0.0, y);
          const double diagonal = 8.0 * element_matrix(g).value[0][0] + s;
          const double rounding = 2e-15 * std::fmax(1.0, diagonal * largest_size(p));
          for (std::size_t k = 0; k < r.size(); k++)
            EXPECT_NEAR(y[k], r[k], rounding) << n[0] << n[1] << n[2];
          Field edges = p;
          set_fixed(g, 0.0, 0.0, edges);
          EXPECT_EQ(edges, p);    // 0 where the pressure is given
          if (!g.has_fixed_nodes() && s == 0.0) {
            EXPECT_NEAR(mean_pressure(g, p), 0.0, 1e-14 * (1.0 + largest_size(p)));
          }
          g = any_grid(rnd, sides, n[0], n[1], n[2]);    // the cell has moved
        }
      }
}

TEST(PoreSolver, LeavesOutWhatHasNoSolution)
{
  Random rnd(32);
  for (const Sides &sides : {SIDES[0], SIDES[4]}) {
    const Grid g = any_grid(rnd, sides, 4, 5, 3);
    ConstantSolver solver(g);
    solver.set_cell(g);
    Field r = random_field(rnd, g), p, q;
    solver.solve(r, 2.0, 0.0, p);
    project(g, false, r);
    solver.solve(r, 2.0, 0.0, q);
    for (std::size_t n = 0; n < p.size(); n++) EXPECT_NEAR(p[n], q[n], 1e-14);
  }
}

TEST(PoreSolver, NothingToSolveIsZero)
{
  Random rnd(33);
  const Grid g = any_grid(rnd, SIDES[1], 3, 3, 3);
  ConstantSolver solver(g);
  solver.set_cell(g);
  Field p;
  solver.solve(random_field(rnd, g), 0.0, 0.0, p);
  EXPECT_EQ(largest_size(p), 0.0);
}

TEST(PoreSolver, GivesTheSameEachTime)
{
  Random rnd(34);
  const Grid g = any_grid(rnd, SIDES[1], 8, 9, 5);
  const Field r = random_field(rnd, g);
  Field first;
  for (int trial = 0; trial < 4; trial++) {
    ConstantSolver solver(g);
    solver.set_cell(g);
    Field p;
    solver.solve(r, 1.3, 0.0, p);
    if (trial == 0) first = p;
    EXPECT_EQ(p, first);
  }
}

}    // namespace

#endif
