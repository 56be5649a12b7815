// Puts entries of files into sparse matrices, and finds the structure m (x) 1_3 in them.

#include "models/solid/import_entries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "models/solid/import_text.h"
#include "models/support/quantity.h"

namespace spoke::solid {
namespace {

/// Difference of entries that should be equal, of the largest entry.
constexpr double kSymmetry = 1e-10;
constexpr double kStructure = 1e-12;

std::string place_name(int row, int column, const CoordinateName& name) {
  return '(' + name(row) + "; " + name(column) + ')';
}

void sort_and_find_doubles(MatrixFile& file, const CoordinateName& name) {
  std::stable_sort(file.entries.begin(), file.entries.end(),
                   [](const MatrixEntry& a, const MatrixEntry& b) {
                     return a.column != b.column ? a.column < b.column : a.row < b.row;
                   });
  const auto twice = std::adjacent_find(file.entries.begin(), file.entries.end(),
                                        [](const MatrixEntry& a, const MatrixEntry& b) {
                                          return a.column == b.column && a.row == b.row;
                                        });
  if (twice == file.entries.end()) return;
  const MatrixEntry& second = *std::next(twice);
  fail_in_file(file.file, second.line, file.key,
               "the entry " + place_name(second.row, second.column, name) + " stands in line " +
                   std::to_string(twice->line) + " already, expected it once");
}

ImportedSparse put_together(const std::vector<MatrixEntry>& sorted, int size) {
  ImportedSparse matrix(size, size);
  matrix.reserve(static_cast<Eigen::Index>(sorted.size()));
  auto entry = sorted.begin();
  for (int column = 0; column < size; ++column) {
    matrix.startVec(column);
    for (; entry != sorted.end() && entry->column == column; ++entry)
      matrix.insertBack(entry->row, column) = entry->value;
  }
  matrix.finalize();
  return matrix;
}

/// How the entries of a matrix lie to each other.
struct Mirroring {
  int pairs = 0;    ///< entries beside the diagonal whose mirror image is there
  int singles = 0;  ///< those whose mirror image is not there
  double worst = 0.0;
  int row = 0, column = 0;            ///< where an entry differs most from its mirror image
  int pair_row = 0, pair_column = 0;  ///< of a pair
};

Mirroring compare_mirrored(const ImportedSparse& matrix, const ImportedSparse& mirrored) {
  Mirroring result;
  for (int column = 0; column < matrix.outerSize(); ++column) {
    ImportedSparse::InnerIterator there(mirrored, column);
    for (ImportedSparse::InnerIterator here(matrix, column); here; ++here) {
      if (here.row() == column) continue;
      while (there && there.row() < here.row()) ++there;
      const bool is_pair = there && there.row() == here.row();
      ++(is_pair ? result.pairs : result.singles);
      if (is_pair) {
        result.pair_row = static_cast<int>(here.row());
        result.pair_column = column;
      }
      const double difference = std::abs(here.value() - (is_pair ? there.value() : 0.0));
      if (difference <= result.worst) continue;
      result.worst = difference;
      result.row = static_cast<int>(here.row());
      result.column = column;
    }
  }
  return result;
}

int line_of(const MatrixFile& file, int row, int column) {
  const auto found = std::find_if(
      file.entries.begin(), file.entries.end(),
      [&](const MatrixEntry& entry) { return entry.row == row && entry.column == column; });
  return found == file.entries.end() ? 0 : found->line;
}

/// Fails unless the triangles are there that the format promises. Returns whether it is one.
bool is_one_triangle(const MatrixFile& file, const Mirroring& mirroring, double largest,
                     const CoordinateName& name) {
  const std::string place = place_name(mirroring.row, mirroring.column, name);
  const int line = line_of(file, mirroring.row, mirroring.column);
  const bool is_one = mirroring.pairs == 0 && mirroring.singles > 0;
  if (is_one && file.triangles == StoredTriangles::both)
    fail_in_file(file.file, 0, file.key,
                 "holds one triangle of the matrix only, expected both, or a header that says "
                 "symmetric");
  if (is_one) return true;
  const bool is_mixed =
      file.triangles == StoredTriangles::one
          ? mirroring.pairs > 0
          : file.triangles == StoredTriangles::either && mirroring.singles > mirroring.pairs;
  if (is_mixed)
    fail_in_file(file.file, line_of(file, mirroring.pair_row, mirroring.pair_column), file.key,
                 "the entry " + place_name(mirroring.pair_row, mirroring.pair_column, name) +
                     " and its mirror image are both in the file, expected the entries of one "
                     "triangle");
  if (mirroring.worst > kSymmetry * largest)
    fail_in_file(file.file, line, file.key,
                 "is not symmetric: the entry " + place + " differs from its mirror image by " +
                     describe(mirroring.worst) + ", the largest is " + describe(largest) +
                     ", expected a symmetric matrix");
  return false;
}

/// Where a matrix differs most from m (x) 1_3.
struct Deviation {
  double worst = 0.0;
  int row = 0, column = 0;

