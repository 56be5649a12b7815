#pragma once

// A spatial body's data in the table, as kernels read them.

#include "engine/bodies/table/body_kind.h"
#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Returns the flex vectors of a body.
space::BodyState body_state_of(const BodyData<Space>& body);
/// Returns the motion of a section against the frame of its body at the state in the table.
inline space::HandleMotion motion_at(const BodyData<Space>& body,
                                     const space::Section& section) noexcept {
  return body.kind->motion_at(body, section);
}
/// Returns force and moment of a load of the scenario at its point `k`, in the frame of its body B;
/// R_HB and R_0: of B in H and of H in the inertial frame, `section`: of the loaded section in B.
space::Twist calc_load_wrench(const BodyLoad<Space>& load, std::size_t k, double t,
                              const space::Rotation& R_HB, const space::Rotation& R_0,
                              const space::Rotation& section) noexcept;
space::JointState joint_state_of(const BodyData<Space>& body);
/// Returns the motion on which the terms of body j depend besides its deformation, at time t [s].
space::BodyMotion body_motion_of(const System<Space>& system, double t, std::size_t j,
                                 const SubsystemData<Space>& data) noexcept;
/// Returns the power of a wrench in B on a section that moves against B as given [W]; `twist`: of
/// B.
inline double calc_wrench_power(const space::Twist& wrench, const space::HandleMotion& motion,
                                const space::Twist& twist) {
  return wrench.dot(motion.carry(twist) + motion.twist());
}
/// Adds the moment of a body's tension on the hub, in H, and the power of that.
void add_hub_moment(const space::Angular& moment, const HubState<Space>& hub,
                    space::BodyTerms& terms) noexcept;

/// Returns the field that the masses of a subsystem feel, in H [m/s^2], as calc_tension_field() of
/// the plane does; on an axle whose mount moves, gravity less its acceleration, and on a support
/// that moves as prescribed less that of the hub.
space::Position calc_tension_field(const System<Space>& system, double t,
                                   const SubsystemData<Space>& data) noexcept;

/// Returns the rotation from the frame in which a load is resolved to B.
space::Rotation resolve_load(spatial::LoadFrame frame, const space::Rotation& R_HB,
                             const space::Rotation& R_0, const space::Rotation& section) noexcept;

}  // namespace spoke
