// Puts together what the files of other programs hold.

#include "models/solid/import.h"

#include <algorithm>
#include <cassert>

#include "models/solid/import_checks.h"
#include "models/solid/import_formats.h"
#include "models/solid/import_text.h"
#include "models/solid/interfaces.h"
#include "models/solid/mesh_text.h"
#include "spoke/error.h"

namespace spoke::solid {
namespace {

constexpr std::size_t kStresses = space::kSpins + 3;

[[noreturn]] void fail_at_key(const std::string& key, const std::string& sentence) {
  throw InputError(sentence, {.key = key});
}

const std::string& stress_file(const spatial::SolidMatrices& files, std::size_t k) {
  return k < files.own.size() ? files.own[k] : files.translation[k - files.own.size()];
}

/// Lists the files: stiffness, mass, then nine of stresses or none.
std::vector<MatrixName> list_files(const spatial::SolidMatrices& files) {
  if (files.stiffness.empty()) fail_at_key("stiffness", "is missing, expected a file");
  if (files.mass.empty()) fail_at_key("mass", "is missing, expected a file");
  if (files.nodes.empty()) fail_at_key("nodes", "is missing, expected a file of their places");
  std::vector<MatrixName> names = {{files.stiffness, "stiffness"}, {files.mass, "mass"}};
  for (std::size_t k = 0; k < kStresses; ++k)
    if (!stress_file(files, k).empty())
      names.push_back({stress_file(files, k), "geometric_stiffness"});
  if (names.size() != 2 && names.size() != 2 + kStresses)
    fail_at_key("geometric_stiffness",
                "has " + std::to_string(names.size() - 2) +
                    " files of geometric stiffness, expected nine (six of rotation, "
                    "three of translation) or none");
  return names;
}

MatrixFiles read_files(const std::string& format, const std::vector<MatrixName>& names,
                       const NodeTable& table) {
  if (format == "calculix") return read_calculix(names, table);
  if (format == "abaqus") return read_abaqus(names, table);
  if (format == "matrix_market") return read_matrix_market(names, table);
  fail_at_key("format", "is " + show_text(format) +
                            ", expected \"calculix\", \"abaqus\" or \"matrix_market\"");
}

/// Numbers the nodes anew that the matrices have; -1: they do not have it.
std::vector<int> number_used(const std::vector<char>& used) {
  std::vector<int> numbers(used.size(), -1);
  int next = 0;
  for (std::size_t node = 0; node < used.size(); ++node)
    if (used[node] != 0) numbers[node] = next++;
  return numbers;
}

void renumber(MatrixFiles& files) {
  const std::vector<int> numbers = number_used(files.used);
  const auto now = [&](int coordinate) {
    return 3 * numbers[static_cast<std::size_t>(coordinate / 3)] + coordinate % 3;
  };
  for (MatrixFile& file : files.files) {
    for (MatrixEntry& entry : file.entries) {
      entry.row = now(entry.row);
      entry.column = now(entry.column);
    }
  }
}

/// Says which nodes of the table the matrices do not have.
std::string describe_missing(const NodeTable& table, const std::vector<char>& used) {
  const auto first = std::find(used.begin(), used.end(), 0);
  if (first == used.end()) return "";
  const auto count = std::count(used.begin(), used.end(), 0);
  return " (the matrices lack " + std::to_string(count) + " of the nodes of " + table.mesh().file +
         ", the first is node " +
         std::to_string(table.label(static_cast<int>(first - used.begin()))) + ')';
}

void take_stresses(ImportedMatrices& result, const std::vector<MatrixFile>& files,
                   double length_scale, const CoordinateName& name) {
  const int size = static_cast<int>(result.K.cols());
  for (std::size_t k = 0; k + 2 < files.size(); ++k) {
    const MatrixFile& file = files[k + 2];
    const ImportedSparse scalar =
        find_scalar_matrix(make_symmetric(file, size, name), file, name,
                           "expected the geometric stiffness of solid elements");
    const bool is_own = k < result.own.size();
    (is_own ? result.own[k] : result.translation[k - result.own.size()]) =
        scalar / (is_own ? length_scale : length_scale * length_scale);
  }
}

/// Gives m entries wherever the stresses have some.
void widen_mass(ImportedMatrices& matrices) {
  const auto widen = [&](const ImportedSparse& scalar) {
    matrices.m = ImportedSparse(matrices.m + 0.0 * scalar);
  };
  for (const ImportedSparse& scalar : matrices.own) widen(scalar);
  for (const ImportedSparse& scalar : matrices.translation) widen(scalar);
  matrices.m.makeCompressed();
}

/// Refuses stiffening without all the stresses that it needs.
void check_stresses(const spatial::SolidBody& body, const ImportedMatrices& matrices) {
  if (!body.geometric_stiffening) return;
  if (!matrices.has_stresses())
    fail_at_key("geometric_stiffening",
                "needs the stresses, which matrices of other programs do not hold, expected false, "
                "files of geometric stiffness matrices, or the mesh in place of the matrices");
  if (body.interfaces.size() > 1)
    fail_at_key("geometric_stiffening",
                "needs the stresses under wrenches on " + show_text(body.interfaces[1].name) +
                    ", which the files do not hold, expected false, one interface, or the mesh in "
                    "place of the matrices");
}

}  // namespace

Eigen::VectorXd values_in_places_of(const ImportedSparse& m, const ImportedSparse& scalar) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(m.nonZeros());
  Eigen::Index k = 0;
  for (int column = 0; column < m.outerSize(); ++column) {
    ImportedSparse::InnerIterator other(scalar, column);
    for (ImportedSparse::InnerIterator entry(m, column); entry; ++entry, ++k) {
      if (!other || other.row() != entry.row()) continue;
      values[k] = other.value();
      ++other;
    }
    assert(!other);
  }
  return values;
}

