#pragma once

// From what a scenario says of a joint to the joint of a tree in space.

#include "models/space/tree_joint.h"
#include "models/spatial_model.h"
#include "models/tree/mass_properties.h"

namespace spoke::spatial {

/// A joint whose frame is at `placement` on the parent, as TreeBody has both: its coordinates in
/// the order of Joint::coordinates; those that are prescribed are driven.
space::Joint make_space_joint(const Joint& joint, const Placement& placement);

/// As the description has it; what a program says begins as a constant.
space::DrivenMotion make_driven_motion(const Motion& motion);

}  // namespace spoke::spatial
