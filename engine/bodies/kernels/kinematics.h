#pragma once

// Position and velocity analysis of a subsystem. The joints of a tree are explicit: rotations and
// twists follow outward, body by body, from the hub and the deformations, so the constraints hold
// to round-off and never drift (docs/formulation.md, section 3).

#include <algorithm>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Sets the relative rotations along a subsystem, from the deformations.
template <class World>
void calc_rotations(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on. Of a planar tip body the coordinates are those of its
/// inboard handle only; a clamped frame has none.
PartList parts_of_rotations(const SubsystemData<Plane>& data);

/// Sets the poses of all body frames of a subsystem in the hub frame, from the rotations and
/// deformations.
template <class World>
void calc_poses(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                ArenaVector<PoseOf<World>>& poses) noexcept;

/// Returns R_HB of a body, from the rotations.
template <class World>
RotationOf<World> calc_rotation_to_hub(const SubsystemData<World>& data, int body) noexcept;

/// Sets the twists of all body frames relative to the inertial frame, each resolved in its body
/// frame.
template <class World>
void calc_velocities(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on, besides prescribed motions; poses depend on no others.
template <class World>
PartList parts_of_velocities(const SubsystemData<World>& data) {
  PartList list = parts_of_rotations(data);
  graph::add_to(list, data.parts.rotations, data.parts.hub_state);
  return list;
}

/// Returns place, orientation and hub-frame twist of the hub, from its coordinates.
HubState<Plane> calc_hub_state(const StepData<Plane>& data);
HubState<Space> calc_hub_state(const StepData<Space>& data);

// Spatial subsystems: the handles of the bodies are placed first; the motions of the joints, which
// depend on velocities too, follow with the twists. Prescribed motions must have been set.

void calc_rotations(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept;
PartList parts_of_rotations(const SubsystemData<Space>& data);
void calc_poses(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                ArenaVector<space::Pose>& poses) noexcept;
space::Rotation calc_rotation_to_hub(const Subsystem<Space>& subsystem,
                                     const SubsystemData<Space>& data, int body) noexcept;
void calc_velocities(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept;

/// Whether a joint follows the azimuth of the hub.
bool follows_azimuth(const Subsystem<Space>& subsystem);
/// Whether a joint follows the azimuth of a hub that no support carries and whose rotation is an
/// unknown.
bool follows_free_hub(const System<Space>& system, const Subsystem<Space>& subsystem);

/// Sets the prescribed motions of the joints of subsystem `i` at time t [s]; planar joints have
/// none. Where the hub's rotation is an unknown, the azimuth is that of its coordinates, and its
/// acceleration that of the last iterate.
inline void prescribe_joints(const System<Plane>&, double, std::size_t, StepData<Plane>&) {}
void prescribe_joints(const System<Space>& system, double t, std::size_t i,
                      StepData<Space>& data) noexcept;
/// Return the parts that these motions depend on.
inline PartList parts_of_prescribed_joints(const System<Plane>&, std::size_t,
                                           const StepData<Plane>&) {
  return {};
}
PartList parts_of_prescribed_joints(const System<Space>& system, std::size_t i,
                                    const StepData<Space>& data);

/// Sets, in an implicit pass, the angular accelerations of the frames of subsystem `i`, about which
/// tension on its left-hand side is taken. They follow from those of the coordinates: the ones that
/// the pass before has found go with the velocities before its correction.
void set_angular_accelerations(const System<Plane>& system, std::size_t i,
                               StepData<Plane>& data) noexcept;
void set_angular_accelerations(const System<Space>& system, std::size_t i,
                               StepData<Space>& data) noexcept;
/// Whether implicit passes take tension of any body to their left-hand side, and so need them.
template <class World>
bool needs_angular_accelerations(const SubsystemData<World>& data) {
  const std::vector<BodyParts>& bodies = data.parts.bodies;
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const BodyParts& body) { return body.tension.index >= 0; });
}
/// Return the parts that they depend on besides the velocities; none where none is needed.
PartList parts_of_angular_accelerations(std::size_t i, const StepData<Plane>& data);
PartList parts_of_angular_accelerations(std::size_t i, const StepData<Space>& data);

}  // namespace spoke
