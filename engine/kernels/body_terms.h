#pragma once

// The terms of a body's equation of motion, (P 3), at a state.

#include "engine/table/step_data.h"

namespace spoke {

/// What a body's terms depend on besides its deformation.
struct BodyMotion {
  double speed = 0.0;      ///< angular velocity w of the body frame [rad/s]
  double hub_speed = 0.0;  ///< w0, for the centrifugal stiffening [rad/s]
};

/// Calculates the state-dependent mass terms and the right-hand side of a body, (P 3), with its
/// damping: terms, c_theta and Q_f of `data` (docs/formulation.md, section 2). Elastic and damping
/// forces are taken at q_elastic and v_elastic. Without loads.
void calc_body_terms(const BodyMotion& motion, const Damping& damping, BodyData& data) noexcept;

/// Adds the body's point loads at time `t` [s] to its right-hand side, and their power.
/// R_HB: body frame to hub frame; R_0: hub frame to inertial frame; `twist`: of the body frame.
void add_loads(double t, const Rotation& R_HB, const Twist& twist, const Rotation& R_0,
               BodyData& data) noexcept;

/// What point loads and loads of the user's do to a body at a section and outboard of it: force [N]
/// and moment about the deformed section [N m], body frame. Frames as in add_loads().
Twist calc_applied_beyond(double t, const Rotation& R_HB, const Rotation& R_0,
                          const Section& section, const BodyData& data) noexcept;

}  // namespace spoke
