#pragma once

// The matrices of bearings in scenarios: read, checked, and written back.

#include <optional>
#include <string_view>

#include "models/loop.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/toml_section.h"
#include "models/support/json.h"

namespace spoke {

/// What is said of matrices of another kind of closure.
inline constexpr std::string_view kMatrixOfOther =
    "is a matrix, expected one only with kind \"bearing\"";

/// Reads speed, stiffness and damping of a bearing; none if it has no matrices. Throws InputError
/// about matrices of another shape.
std::optional<BearingMatrices> read_matrices(const TomlSection& section);
/// Finds a fault of the matrices of a loop, whatever its kind.
spatial::Fault find_matrix_fault(const Loop& loop);
/// Adds what read_matrices() reads.
void add_matrices(const BearingMatrices& matrices, Json& loop);

}  // namespace spoke
