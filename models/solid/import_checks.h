#pragma once

// Checks of matrices from other programs.

#include "models/solid/import_entries.h"
#include "models/solid/imported_matrices.h"

namespace spoke::solid {

/// Throws InputError, "file: what is wrong, what is expected", unless the mass matrix is positive
/// definite and its moments are those of a body of this extent.
void check_mass(const ImportedMatrices& matrices, const MatrixFile& file);

/// Throws InputError unless K has the six rigid motions: |K R| < 1e-8 |K| |R|. `missing` names
/// nodes of the table that the matrices do not have; empty: none.
void check_rigid_motions(const ImportedMatrices& matrices, const MatrixFile& file,
                         const std::string& missing);

}  // namespace spoke::solid
