/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Before a run the pressure of a scene is known by its volume fraction only, and where contacts may
// be frictional or not, or pack better than spheres of one size, only within bounds: what holds at
// both is said, what does not is left to a run.

#ifndef SCENE_BOUNDS_H
#define SCENE_BOUNDS_H

#include "scene_accuracy.h"
#include "scene_verdict.h"

#include <string>
#include <vector>

namespace LAMMPS_NS::Scene_NS {

// at the least and at the largest pressure, or once
inline std::vector<Numbers> numbers_at_bounds(const Scene &s)
{
  const Bounds bounds = known(s.pressure) ? Bounds{} : steady_pressure(s);
  if (bounds.one()) return {numbers(s)};
  auto at = [&s](double pressure) {
    Scene there = s;
    there.pressure = pressure;
    Numbers n = numbers(there);
    n.estimated = true;
    return n;
  };
  return {at(bounds.low), at(bounds.high)};
}

inline std::string without_source(const std::string &why)
{
  return why.substr(0, why.find(" ["));
}

inline Verdict merge(const Verdict &low, const Verdict &high)
{
  if (low.answer == high.answer) return high;
  return {low.effect, CANNOT_TELL,
          std::string("run first, or give pressure P. At the least pressure of steady flow: ") +
              ANSWER_NAME[low.answer] + ", " + without_source(low.why) +
              "; at the largest: " + ANSWER_NAME[high.answer] + ", " + without_source(high.why)};
}

inline std::vector<Verdict> judge_at_bounds(const Scene &s)
{
  const std::vector<Numbers> n = numbers_at_bounds(s);
  std::vector<Verdict> out = judge(s, n.front());
  const std::vector<Verdict> high = judge(s, n.back());
  for (std::size_t e = 0; e < out.size(); e++) out[e] = merge(out[e], high[e]);
  return out;
}

// those that hold at either bound, and which
inline std::vector<std::string> warnings_at_bounds(const Scene &s)
{
  const std::vector<Numbers> n = numbers_at_bounds(s);
  std::vector<std::string> out =
      warnings(s, n.back());    // the pressure spoils what it is high for
  if (n.size() > 1)
    for (std::string &text : out)
      if (text.find("E eps/P") != std::string::npos) text += " (at the largest pressure)";
  return out;
}

// "2.1", or "0.5 to 2.1"
inline std::string show(const std::vector<Numbers> &n, double Numbers::*what)
{
  const double a = n.front().*what, b = n.back().*what;
  return a == b || !known(a) ? show(b) : show(std::fmin(a, b)) + " to " + show(std::fmax(a, b));
}

// Does a pressure measured in a run look like that of steady flow at this volume fraction? Both
// bounds are taken FAR wide, inertia may add to the second; no law of dilute suspensions, of discs
// and of surfaces with forces is at hand.
static constexpr double FAR = 5.0;
static constexpr double DENSE = 0.4;

struct Doubt {
  bool any = false;
  Bounds steady;
};

inline Doubt doubt_pressure(const Scene &s, double measured)
{
  const Bounds steady = steady_pressure(s);
  if (!known(steady.low) || !known(measured) || s.phi < DENSE || s.adhesion > 0.0 ||
      s.repulsion > 0.0)
    return {};
  Scene here = s;
  here.pressure = measured;
  const double St = numbers(here).St;
  const double inertia = known(St) ? 1.0 + 4.0 * St / VISCOUS_TO_INERTIAL : 1.0;
  return {measured < steady.low / FAR || measured > steady.high * inertia * FAR, steady};
}

// Do the halves of a mean over this strain differ by more than a half, and by more than three times
// what chance makes of them?
inline bool still_changing(const Scene &s, double first, double second, double strain)
{
  const double mean = 0.5 * std::fabs(first + second);
  const double chance = std::sqrt(2.0) * scatter(s.phi) / std::sqrt(s.particles * 0.5 * strain);
  return std::fabs(second - first) > mean * std::fmax(0.5, 3.0 * chance);
}

}    // namespace LAMMPS_NS::Scene_NS

#endif
