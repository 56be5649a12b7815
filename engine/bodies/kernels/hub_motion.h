#pragma once

// Motion of the hub and of the root brackets on it: what support and drive prescribe, and the same
// acceleration in other frames (docs/formulation.md, sections 1 and 3).

#include "engine/bodies/table/step_data.h"

namespace spoke {

namespace plane {
/// The joint between the hub and a planar subsystem: its bracket stands at p in the hub frame, to
/// which R leads from the first body, and has the acceleration `bias` where the hub's is zero.
struct JointTerms {
  Rotation R;
  Position p;
  Twist bias;
};
}  // namespace plane
inline plane::JointTerms make_root_joint(const Subsystem<Plane>& subsystem,
                                         const SubsystemData<Plane>& data) {
  Twist bias = Twist::Zero();
  linear(bias) = centripetal(angular(data.hub->twist), subsystem.root.p);
  return {data.joints[0].R, subsystem.root.p, bias};
}

/// Acceleration of a subsystem's root bracket, less gravity, resolved in its first body's frame.
template <class World, class RootJoint>
TwistOf<World> calc_root_acceleration(const RootJoint& joint,
                                      const TwistOf<World>& hub_acceleration) {
  // T Y'' + b with T = [I, B p; 0, 1], in the hub frame.
  TwistOf<World> bracket = hub_acceleration;
  linear(bracket) += cross(angular(hub_acceleration), joint.p) + linear(joint.bias);
  angular(bracket) += angular(joint.bias);
  return joint.R.inverse() * bracket;
}

/// Returns the acceleration of the hub in the inertial frame from its solution (a - g, hub frame)
/// at time t [s].
template <class World>
TwistOf<World> calc_inertial_acceleration(const System<World>& system, double t,
                                          const HubState<World>& hub,
                                          const HubSolution<World>& solution);

/// Returns the acceleration of the hub that support and drive prescribe, less gravity, in the hub
/// frame, at time t [s]; components that are not prescribed are those that the mount carries along,
/// zero without one. `alpha`: the drive's [rad/s^2].
template <class World>
TwistOf<World> calc_prescribed_acceleration(const System<World>& system, double t,
                                            const HubState<World>& hub, double alpha);

/// Returns the angular acceleration of the mount about the axle [rad/s^2].
inline double calc_carried_spin_up(const System<Plane>&, double) { return 0.0; }
double calc_carried_spin_up(const System<Space>& system, double t) noexcept;

/// Returns the velocity (resolved in H) and angular velocity of the hub at the end of a step.
space::Twist calc_recorded_twist(const SystemRecord<Space>& record) noexcept;

/// Sets the orientation that the mount gives the hub at time t [s]; that of a free hub stays.
inline void place_axle(const System<Plane>&, double, BodyTypes<Plane>::Attitude&) noexcept {}
void place_axle(const System<Space>& system, double t, space::HubAttitude& attitude) noexcept;

/// Sets position, velocity and acceleration of the hub's prescribed components at time t [s]. With
/// a mount they depend on the axle's angle and speed, which must be set if they are free.
template <class World>
void impose_hub_motion(const System<World>& system, double t, CoordinateBlock& hub) noexcept;

/// Returns the whole motion of a hub that support and drive prescribe, at time t [s].
template <class World>
PrescribedHub<World> calc_prescribed_motion(const System<World>& system, double t) noexcept;

/// Whether support and drive prescribe the whole motion of the hub. The solution of (P 9) is then
/// known but for the reaction, which no motion depends on.
template <class World>
bool is_prescribed(const System<World>& system);

}  // namespace spoke
