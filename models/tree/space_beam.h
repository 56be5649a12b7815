#pragma once

// From what a scenario says of beams and joints to the constants of space.

#include "models/space/beam.h"
#include "models/space/joint.h"
#include "models/spatial_model.h"
#include "models/tree/tree.h"

namespace spoke::spatial {

/// The beam as the elements know it; a station is the same in both. Its damping is
/// stiffness_factor [s] for every strain. Precondition: the beam is fine.
space::Beam make_space_beam(const Beam& beam, double stiffness_factor);

/// The joint that carries a body: its coordinates in the order of Joint::coordinates; those that
/// are prescribed are driven.
space::Joint make_space_joint(const TreeBody& body);

}  // namespace spoke::spatial
