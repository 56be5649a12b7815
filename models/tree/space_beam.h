#pragma once

// Makes the beam that elements are built from out of the description of a beam.

#include "models/space/beam.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns the beam that elements are built from, with stations as in the description.
/// Precondition: the beam is fine.
space::Beam make_space_beam(const Beam& beam, const DirectionDamping& damping = {});

/// Returns where the axis begins in the beam's frame: its sweep and prebend at the first station
/// [m].
Vector find_axis_begin(const Sections& sections);

}  // namespace spoke::spatial
