#pragma once

// The surface of a mesh: the faces that belong to one element only.

#include <array>
#include <vector>

#include "models/solid_body.h"

namespace spoke::solid {

/// A face of the surface of a mesh, its nodes in the order in which they turn about the normal that
/// points out of the body (right-handed).
struct SurfaceFace {
  spatial::SolidFace face;
  int element = 0;  ///< index of its element
};

/// Finds the faces that belong to one element only, in the order of the elements.
std::vector<SurfaceFace> find_surface(const spatial::SolidMesh& mesh);

/// Returns the faces of an element, in the order of Abaqus's S1, S2, ..., oriented outward.
std::vector<spatial::SolidFace> faces_of(const spatial::SolidElement& element);

/// Splits faces into triangles of their nodes, for drawing, with the faces' orientation: a triangle
/// with mid nodes into 4, a quadrilateral into 2, with mid nodes into 6.
std::vector<std::array<int, 3>> split_into_triangles(const std::vector<SurfaceFace>& faces);

/// Returns the nodes of faces, ascending, each once.
std::vector<int> nodes_of(const std::vector<SurfaceFace>& faces);

}  // namespace spoke::solid
