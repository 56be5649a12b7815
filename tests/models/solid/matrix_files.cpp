#include "tests/models/solid/matrix_files.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "models/solid/elements.h"
#include "tests/models/solid/solids.h"

namespace spoke::test {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr spatial::SolidMaterial kBoxMaterial = {
    .youngs_modulus = 7e10, .poissons_ratio = 0.33, .density = 2700.0};

std::string number(double value) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

/// Writes a line for each entry that `keeps` lets through.
template <class Keeps, class Line>
std::string lines_of(const Sparse& matrix, const Keeps& keeps, const Line& line) {
  std::string text;
  for (int column = 0; column < matrix.outerSize(); ++column)
    for (Sparse::InnerIterator entry(matrix, column); entry; ++entry)
      if (keeps(entry.row(), column))
        text += line(static_cast<int>(entry.row()), column) + number(entry.value()) + '\n';
  return text;
}

std::string indices(int row, int column) {
  return std::to_string(row + 1) + ' ' + std::to_string(column + 1) + ' ';
}

const char* abaqus_name(spatial::ElementKind kind) {
  switch (kind) {
    case spatial::ElementKind::tet4:
      return "C3D4";
    case spatial::ElementKind::tet10:
      return "C3D10";
    case spatial::ElementKind::hex8:
      return "C3D8";
    default:
      return "C3D20";
  }
}

std::string label_text(const spatial::SolidMesh& mesh, int node) {
  return std::to_string(mesh.labels[static_cast<std::size_t>(node)]);
}

}  // namespace

Sparse spread(const Sparse& scalar) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < scalar.outerSize(); ++column)
    for (Sparse::InnerIterator entry(scalar, column); entry; ++entry)
      for (int axis = 0; axis < 3; ++axis)
        entries.emplace_back(3 * static_cast<int>(entry.row()) + axis, 3 * column + axis,
                             entry.value());
  Sparse matrix(3 * scalar.rows(), 3 * scalar.cols());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

AssembledMatrices assemble(const GridMesh& grid) {
  AssembledMatrices result{.mesh = make_grid_mesh(grid), .m = {}, .M = {}, .K = {}};
  const int n = static_cast<int>(result.mesh.nodes.size());
  for (int node = 0; node < n; ++node) result.mesh.labels.push_back(10 + 3 * node);
  std::vector<Eigen::Triplet<double>> m, K;
  for (const spatial::SolidElement& element : result.mesh.elements) {
    const solid::NodeColumns x = solid::places_of(result.mesh, element);
    const auto me = solid::calc_mass(element.kind, x, kBoxMaterial.density);
    const auto Ke = solid::calc_stiffness(element.kind, x, solid::lame_of(kBoxMaterial));
    const int count = spatial::count_nodes(element.kind);
    for (int i = 0; i < 3 * count; ++i) {
      for (int j = 0; j < 3 * count; ++j) {
        const int row = element.nodes[static_cast<std::size_t>(i / 3)];
        const int column = element.nodes[static_cast<std::size_t>(j / 3)];
        K.emplace_back(3 * row + i % 3, 3 * column + j % 3, Ke(i, j));
        if (i % 3 == 0 && j % 3 == 0) m.emplace_back(row, column, me(i / 3, j / 3));
      }
    }
  }
  result.m.resize(n, n);
  result.m.setFromTriplets(m.begin(), m.end());
  result.K.resize(3 * n, 3 * n);
  result.K.setFromTriplets(K.begin(), K.end());
  result.K = Sparse(0.5 * (result.K + Sparse(result.K.transpose())));
  result.m = Sparse(0.5 * (result.m + Sparse(result.m.transpose())));
  result.M = spread(result.m);
  return result;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string table_text(const spatial::SolidMesh& mesh, bool has_labels) {
  std::string text = "# nodes\n";
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const spatial::Vector& x = mesh.nodes[node];
    if (has_labels) text += label_text(mesh, static_cast<int>(node)) + ' ';
    text += number(x[0]) + ' ' + number(x[1]) + ' ' + number(x[2]) + '\n';
  }
  return text;
}

std::string calculix_text(const Sparse& matrix) {
  return lines_of(
      matrix, [](auto row, auto column) { return row <= column; }, indices);
}

std::string dof_text(const spatial::SolidMesh& mesh) {
  std::string text;
  for (const int label : mesh.labels)
    for (const char* axis : {".1\n", ".2\n", ".3\n"}) text += std::to_string(label) + axis;
  return text;
}

