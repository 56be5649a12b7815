#pragma once

// How files write vectors: with three components in space, in the plane as a place or as an angle.

#include <array>
#include <cstddef>
#include <string_view>

namespace spoke::spatial {

/// The components of a vector that a file gives; the others are 0. One alone is a number, several
/// are an array.
struct VectorShape {
  std::size_t first, count;
  std::array<std::string_view, 3> names;  ///< keys of their arrays over time
};
inline constexpr VectorShape kVectorInSpace{0, 3, {"x", "y", "z"}};
inline constexpr VectorShape kPlaceInPlane{0, 2, {"x", "y"}};
inline constexpr VectorShape kAngleInPlane{2, 1, {"value"}};

/// Returns the shape of places and directions.
constexpr const VectorShape& place_shape(bool in_plane) {
  return in_plane ? kPlaceInPlane : kVectorInSpace;
}
/// Returns the shape of rotation vectors.
constexpr const VectorShape& rotation_shape(bool in_plane) {
  return in_plane ? kAngleInPlane : kVectorInSpace;
}

}  // namespace spoke::spatial
