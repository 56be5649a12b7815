#pragma once

// Which body of a subsystem has its tip.

#include <algorithm>
#include <cstddef>
#include <utility>

#include "models/system/system.h"

namespace spoke {

/// Returns the index of the body at the tip of subsystem `i`, as spatial::find_tip_body() of its
/// tree does: of one that a rotor carries, the last that is not of rotors on it.
template <class World>
std::size_t find_tip_body(const System<World>& system, std::size_t i) {
  auto end = static_cast<int>(system.subsystems[i].bodies.size());
  if (system.subsystems[i].rotor >= 0)
    for (const SupportedRotor& rotor : system.rotors)
      if (std::cmp_equal(rotor.subsystem, i)) end = std::min({end, rotor.body, rotor.driven});
  return static_cast<std::size_t>(end) - 1;
}

}  // namespace spoke
