#pragma once

// Start of a joint at given coordinates.

#include "engine/bodies/space/body.h"

namespace spoke::space {

/// Sets the coordinates of a joint. A spherical joint, given by the rotation vector from parent to
/// child, takes the rotation as its reference.
void put_joint(const Joint& joint, const double* q, JointData& data);

}  // namespace spoke::space
