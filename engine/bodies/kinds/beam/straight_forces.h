#pragma once

// Elastic forces and geometric stiffening of a body whose directions do not meet, four elements
// side by side.

#include "engine/bodies/space/lanes.h"

namespace spoke::space {

/// Sets the forces of both ends of all elements in scratch.lanes, -K q of the elastic coordinates
/// `elastic` and, if the body is stiffened, those of the tension at the coordinates and velocities
/// there. Of the terms it then sets those of the stiffening in the hub's equation, and the
/// tension's moment.
void calc_straight_forces(const BodyModel& model, const BodyMotion& motion, LaneRows::Kind elastic,
                          const BodyScratch& scratch, BodyTerms& terms) noexcept;

}  // namespace spoke::space
