#pragma once

// The nodes of a beam that is cut into bodies.

#include <vector>

#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns the stations of the nodes of each body of a beam, from root to tip. `joints` part the
/// beam, at ascending stations within it; at `places` there are nodes.
std::vector<std::vector<double>> cut_beam(const Beam& beam, const std::vector<double>& joints,
                                          const std::vector<double>& places);

/// Returns the distance [m] up to which two stations of a beam of this length count as one place.
double resolution_of(const Beam& beam);

}  // namespace spoke::spatial
