#pragma once

// Entries of matrices as files hold them, and the sparse matrices that they make.

#include <Eigen/SparseCore>
#include <functional>
#include <string>
#include <vector>

namespace spoke::solid {

using ImportedSparse = Eigen::SparseMatrix<double>;

/// An entry of a matrix, and the line that it stands in.
struct MatrixEntry {
  int row = 0;  ///< 3 node + axis
  int column = 0;
  int line = 0;
  double value = 0.0;
};

/// How a file holds a symmetric matrix.
enum class StoredTriangles {
  both,    ///< all entries
  one,     ///< those of one triangle
  either,  ///< all entries, or those of one triangle
};

/// The entries of a file.
struct MatrixFile {
  std::string file;
  std::string key;  ///< of the description which names the file: "mass"
  StoredTriangles triangles = StoredTriangles::either;
  std::vector<MatrixEntry> entries;
};

/// Returns what messages call a coordinate: "node 13, y".
using CoordinateName = std::function<std::string(int coordinate)>;

/// Makes a symmetric matrix, both triangles, without entries that are 0. Throws InputError,
/// "file:line: what is wrong", for entries that are there twice or not symmetric.
ImportedSparse make_symmetric(MatrixFile file, int size, const CoordinateName& name);

/// Returns the scalar matrix m (n x n) of a matrix m (x) 1_3. Throws InputError, "file: what is
/// wrong", if it has another structure; `advice` says what to do then.
ImportedSparse find_scalar_matrix(const ImportedSparse& matrix, const MatrixFile& file,
                                  const CoordinateName& name, const std::string& advice);

/// Returns the entry that is largest by its size; 0 of an empty matrix.
double largest_entry(const ImportedSparse& matrix);

}  // namespace spoke::solid
