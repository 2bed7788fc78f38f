// Terzaghi's consolidation of a stack of spheres under a load, on a drained top and an impermeable
// bottom, coupled at the time step of the contacts: pressure at the bottom and settlement in time.

#ifdef SUSPENSION_FFTW

#include "pore_run.h"

using namespace pore_case;

namespace {

// K. Terzaghi (1925), by the series of his solution; T = cv t/H^2
struct Terzaghi {
  double pressure, settlement;
};

Terzaghi terzaghi(double T)
{
  Terzaghi sum{0.0, 1.0};
  for (int m = 0; m < 400; m++) {
    const double M = (m + 0.5) * PI, decay = std::exp(-M * M * T);
    sum.pressure += 2.0 * (m % 2 ? -1.0 : 1.0) / M * decay;
    sum.settlement -= 2.0 / (M * M) * decay;
  }
  return sum;
}

TEST(PoreConsolidation, SeriesIsThatOfTheTable)
{
  EXPECT_NEAR(terzaghi(0.02).settlement, 0.159577, 1e-6);
  EXPECT_NEAR(terzaghi(0.1).pressure, 0.949305, 1e-6);
  EXPECT_NEAR(terzaghi(1.0).settlement, 0.931260, 1e-6);
  EXPECT_NEAR(terzaghi(2.0).pressure, 0.009157, 1e-6);
}

struct Errors {
  double pressure = 0.0, settlement = 0.0;
};

void keep_larger(double &error, double next)
{
  if (!(next <= error)) error = next;    // what is not a number stays, too
}

// spheres of diameter 1, springs kn, 2 kn at the walls: E = kn/d; drag: dt over the time of decay
// by it
Errors consolidate(int spheres, double h, double k, double drag, double until)
{
  const double kn = 1.0, mass = 1.0, load = 1.0, H = spheres;
  // springs of a long chain: at most 4 kn/m
  const double dt = 0.9 * std::sqrt(mass / kn);
  const double phi = PI / 6.0, density = mass / phi;    // of the sphere: mass over pi/6
  const double viscosity = drag * k * density * phi / dt;
  Grid g;
  g.ny = static_cast<int>(std::round(H / h));
  g.lower = Wall::IMPERMEABLE;
  g.upper = Wall::DRAINED;
  g.cell.yprd = H;
  Bed bed;
  for (int n = 0; n < spheres; n++) {
    bed.x.push_back({0.5, n + 0.5, 0.5});
    bed.radius.push_back(0.5);
  }
  const Pores pores(g, {Closure::CONSTANT, k, 1.0, 0.1}, viscosity, bed);
  LinearRun run(pores, dt, std::vector<double>(bed.size(), 1.0 / mass));

  const double cv = k * kn / viscosity, final_settlement = load * H / kn;
  std::vector<double> u(bed.size(), 0.0);
  std::vector<Vec3> f(bed.size());
  Errors errors;
  for (int n = 1; cv * n * dt / (H * H) < until; n++) {
    for (std::size_t i = 0; i < u.size(); i++) {
      const double below = i > 0 ? kn * (u[i - 1] - u[i]) : -2.0 * kn * u[0];
      const double above = i + 1 < u.size() ? kn * (u[i + 1] - u[i]) : -load;
      f[i] = {0.0, below + above, 0.0};
    }
    // positions of the time t
    const double T = cv * (n - 1) * dt / (H * H);
    run.step(f);
    if (T > 0.02) {
      const Terzaghi exact = terzaghi(T);
      const double settled = (-u.back() + load / (2.0 * kn)) / final_settlement;
      keep_larger(errors.pressure, std::fabs(run.p[0] - exact.pressure));
      keep_larger(errors.settlement, std::fabs(settled - exact.settlement));
    }
    for (std::size_t i = 0; i < u.size(); i++) u[i] += dt * run.v[i].y;
  }
  return errors;
}

// dt over the time of decay by the drag is 124: two decades above the limit of explicit coupling
TEST(PoreConsolidation, StackOfTwentySpheresFollowsTerzaghi)
{
  const struct {
    double h, pressure, settlement;
  } table[] = {{1.0, 0.0005, 0.001}, {1.5, 0.004, 0.0005}, {2.0, 0.008, 0.0005}};
  for (const auto &row : table) {
    const Errors e = consolidate(20, row.h, 1e-3, 124.0, 0.2);
    EXPECT_LT(e.pressure, row.pressure) << row.h;
    EXPECT_LT(e.settlement, row.settlement) << row.h;
  }
}

TEST(PoreConsolidation, ErrorsFallWithTheHeight)
{
  const Errors e = consolidate(40, 1.5, 1e-3, 60.0, 0.15);
  EXPECT_LT(e.pressure, 0.001);
  EXPECT_LT(e.settlement, 0.0001);
}

TEST(PoreConsolidation, DoesNotDependOnThePermeabilityButForTime)
{
  const Errors a = consolidate(20, 1.0, 1e-3, 60.0, 0.1), b = consolidate(20, 1.0, 1e-5, 60.0, 0.1);
  EXPECT_NEAR(a.pressure, b.pressure, 1e-9);
  EXPECT_NEAR(a.settlement, b.settlement, 1e-9);
}

}    // namespace

#endif
