#pragma once

// Readers of matrices, by the program that wrote them.

#include <string>
#include <vector>

#include "models/solid/import_entries.h"
#include "models/solid/import_nodes.h"

namespace spoke::solid {

/// A file of a matrix, and the key of the description that names it.
struct MatrixName {
  std::string file;
  std::string key;
};

/// Matrices as their files hold them. Rows and columns are 3 node + axis, by the table of nodes.
struct MatrixFiles {
  std::vector<MatrixFile> files;  ///< in the order of their names
  std::vector<char> used;         ///< by node of the table, whether the matrices have it
};

/// Reads files *.sti and *.mas of CalculiX, and the file *.dof beside the first of them.
MatrixFiles read_calculix(const std::vector<MatrixName>& names, const NodeTable& nodes);
/// Reads matrices of Abaqus, of either format.
MatrixFiles read_abaqus(const std::vector<MatrixName>& names, const NodeTable& nodes);
/// Reads files of Matrix Market, coordinate or array, of real numbers.
MatrixFiles read_matrix_market(const std::vector<MatrixName>& names, const NodeTable& nodes);

}  // namespace spoke::solid
