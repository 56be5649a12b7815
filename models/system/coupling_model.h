#pragma once

// The rows that couplings of joints are.

#include <cstddef>

#include "models/system/loop_model.h"
#include "models/tree/tree.h"

namespace spoke {

/// Makes the row of a coupling of a tree, by its index. Precondition: check_model() accepts the
/// model that the tree is of.
LoopModel make_coupling(const spatial::Tree& tree, std::size_t coupling);

}  // namespace spoke
