#pragma once

// A TOML document with overrides, and the places of its keys for messages.

#include <map>
#include <string>
#include <vector>

#include "models/reader/toml_value.h"

namespace spoke {

/// A TOML text and the overrides of its keys. Keys are named by paths of names and of indices from
/// 1: "hub.drive.speed", "blades.2.length".
class TomlDocument {
 public:
  /// Parses `text`; `name` stands for the file in messages. Throws InputError.
  TomlDocument(const std::string& text, std::string name);

  /// Sets one key as a command line says it: "blade.bodies=8", "blades.2.length=7.5",
  /// "load.1.force=[0, 1]". The value is TOML; any other text is taken as a string. Tables are made
  /// as needed. Throws InputError, its text beginning "--set blade.bodies=8: ".
  void set(const std::string& assignment);

  const TomlTable& root() const { return *root_.as_table(); }

  /// Returns where a key was set: the override that gave it its value, otherwise file:line:column
  /// as far as known.
  std::string place(const std::string& path, const TomlPosition& position) const;
  /// Throws InputError "place: path: what".
  [[noreturn]] void fail(const std::string& path, const TomlPosition& position,
                         const std::string& what) const;

 private:
  using Names = std::vector<std::string>;

  TomlValue& find_or_make(TomlValue& parent, const Names& names, std::size_t depth,
                          const std::string& where);
  void remember(const std::string& path, const std::string& where);
  /// Returns the override that gave a key its value, "--set KEY=VALUE"; empty: the file did.
  std::string find_override(const std::string& path) const;

  std::string name_;
  TomlValue root_;                                ///< a table
  std::map<std::string, std::string> overrides_;  ///< by path of a key, the override that made it
};

}  // namespace spoke
