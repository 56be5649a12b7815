#pragma once

// Elimination and recovery of the tree of a subsystem, body by body: the overloads that the
// templates of `structured` call. In the plane the tree is a chain; in space bodies hang at any
// handle of their parents.

#include "engine/formulation/structured.h"
#include "engine/formulation/tree_joints.h"

namespace spoke::structured {

/// Sets the branch of body j: with all that its children carry (engine/tree/joint_elimination.h).
void join_children(const Subsystem<Space>& subsystem, std::size_t j,
                   const SubsystemData<Space>& data, SubsystemWork<Space>& work);

/// Sets the wrenches at the joints of the children of body j, and the accelerations of their
/// coordinates.
void recover_children(const Subsystem<Space>& subsystem, std::size_t j,
                      const SubsystemWork<Space>& work, SubsystemData<Space>& data);

}  // namespace spoke::structured
