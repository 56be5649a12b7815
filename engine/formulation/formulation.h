#pragma once

// The names of the three formulations; the one public header of this folder.

#include <string_view>

#include "spoke/export.h"

namespace spoke {

/// Three ways to the same accelerations (docs/formulation.md, section 4).
enum class Formulation {
  structured,  ///< constant blocks factorised once, block-tridiagonal condensation: O(N M E)
  subsystem,   ///< the paper's subsystem synthesis with dense blocks, (P 7) to (P 11)
  augmented,   ///< one dense system of all coordinates and multipliers, (P 4) to (P 6)
};

/// "structured", "subsystem" or "augmented".
SPOKE_EXPORT std::string_view name_of(Formulation formulation);

}  // namespace spoke
