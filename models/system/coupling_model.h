#pragma once

// The rows that couplings of joints are.

#include <cstddef>

#include "models/system/loop_model.h"
#include "models/tree/tree.h"

namespace spoke {

/// Makes the row of a coupling of a tree, by its index: its share of it, if it has joints
/// elsewhere. Precondition: check_model() accepts the model that the tree is of.
LoopModel make_coupling(const spatial::Tree& tree, std::size_t coupling);
/// Makes the share of a tree of another tree's coupling: of its joints there, or on a hub.
LoopModel make_coupling_share(const spatial::Tree& tree, const Coupling& coupling);

}  // namespace spoke
