#pragma once

// The terms of a body of a spatial subsystem, and of the joint that carries it.

#include <array>

#include "engine/kernels/kinematics.h"
#include "engine/table/step_data.h"

namespace spoke {

/// Returns the constants that the kernels of a flexible body read (engine/space/body_data.h).
/// Precondition: the body is flexible.
space::BodyModel body_model_of(const BodyData<Space>& body);
space::BodyState body_state_of(const BodyData<Space>& body);
/// Makes, at the first pass of a step, the tension on its left-hand side that of the hub's speed.
void follow_hub_speed(const HubState<Space>& hub, BodyData<Space>& body) noexcept;
/// Whether the terms of a pass of an implicit step have such tension.
bool has_implicit_tension(const BodyData<Space>& body) noexcept;
/// Returns M_RR about the origin of its frame. Precondition: the body is rigid.
const space::SymmetricTwistMatrix& rigid_mass_of(const BodyData<Space>& body);
/// Returns the motion of a section against the frame of its body at the state in the table.
space::HandleMotion motion_at(const BodyData<Space>& body, const space::Section& section) noexcept;
/// Returns force and moment of a load of the scenario at its point `k`, in the frame of its body B;
/// R_HB and R_0: of B in H and of H in the inertial frame, `section`: of the loaded section in B.
space::Twist calc_load_wrench(const BodyLoad<Space>& load, std::size_t k, double t,
                              const space::Rotation& R_HB, const space::Rotation& R_0,
                              const space::Rotation& section) noexcept;
space::JointState joint_state_of(const BodyData<Space>& body);

/// Whether forces on a body, in the hub's frame, depend on its pose and deformation.
bool depend_on_pose(const BodyData<Space>& body) noexcept;

/// Returns the sum of all that is applied to body `j` at time t [s], in the hub's frame [N]; the
/// pose is used only where forces depend on it.
space::Position sum_forces(double t, const Subsystem<Space>& subsystem,
                           const SubsystemData<Space>& data, std::size_t j) noexcept;

/// Returns the field that the masses of a subsystem feel, in H [m/s^2], as calc_tension_field() of
/// the plane does; on an axle whose mount moves, gravity less its acceleration.
space::Position calc_tension_field(const System<Space>& system, double t,
                                   const SubsystemData<Space>& data) noexcept;

/// Returns shift and rate of the coordinate by which the joint that carries body `j` slides, from
/// the deformation of the bodies inboard. Precondition: it slides.
space::SlideState calc_slide_shift(const SubsystemData<Space>& data, std::size_t j) noexcept;

/// A joint's state with its slide at the true place; stays in place.
struct ShiftedJoint {
  std::array<double, space::Joint::kMost> q{}, v{};
  space::JointState state;

  ShiftedJoint(const BodyData<Space>& body, const space::SlideState& slide) noexcept;
  ShiftedJoint(const ShiftedJoint&) = delete;
  ShiftedJoint& operator=(const ShiftedJoint&) = delete;
};

/// Returns the forces of the motors on a joint's coordinates at time t [s].
std::array<double, space::Joint::kMost> calc_motors(const space::TreeJoint& joint,
                                                    double t) noexcept;

/// Calculates the terms of body `j` at the state in the table, (P 3) in space, and the forces of
/// its joint at time t [s]. `shares`: those of stiffness and damping that an implicit pass leaves
/// to the unknown accelerations.
void calc_terms(const System<Space>& system, const Subsystem<Space>& subsystem, double t,
                const space::ImplicitShares& shares, int j, SubsystemData<Space>& data) noexcept;

}  // namespace spoke
