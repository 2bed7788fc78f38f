// Shows that nothing divides by zero, overflows or has no value on the way to a force, so that a
// LAMMPS that traps floating-point exceptions (-DLAMMPS_TRAP_FPE) runs: lanes without a pair, lanes
// whose step is not usual, and pairs by themselves.

#include "batch_case.h"
#include "fluid_drag.h"
#include "lubcontact_power.h"
#include "rheometer_flow.h"
#include "rheometer_plate.h"

#include <cfenv>
#include <vector>

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

namespace {

// What a trap would catch, since the last call.
std::string exceptions()
{
  std::string all;
  if (std::fetestexcept(FE_DIVBYZERO)) all += "division by zero, ";
  if (std::fetestexcept(FE_INVALID)) all += "invalid operation, ";
  if (std::fetestexcept(FE_OVERFLOW)) all += "overflow, ";
  std::feclearexcept(FE_ALL_EXCEPT);
  return all;
}

// A pair and a step that is rarely usual.
struct Wild : Case {
  double dt;
  Film film;

  explicit Wild(Random &rnd) : Case(rnd)
  {
    film = make_film(rnd.log_uniform(1e-20, 1e9), rnd.log_uniform(1e-2, 2.0),
                     rnd.coin() ? Range::CUT : Range::SHIFTED, 0.6);
    dt = rnd.log_uniform(1e-12, 1e6);
    const double scale = rnd.coin() ? rnd.log_uniform(1e-12, 1e12)
                                    : 1.0;    // another unit of force
    c.normal.g *= scale;
    c.normal.asperity *= scale;
    c.kt *= scale;
    c.normal.repulsion.force *= scale;
    if (rnd.coin()) i.v = j.v = i.omega = j.omega = {};    // as in a run that begins
  }

  // any gap that a run can reach
  template <class E> void set_wild_history(Random &rnd)
  {
    set_history<E>(rnd, geometry());
    const double ln_u = rnd.coin() ? -rnd.log_uniform(1.0, 1e5) : rnd.uniform(-5.0, 1.0);
    const GapLaw &law = c.normal.gap;
    if constexpr (E::gap_history) {
      history[E::GAP_SLOT] = std::exp(ln_u);
      history[E::GAP_SLOT + 1] = ln_u;
    }
    if constexpr (E::gap_history && E::adhesion) {
      const bool holds = ln_u < law.ln_eps || (ln_u < law.ln_release && rnd.coin());
      history[E::BOND_SLOT] = holds ? 1.0 : 0.0;
    }
    if constexpr (E::surface_history)
      if (rnd.coin()) history[E::SURFACE_SLOT] = a * rnd.uniform(-0.5, 3.0);
  }
};

template <class E> void step_alone(const Wild &w, const Film &film)
{
  double next[Batch::HISTORY + 1] = {};
  const PairGeometry g = w.geometry();
  next_history<E>(w.c, film, g, w.i, w.j, w.dt, w.history, next);
  Load load = pair_load<E>(w.c, film, g, next);
  stored_energy<E>(w.c, g, load, next);
  pair_energy<E>(w.c, g, load);
  force_by_channel(g, load);
  if constexpr (E::residual) present_stresslet<E>(w.c, film, g, load, next);
  step_loss<E>(w.c, film, g, w.i, w.j, w.dt, w.history, next);
  first_history<E>(w.c, g, next);
  load = pair_load<E>(w.c, film, g, next);
  ASSERT_TRUE(std::isfinite(norm(force_on_i(load, g))));
}

// Each effect by itself, all of them, and the extensions.
template <class F> void for_every_law(F &&f)
{
  auto one = [&f](auto mask) {
    f(Effects<mask.value>());
  };
  call_each(one, std::integer_sequence<unsigned, 0, 1, 2, 4, 7, 8, 16, 31>{});
  for_extended_masks(one);
  auto residual = [&f](auto mask) {
    f(WithResidual<Effects<mask.value>>());
  };
  call_each(residual, std::integer_sequence<unsigned, 27, 31, 255>{});
}

// The same film, or a residual one in a strong flow.
template <class E> Film of_law(const Film &f)
{
  if (!E::residual) return f;
  Film film = make_film(f.viscosity, 2.0, Range::RESIDUAL, 0.6);
  film.strain = {3.0, -1.0, -2.0, 50.0, 0.0, 0.3};
  return film;
}

}    // namespace

