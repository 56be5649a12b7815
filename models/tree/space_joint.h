#pragma once

// Makes a joint of a tree in space out of its description.

#include "models/space/tree_joint.h"
#include "models/spatial_model.h"
#include "models/tree/mass_properties.h"

namespace spoke::spatial {

/// Returns the joint whose frame is at `placement` on the parent (both as in TreeBody). Its
/// coordinates are in the order of Joint::coordinates; prescribed ones are driven.
space::Joint make_space_joint(const Joint& joint, const Placement& placement);

/// Returns the motion as described; a ProgramMotion begins as a constant.
space::DrivenMotion make_driven_motion(const Motion& motion);

}  // namespace spoke::spatial
