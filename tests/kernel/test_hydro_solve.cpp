// Stokes flow on the points of a periodic cell.

#include "hydro_case.h"

#ifdef SUSPENSION_FFTW

using namespace hydro_case;

namespace {

const Points POINTS = {8, 6, 10};
constexpr double ETA = 0.7;

Cell tilted_cell()
{
  return {{1.0, 2.0, -3.0}, 3.0, 4.0, 5.0, 1.2, -0.7, 0.9};
}

// all ranks, from forces of the whole grid to velocities
std::vector<double> solve(const Cell &cell, const std::vector<double> &forces, int ranks)
{
  std::vector<std::unique_ptr<StokesSolver>> solvers;
  const std::size_t all = forces.size() / 3;
  for (int r = 0; r < ranks; r++) {
    solvers.push_back(std::make_unique<StokesSolver>(POINTS, r, ranks));
    StokesSolver &s = *solvers.back();
    const std::size_t from = static_cast<std::size_t>(s.layers().first) * POINTS[0] * POINTS[1];
    for (int c = 0; c < 3; c++)
      std::copy_n(&forces[c * all] + from, s.points(), s.field() + c * s.points());
    s.set_response(cell, [](const WaveVector &wave) {
      return stokes_factors(wave, ETA);
    });
    s.to_waves();
  }
  exchange_of_ranks(solvers, &StokesSolver::of_forces);
  for (const auto &s : solvers) s->respond();
  exchange_of_ranks(solvers, &StokesSolver::of_waves);
  std::vector<double> u(forces.size());
  for (const auto &s : solvers) {
    s->to_velocities();
    const std::size_t from = static_cast<std::size_t>(s->layers().first) * POINTS[0] * POINTS[1];
    for (int c = 0; c < 3; c++)
      std::copy_n(s->field() + c * s->points(), s->points(), &u[c * all] + from);
  }
  return u;
}

// of a wave of the cell with these numbers along its edges
struct Wave {
  int m[3];
  Vec3 k;    // by solving k.edge = 2 pi m
  Wave(const Cell &c, int a, int b, int d) : m{a, b, d}
  {
    const Vec3 e1{c.xprd, 0.0, 0.0}, e2{c.xy, c.yprd, 0.0}, e3{c.xz, c.yz, c.zprd};
    const double scale = 2.0 * PI_ / dot(e1, cross(e2, e3));
    k = scale * (a * cross(e2, e3) + b * cross(e3, e1) + d * cross(e1, e2));
  }
  double phase(int i, int j, int l) const
  {
    return 2.0 * PI_ *
        (static_cast<double>(m[0] * i) / POINTS[0] + static_cast<double>(m[1] * j) / POINTS[1] +
         static_cast<double>(m[2] * l) / POINTS[2]);
  }
};

std::vector<double> wave_field(const Wave &w, const Vec3 &cosine, const Vec3 &sine)
{
  const std::size_t all = 8 * 6 * 10;
  std::vector<double> f(3 * all);
  std::size_t n = 0;
  for (int l = 0; l < 10; l++)
    for (int j = 0; j < 6; j++)
      for (int i = 0; i < 8; i++, n++) {
        const double c = std::cos(w.phase(i, j, l)), s = std::sin(w.phase(i, j, l));
        f[n] = c * cosine.x + s * sine.x;
        f[n + all] = c * cosine.y + s * sine.y;
        f[n + 2 * all] = c * cosine.z + s * sine.z;
      }
  return f;
}

TEST(HydroSolve, WavesOfADeformedCell)
{
  Random rnd(31);
  const Cell cell = tilted_cell();
  const int waves[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, -1, 3}, {-3, 2, -4}, {0, -2, 1}};
  for (const auto &m : waves) {
    const Wave w(cell, m[0], m[1], m[2]);
    const Vec3 cosine = rnd.vector(1.0), sine = rnd.vector(1.0);
    const auto response = [&](const Vec3 &f) {
      const double k2 = dot(w.k, w.k);
      return 1.0 / (ETA * k2) * (f - (dot(w.k, f) / k2) * w.k);
    };
    const auto expected = wave_field(w, response(cosine), response(sine));
    const auto found = solve(cell, wave_field(w, cosine, sine), 1);
    for (std::size_t n = 0; n < found.size(); n++) EXPECT_NEAR(found[n], expected[n], 1e-14);
  }
}

