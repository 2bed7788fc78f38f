// A sphere over a fixed one, each of radius 1, under a weight: the scene of many hard cases.
//
// With the film force -c u'/u, c = (3/2) pi eta a^2, Newton's law m v' = P - W of smooth spheres
// integrates to  c ln u + m v = const - W t  whatever the stiffness.

#ifndef HARD_CASES_FALLING_H
#define HARD_CASES_FALLING_H

#include "scene.h"

namespace hard_cases {

static constexpr unsigned EVERYTHING = SQUEEZE | SHEAR | FRICTION | ROLL | TWIST;
inline const Law FULL = make_law<EVERYTHING>();

inline double film_coefficient(double eta, double a)
{
  return 1.5 * testing_tools::PI_ * eta * a * a;
}

// A sphere above a fixed one of the same radius 1, at the gap un; range of the film 1.
inline Scene above(const PairCoeffs &c, double eta, double un, double mass, double weight,
                   double dt)
{
  Scene s{FULL, c, make_film(eta, 1.0, Range::CUT, 0.6)};
  s.dt = dt;
  s.gravity = {0.0, 0.0, -weight / mass};
  s.spheres = {{{}, {}, {}, 1.0, 0.0}, {{0.0, 0.0, 2.0 + un}, {}, {}, 1.0, mass}};
  s.start();
  return s;
}

inline double ln_gap(const Scene &s)
{
  return s.pairs[0].history[1];
}

inline double speed(const Scene &s)
{
  return s.spheres[1].v.z;
}

}    // namespace hard_cases

#endif
