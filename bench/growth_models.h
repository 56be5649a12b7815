#pragma once

// Models of any size, to measure how costs grow.

#include "models/scenario.h"

namespace spoke::bench {

/// Returns a straight blade in so many bodies: models/spatial_wu_haug.toml or
/// models/paper_rotor.toml without stiffening and sensors.
Scenario chain_in_space(int bodies);
Scenario chain_in_plane(int bodies);

/// Returns a rotor of models/spatial_wu_haug.toml with so many blades of four bodies.
Scenario rotor_in_space(int blades);

/// Returns such a rotor with so many blades of so many bodies, each blade on so many springs, rods
/// that give, from places along it to the hub.
Scenario sprung_rotor(int blades, int bodies, int springs);

/// Returns a bar that turns, of so many cells along it, in the coordinates of its nodes.
Scenario nodal_bar(int cells);
/// Returns the number of its coordinates.
int count_unknowns(int cells);

}  // namespace spoke::bench
