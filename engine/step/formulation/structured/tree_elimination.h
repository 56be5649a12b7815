#pragma once

// Elimination and recovery of the tree of a subsystem, body by body: the overloads that the
// templates of `structured` call. In the plane the tree is a chain; in space bodies hang at any
// handle of their parents.

#include "engine/step/formulation/structured.h"
#include "engine/step/formulation/tree_joints.h"

namespace spoke::structured {

/// Whether the bodies of a subsystem are eliminated by their masses.
inline bool has_rigid_bodies_alone(const SubsystemData<Plane>&) { return false; }
bool has_rigid_bodies_alone(const SubsystemData<Space>& data);

/// Sets the branch of body j: with all that its children carry
/// (engine/bodies/tree/joint_elimination.h).
void join_children(const Subsystem<Space>& subsystem, std::size_t j,
                   const SubsystemData<Space>& data, SubsystemWork<Space>& work);

/// Sets the wrenches at the joints of the children of body j, and the accelerations of their
/// coordinates.
void recover_children(const Subsystem<Space>& subsystem, std::size_t j,
                      const SubsystemWork<Space>& work, SubsystemData<Space>& data);

// Subsystems of rigid bodies alone, by masses (engine/bodies/tree/mass_elimination.h).

/// Sets the branch of body j: with all that its children carry.
inline void join_children_by_mass(const Subsystem<Plane>&, std::size_t, const SubsystemData<Plane>&,
                                  SubsystemWork<Plane>&) {}
void join_children_by_mass(const Subsystem<Space>& subsystem, std::size_t j,
                           const SubsystemData<Space>& data, SubsystemWork<Space>& work);

/// Eliminates the joint of a root, and returns what the hub feels of its tree.
tree::HubShare<Space> eliminate_root_by_mass(const space::JointTerms& joint,
                                             const tree::Branch<Space>& branch,
                                             tree::RootElimination<Space>& root) noexcept;

/// Recovers wrenches and accelerations of all, from the roots to the tips.
inline void recover_by_mass(const Subsystem<Plane>&, SubsystemWork<Plane>&, SubsystemData<Plane>&) {
}
void recover_by_mass(const Subsystem<Space>& subsystem, SubsystemWork<Space>& work,
                     SubsystemData<Space>& data) noexcept;

/// Finds and uses the columns of loops as the functions of structured.h do.
inline void calc_loop_columns_by_mass(const Subsystem<Plane>&, std::size_t,
                                      const SubsystemWork<Plane>&, SubsystemData<Plane>&) {}
void calc_loop_columns_by_mass(const Subsystem<Space>& subsystem, std::size_t loop,
                               const SubsystemWork<Space>& work,
                               SubsystemData<Space>& data) noexcept;

}  // namespace spoke::structured