ImportedMatrices read_matrices(const spatial::SolidMatrices& files, double length_scale) {
  const std::vector<MatrixName> names = list_files(files);
  const NodeTable table(files.nodes, length_scale);
  MatrixFiles read = read_files(files.format, names, table);
  renumber(read);
  ImportedMatrices result;
  result.mesh = table.select(read.used);
  result.nodes.assign(result.mesh->nodes.begin(), result.mesh->nodes.end());
  result.labels = result.mesh->labels;
  const int size = 3 * static_cast<int>(result.nodes.size());
  const CoordinateName name = [&](int coordinate) {
    return "node " + std::to_string(result.labels[static_cast<std::size_t>(coordinate / 3)]) +
           ", " + "xyz"[coordinate % 3];
  };
  const MatrixFile& stiffness = read.files[0];
  const MatrixFile& mass = read.files[1];
  result.K = make_symmetric(stiffness, size, name) / length_scale;
  const ImportedSparse M = make_symmetric(mass, size, name);
  result.m = find_scalar_matrix(M, mass, name,
                                "expected the mass of solid elements: export without rotational "
                                "coordinates, or give the mesh in place of the matrices") /
             length_scale;
  take_stresses(result, read.files, length_scale, name);
  if (result.has_stresses()) widen_mass(result);
  check_rigid_motions(result, stiffness, describe_missing(table, read.used));
  check_mass(result, mass);
  return result;
}

SolidGeometry make_geometry_of_matrices(const spatial::SolidBody& body,
                                        const ImportedMatrices& matrices) {
  check_stresses(body, matrices);
  SolidGeometry geometry;
  geometry.mesh = matrices.mesh;
  find_interfaces(body, geometry);
  Eigen::Matrix<double, Eigen::Dynamic, 3> x(static_cast<Eigen::Index>(matrices.nodes.size()), 3);
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    x.row(i) = matrices.nodes[static_cast<std::size_t>(i)];
  const Eigen::VectorXd by_node = matrices.m * Eigen::VectorXd::Ones(x.rows());
  geometry.mass = by_node.sum();
  geometry.first_moment = x.transpose() * by_node;
  geometry.second_moment = x.transpose() * (matrices.m * x);
  move_moments_to_first(geometry);
  return geometry;
}

}  // namespace spoke::solid
