/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The history of a pair carried over to a pair style with other effects.

#ifndef SCENE_HISTORY_H
#define SCENE_HISTORY_H

#include "lubcontact_effects.h"
#include "lubcontact_normal.h"

#include <array>
#include <cmath>
#include <vector>

namespace LAMMPS_NS::Scene_NS {

// first slot of each part, in the order of lubcontact_effects.h, and the end
using Slots = std::array<int, 8>;

// of a loop that is compiled
inline Slots slots_of(unsigned instance)
{
  static_assert(Lubcontact_NS::Effects<Lubcontact_NS::NUM_COMBINATIONS - 1>::HISTORY_SIZE == 12,
                "a part of the history is missing here");
  Slots slots{};
  Lubcontact_NS::with_effects(instance, [&slots](auto effects) {
    using E = decltype(effects);
    slots = {E::GAP_SLOT,   E::SURFACE_SLOT, E::SHEAR_SLOT,   E::ROLL_SLOT,
             E::TWIST_SLOT, E::BOND_SLOT,    E::DASHPOT_SLOT, E::HISTORY_SIZE};
  });
  return slots;
}

// for each slot of a history of the loop `to`: its slot in that of the loop `from`, -1 if it has
// none
inline std::vector<int> history_map(unsigned from, unsigned to)
{
  const Slots source = slots_of(from), target = slots_of(to);
  std::vector<int> map;
  for (int part = 0; part + 1 < static_cast<int>(target.size()); part++) {
    const bool there = source[part + 1] > source[part];
    for (int m = target[part]; m < target[part + 1]; m++)
      map.push_back(there ? source[part] + m - target[part] : -1);
  }
  return map;
}

static constexpr unsigned EVERYTHING = Lubcontact_NS::NUM_COMBINATIONS - 1;
using Whole = Lubcontact_NS::Effects<EVERYTHING>;

// All slots of a pair at un that has a gap and a bond already, or null; the rest as of a pair seen
// for the first time, with the extensions X of the normal mode.
template <unsigned X>
std::array<double, Whole::HISTORY_SIZE> new_slots(const Lubcontact_NS::NormalCoeffs &c, double a,
                                                  double un, const double *gap, const double *bond)
{
  std::array<double, Whole::HISTORY_SIZE> slots{};
  const bool touch = gap ? gap[0] < c.gap.eps_a
                         : Lubcontact_NS::elastic_contact<X>(c, a, un / a, false);
  const bool holds = bond ? *bond != 0.0 : touch;
  const double u = gap ? gap[0] : Lubcontact_NS::elastic_gap_a<X>(c, a, un / a, holds);
  slots[Whole::GAP_SLOT] = u;
  slots[Whole::GAP_SLOT + 1] = std::log(u);
  slots[Whole::SURFACE_SLOT] = un;
  slots[Whole::BOND_SLOT] = holds ? 1.0 : 0.0;
  return slots;
}

// History of the loop `to` from `old` of the loop `from`. a, un: effective radius and gap of the
// undeformed surfaces, lengths.
inline void adopt_history(unsigned from, unsigned to, const Lubcontact_NS::NormalCoeffs &c,
                          double a, double un, const double *old, double *next)
{
  enum { GAP, SURFACE, BOND = 5 };
  const Slots source = slots_of(from);
  if (source[SURFACE + 1] > source[SURFACE]) un = old[source[SURFACE]];
  const double *gap = source[GAP + 1] > source[GAP] ? old + source[GAP] : nullptr;
  const double *bond = source[BOND + 1] > source[BOND] ? old + source[BOND] : nullptr;
  std::array<double, Whole::HISTORY_SIZE> fresh{};
  Lubcontact_NS::with_effects(to, [&](auto effects) {
    fresh = new_slots<decltype(effects)::normal>(c, a, un, gap, bond);
  });
  const std::vector<int> map = history_map(from, to), place = history_map(EVERYTHING, to);
  for (std::size_t m = 0; m < map.size(); m++)
    next[m] = map[m] >= 0 ? old[map[m]] : fresh[place[m]];
}

}    // namespace LAMMPS_NS::Scene_NS

#endif
