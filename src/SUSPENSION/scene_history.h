// The history of a pair carried over to a pair style with other effects.

#ifndef SCENE_HISTORY_H
#define SCENE_HISTORY_H

#include "lubcontact_effects.h"

#include <array>
#include <utility>
#include <vector>

namespace scene {

// first slot of each part, in the order of lubcontact_effects.h, and the end
using Slots = std::array<int, 7>;

template <unsigned MASK> constexpr Slots slots_of()
{
  using E = lubcontact::Effects<MASK>;
  static_assert(lubcontact::Effects<lubcontact::NUM_COMBINATIONS - 1>::HISTORY_SIZE == 11,
                "a part of the history is missing here");
  return {E::GAP_SLOT,   E::SURFACE_SLOT, E::SHEAR_SLOT,  E::ROLL_SLOT,
          E::TWIST_SLOT, E::BOND_SLOT,    E::HISTORY_SIZE};
}

template <std::size_t... MASK> Slots slots_of(unsigned mask, std::index_sequence<MASK...>)
{
  static constexpr Slots all[] = {slots_of<MASK>()...};
  return all[mask];
}

inline Slots slots_of(unsigned mask)
{
  return slots_of(mask, std::make_index_sequence<lubcontact::NUM_COMBINATIONS>());
}

// for each slot of a history with effects to: its slot with effects from, -1 if it has none
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

}    // namespace scene

#endif
