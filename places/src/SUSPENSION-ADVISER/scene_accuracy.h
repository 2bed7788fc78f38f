/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What accuracy costs: proposes settings for a tolerance of the shear viscosity. The laws were
// measured by benchmarks/accuracy_cost at phi 0.5, friction 0.5, range cut 0.5; test tools.accuracy
// compares each constant with the runs in its suspension.csv. Errors are relative, against the
// converged solution of this model: hard particles without inertia, many, small steps. How far
// that is from an experiment is another matter.

#ifndef SCENE_ACCURACY_H
#define SCENE_ACCURACY_H

#include "scene_numbers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace LAMMPS_NS::Scene_NS {

// change of the viscosity = coefficient x^exponent, measured for x in [low, high]; below low the
// law interpolates to 0, above high there is no bound
struct ErrorLaw {
  double coefficient, error, exponent, low, high;
  double at(double x) const { return coefficient * std::pow(x, exponent); }
  double doubt(double x) const { return error * std::pow(x, exponent); }
};

enum Cause { TIME_STEP, SOFTNESS, PARTICLE_INERTIA, FEW_PARTICLES, NO_TWIST, NUM_CAUSES };
inline constexpr const char *CAUSE_NAME[NUM_CAUSES] = {"time step", "stiffness", "particle inertia",
                                                       "few particles", "twisting film left out"};
// printed by benchmarks/accuracy_cost/suspension_laws.py table
inline constexpr ErrorLaw LAW[NUM_CAUSES] = {
    // clang-format off
    {-1.5, 0.72, 1.0, 1.7e-05, 0.001},    // of rate dt
    {2.2, 0.5, 1.0, 0.00046, 0.046},    // of P/(E eps)
    {0.025, 0.0016, 2.0, 0.05, 5.0},    // of St
    {4.0, 3.6, 1.0, 0.0005, 0.01},    // of 1/N
    {0.019, 0.038, 1.0, 1.0, 1.0},    // of 1 without it
    // clang-format on
};

// standard error of the mean over a strain: scatter/sqrt(N strain), at volume fractions
struct Scatter {
  double phi, value;
};
inline constexpr Scatter SCATTER[] = {{0.40, 1.3}, {0.45, 1.2}, {0.50, 3.1}, {0.54, 3.8}};

static constexpr double SETTLE = 2.0;      // strain from a packing at rest to the steady flow
static constexpr double SHORTEST = 4.0;    // strain to average: error bars need it
// CPU of a particle: of a unit of strain (neighbor lists) and of a step, all films
static constexpr double STRAIN_SECONDS = 0.00052;
static constexpr double STEP_SECONDS = 3.5e-07;
static constexpr double MODEL_DOUBT = 0.15;    // of the model against experiments, tests/validation

static constexpr double SMALLEST_MEASURED = 0.03;    // change that the runs could tell from none

// what may be chosen, within what was run. Steps above 0.72 of the limit save little: pairs that
// relax within a step take longer
static constexpr double STEP_OF_LIMIT = 0.72;
inline constexpr double SOFTNESSES[] = {0.045, 0.023, 0.015, 0.0045, 0.0015, 0.00046};
inline constexpr double INERTIAS[] = {2.0, 1.0, 0.5, 0.05};
inline constexpr double SIZES[] = {200, 500, 1000, 2000};

// soft particles in a small cell break down: one strong chain of contacts crushes asperities, and
// their films, once flat, carry more. N 100 and 200 did at P/(E eps) 0.046, not at 0.0046
static constexpr double SMALL_CELL = 500.0, HARD_ENOUGH = 0.0046;
inline bool breaks_down(double softness, double particles)
{
  return particles < SMALL_CELL && softness > HARD_ENOUGH;
}

struct Plan {
  bool possible = false;
  double step = 0.0, softness = 0.0, St = 0.0, particles = 0.0;
  bool twist = true;
  double steps = 0.0;                // of a unit of strain
  double strain = 0.0;               // to average, after SETTLE
  double change[NUM_CAUSES] = {};    // expected
  double doubt = 0.0;                // of their sum, one standard error
  double scatter = 0.0;              // one standard error of the mean
  double cost = 0.0;                 // CPU seconds, all
  double expected() const
  {
    double sum = 0.0;
    for (const double c : change) sum += std::fabs(c);
    return sum;
  }
  double promised() const { return expected() + 2.0 * std::hypot(doubt, scatter); }
};

