// Matrices of Abaqus (*MATRIX OUTPUT): lines "node, dof, node, dof, value" (FORMAT=MATRIX INPUT),
// or "row column value" with rows 3 (node - 1) + dof (FORMAT=COORDINATE).

#include <algorithm>
#include <optional>

#include "models/solid/import_formats.h"
#include "models/solid/import_text.h"

namespace spoke::solid {
namespace {

/// Reads "node, dof", fields 0 and 1 or 2 and 3, as 3 node + axis.
int read_node_and_axis(const NumberText& text, std::size_t field, const NodeTable& nodes) {
  const std::int64_t label = text.whole(field), axis = text.whole(field + 1);
  if (label < 0)
    text.fail("node " + std::to_string(label) +
              " is a coordinate inside an element, expected elements without any");
  if (axis < 1 || axis > 3)
    text.fail("node " + std::to_string(label) + " has the coordinate " + std::to_string(axis) +
              ", expected 1, 2 and 3 (displacements): export without rotational coordinates, "
              "of solid elements only");
  const int node = nodes.find(label);
  if (node < 0)
    text.fail("node " + std::to_string(label) + " is not in " + nodes.mesh().file +
              ", expected all nodes there");
  return 3 * node + static_cast<int>(axis) - 1;
}

/// Reads a row or column 3 (node - 1) + dof of nodes in the order of their labels.
int read_row(const NumberText& text, std::size_t field, const std::vector<int>& by_label) {
  const std::int64_t row = text.whole(field);
  if (row < 1 || row > 3 * std::ssize(by_label))
    text.fail("the row or column " + std::to_string(row) + " is outside, expected 1 to " +
              std::to_string(3 * by_label.size()) + ", three for each node of the table");
  const int node = by_label[static_cast<std::size_t>((row - 1) / 3)];
  return 3 * node + static_cast<int>((row - 1) % 3);
}

/// Reads a file; `used` and `columns` (3 or 5) are of all files.
MatrixFile read_abaqus_file(const MatrixName& name, const NodeTable& nodes,
                            const std::vector<int>& by_label, MatrixFiles& all,
                            std::size_t& columns) {
  NumberText text(name.file, name.key);
  MatrixFile file{
      .file = name.file, .key = name.key, .triangles = StoredTriangles::either, .entries = {}};
  while (text.next()) {
    if (text.line().front() == '*') continue;  // comments and keywords
    const std::size_t count = text.fields().size();
    if (columns == 0 && (count == 3 || count == 5)) columns = count;
    if (count != columns)
      text.fail("has " + std::to_string(count) + (count == 1 ? " field" : " fields") +
                ", expected 5 in all lines (\"node, dof, node, dof, value\") or 3 (\"row column "
                "value\")");
    MatrixEntry entry{.line = text.number(), .value = text.real(count - 1)};
    if (columns == 5) {
      entry.row = read_node_and_axis(text, 0, nodes);
      entry.column = read_node_and_axis(text, 2, nodes);
    } else {
      entry.row = read_row(text, 0, by_label);
      entry.column = read_row(text, 1, by_label);
    }
    all.used[static_cast<std::size_t>(entry.row / 3)] = 1;
    all.used[static_cast<std::size_t>(entry.column / 3)] = 1;
    file.entries.push_back(entry);
  }
  return file;
}

}  // namespace

MatrixFiles read_abaqus(const std::vector<MatrixName>& names, const NodeTable& nodes) {
  const std::vector<int> by_label = nodes.by_label();
  MatrixFiles result{.files = {}, .used = std::vector<char>(by_label.size(), 0)};
  std::size_t columns = 0;
  for (const MatrixName& name : names)
    result.files.push_back(read_abaqus_file(name, nodes, by_label, result, columns));
  if (columns == 3) result.used.assign(by_label.size(), 1);
  return result;
}

}  // namespace spoke::solid
