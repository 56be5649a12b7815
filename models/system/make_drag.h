#pragma once

// Places the drag of bodies.

#include <memory>
#include <vector>

#include "models/space/body.h"
#include "models/space/hub.h"
#include "models/space/tension_place.h"
#include "models/space/tree_joint.h"
#include "models/spatial_model.h"
#include "models/system/system.h"
#include "models/tree/tree.h"

namespace spoke {

/// Places the drag of a tree's bodies: on a beam at two points, after Gauss, between each of its
/// nodes and of the stations of its drag. `described`: the bodies of the tree; `made`: its
/// subsystem. What disturbs the wind of blades has its axis at each of these nodes and stations.
/// Null: there is none.
std::shared_ptr<const DragModel> make_drag(const std::vector<spatial::Body>& described,
                                           const spatial::Tree& tree, const Subsystem<Space>& made,
                                           double density);

}  // namespace spoke