TEST(HydroSolve, ConstantsAndShortestWavesAreLeftOut)
{
  const Vec3 one{1.0, 2.0, 3.0};
  const int waves[][3] = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {0, 2, 5}};
  for (const auto &m : waves)
    for (const double u :
         solve(tilted_cell(), wave_field(Wave(tilted_cell(), m[0], m[1], m[2]), one, {}), 1))
      EXPECT_NEAR(u, 0.0, 1e-14);
}

// any factors across and along the wave vector
TEST(HydroSolve, FactorsOfAWave)
{
  const Wave w(tilted_cell(), 2, -1, 3);
  Random rnd(33);
  const Vec3 cosine = rnd.vector(1.0), sine = rnd.vector(1.0);
  StokesSolver s(POINTS, 0, 1);
  s.set_response(tilted_cell(), [&](const WaveVector &wave) {
    if (wave.number[0] == 2 && wave.number[1] == -1 && wave.number[2] == 3) {
      EXPECT_LT(norm(wave.k - w.k), 1e-13);
      EXPECT_NEAR(wave.square, dot(w.k, w.k), 1e-13);
    }
    return WaveFactors{0.3, -2.0};
  });
  const auto response = [&](const Vec3 &f) {
    const Vec3 along = dot(w.k, f) / dot(w.k, w.k) * w.k;
    return 480.0 * (0.3 * (f - along) - 2.0 * along);
  };
  const auto forces = wave_field(w, cosine, sine);
  std::copy(forces.begin(), forces.end(), s.field());
  s.to_waves();
  s.exchange_alone();
  s.respond();
  s.exchange_alone();
  s.to_velocities();
  const auto expected = wave_field(w, response(cosine), response(sine));
  for (std::size_t n = 0; n < expected.size(); n++)
    EXPECT_NEAR(s.field()[n], expected[n] / 480.0, 1e-13);
}

// f and its companion g stand for f + lap g; so does the response
TEST(HydroSolve, Companion)
{
  const Wave w(tilted_cell(), 2, -1, 3);
  const double square = dot(w.k, w.k);
  Random rnd(34);
  const Vec3 f = rnd.vector(1.0), g = rnd.vector(1.0), force = f - square * g;
  StokesSolver s(POINTS, 0, 1, WITH_COMPANION);
  s.set_response(tilted_cell(), [](const WaveVector &wave) {
    return stokes_factors(wave, ETA);
  });
  const auto plain = wave_field(w, f, {}), companion = wave_field(w, g, {});
  std::copy(plain.begin(), plain.end(), s.field());
  std::copy(companion.begin(), companion.end(), s.field() + 3 * 480);
  s.to_waves();
  s.exchange_alone();
  s.respond();
  s.exchange_alone();
  s.to_velocities();
  const Vec3 u = 1.0 / (ETA * square) * (force - (dot(w.k, force) / square) * w.k);
  const auto velocity = wave_field(w, u, {}), lap = wave_field(w, -square * u, {});
  for (std::size_t n = 0; n < velocity.size(); n++) {
    EXPECT_NEAR(s.field()[n], velocity[n], 1e-13);
    EXPECT_NEAR(s.field()[n + 3 * 480], lap[n], 1e-13);
  }
}

// as many as there are layers, and more: some have none
TEST(HydroSolve, RanksShareTheGrid)
{
  Random rnd(32);
  std::vector<double> f(3 * 480);
  for (double &value : f) value = rnd.uniform(-1.0, 1.0);
  const auto one = solve(tilted_cell(), f, 1);
  for (const int ranks : {2, 3, 13}) {
    const auto several = solve(tilted_cell(), f, ranks);
    for (std::size_t n = 0; n < one.size(); n++) EXPECT_NEAR(several[n], one[n], 1e-14);
  }
}

}    // namespace

#endif
