#pragma once

// The faces of all elements, sorted so that those of equal corners stand side by side.

#include <array>
#include <tuple>
#include <vector>

#include "models/solid_body.h"

namespace spoke::solid {

/// A face of an element by its corners.
struct ElementFace {
  std::array<int, 4> corners;  ///< ascending; of a triangle the first is -1
  int element;
  int side;  ///< from 0, in the order of faces_of()

  friend bool operator<(const ElementFace& a, const ElementFace& b) {
    return std::tie(a.corners, a.element, a.side) < std::tie(b.corners, b.element, b.side);
  }
};

/// Returns the faces of all elements by their corners, then their elements.
std::vector<ElementFace> sort_faces(const spatial::SolidMesh& mesh);

/// Returns 3 or 4.
int count_corners(const spatial::SolidFace& face);

}  // namespace spoke::solid