  void add(double difference, int at_row, int at_column) {
    if (std::abs(difference) <= worst) return;
    worst = std::abs(difference);
    row = at_row;
    column = at_column;
  }
};

}  // namespace

double largest_entry(const ImportedSparse& matrix) {
  double largest = 0.0;
  for (int column = 0; column < matrix.outerSize(); ++column)
    for (ImportedSparse::InnerIterator entry(matrix, column); entry; ++entry)
      largest = std::max(largest, std::abs(entry.value()));
  return largest;
}

ImportedSparse make_symmetric(MatrixFile file, int size, const CoordinateName& name) {
  sort_and_find_doubles(file, name);
  const ImportedSparse matrix = put_together(file.entries, size);
  const ImportedSparse mirrored = matrix.transpose();
  const Mirroring mirroring = compare_mirrored(matrix, mirrored);
  ImportedSparse whole;
  if (is_one_triangle(file, mirroring, largest_entry(matrix), name)) {
    whole = matrix + mirrored;
    for (int k = 0; k < size; ++k)
      if (matrix.coeff(k, k) != 0.0) whole.coeffRef(k, k) = matrix.coeff(k, k);
  } else {
    whole = 0.5 * (matrix + mirrored);
  }
  whole.prune([](Eigen::Index, Eigen::Index, double value) { return value != 0.0; });
  whole.makeCompressed();
  return whole;
}

ImportedSparse find_scalar_matrix(const ImportedSparse& matrix, const MatrixFile& file,
                                  const CoordinateName& name, const std::string& advice) {
  const int nodes = static_cast<int>(matrix.cols()) / 3;
  std::array<ImportedSparse, 3> by_axis;
  std::array<std::vector<Eigen::Triplet<double>>, 3> entries;
  Deviation deviation;
  for (int column = 0; column < matrix.outerSize(); ++column) {
    for (ImportedSparse::InnerIterator entry(matrix, column); entry; ++entry) {
      const int row = static_cast<int>(entry.row());
      if (row % 3 != column % 3)
        deviation.add(entry.value(), row, column);
      else
        entries[static_cast<std::size_t>(column % 3)].emplace_back(row / 3, column / 3,
                                                                   entry.value());
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    by_axis[axis].resize(nodes, nodes);
    by_axis[axis].setFromTriplets(entries[axis].begin(), entries[axis].end());
  }
  for (const int axis : {1, 2}) {
    const ImportedSparse difference = by_axis[static_cast<std::size_t>(axis)] - by_axis[0];
    for (int column = 0; column < nodes; ++column)
      for (ImportedSparse::InnerIterator entry(difference, column); entry; ++entry)
        deviation.add(entry.value(), 3 * static_cast<int>(entry.row()) + axis, 3 * column + axis);
  }
  const double largest = largest_entry(matrix);
  if (deviation.worst > kStructure * largest)
    fail_in_file(
        file.file, 0, file.key,
        "is not of the structure m (x) 1_3, equal in three directions and without coupling "
        "of these: the entry " +
            place_name(deviation.row, deviation.column, name) + " is off by " +
            describe(deviation.worst / largest) + " of the largest, " + advice);
  return by_axis[0];
}

}  // namespace spoke::solid
