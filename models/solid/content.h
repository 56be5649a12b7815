#pragma once

// The content of the files of a solid, whatever their names.

#include <cstdint>

#include "models/solid_body.h"

namespace spoke::solid {

/// Returns a hash of what a solid is made of: places, elements and sets of its mesh, or the bytes
/// of the files of its matrices. Files that cannot be read count as empty.
std::uint64_t hash_content(const spatial::SolidBody& body);

}  // namespace spoke::solid
