#pragma once

// Matrices of a mesh of a box, files of them as other programs write them, and CalculiX itself,
// where it is installed, for tests.

#include <Eigen/SparseCore>
#include <filesystem>
#include <string>
#include <vector>

#include "models/solid/import.h"
#include "tests/models/solid/grid_mesh.h"

namespace spoke::test {

/// Mass and stiffness of a mesh; both triangles, rows 3 node + axis.
struct AssembledMatrices {
  spatial::SolidMesh mesh;
  Eigen::SparseMatrix<double> m;  ///< n x n
  Eigen::SparseMatrix<double> M;  ///< m (x) 1_3
  Eigen::SparseMatrix<double> K;
};

/// Assembles the matrices of a box of aluminium (7e10 Pa, 0.33, 2700 kg/m^3); its nodes have the
/// labels 10, 13, 16, ...
AssembledMatrices assemble(const GridMesh& grid);

/// Returns scalar (x) 1_3.
Eigen::SparseMatrix<double> spread(const Eigen::SparseMatrix<double>& scalar);

void write_text(const std::filesystem::path& file, const std::string& text);

/// Lines "label x y z", or "x y z".
std::string table_text(const spatial::SolidMesh& mesh, bool has_labels);
/// Lines "row column value" of the upper triangle, as CalculiX writes it.
std::string calculix_text(const Eigen::SparseMatrix<double>& matrix);
/// Lines "label.axis".
std::string dof_text(const spatial::SolidMesh& mesh);
/// Lines "node, dof, node, dof, value" of the lower triangle.
std::string abaqus_text(const Eigen::SparseMatrix<double>& matrix, const spatial::SolidMesh& mesh);
/// Lines "row column value" of all entries.
std::string coordinate_text(const Eigen::SparseMatrix<double>& matrix);
/// A file of Matrix Market, coordinate or array, general or symmetric.
std::string market_text(const Eigen::SparseMatrix<double>& matrix, bool is_array,
                        bool is_symmetric);
/// An .inp file with nodes, elements (hex20, tet10, ...), material, the sets of the mesh, and
/// `step` behind them.
std::string inp_text(const spatial::SolidMesh& mesh, const std::string& step);

/// Writes bar.sti, bar.mas, bar.dof and nodes.txt, and returns their description.
spatial::SolidMatrices write_calculix(const std::filesystem::path& folder,
                                      const AssembledMatrices& matrices);

/// Whether ccx can be run.
bool has_calculix();
/// Runs ccx in a folder on `text`, written there as `name`.inp; it must succeed.
void run_calculix(const std::filesystem::path& folder, const std::string& name,
                  const std::string& text);
/// Reads frequencies [Hz] of a .dat file: mode, eigenvalue, rad/s, Hz, imaginary part.
std::vector<double> read_frequencies(const std::filesystem::path& file);

}  // namespace spoke::test
