#pragma once

// The terms of a body of a spatial subsystem, and of the joint that carries it.

#include <array>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/space/applied_tension.h"
#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Whether the terms of a pass of an implicit step have such tension.
bool has_implicit_tension(const BodyData<Space>& body) noexcept;
/// Whether a body's tension depends on what is applied.
bool has_applied_tension(const BodyData<Space>& body) noexcept;
/// Returns the linear momentum of a body that deforms, by its terms, in B.
space::Position calc_deformed_momentum(const BodyData<Space>& body,
                                       const space::Twist& twist) noexcept;
/// Whether forces on a body, in the hub's frame, depend on its pose and deformation.
bool depend_on_pose(const BodyData<Space>& body) noexcept;

/// Returns the sum of all that is applied to body `j` at time t [s], in the hub's frame [N]; the
/// pose is used only where forces depend on it.
space::Position sum_forces(double t, const Subsystem<Space>& subsystem,
                           const SubsystemData<Space>& data, std::size_t j) noexcept;

/// Returns the parts on which the scenario's loads among it depend.
PartList parts_of_forces(std::size_t j, const SubsystemData<Space>& data);

/// Returns shift and rate of the coordinate by which the joint that carries body `j` slides, from
/// the deformation of the bodies inboard. Precondition: it slides.
space::SlideState calc_slide_shift(const SubsystemData<Space>& data, std::size_t j) noexcept;
/// Returns the parts on which they and the forces at the true place depend.
PartList parts_of_slide(std::size_t j, const SubsystemData<Space>& data);

/// A joint's state with its slide at the true place; stays in place.
struct ShiftedJoint {
  std::array<double, space::Joint::kMost> q{}, v{};
  space::JointState state;

  ShiftedJoint(const BodyData<Space>& body, const space::SlideState& slide) noexcept;
  ShiftedJoint(const ShiftedJoint&) = delete;
  ShiftedJoint& operator=(const ShiftedJoint&) = delete;
};

/// Returns the forces of the motors on a joint's coordinates at time t [s], with those that the
/// program adds.
std::array<double, space::Joint::kMost> calc_motors(const space::TreeJoint& joint,
                                                    double t) noexcept;

/// Calculates the terms of body `j` at the state in the table, (P 3) in space, and the forces of
/// its joint at time t [s]. `shares`: those of stiffness and damping that an implicit pass leaves
/// to the unknown accelerations. The tiles of a solid in several slices must be done.
void calc_terms(const System<Space>& system, const Subsystem<Space>& subsystem, double t,
                const space::ImplicitShares& shares, int j, SubsystemData<Space>& data) noexcept;
/// Returns the parts on which they depend, of those the ones that its options make them depend on;
/// `has_implicit`: whether any pass is implicit.
PartList parts_of_terms(const System<Space>& system, std::size_t i, std::size_t j,
                        bool has_implicit, const StepData<Space>& data);

}  // namespace spoke
