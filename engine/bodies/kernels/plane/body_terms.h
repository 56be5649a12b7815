#pragma once

// The terms of a body's equation of motion, (P 3), at a state.

#include "engine/bodies/table/step_data.h"

namespace spoke::plane {

/// Motion on which a body's terms depend besides its deformation.
struct BodyMotion {
  double speed = 0.0;      ///< angular velocity w of the body frame [rad/s]
  double hub_speed = 0.0;  ///< w0, for the centrifugal stiffening [rad/s]
};

/// Whether small masses that turn take off the rotary inertia of a body.
inline bool has_turning(const FlexibleBody& body) { return body.turning.size() > 0; }
/// Returns what the centrifugal inertia of a body is made of, by its geometric stiffening or by its
/// turning; null: neither.
inline const SymmetricBand<3>* centrifugal_of(const TreeBody<Plane>& member) {
  return has_turning(*member.body) ? &member.body->turning : member.stiffening.centrifugal.get();
}

/// Calculates the state-dependent mass terms and the right-hand side of a body, (P 3), with its
/// damping: terms, c_theta and Q_f of `data` (docs/formulation.md, section 2). Elastic and damping
/// forces are taken at q_elastic and v_elastic. Without loads.
void calc_body_terms(const BodyMotion& motion, const Damping& damping,
                     BodyData<Plane>& data) noexcept;

}  // namespace spoke::plane
