// Matrices of CalculiX: *FREQUENCY, SOLVER=MATRIXSTORAGE writes triangles of K (.sti) and M (.mas)
// as lines "row column value", and the coordinates as lines "node.axis" (.dof).

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>

#include "models/solid/import_formats.h"
#include "models/solid/import_text.h"
#include "models/solid/mesh_text.h"

namespace spoke::solid {
namespace {

constexpr const char* kAxes = "xyz";

/// Coordinates in the order of a .dof file, as 3 node + axis.
struct CalculixCoordinates {
  std::string file;
  std::vector<int> at;
  std::vector<char> used;  ///< by node of the table
};

/// Reads "13.2": node 13, y.
int read_coordinate(const NumberText& text, const NodeTable& nodes) {
  text.require_fields(1, "a coordinate \"node.axis\"");
  const std::string_view word = text.fields()[0];
  const char* end = word.data() + word.size();
  int label = 0, axis = 0;
  const auto point = std::from_chars(word.data(), end, label);
  const bool has_point = point.ec == std::errc() && point.ptr != end && *point.ptr == '.';
  const auto rest = has_point ? std::from_chars(point.ptr + 1, end, axis) : point;
  if (!has_point || rest.ec != std::errc() || rest.ptr != end)
    text.fail(show_text(word) + " is no coordinate, expected \"node.axis\" as in 13.2");
  if (axis < 1 || axis > 3)
    text.fail("node " + std::to_string(label) + " has the coordinate " + std::to_string(axis) +
              ", expected 1, 2 and 3 (displacements): solid elements only");
  const int node = nodes.find(label);
  if (node < 0)
    text.fail("node " + std::to_string(label) + " is not in " + nodes.mesh().file +
              ", expected all nodes there: C3D8I, shells and beams have more than their own "
              "nodes and cannot be used");
  return 3 * node + axis - 1;
}

CalculixCoordinates read_coordinates(const std::string& file, const std::string& key,
                                     const NodeTable& nodes) {
  NumberText text(file, key, "CalculiX's list of coordinates beside its matrices");
  CalculixCoordinates result{
      .file = file, .at = {}, .used = std::vector<char>(nodes.mesh().nodes.size(), 0)};
  std::vector<int> lines(3 * result.used.size(), 0);
  while (text.next()) {
    const int coordinate = read_coordinate(text, nodes);
    int& line = lines[static_cast<std::size_t>(coordinate)];
    if (line != 0)
      text.fail("the coordinate " + std::string(text.line()) + " stands in line " +
                std::to_string(line) + " already, expected it once");
    line = text.number();
    result.at.push_back(coordinate);
    result.used[static_cast<std::size_t>(coordinate / 3)] = 1;
  }
  for (std::size_t node = 0; node < result.used.size(); ++node) {
    for (std::size_t axis = 0; axis < 3 && result.used[node] != 0; ++axis) {
      if (lines[3 * node + axis] == 0)
        text.fail_at(0, "node " + std::to_string(nodes.label(static_cast<int>(node))) +
                            " lacks its coordinate " + std::to_string(axis + 1) + " (" +
                            kAxes[axis] +
                            "), expected all three: export without *BOUNDARY, *MPC and "
                            "*EQUATION");
    }
  }
  return result;
}

MatrixFile read_triangle(const MatrixName& name, const CalculixCoordinates& coordinates) {
  NumberText text(name.file, name.key);
  MatrixFile file{
      .file = name.file, .key = name.key, .triangles = StoredTriangles::either, .entries = {}};
  const std::int64_t size = std::ssize(coordinates.at);
  while (text.next()) {
    text.require_fields(3, "\"row column value\"");
    const std::array<std::int64_t, 2> place = {text.whole(0), text.whole(1)};
    for (const std::int64_t index : place)
      if (index < 1 || index > size)
        text.fail("the entry (" + std::to_string(place[0]) + ", " + std::to_string(place[1]) +
                  ") is outside, expected rows and columns from 1 to " + std::to_string(size) +
                  ", the number of coordinates in " + coordinates.file);
    const double value = text.real(2);
    file.entries.push_back({coordinates.at[static_cast<std::size_t>(place[0] - 1)],
                            coordinates.at[static_cast<std::size_t>(place[1] - 1)], text.number(),
                            value});
  }
  return file;
}

}  // namespace

MatrixFiles read_calculix(const std::vector<MatrixName>& names, const NodeTable& nodes) {
  const std::string beside =
      std::filesystem::path(names.front().file).replace_extension(".dof").string();
  const CalculixCoordinates coordinates = read_coordinates(beside, names.front().key, nodes);
  MatrixFiles result{.files = {}, .used = coordinates.used};
  for (const MatrixName& name : names) result.files.push_back(read_triangle(name, coordinates));
  return result;
}

}  // namespace spoke::solid
