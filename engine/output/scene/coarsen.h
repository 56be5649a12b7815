#pragma once

// Fewer triangles for a surface, for drawings.

#include <array>
#include <cstddef>
#include <vector>

#include "models/mount_motion.h"

namespace spoke::scene {

using Triangle = std::array<int, 3>;

/// Merges points of a closed surface until at most `most` triangles are left, or no more can go
/// without folding it. What is left are points of the surface, where it is curved or has edges
/// closer together. Orientation is kept.
std::vector<Triangle> coarsen(const std::vector<spatial::Vector>& points,
                              std::vector<Triangle> triangles, std::size_t most);

/// Finds the edges at which two triangles meet at more than 35 degrees, or that have one only.
std::vector<std::array<int, 2>> find_sharp_edges(const std::vector<spatial::Vector>& points,
                                                 const std::vector<Triangle>& triangles);

}  // namespace spoke::scene
