#pragma once

// The joints of a subsystem's tree as all formulations see them, and the places of their results:
// once for the chains of the plane, whose joints are rigid, and the trees of space.

#include <cassert>
#include <cstddef>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/table/step_data.h"
#include "engine/bodies/tree/joint_recovery.h"
#include "engine/bodies/tree/joint_rows.h"

namespace spoke {

/// Returns the number of coordinates of the joint that carries a body.
inline int joint_coordinates(const TreeBody<Plane>&) { return 0; }
inline int joint_coordinates(const TreeBody<Space>& body) { return body.joint.joint.coordinates; }

/// Returns the joint that carries body `j`, from the hub or from a handle of its parent, with the
/// members R, p and bias and, in space, those of its coordinates
/// (engine/bodies/tree/joint_elimination.h).
inline plane::JointTerms joint_of(const Subsystem<Plane>& subsystem,
                                  const SubsystemData<Plane>& data, std::size_t j) {
  assert(j < data.joints.size());
  if (j == 0) return make_root_joint(subsystem, data);
  return {data.joints[j].R, Position::Zero(), Twist::Zero()};
}
inline space::JointTerms joint_of(const Subsystem<Space>& subsystem,
                                  const SubsystemData<Space>& data, std::size_t j) {
  assert(j < data.joints.size() && data.bodies[j].joint.forces);
  return {subsystem.bodies[j].joint.joint, data.joints[j], *data.bodies[j].joint.forces};
}

/// Returns the place of the accelerations of the coordinates of a body's joint; null in the plane.
inline double* joint_accelerations(BodyData<Plane>&) { return nullptr; }
inline double* joint_accelerations(BodyData<Space>& body) { return body.joint.a_found; }

/// Returns the wrench on handle `h` of body `j`, in its frame.
inline Twist& wrench_on(SubsystemData<Plane>& data, std::size_t j, int h) {
  assert(j < data.wrenches.size() && (h == 0 || h == 1));
  return h == 0 ? data.wrenches[j].inboard : data.wrenches[j].outboard;
}
inline space::Twist& wrench_on(SubsystemData<Space>& data, std::size_t j, int h) {
  assert(j < data.bodies.size() && h >= 0 && h < data.bodies[j].work.port.handles);
  return data.bodies[j].work.wrenches[h];
}
template <class World>
const TwistOf<World>& wrench_on(const SubsystemData<World>& data, std::size_t j, int h) {
  return wrench_on(const_cast<SubsystemData<World>&>(data), j, h);
}

/// Sets the wrench on the inboard handle of body `j`. In the plane, nothing hangs at a tip's other
/// handle.
inline void set_inboard_wrench(const Twist& F, std::size_t j, SubsystemData<Plane>& data) {
  data.wrenches[j] = {F, Twist::Zero()};
}
inline void set_inboard_wrench(const space::Twist& F, std::size_t j, SubsystemData<Space>& data) {
  data.wrenches[j].inboard = data.bodies[j].work.wrenches[0] = F;
}

/// Sets the wrenches on all handles of a subsystem. `inboard(j)`: on the inboard one of body j, the
/// multipliers of (P 8).
template <class World, class Inboard>
void set_wrenches(const Subsystem<World>& subsystem, const Inboard& inboard,
                  SubsystemData<World>& data) {
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const TreeBody<World>& body = subsystem.bodies[j];
    const TwistOf<World> F = inboard(static_cast<int>(j));
    set_inboard_wrench(F, j, data);
    if (body.parent >= 0)
      wrench_on(data, static_cast<std::size_t>(body.parent), body.handle) =
          tree::pass_to_parent<World>(joint_of(subsystem, data, j), F);
  }
}

/// Reports the work of the drives of the joint that carries body `j`; planar joints have none.
inline void report_drives(std::size_t, SubsystemData<Plane>&) noexcept {}
void report_drives(std::size_t j, SubsystemData<Space>& data) noexcept;

}  // namespace spoke
