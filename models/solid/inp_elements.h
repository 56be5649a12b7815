#pragma once

// The elements of Abaqus and CalculiX, by their types.

#include <string_view>

#include "models/solid_body.h"

namespace spoke::solid {

/// What a type of elements is to a mesh.
enum class InpRole { unknown, volume, face, ignored };
struct InpElement {
  InpRole role = InpRole::unknown;
  int nodes = 0;                                            ///< of volumes and faces
  spatial::ElementKind kind = spatial::ElementKind::tet10;  ///< of volumes
};

/// Returns what a type in capital letters is: "C3D10", "CPS6", "T3D2".
InpElement find_inp_element(std::string_view type);

}  // namespace spoke::solid
