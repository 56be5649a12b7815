#pragma once

// The places where the loads of a model in space act on the bodies of its trees.

#include <vector>

#include "models/spatial_model.h"
#include "models/system/blade_loads.h"
#include "models/tree/tree.h"

namespace spoke {

/// Returns the loads on each body of tree number `index`, of a model's trees in their order; forces
/// are in the frames of the description. Loads per length act at the points of Gauss's rule of four
/// in each element, or part of one, weighted by the length along the beam's x axis.
std::vector<std::vector<BodyLoad<Space>>> make_body_loads(const spatial::Model& model,
                                                          const spatial::Tree& tree,
                                                          std::size_t index);

/// Returns the part of a load on a beam that acts at a place of its body, given in elements from
/// the inboard end, and outboard of it; without points if there is none.
BodyLoad<Space> take_outboard(const BodyLoad<Space>& load, double along);

}  // namespace spoke
