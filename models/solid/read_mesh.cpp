// Tells the formats of mesh files apart by how they begin.

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "models/solid/gmsh_reader.h"
#include "models/solid/inp_reader.h"
#include "models/solid/mesh_text.h"
#include "models/solid/parse_mesh.h"
#include "models/solid/solid.h"
#include "models/text_file.h"

namespace spoke::solid {

namespace {

constexpr std::size_t kLargestMesh = (std::size_t{2} << 30) - 1;

/// Returns the first character that is no blank.
char first_of(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string_view::npos ? ' ' : text[begin];
}

[[noreturn]] void refuse_format(std::string_view text, const std::string& file) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  refuse_mesh(file, 1,
              "begins with " + show_text(text.substr(begin, 12)) +
                  ", expected a mesh: $MeshFormat (gmsh .msh) or *NODE (Abaqus .inp)");
}

std::string read_mesh_text(const std::string& file) {
  return read_text(file, "a mesh (gmsh .msh or Abaqus .inp)", kLargestMesh);
}

}  // namespace

std::shared_ptr<const spatial::SolidMesh> parse_mesh(
    std::string_view text, const std::string& file, double length_scale,
    std::optional<spatial::SolidMaterial>* material) {
  const char first = first_of(text);
  if (first == '$') return assemble_mesh(read_gmsh(text, file), file, length_scale);
  if (first == '*') return assemble_mesh(read_inp(text, file, material), file, length_scale);
  refuse_format(text, file);
}

std::shared_ptr<const spatial::SolidMesh> read_mesh(
    const std::string& file, double length_scale, std::optional<spatial::SolidMaterial>* material) {
  return parse_mesh(read_mesh_text(file), file, length_scale, material);
}

std::shared_ptr<spatial::SolidMesh> read_node_mesh(const std::string& file, double length_scale) {
  const std::string text = read_mesh_text(file);
  if (first_of(text) == '*') return assemble_mesh(read_inp_nodes(text, file), file, length_scale);
  if (first_of(text) != '$') refuse_format(text, file);
  MeshParts parts = read_gmsh(text, file);
  parts.elements.clear();
  return assemble_mesh(std::move(parts), file, length_scale);
}

}  // namespace spoke::solid
