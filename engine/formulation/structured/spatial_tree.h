#pragma once

// What the formulation `structured` does for bodies in space, which hang at any handle of their
// parents: the overloads that its templates call.

#include "engine/formulation/structured.h"

namespace spoke::structured {

/// Body j with all that its children carry (engine/tree/joint_elimination.h).
tree::Branch<Space> join_children(const Subsystem<Space>& subsystem, std::size_t j,
                                  SubsystemData<Space>& data, SubsystemWork<Space>& work);

/// The joint of a subsystem at the hub.
space::JointTerms make_root_joint(const Subsystem<Space>& subsystem,
                                  const SubsystemData<Space>& data);

/// Wrenches at the joints of the children of body j, and the accelerations of their coordinates.
void recover_children(const Subsystem<Space>& subsystem, std::size_t j,
                      const SubsystemWork<Space>& work, SubsystemData<Space>& data);

/// Where the accelerations of the coordinates of a body's joint go.
inline double* joint_accelerations(BodyData<Space>& body) { return body.joint.a_found; }

}  // namespace spoke::structured
