#pragma once

// The inertia of the frame of a body that deforms.

#include <Eigen/Core>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Subtracts M_RR X from the first six rows of a force.
inline void subtract_frame_inertia(const BodyData<Space>& body, Eigen::VectorXd& force) {
  const space::BodyTerms& terms = body.terms;
  const space::Position a = linear(body.X);
  const space::Angular alpha = angular(body.X);
  force.head<3>() -= body.model->body->mass() * a + cross(alpha, terms.S);
  force.segment<3>(3) -= cross(terms.S, a) + terms.Theta * alpha;
}

}  // namespace spoke
