#pragma once

// Local errors of generalized_alpha, estimated from the first iteration of a step. For a coordinate
//   q:  c h^2 (A_{n+1} - A_n),  c = beta - (af - am)/2 - 1/6 = 1/12 + (af - am)^2/4,
// the first term of the error of the step's quadrature of A, with A_{n+1} as the first iteration
// finds it. For an orientation, whose D' = w leaves out +-D x w/2 besides:
//   D:  c h^2 (w'_{n+1} - w'_n) -+ h^3/12 w x w',  - in the child's frame, + in the parent's.
// Angles are measured in rad, places by a length of the model. rk4 has no such estimate.

#include "engine/bodies/table/step_data.h"
#include "engine/step/integrator/generalized_alpha.h"

namespace spoke {

/// Estimates the error of the joint that carries a body, before the integrator takes the joint's
/// accelerations.
StepError estimate_joint_error(const GeneralizedAlpha& method,
                               const BodyData<Space>& body) noexcept;
inline StepError estimate_joint_error(const GeneralizedAlpha&, const BodyData<Plane>&) noexcept {
  return {};
}

/// Estimates the error of the deformation of a body whose accelerations are others than those of
/// the last step, by `change` of a coordinate at most, beta' h^2 |A_{n+1} - A_n| [m, rad].
template <class World>
StepError estimate_deformation_error(const GeneralizedAlpha& method, double change,
                                     const BodyData<World>& body) noexcept {
  // Displacements are the largest coordinates of a beam longer than 1 m, else rotations are.
  const double size = method.error_share * change / std::max(1.0, body.length);
  return {size, -1, -1, CoordinatePlace::deformation};
}

/// Estimates the error of a free hub, or of the angle about its axle, whose acceleration is
/// `found`, before the integrator takes it.
template <class World>
StepError estimate_hub_error(const System<World>& system, const GeneralizedAlpha& method,
                             const TwistOf<World>& found, const StepData<World>& data) noexcept;

/// Sets the lengths of a model by which errors of places are measured: for each flexible body its
/// own; for all else the greatest of these, or, where there is none, the reach of the rigid bodies.
template <class World>
void set_lengths(StepData<World>& data);

}  // namespace spoke
