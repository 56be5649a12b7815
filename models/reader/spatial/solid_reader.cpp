// Reads the description of a solid, then its mesh.

#include "models/reader/spatial/solid_reader.h"

#include <filesystem>
#include <variant>

#include "models/file_watch.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/solid_faults.h"
#include "models/reader/spatial/vector_reader.h"
#include "models/scenario.h"
#include "models/solid/kept_geometry.h"
#include "spoke/error.h"

namespace spoke::spatial {
namespace {

constexpr const char* kMeshExpected = "a mesh of gmsh (.msh) or Abaqus (.inp)";

/// Reads the name of a file, which must be there.
std::string read_file_name(const TomlSection& section, std::string_view key,
                           const std::string& folder, const std::string& expected) {
  if (!section.has(key)) section.fail(key, "is missing, expected " + expected);
  const std::string name = section.text(key, "");
  const std::filesystem::path file = std::filesystem::path(folder) / name;
  std::error_code ignored;
  if (name.empty() || !std::filesystem::exists(file, ignored))
    section.fail(key, "is \"" + name + "\", but there is no file " + file.string() + ", expected " +
                          expected);
  announce_reading(file);  // now, though matrices are read when the solid is made
  return file.string();
}

/// Reads an array of names of files.
template <std::size_t Count>
std::array<std::string, Count> read_file_names(const TomlSection& section, std::string_view key,
                                               const std::string& folder) {
  const std::string expected = "an array of " + std::to_string(Count) + " files";
  if (!section.has(key)) section.fail(key, "is missing, expected " + expected);
  std::array<std::string, Count> files;
  const TomlArray& values = section.values(key);
  if (values.size() != Count) section.fail_expected(key, expected);
  for (std::size_t i = 0; i < Count; ++i) {
    const std::string* name = values[i].as_text();
    if (!name) section.fail_expected(key, expected);
    const std::filesystem::path file = std::filesystem::path(folder) / *name;
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
      section.fail_at(std::string(key) + '.' + std::to_string(i + 1),
                      "is \"" + *name + "\", but there is no file " + file.string());
    announce_reading(file);
    files[i] = file.string();
  }
  return files;
}

/// Reads what another program has assembled.
SolidMatrices read_matrices(const TomlSection& section, const std::string& folder) {
  SolidMatrices matrices;
  matrices.format = keys::words_of(keys::kSolidRows,
                                   "format")[keys::read_word(section, keys::kSolidRows, "format")];
  matrices.mass = read_file_name(section, "mass", folder, "a file of the mass matrix");
  matrices.stiffness =
      read_file_name(section, "stiffness", folder, "a file of the stiffness matrix");
  matrices.nodes = read_file_name(section, "nodes", folder, "a file of the nodes");
  if (!section.has("geometric_stiffness")) return matrices;
  const TomlSection files =
      section.section("geometric_stiffness", keys::keys_of(keys::kGeometricStiffnessRows));
  matrices.own = read_file_names<6>(files, "own", folder);
  matrices.translation = read_file_names<3>(files, "translation", folder);
  return matrices;
}

/// Reads the mesh's file, or the matrices in its place.
void read_source(const TomlSection& section, const std::string& folder, SolidBody& body) {
  const bool has_matrices = section.has("format") || section.has("mass") ||
                            section.has("stiffness") || section.has("nodes");
  if (section.has("mesh")) {
    for (const char* other : {"format", "mass", "stiffness", "nodes", "geometric_stiffness"})
      if (section.has(other))
        section.fail(other, "given along with mesh, expected only one of them");
    body.file = read_file_name(section, "mesh", folder, kMeshExpected);
  } else if (has_matrices) {
    body.matrices = read_matrices(section, folder);
  } else {
    section.fail("mesh", std::string("is missing, expected ") + kMeshExpected +
                             "; or mass, stiffness, nodes and format");
  }
}

SolidInterface read_interface(const TomlSection& section) {
  SolidInterface interface;
  if (!section.has("name")) section.fail("name", "is missing, expected a name");
  interface.name = section.text("name", "");
  interface.nodes = read_choice(section, "nodes");
  keys::read(section, keys::kInterfaceRows, &interface);
  if (section.has("point")) interface.point = read_vector(section, "point", kLength);
  return interface;
}

/// Reads how the solid is reduced, damped and stiffened.
void read_coordinates(const TomlSection& section, SolidBody& body) {
  keys::read(section, keys::kSolidRows, &body);
  if (section.has("modes")) body.modes = section.integer("modes", kModes);
  if (section.has("up_to")) body.up_to = section.number("up_to", kFrequency);
  const bool has_stresses = !body.matrices || section.has("geometric_stiffness");
  body.geometric_stiffening = section.flag("geometric_stiffening", has_stresses);
  if (section.is_array("damping"))
    body.damping = section.numbers("damping", kDampingRatio);
  else if (section.has("damping"))
    body.damping = {section.number("damping", kDampingRatio)};
}

/// Takes over what a body has read: the mesh of the same file, and all that was made of it if the
/// bodies have one shape.
void share_mesh(const Subsystem& other, SolidBody& body) {
  for (const Body& candidate : other.bodies) {
    const auto* solid = std::get_if<SolidBody>(&candidate.shape);
    // An .inp file's material came with its mesh.
    if (solid && solid->file == body.file && solid->length_scale == body.length_scale &&
        body.material)
      body.mesh = solid->mesh;
    if (solid && has_same_shape(*solid, body)) body.kept = solid->kept;
  }
}

}  // namespace

TomlSection::Keys solid_keys() { return keys::keys_of(keys::kSolidRows); }

NodeChoice read_choice(const TomlSection& section, std::string_view key) {
  const std::string expected = kNodesExpected;
  if (!section.has(key)) section.fail(key, "is missing, expected " + expected);
  if (section.is_text(key)) return section.text(key, "");
  if (!section.is_table(key)) section.fail_expected(key, expected);
  const TomlSection table = section.section(key, keys::keys_of(keys::kNodesRows));
  const int given = int{table.has("plane")} + int{table.has("cylinder")} + int{table.has("box")};
  if (given != 1)
    table.fail("", "has " + std::to_string(given) + " keys, expected one: plane, cylinder or box");
  if (table.has("plane")) {
    PlaneNodes plane;
    keys::read(table.section("plane", keys::keys_of(keys::kPlaneNodesRows)), keys::kPlaneNodesRows,
               &plane);
    return plane;
  }
  if (table.has("cylinder")) {
    CylinderNodes cylinder;
    keys::read(table.section("cylinder", keys::keys_of(keys::kCylinderNodesRows)),
               keys::kCylinderNodesRows, &cylinder);
    return cylinder;
  }
  BoxNodes box;
  keys::read(table.section("box", keys::keys_of(keys::kBoxNodesRows)), keys::kBoxNodesRows, &box);
  return box;
}

SolidBody read_solid(const TomlSection& section, const std::string& folder,
                     const std::vector<Subsystem>& before, const Subsystem& own) {
  SolidBody body;
  read_source(section, folder, body);
  if (section.has("material"))
    keys::read(section.section("material", keys::keys_of(keys::kMaterialRows)), keys::kMaterialRows,
               &body.material.emplace());
  keys::read(section.section("scale", keys::keys_of(keys::kScaleRows)), keys::kScaleRows, &body);
  read_coordinates(section, body);
  for (const TomlSection& table :
       section.sections("interface", keys::keys_of(keys::kInterfaceRows)))
    body.interfaces.push_back(read_interface(table));
  if (const Fault fault = find_description_fault(body)) section.fail_at(fault.path, fault.text);
  for (const Subsystem& subsystem : before) share_mesh(subsystem, body);
  share_mesh(own, body);
  try {
    solid::keep_geometry(body);
  } catch (const InputError& error) {
    if (solid::is_of_mesh(error)) throw;
    section.fail_at(error.place().key, error.what());
  }
  return body;
}

}  // namespace spoke::spatial
