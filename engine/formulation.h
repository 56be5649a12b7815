#pragma once

// The three formulations and their names; the one public header of this folder.

#include <span>
#include <string_view>

#include "spoke/export.h"

namespace spoke {

/// Three ways to the same accelerations (docs/formulation.md, section 4).
enum class Formulation {
  structured,  ///< constant blocks factorised once, block-tridiagonal condensation: O(N M E)
  subsystem,   ///< the paper's subsystem synthesis with dense blocks, (P 7) to (P 11)
  augmented,   ///< one dense system of all coordinates and multipliers, (P 4) to (P 6)
};

/// Returns all three, in this order.
SPOKE_EXPORT std::span<const Formulation> formulations();
/// Returns "structured", "subsystem" or "augmented".
SPOKE_EXPORT std::string_view name_of(Formulation formulation);
/// Returns the formulation of this name. Throws InputError, with the names to choose from, if there
/// is none.
SPOKE_EXPORT Formulation formulation_of(std::string_view name);

}  // namespace spoke
