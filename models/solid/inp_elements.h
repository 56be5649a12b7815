#pragma once

// The elements of Abaqus and CalculiX, by their types.

#include <string_view>

#include "models/solid_body.h"

namespace spoke::solid {

/// What a type of elements is to a mesh. Faces and lines name places of the body, as long as no
/// section makes shells or beams of them.
enum class InpRole { unknown, volume, face, line, mass };
struct InpElement {
  InpRole role = InpRole::unknown;
  int nodes = 0;                                            ///< of lines at most so many
  spatial::ElementKind kind = spatial::ElementKind::tet10;  ///< of volumes
};

/// Returns what a type in capital letters is: "C3D10", "CPS6", "T3D2".
InpElement find_inp_element(std::string_view type);

}  // namespace spoke::solid
