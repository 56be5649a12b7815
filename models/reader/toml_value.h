#pragma once

// Values of a TOML document, and where they stand. The library that parses it is compiled in
// toml_document.cpp only: it takes seconds in each source.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace spoke {

/// Line and column of a file, from 1; 0: not known.
struct TomlPosition {
  int line = 0;
  int column = 0;
  bool is_known() const { return line > 0 && column > 0; }
};

struct TomlValue;
struct TomlMember;

using TomlArray = std::vector<TomlValue>;

/// Members sorted by their keys.
class TomlTable {
 public:
  /// Null if there is none.
  const TomlValue* find(std::string_view key) const;
  TomlValue* find(std::string_view key);
  /// Adds a member, or gives an existing one another value and keeps the place of its key.
  void set(std::string_view key, TomlValue value, const TomlPosition& position = {});

  std::vector<TomlMember>::const_iterator begin() const;
  std::vector<TomlMember>::const_iterator end() const;

 private:
  std::vector<TomlMember> members_;
};

/// A date or a time, which is no value of any key.
struct TomlDate {};

struct TomlValue {
  std::variant<TomlDate, std::string, std::int64_t, double, bool, TomlArray, TomlTable> data;
  TomlPosition position;

  // Null if the value is of another type.
  const std::string* as_text() const { return std::get_if<std::string>(&data); }
  const std::int64_t* as_integer() const { return std::get_if<std::int64_t>(&data); }
  const double* as_floating_point() const { return std::get_if<double>(&data); }
  const bool* as_flag() const { return std::get_if<bool>(&data); }
  const TomlArray* as_array() const { return std::get_if<TomlArray>(&data); }
  TomlArray* as_array() { return std::get_if<TomlArray>(&data); }
  const TomlTable* as_table() const { return std::get_if<TomlTable>(&data); }
  TomlTable* as_table() { return std::get_if<TomlTable>(&data); }

  /// Whether it is an array of one table or more, and of nothing else.
  bool is_array_of_tables() const;
};

struct TomlMember {
  std::string key;
  TomlPosition position;  ///< place of the key
  TomlValue value;
};

/// Returns a value as an error message quotes it: -8, "clampd", an array of 3 values, a table.
std::string describe(const TomlValue& value);

/// Returns text for a message of one line: control characters become spaces, long text is cut.
std::string one_line(std::string_view text, std::size_t longest = std::string::npos);

}  // namespace spoke