inline double scatter(double phi)
{
  const Scatter *s = SCATTER;
  constexpr int last = std::size(SCATTER) - 1;
  if (phi <= s[0].phi) return s[0].value;
  for (int n = 1; n <= last; n++)
    if (phi <= s[n].phi) {
      const double part = (phi - s[n - 1].phi) / (s[n].phi - s[n - 1].phi);
      return s[n - 1].value + part * (s[n].value - s[n - 1].value);
    }
  return s[last].value;
}

// CPU seconds of the whole run
inline double seconds(const Plan &p)
{
  return p.particles * (SETTLE + p.strain) * (STRAIN_SECONDS + p.steps * STEP_SECONDS);
}

// what is changed by the settings, and how long to average so that the tolerance holds with 95 %
inline Plan judge_plan(Plan p, double tolerance, double phi)
{
  const double x[NUM_CAUSES] = {1.0 / p.steps, p.softness, p.St, 1.0 / p.particles,
                                p.twist ? 0.0 : 1.0};
  double doubt = 0.0;
  for (int c = 0; c < NUM_CAUSES; c++) {
    if (x[c] > LAW[c].high) return p;
    p.change[c] = LAW[c].at(x[c]);
    doubt += LAW[c].doubt(x[c]) * LAW[c].doubt(x[c]);
  }
  p.doubt = std::sqrt(doubt);
  if (breaks_down(p.softness, p.particles)) return p;
  const double room = 0.5 * (tolerance - p.expected());
  if (room <= p.doubt) return p;
  p.scatter = std::sqrt(room * room - doubt);
  const double root = scatter(phi) / p.scatter;
  p.strain = std::max(root * root / p.particles, SHORTEST);
  p.scatter = scatter(phi) / std::sqrt(p.particles * p.strain);
  p.possible = true;
  return p;
}

// steps of a unit of strain: dt = step * limit, the limit in units of sqrt(m/g) at softness and St
inline double steps_per_strain(const Plan &p, const Scene &s, const Numbers &n, double limit)
{
  return 1.0 / (p.step * limit * std::fabs(s.rate)) *
      std::sqrt(n.St / p.St * (1.0 / n.crushing) / p.softness);
}

// the cheapest settings whose error bound is within the tolerance; limit: of the time step at the
// settings of now
inline Plan plan(double tolerance, const Scene &s, const Numbers &n, double limit)
{
  Plan best;
  for (const double softness : SOFTNESSES)
    for (const double St : INERTIAS)
      for (const double particles : SIZES)
        for (const bool twist : {true, false}) {
          Plan p;
          p.step = STEP_OF_LIMIT;
          p.softness = softness;
          p.St = St;
          p.particles = particles;
          p.twist = twist;
          p.steps = steps_per_strain(p, s, n, limit);
          p = judge_plan(p, tolerance, s.phi);
          p.cost = seconds(p);
          if (p.possible && (!best.possible || p.cost < best.cost)) best = p;
        }
  return best;
}

// the smallest error bound of any settings, with an endless run
inline double finest(const Scene &s, const Numbers &n, double limit)
{
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; k++) {
    const double middle = 0.5 * (low + high);
    (plan(middle, s, n, limit).possible ? high : low) = middle;
  }
  return high;
}

// what the numbers do not say
inline std::vector<std::string> remarks(double tolerance, const Scene &s)
{
  std::vector<std::string> out;
  if (tolerance < MODEL_DOUBT)
    out.push_back(
        "the tolerance refers to the converged solution of the model, which is not known to be "
        "within " +
        show(100.0 * MODEL_DOUBT) + " % of an experiment");
  if (tolerance < SMALLEST_MEASURED)
    out.push_back("single errors below " + show(100.0 * SMALLEST_MEASURED) +
                  " % were not measured: they follow from the laws");
  constexpr double slack = 0.005;
  if (s.phi < SCATTER[0].phi - slack || s.phi > std::rbegin(SCATTER)->phi + slack)
    out.push_back("phi " + show(s.phi) + " is outside what was measured");
  if (!(s.friction >= 0.3 && s.friction <= 0.7))
    out.push_back("measured with friction 0.5, not with " + show(s.friction));
  return out;
}

}    // namespace LAMMPS_NS::Scene_NS

#endif
