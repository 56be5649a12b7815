#pragma once

// From what a scenario says of a beam to the beam that elements are made of.

#include "models/space/beam.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// The beam as the elements know it; a station is the same in both. Its damping is
/// stiffness_factor [s] for every strain. Precondition: the beam is fine.
space::Beam make_space_beam(const Beam& beam, double stiffness_factor);

}  // namespace spoke::spatial
