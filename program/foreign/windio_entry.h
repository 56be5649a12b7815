#pragma once

// Entries of an ontology of WindIO: numbers, arrays, and values over a grid.

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

namespace spoke::foreign {

/// A node of the file and its path of keys.
class Entry {
 public:
  Entry(const YAML::Node& node, const std::string& file, std::string path, int line)
      : node_(node), file_(&file), path_(std::move(path)), line_(line) {}

  int line() const { return line_; }
  const std::string& path() const { return path_; }
  /// Returns "components.hub.diameter, rotor.yaml:47".
  std::string from() const;
  /// Throws InputError with file, line, path and what.
  [[noreturn]] void refuse(const std::string& what) const;

  bool has(const std::string& key) const { return node_.IsMap() && find(key).IsDefined(); }
  /// Returns the value of a key, which must be there.
  Entry at(const std::string& key) const;
  /// Returns the elements of an array.
  std::vector<Entry> elements() const;
  double number() const;
  /// Returns a number that must be positive.
  double positive() const;
  std::vector<double> numbers() const;
  /// Returns a word; nothing if there is none.
  std::string text() const;

 private:
  YAML::Node find(const std::string& key) const { return std::as_const(node_)[key]; }

  YAML::Node node_;
  const std::string* file_;
  std::string path_;
  int line_;
};

/// Values over a grid from 0 to 1, linear between.
struct Course {
  std::vector<double> grid, values;
  double at(double place) const;
};

/// Reads `grid`, which ascends from 0 to 1.
std::vector<double> read_grid(const Entry& table);
/// Requires one element for each of the grid.
void check_count(const Entry& entry, std::size_t found, std::size_t count);
/// Reads `grid` and `values`.
Course read_course(const Entry& table);
/// Returns all places of some grids, in order.
std::vector<double> unite_grids(std::initializer_list<const std::vector<double>*> grids);

}  // namespace spoke::foreign