std::string abaqus_text(const Sparse& matrix, const spatial::SolidMesh& mesh) {
  return "** matrix\n" +
         lines_of(
             matrix, [](auto row, auto column) { return row >= column; },
             [&](int row, int column) {
               return label_text(mesh, row / 3) + "," + std::to_string(row % 3 + 1) + ", " +
                      label_text(mesh, column / 3) + "," + std::to_string(column % 3 + 1) + ", ";
             });
}

std::string coordinate_text(const Sparse& matrix) {
  return lines_of(
      matrix, [](auto, auto) { return true; }, indices);
}

std::string market_text(const Sparse& matrix, bool is_array, bool is_symmetric) {
  std::string text = std::string("%%MatrixMarket matrix ") + (is_array ? "array" : "coordinate") +
                     " real " + (is_symmetric ? "symmetric" : "general") + "\n% a comment\n" +
                     std::to_string(matrix.rows()) + ' ' + std::to_string(matrix.cols());
  if (is_array) {
    text += '\n';
    for (int column = 0; column < matrix.cols(); ++column)
      for (int row = is_symmetric ? column : 0; row < matrix.rows(); ++row)
        text += number(matrix.coeff(row, column)) + '\n';
    return text;
  }
  int count = 0;
  const std::string entries = lines_of(
      matrix, [&](auto row, auto column) { return !is_symmetric || row >= column; },
      [&](int row, int column) {
        ++count;
        return indices(row, column);
      });
  return text + ' ' + std::to_string(count) + '\n' + entries;
}

std::string inp_text(const spatial::SolidMesh& mesh, const std::string& step) {
  std::string text = "*NODE, NSET=ALL\n";
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const spatial::Vector& x = mesh.nodes[node];
    text += label_text(mesh, static_cast<int>(node)) + ", " + number(x[0]) + ", " + number(x[1]) +
            ", " + number(x[2]) + '\n';
  }
  text += std::string("*ELEMENT, TYPE=") + abaqus_name(mesh.elements.at(0).kind) + ", ELSET=BODY";
  int id = 0;
  for (const spatial::SolidElement& element : mesh.elements) {
    text += '\n' + std::to_string(++id);
    for (int k = 0; k < spatial::count_nodes(element.kind); ++k)
      text += (k % 8 == 7 ? ",\n" : ", ") +
              label_text(mesh, element.nodes[static_cast<std::size_t>(k)]);
  }
  text += '\n';
  for (const spatial::SolidNodeSet& set : mesh.sets) {
    text += "*NSET, NSET=" + set.name + '\n';
    for (const int node : set.nodes) text += label_text(mesh, node) + ",\n";
  }
  return text +
         "*MATERIAL, NAME=ALU\n*ELASTIC\n7e10, 0.33\n*DENSITY\n2700\n"
         "*SOLID SECTION, ELSET=BODY, MATERIAL=ALU\n" +
         step;
}

spatial::SolidMatrices write_calculix(const std::filesystem::path& folder,
                                      const AssembledMatrices& matrices) {
  write_text(folder / "bar.sti", calculix_text(matrices.K));
  write_text(folder / "bar.mas", calculix_text(matrices.M));
  write_text(folder / "bar.dof", dof_text(matrices.mesh));
  write_text(folder / "nodes.txt", table_text(matrices.mesh, true));
  spatial::SolidMatrices files;
  files.format = "calculix";
  files.mass = (folder / "bar.mas").string();
  files.stiffness = (folder / "bar.sti").string();
  files.nodes = (folder / "nodes.txt").string();
  return files;
}

bool has_calculix() { return std::system("command -v ccx > /dev/null 2>&1") == 0; }

void run_calculix(const std::filesystem::path& folder, const std::string& name,
                  const std::string& text) {
  write_text(folder / (name + ".inp"), text);
  const std::string command =
      "cd '" + folder.string() + "' && ccx " + name + " > " + name + ".log 2>&1";
  REQUIRE(std::system(command.c_str()) == 0);
}

std::vector<double> read_frequencies(const std::filesystem::path& file) {
  std::ifstream lines(file);
  std::vector<double> frequencies;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    double mode, eigenvalue, radians, hertz, imaginary;
    if (words >> mode >> eigenvalue >> radians >> hertz >> imaginary &&
        mode == static_cast<double>(frequencies.size() + 1))
      frequencies.push_back(hertz);
  }
  return frequencies;
}

}  // namespace spoke::test
