#pragma once

// The terms of a body of a tree in space, and of the joint that carries it.

#include "engine/table/step_data.h"

namespace spoke {

/// What the kernels of a flexible body read (engine/space/body_data.h). Precondition: it is one.
space::BodyModel body_model_of(const BodyData<Space>& body);
space::BodyState body_state_of(const BodyData<Space>& body);
/// M_RR about the origin of its frame. Precondition: the body is rigid.
const space::SymmetricTwistMatrix& rigid_mass_of(const BodyData<Space>& body);
/// How a section moves against the frame of its body at the state in the table.
space::HandleMotion motion_at(const BodyData<Space>& body, const space::Section& section) noexcept;
/// Force and moment of a load of the scenario at its point `k`, in the frame of its body B; R_HB
/// and R_0: of B in H and of H in the inertial frame, `section`: of the loaded section in B.
space::Twist calc_load_wrench(const BodyLoad<Space>& load, std::size_t k, double t,
                              const space::Rotation& R_HB, const space::Rotation& R_0,
                              const space::Rotation& section) noexcept;
space::JointState joint_state_of(const BodyData<Space>& body);

/// Calculates the terms of body `j` at the state in the table, (P 3) in space, and the forces of
/// its joint at time t [s]. `shares`: those of stiffness and damping that an implicit pass leaves
/// to the unknown accelerations.
void calc_terms(const System<Space>& system, const Subsystem<Space>& subsystem, double t,
                const space::ImplicitShares& shares, int j, SubsystemData<Space>& data) noexcept;

}  // namespace spoke
