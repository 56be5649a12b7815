#pragma once

// Puts a joint where it is to start.

#include "engine/space/spatial_body.h"

namespace spoke::space {

/// Sets the coordinates of a joint; of a spherical one, given by the rotation vector from parent to
/// child, the rotation becomes what it turns from.
void put_joint(const Joint& joint, const double* q, JointData& data);

}  // namespace spoke::space