TEST(Traps, BatchesThatArePartlyFilledOrEmpty)
{
#ifdef __clang__
  GTEST_SKIP()
      << "with -fno-trapping-math Clang computes both sides of a choice, 0/0 on the other one";
#endif
  for (const Range rule : {Range::CUT, Range::SHIFTED})
    for_every_law([rule](auto effects) {
      using E = decltype(effects);
      const Film film = of_law<E>(make_film(1.0, 0.5, rule, 0.6));
      Random rnd(E::mask);
      for (int filled = 0; filled < Batch::WIDTH; filled++) {
        Batch b = idle_batch();
        exceptions();
        for (int repeat = 0; repeat < 3; repeat++) {    // later ones find what the last have left
          for (int l = 0; l < filled - repeat; l++) {
            Case k(rnd);
            k.set_history<E>(rnd, k.geometry());
            put(k, b, l);
          }
          exceptions();
          step_batch<E>(b, film, 1e-4);
          if constexpr (E::residual) stresslets_together<E>(b, film);
          EXPECT_EQ(exceptions(), "") << filled << " pairs";
        }
      }
    });
}

TEST(Traps, BatchesOfStepsThatAreNotUsual)
{
  for_every_law([](auto effects) {
    using E = decltype(effects);
    Random rnd(100 + E::mask);
    int unusual = 0;
    for (int trial = 0; trial < 300; trial++) {
      Batch b = idle_batch();
      const Wild first(rnd);
      const Film film = of_law<E>(trial % 10 ? first.film : make_film(0.0, 0.5, Range::CUT, 0.6));
      for (int l = 0; l < Batch::WIDTH; l++) {
        Wild w(rnd);
        w.set_wild_history<E>(rnd);
        if (rnd.coin())    // a pair that is new
          for (double &slot : w.history) slot = 0.0;
        put(w, b, l);
      }
      exceptions();
      step_batch<E>(b, film, first.dt);
      if constexpr (E::residual) stresslets_together<E>(b, film);
      EXPECT_EQ(exceptions(), "") << "trial " << trial;
      for (const double usual : b.usual) unusual += usual == 0.0;
    }
    if (E::squeeze) { EXPECT_GT(unusual, 500); }
  });
}

TEST(Traps, PairsByThemselves)
{
  for_every_law([](auto effects) {
    using E = decltype(effects);
    Random rnd(200 + E::mask);
    for (int trial = 0; trial < 1000; trial++) {
      Wild w(rnd);
      w.set_wild_history<E>(rnd);
      const Film film = of_law<E>(trial % 10 ? w.film : make_film(0.0, 0.5, Range::CUT, 0.6));
      exceptions();
      step_alone<E>(w, film);
      ASSERT_EQ(exceptions(), "") << "trial " << trial;
    }
  });
}

TEST(Traps, BackwardEuler)
{
  using E = Effects<SQUEEZE>;
  Random rnd(300);
  for (int trial = 0; trial < 20000; trial++) {
    Wild w(rnd);
    w.c.normal.gap.euler = true;
    w.set_wild_history<E>(rnd);
    exceptions();
    step_alone<E>(w, w.film);
    ASSERT_EQ(exceptions(), "") << "trial " << trial;
  }
}

TEST(Traps, WithoutDragWithoutFlowWithoutStress)
{
  volatile double zero = 0.0;    // nothing is computed by the compiler
  exceptions();
  EXPECT_EQ(LAMMPS_NS::Fluid_NS::mean_drag(zero), 1.0);
  EXPECT_EQ(LAMMPS_NS::Fluid_NS::mean_drag_full(zero), 1.0);
  EXPECT_EQ(LAMMPS_NS::Rheometer_NS::decay_mean(zero), 1.0);
  EXPECT_EQ(LAMMPS_NS::Rheometer_NS::oscillation_rate(zero, 1.0, zero, zero, 0.1), 1.0);
  EXPECT_EQ(LAMMPS_NS::Rheometer_NS::damped_velocity(2.0, zero, 1.0, zero, 0.1), 2.0);
  const LAMMPS_NS::Rheometer_NS::Material m{1.0, 1.0, 2.0, 4.0};
  EXPECT_EQ(LAMMPS_NS::Rheometer_NS::next_rate(m, zero, zero, zero, 1.0, 0.1), 0.0);
  EXPECT_EQ(LAMMPS_NS::Rheometer_NS::dilation_limit(m, zero, zero, 1.0), 0.0);
  EXPECT_EQ(LAMMPS_NS::Rheometer_NS::watch({}, zero, zero, 0.1).age, 0.0);
  const LAMMPS_NS::Rheometer_NS::Gradient g =
      LAMMPS_NS::Rheometer_NS::gradient(LAMMPS_NS::Rheometer_NS::SHEAR, 3, zero, zero, 0.1);
  EXPECT_EQ(LAMMPS_NS::Rheometer_NS::change(g, g, zero).xy, 0.0);
  EXPECT_EQ(exceptions(), "");
}
