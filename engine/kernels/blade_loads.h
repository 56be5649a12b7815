#pragma once

// What acts on a body besides its inertia and elasticity: forces and moments at sections, drag, and
// the work of gravity that rises (docs/formulation.md, section 2). All add to the terms of
// calc_body_terms().

#include "engine/table/step_data.h"

namespace spoke {

/// Adds a force [N] and a moment [N m] at a section to a body's right-hand side, and their power;
/// force in the body frame, `twist`: of the body frame.
void add_wrench(const Section& section, const Position& force, double moment, const Twist& twist,
                BodyData<Plane>& body) noexcept;

/// Adds the loads of the scenario on a body at time `t` [s]. R_HB: body frame to hub frame; R_0:
/// hub frame to inertial frame.
void add_loads(double t, const Rotation& R_HB, const Rotation& R_0, const Twist& twist,
               BodyData<Plane>& body) noexcept;

/// Adds the drag on body `j` of a subsystem at time `t` [s]. Of drag relative to the hub the poses
/// for drag must be those of the state.
void add_drags(double t, int j, SubsystemData<Plane>& data) noexcept;

/// What loads of the scenario, drag and loads of the user's do to body `j` of a subsystem at a
/// section and outboard of it: force [N] and moment about the deformed section [N m], body frame.
/// Poses, twists and the hub's motion must be those of the state at time `t` [s].
Twist calc_applied_beyond(double t, const Section& section, int j,
                          const SubsystemData<Plane>& data) noexcept;

/// Adds the power of gravity on a body; `gravity` in the body frame [m/s^2]. Its force is none: see
/// solve_hub().
void add_gravity_power(const Position& gravity, const Twist& twist, BodyData<Plane>& body) noexcept;

}  // namespace spoke
