#pragma once

// Solids from matrices that other programs have assembled.

#include "models/solid/imported_matrices.h"
#include "models/solid/solid.h"
#include "models/solid_body.h"

namespace spoke::solid {

/// Reads matrices and checks that they are those of a body that nothing holds. The files' unit of
/// length is `length_scale` metres, their units of force and time are newton and second: of mm and
/// N masses are in t. Throws InputError, its text "file:line: what is wrong, what is expected" and
/// its place().key "mass", "stiffness", ...
ImportedMatrices read_matrices(const spatial::SolidMatrices& files, double length_scale);

/// Returns the entries of a scalar matrix in the places of those of m, which has some wherever it
/// does.
Eigen::VectorXd values_in_places_of(const ImportedMatrices::Sparse& m,
                                    const ImportedMatrices::Sparse& scalar);

/// Finds mass and interfaces of a solid of matrices, as make_geometry() does of one with a mesh.
/// The nodes of interfaces count equally.
SolidGeometry make_geometry_of_matrices(const spatial::SolidBody& body,
                                        const ImportedMatrices& matrices);

}  // namespace spoke::solid
