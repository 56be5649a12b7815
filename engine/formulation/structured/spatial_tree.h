#pragma once

// What the formulation `structured` does for bodies in space, which hang at any handle of their
// parents: the overloads that its templates call.

#include "engine/formulation/structured.h"
#include "engine/formulation/tree_joints.h"

namespace spoke::structured {

/// Sets the branch of body j: with all that its children carry (engine/tree/joint_elimination.h).
void join_children(const Subsystem<Space>& subsystem, std::size_t j,
                   const SubsystemData<Space>& data, SubsystemWork<Space>& work);

/// Wrenches at the joints of the children of body j, and the accelerations of their coordinates.
void recover_children(const Subsystem<Space>& subsystem, std::size_t j,
                      const SubsystemWork<Space>& work, SubsystemData<Space>& data);

}  // namespace spoke::structured
