// Follows a path of keys through a scenario's file.

#include "models/reader/key_place.h"

#include <algorithm>
#include <filesystem>

#include "models/reader/toml_document.h"
#include "models/text_file.h"

namespace spoke {
namespace {

/// Returns the place of the last part of a path that is there. Blades that one table describes have
/// its keys.
TomlPosition find_position(const TomlTable& root, std::string path) {
  if (path.starts_with("blades.") && !root.find("blades")) {
    const std::size_t behind = path.find('.', sizeof("blades.") - 1);
    path = "blade" + (behind == std::string::npos ? "" : path.substr(behind));
  }
  TomlPosition found;
  const TomlTable* table = &root;
  const TomlArray* array = nullptr;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string name = path.substr(begin, end - begin);
    const TomlValue* value = nullptr;
    if (array) {
      const std::size_t index = std::stoul(name);
      if (index >= 1 && index <= array->size()) value = &(*array)[index - 1];
    } else if (table) {
      value = table->find(name);
    }
    if (!value) break;
    if (value->position.is_known()) found = value->position;
    table = value->as_table();
    array = value->as_array();
    begin = end + 1;
  }
  return found;
}

}  // namespace

InputError place_in_file(const InputError& error, const std::string& file,
                         const Overrides& overrides) {
  InputPlace place = error.place();
  place.file = file;
  if (place.key.empty()) return InputError(file + ": " + error.what(), place);
  // What is no file cannot be read again.
  if (!std::filesystem::is_regular_file(file)) return InputError(file + ": " + error.what(), place);
  TomlDocument document(read_text(file), file);
  for (const std::string& assignment : overrides) document.set(assignment);
  const TomlPosition position = find_position(document.root(), place.key);
  place.line = position.line;
  place.column = position.column;
  return InputError(document.place(place.key, position) + ": " + error.what(), place);
}

}  // namespace spoke
