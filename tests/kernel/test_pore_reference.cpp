// A whole step against an independent one: full matrices of a general mesh, by NumPy and SciPy.

#ifdef SUSPENSION_FFTW

#include "pore_run.h"

using namespace pore_case;

namespace {

#include "reference/pore_reference.h"

constexpr double TOLERANCE = 1e-10;

struct Case {
  Bed bed;
  std::vector<double> inverse_mass;
  std::vector<Vec3> v, force;
  Pores pores;

  explicit Case(const PoreCase &c) :
      bed(spheres(c)),
      pores(Grid{c.nx, c.ny, c.nz, c.lower, c.upper, c.cell},
            {c.kozeny ? Closure::KOZENY : Closure::BEETSTRA, 0.0, 1.0, 0.1}, PORE_VISCOSITY, bed)
  {
    for (std::size_t n = 0; n < c.particles.size(); n += 11) {
      const double *row = &c.particles[n];
      inverse_mass.push_back(1.0 / row[4]);
      v.push_back({row[5], row[6], row[7]});
      force.push_back({row[8], row[9], row[10]});
    }
  }
  static Bed spheres(const PoreCase &c)
  {
    Bed bed;
    for (std::size_t n = 0; n < c.particles.size(); n += 11) {
      bed.x.push_back({c.particles[n], c.particles[n + 1], c.particles[n + 2]});
      bed.radius.push_back(c.particles[n + 3]);
    }
    return bed;
  }
};

void expect_same(const std::vector<double> &found, const std::vector<double> &expected)
{
  ASSERT_EQ(found.size(), expected.size());
  double scale = 0.0;
  for (double value : expected) scale = std::fmax(scale, std::fabs(value));
  for (std::size_t n = 0; n < found.size(); n++)
    EXPECT_NEAR(found[n], expected[n], TOLERANCE * scale) << n;
}

TEST(PoreReference, ElementsAndBounds)
{
  for (const PoreCase &c : PORE_CASES) {
    SCOPED_TRACE(c.name);
    const Case one(c);
    std::vector<double> phi;
    for (const Element &e : one.pores.elements) phi.push_back(e.phi);
    expect_same(phi, c.phi);
    expect_same(one.pores.mobility, c.mobility);
    expect_same(one.pores.bounds(one.inverse_mass), c.bound);
  }
}

TEST(PoreReference, Step)
{
  for (const PoreCase &c : PORE_CASES) {
    SCOPED_TRACE(c.name);
    const Case one(c);
    const Grid &g = one.pores.grid;
    std::vector<Vec3> ahead = one.pores.forces(c.p, PORE_SLOPE);
    for (std::size_t i = 0; i < ahead.size(); i++)
      ahead[i] = predicted(one.v[i], one.force[i], ahead[i], one.inverse_mass[i], PORE_DT);
    const std::vector<Motion> motion = one.pores.motion(ahead);
    Field r = imbalance(g, one.pores.matrix, one.pores.mobility, motion, c.walls, PORE_SLOPE, c.p);
    project(g, false, r);
    ConstantSolver solver(g);
    solver.set_cell(g);
    Field p;
    solver.solve(r,
                 largest(implicit_mobilities(one.pores.mobility, one.pores.bounds(one.inverse_mass),
                                             PORE_DT)),
                 0.0, p);
    for (std::size_t n = 0; n < p.size(); n++) p[n] += c.p[n];
    expect_same(p, c.p_next);
    std::vector<double> forces;
    for (const Vec3 &f : one.pores.forces(p, PORE_SLOPE)) {
      forces.push_back(f.x);
      forces.push_back(f.y);
      forces.push_back(f.z);
    }
    expect_same(forces, c.forces);
  }
}

TEST(PoreReference, DarcysLaw)
{
  for (const PoreCase &c : PORE_CASES) {
    SCOPED_TRACE(c.name);
    const Case one(c);
    Field p(c.p.size(), 0.0);
    set_fixed(one.pores.grid, 0.5, -0.25, p);
    solve_darcy(one.pores, one.pores.motion(one.v), c.walls, PORE_SLOPE, 1e-14, p);
    expect_same(p, c.darcy);
  }
}

}    // namespace

#endif
