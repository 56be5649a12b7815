#pragma once

// Loads on a body besides its inertia and elasticity: forces and moments at sections, drag, and the
// work of gravity that rises (docs/formulation.md, section 2). All add to the terms of
// calc_body_terms().

#include "engine/bodies/kernels/plane/applied_tension.h"
#include "engine/bodies/table/step_data.h"

namespace spoke::plane {

/// Adds a force [N] and a moment [N m] at a section to a body's right-hand side, and their power;
/// force in the body frame, `twist`: of the body frame.
void add_wrench(const Section& section, const Position& force, double moment, const Twist& twist,
                BodyData<Plane>& body) noexcept;

// `tension`: the tension that their forces add to, or null.

/// Adds the loads of the scenario on a body at time `t` [s]. R_HB: body frame to hub frame; R_0:
/// hub frame to inertial frame.
void add_loads(double t, const Rotation& R_HB, const Rotation& R_0, const Twist& twist,
               BodyData<Plane>& body, AppliedTension* tension) noexcept;

/// Adds the drag on body `j` of a subsystem at time `t` [s]. For drag relative to the hub the poses
/// for drag must be those of the state.
void add_drags(double t, int j, SubsystemData<Plane>& data, AppliedTension* tension) noexcept;

/// Frames in which the forces that are applied to a body are resolved.
struct ForceFrames {
  Pose X_HB;     ///< pose of the body in the hub's frame, its place only where drag depends on it
  Rotation R_0;  ///< from the hub's frame to the inertial one
};
/// Whether forces on a body, in the hub's frame, depend on its pose and deformation.
bool depend_on_pose(const BodyData<Plane>& body) noexcept;
/// Finds the frames of body `j` at the state in the table; the pose only where forces depend on it.
ForceFrames find_force_frames(const SubsystemData<Plane>& data, int j) noexcept;

/// Returns the force of a load [N] without weight and course, hub frame, at a section that has
/// turned by `rotation` [rad] in the body frame.
Position calc_load_force(const BodyLoad<Plane>& load, double rotation,
                         const ForceFrames& frames) noexcept;
/// Returns the force of drag [N] at a section, without weight and course, hub frame.
Position calc_drag_force(const BodyDrag<Plane>& drag, const Section& section, const Twist& twist,
                         const ForceFrames& frames, const HubState<Plane>& hub,
                         const BodyData<Plane>& body) noexcept;

/// Calls visit(section, force) for all that is applied to body `j` of a subsystem at time `t` [s]:
/// loads, drag, loads of the user's; force in the hub's frame [N].
template <class Visit>
void visit_forces(double t, int j, const SubsystemData<Plane>& data, const Visit& visit) {
  const BodyData<Plane>& body = data.bodies[static_cast<std::size_t>(j)];
  if (!body.forces.applied) return;
  const ForceFrames frames = find_force_frames(data, j);
  for (const auto& [load, sections] : body.loads) {
    const double factor = load->course->value(t);
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const double rotation =
          value_at(sections[k].slope, sections[k].bending_at, body.coordinates.q);
      visit(sections[k],
            Position(load->points[k].weight * factor * calc_load_force(*load, rotation, frames)));
    }
  }
  const Twist& twist = data.twists[static_cast<std::size_t>(j)];
  for (const auto& [drag, sections] : body.drags) {
    const double factor = drag->course->value(t);
    for (std::size_t k = 0; k < sections.size(); ++k)
      visit(sections[k],
            Position(drag->points[k].weight * factor *
                     calc_drag_force(*drag, sections[k], twist, frames, *data.hub, body)));
  }
  for (const auto& [section, wrench] : body.applied)
    visit(*section, Position(frames.X_HB.R * wrench->force));
}

/// Returns the parts on which the loads and drags among them depend.
PartList parts_of_forces(std::size_t j, const SubsystemData<Plane>& data);

/// Returns the force [N] and the moment about the deformed section [N m] that loads of the
/// scenario, drag and loads of the user's exert on body `j` of a subsystem at a section and
/// outboard of it; body frame. Poses, twists and the hub's motion must be those of the state at
/// time `t` [s].
Twist calc_applied_beyond(double t, const Section& section, int j,
                          const SubsystemData<Plane>& data) noexcept;

/// Adds the power of gravity on a body; `gravity` in the body frame [m/s^2]. It exerts no force in
/// these equations: see solve_hub().
void add_gravity_power(const Position& gravity, const Twist& twist, BodyData<Plane>& body) noexcept;

/// Adds the wrenches on a body to its right-hand side, and their power; `twist`: of its frame,
/// `tension`: the tension that their forces add to, or null.
void add_applied(const Twist& twist, BodyData<Plane>& body, AppliedTension* tension) noexcept;

}  // namespace spoke::plane
