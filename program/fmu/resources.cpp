// Goes through the scenario's tables for keys that name files.

#include "program/fmu/resources.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "models/error.h"
#include "models/reader/toml_document.h"
#include "models/support/json.h"

namespace spoke::fmu {
namespace {

namespace fs = std::filesystem;

/// A key whose value is the name of a file: "subsystem.1.body.2.mesh".
struct FileKey {
  std::string key;
  std::string file;
};

void add_text(const TomlTable& table, std::string_view key, const std::string& path,
              std::vector<FileKey>& found) {
  const TomlValue* value = table.find(key);
  if (value && value->as_text()) found.push_back({path + std::string(key), *value->as_text()});
}

/// Adds the files of matrices: the elements of arrays are numbered from 1.
void add_texts(const TomlTable& table, std::string_view key, const std::string& path,
               std::vector<FileKey>& found) {
  const TomlValue* value = table.find(key);
  const TomlArray* array = value ? value->as_array() : nullptr;
  if (!array) return;
  for (std::size_t k = 0; k < array->size(); ++k)
    if (const std::string* file = (*array)[k].as_text())
      found.push_back({path + std::string(key) + '.' + std::to_string(k + 1), *file});
}

/// Adds the keys of a solid's table, see models/reader/spatial/solid_reader.cpp.
void add_solid(const TomlTable& table, const std::string& path, std::vector<FileKey>& found) {
  add_text(table, "mesh", path, found);
  const TomlValue* mass = table.find("mass");
  if (!mass || !mass->as_text()) return;  // of a rigid body it is a number
  for (const char* key : {"mass", "stiffness", "nodes"}) add_text(table, key, path, found);
  const TomlValue* stiffening = table.find("geometric_stiffness");
  if (!stiffening || !stiffening->as_table()) return;
  for (const char* key : {"own", "translation"})
    add_texts(*stiffening->as_table(), key, path + "geometric_stiffness.", found);
}

void visit(const TomlTable& table, const std::string& path, std::vector<FileKey>& found);

void visit(const TomlValue& value, const std::string& path, std::vector<FileKey>& found) {
  if (const TomlTable* table = value.as_table()) visit(*table, path + '.', found);
  if (const TomlArray* array = value.as_array())
    for (std::size_t k = 0; k < array->size(); ++k)
      visit((*array)[k], path + '.' + std::to_string(k + 1), found);
}

void visit(const TomlTable& table, const std::string& path, std::vector<FileKey>& found) {
  add_solid(table, path, found);
  for (const TomlMember& member : table) visit(member.value, path + member.key, found);
}

/// Adds the files of wind and aerofoils, see models/reader/spatial/wind_reader.cpp, air_reader.cpp.
void add_air(const TomlTable& root, std::vector<FileKey>& found) {
  const TomlValue* wind = root.find("wind");
  if (wind && wind->as_table()) add_text(*wind->as_table(), "file", "wind.", found);
  const TomlValue* airfoils = root.find("airfoil");
  const TomlArray* array = airfoils ? airfoils->as_array() : nullptr;
  if (!array) return;
  for (std::size_t k = 0; k < array->size(); ++k)
    if (const TomlTable* airfoil = (*array)[k].as_table())
      add_text(*airfoil, "file", "airfoil." + std::to_string(k + 1) + '.', found);
}

std::string read_bytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw InputError(file.string() + ": cannot be read, expected a file");
  return bytes;
}

}  // namespace

PackedScenario pack_scenario(const std::string& file, const std::string& text,
                             const Overrides& overrides) {
  PackedScenario packed{fs::path(file).filename().string(), overrides};
  packed.files.push_back({packed.name, text});
  TomlDocument document(text, file);
  for (const std::string& assignment : overrides) document.set(assignment);
  std::vector<FileKey> keys;
  visit(document.root(), "", keys);
  add_air(document.root(), keys);
  std::map<std::string, std::string> names;  // of files that are packed
  for (const FileKey& key : keys) {
    const fs::path path = fs::path(file).parent_path() / key.file;
    std::string& name = names[path.lexically_normal().string()];
    if (name.empty()) {
      name = "files/" + std::to_string(names.size()) + '_' + path.filename().string();
      packed.files.push_back({name, read_bytes(path)});
    }
    packed.overrides.push_back(key.key + '=' + Json(name).dump());
  }
  return packed;
}

}  // namespace spoke::fmu
