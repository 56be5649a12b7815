#pragma once

// Loops and couplings that span several trees: what each of these has of them.

#include <vector>

#include "models/tree/tree.h"

namespace spoke::spatial {

/// Adds to the trees that carry rotors what comes through their hubs of loops that span several
/// trees. Precondition: the model has a support, and the trees have their own loops.
void add_loops_on_hubs(const Model& model, std::vector<Tree>& trees);

/// Adds the ends of couplings whose joints are on several trees, on hubs, too.
void add_coupling_ends(const Model& model, std::vector<Tree>& trees);

}  // namespace spoke::spatial
