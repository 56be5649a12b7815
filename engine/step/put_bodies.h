#pragma once

// Start of the bodies of a system at given coordinates.

#include <Eigen/Core>
#include <vector>

#include "engine/step/step_context.h"

namespace spoke {

/// Puts all bodies at these coordinates, by subsystem, with no velocities of their own: by body
/// those of its joint, as space::put_joint() takes them, then those of its deformation.
template <class World>
void put_bodies(const std::vector<Eigen::VectorXd>& q, SystemContext<World>& context);

}  // namespace spoke
