#pragma once

// The elements of gmsh, by their numbers.

#include <array>

#include "models/solid_body.h"

namespace spoke::solid {

/// A kind of elements of gmsh.
struct GmshElement {
  const char* name;
  int dimension;
  int nodes;
  bool
      is_read;  ///< whether a mesh may hold it: lines, points, faces and the volumes of ElementKind
};

/// Returns a kind by its number; null: unknown.
const GmshElement* find_gmsh_element(int type);

/// Returns the kind of a volume element that is read.
spatial::ElementKind kind_of_gmsh(int type);

/// Puts the nodes of a volume element, as gmsh orders them, in the order of Abaqus.
std::array<int, 20> in_abaqus_order(spatial::ElementKind kind, const std::array<int, 20>& nodes);

}  // namespace spoke::solid
