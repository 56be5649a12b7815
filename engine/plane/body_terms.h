#pragma once

// The terms of a body's equation of motion, (P 3), at a state.

#include "engine/table/step_data.h"

namespace spoke::plane {

/// Motion on which a body's terms depend besides its deformation.
struct BodyMotion {
  double speed = 0.0;      ///< angular velocity w of the body frame [rad/s]
  double hub_speed = 0.0;  ///< w0, for the centrifugal stiffening [rad/s]
};

/// Calculates the state-dependent mass terms and the right-hand side of a body, (P 3), with its
/// damping: terms, c_theta and Q_f of `data` (docs/formulation.md, section 2). Elastic and damping
/// forces are taken at q_elastic and v_elastic. Without loads.
void calc_body_terms(const BodyMotion& motion, const Damping& damping,
                     BodyData<Plane>& data) noexcept;

}  // namespace spoke::plane
