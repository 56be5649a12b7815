#pragma once

// Where the hub of a model is before anything moves.

#include <Eigen/Core>

#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns the place of the hub of a rotor, undeformed and with joint coordinates zero, inertial
/// frame [m]. Precondition: check_model() accepts the model.
Eigen::Vector3d find_hub_place(const Model& model, int rotor = 0);

}  // namespace spoke::spatial
