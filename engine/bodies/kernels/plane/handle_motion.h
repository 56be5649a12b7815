#pragma once

// Motion of the handles of a planar body relative to its frame.

#include "engine/bodies/table/body_data.h"

namespace spoke::plane {

/// Returns the place of the outboard handle in the body frame, deformed [m]. The inboard one is the
/// origin.
inline Position calc_outboard_position(const BodyData<Plane>& body) {
  const double* q = body.coordinates.q;
  return {body.model->body->length + q[body.outboard_at[0]], q[body.outboard_at[1]]};
}
/// Returns the velocity of the outboard handle relative to the body frame [m/s].
inline Position calc_outboard_velocity(const BodyData<Plane>& body) {
  return {body.coordinates.v[body.outboard_at[0]], body.coordinates.v[body.outboard_at[1]]};
}
/// Whether the section of a handle can rotate against the body frame.
inline bool turns(const Handle& handle) { return handle.coordinate[kRotation] >= 0; }
inline bool turns_inboard(const FlexibleBody& body) { return turns(body.inboard); }
/// Return the rotation of a handle's section relative to the body frame, and its rate [rad/s].
inline Rotation calc_inboard_rotation(const BodyData<Plane>& body) {
  if (!turns_inboard(*body.model->body)) return {};
  return Rotation::from_angle(body.coordinates.q[body.inboard_at[kRotation]]);
}
inline Rotation calc_outboard_rotation(const BodyData<Plane>& body) {
  if (!turns(body.model->body->outboard)) return {};
  return Rotation::from_angle(body.coordinates.q[body.outboard_at[kRotation]]);
}
inline double calc_inboard_rate(const BodyData<Plane>& body) {
  return body.coordinates.v[body.inboard_at[kRotation]];
}
inline double calc_outboard_rate(const BodyData<Plane>& body) {
  return body.coordinates.v[body.outboard_at[kRotation]];
}

/// Returns the foreshortening 1/2 int v'^2 dx of a body with geometric stiffening [m]; 0 for a
/// linear one, whose model has none. The stiffened model accounts for it in its energies, not in
/// its coordinates.
double calc_foreshortening(const BodyData<Plane>& body) noexcept;

}  // namespace spoke::plane
