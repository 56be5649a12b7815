#pragma once

// Typed access to the keys of a TOML table.

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/toml_document.h"
#include "models/support/quantity.h"

namespace spoke {

/// One table of a scenario file: typed access to its keys. Every complaint is an InputError naming
/// place, key, value and what was expected. Valid as long as its document.
class TomlSection {
 public:
  using Keys = std::vector<std::string_view>;

  /// Makes the section of the whole document. Throws InputError if it has a key that is not in
  /// `known`, naming the nearest one that is; sections within it do so, too.
  TomlSection(const TomlDocument& document, const Keys& known);

  const std::string& path() const { return path_; }
  bool has(std::string_view key) const { return table_->find(key) != nullptr; }
  bool is_array(std::string_view key) const;
  /// Whether it is an array that begins with an array.
  bool is_nested(std::string_view key) const;
  bool is_text(std::string_view key) const;
  bool is_table(std::string_view key) const;

  /// Returns the table `key`; an empty one if it is missing.
  TomlSection section(std::string_view key, const Keys& known) const;
  /// Returns the array of tables `key`; none if it is missing.
  std::vector<TomlSection> sections(std::string_view key, const Keys& known) const;

  // Read values that are required, or that may be missing where there is a fallback.
  double number(std::string_view key, const Quantity& quantity) const;
  double number(std::string_view key, const Quantity& quantity, double fallback) const;
  int integer(std::string_view key, const Count& count) const;
  int integer(std::string_view key, const Count& count, int fallback) const;
  bool flag(std::string_view key, bool fallback) const;
  std::string text(std::string_view key, const std::string& fallback) const;
  /// Reads an array of `count` numbers, or of one or more if `count` is 0.
  std::vector<double> numbers(std::string_view key, const Quantity& quantity,
                              std::size_t count = 0) const;
  /// Reads an array of arrays of numbers, these of `count` numbers each or, where `other_count` is
  /// given, of that many. Arrays within these only group the numbers.
  std::vector<std::vector<double>> rows(std::string_view key, const Quantity& quantity,
                                        std::size_t count, std::size_t other_count = 0) const;
  /// Returns an array of one value or more, of any types.
  const TomlArray& values(std::string_view key) const;
  /// Reads an array of numbers, each greater than the one before.
  std::vector<double> increasing_numbers(std::string_view key, const Quantity& quantity) const;

  /// Returns the index of a value among the given names.
  std::size_t choice(std::string_view key, const Keys& names) const;
  /// Reads one of the given values of an enumeration that has a function name_of().
  template <class Enum>
  Enum choice(std::string_view key, std::initializer_list<Enum> values, Enum fallback) const {
    if (!has(key)) return fallback;
    Keys names;
    for (const Enum value : values) names.push_back(name_of(value));
    return values.begin()[choice(key, names)];
  }

  /// Returns where a key stands, or the table if the key is empty: "file:4:7: blade.length".
  std::string place(std::string_view key) const;
  /// Throws InputError about a key, or about the table if the key is empty.
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;
  /// Throws InputError about the key at the end of a path of keys and indices (from 1):
  /// "joint.2.axis". The place is that of the last key on the path that is there.
  [[noreturn]] void fail_at(std::string_view path, const std::string& what) const;
  /// Throws InputError: "is VALUE, expected ...".
  [[noreturn]] void fail_expected(std::string_view key, const std::string& expected) const;

 private:
  TomlSection(const TomlDocument& document, const TomlTable& table, std::string path,
              const TomlPosition& position, const Keys& known);

  void check_keys(const Keys& known) const;
  std::string path_of(std::string_view key) const;
  const TomlPosition& position(std::string_view key) const;
  const TomlValue& required(std::string_view key, const std::string& expected) const;
  void flatten(const TomlArray& array, const std::string& path, const Quantity& quantity,
               std::vector<double>& numbers) const;
  double checked_number(const TomlValue& node, const std::string& path,
                        const Quantity& quantity) const;

  const TomlDocument* document_;
  const TomlTable* table_;
  std::string path_;
  TomlPosition position_;  ///< place in complaints about missing keys
};

/// Returns "a", "b" or "c".
std::string join_names(const TomlSection::Keys& names);

}  // namespace spoke
