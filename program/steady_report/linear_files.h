#pragma once

// Writes the matrices and linear.json of `spoke linearize`; docs/modes.md documents them.

#include <string>

#include "engine/linearize.h"

namespace spoke::steady_report {

/// Returns a matrix in Matrix Market's format "coordinate real general", all digits.
std::string make_matrix_market(const Eigen::SparseMatrix<double>& matrix);
/// Returns linear.json: speed, of several rotors all, frame, and names and units of rows and
/// columns.
std::string make_json(const LinearSystem& system);

}  // namespace spoke::steady_report
