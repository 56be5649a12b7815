// Whatever is not as it must be is refused with its line and its path of keys.

#include "program/foreign/windio_entry.h"

#include <algorithm>
#include <cmath>

#include "models/solid/mesh_text.h"
#include "models/support/quantity.h"
#include "program/foreign/beam_table.h"
#include "program/foreign/input_lines.h"

namespace spoke::foreign {
namespace {

int line_of(const YAML::Node& node) { return node.Mark().line + 1; }

/// Returns "beside \"grid\", \"values\"": the keys that a map has.
std::string beside_keys_of(const YAML::Node& map) {
  constexpr std::size_t kMost = 8;
  if (map.size() == 0) return "in this map, which is empty";
  std::string text = "beside";
  std::size_t count = 0;
  for (const auto& member : map) {
    if (count == kMost) return text + " and others";
    const bool is_word = member.first.IsScalar();
    text += (count++ == 0 ? " " : ", ") + (is_word ? solid::show_text(member.first.Scalar())
                                                   : std::string("a key that is no word"));
  }
  return text;
}

}  // namespace

std::string Entry::from() const { return path_ + ", " + place(*file_, line_); }

void Entry::refuse(const std::string& what) const {
  foreign::refuse(*file_, line_, (path_.empty() ? "" : path_ + ": ") + what);
}

Entry Entry::at(const std::string& key) const {
  if (!node_.IsMap()) refuse("is no map, expected one with the key " + key);
  const YAML::Node value = find(key);
  const std::string path = path_.empty() ? key : path_ + '.' + key;
  if (!value.IsDefined()) refuse("has no key " + key + ", expected it " + beside_keys_of(node_));
  return {value, *file_, path, line_of(value)};
}

std::vector<Entry> Entry::elements() const {
  if (!node_.IsSequence() || node_.size() > std::size_t{kMostStations})
    refuse("is no array, expected one of at most " + std::to_string(kMostStations) + " elements");
  std::vector<Entry> all;
  std::size_t number = 0;
  for (const YAML::Node& element : node_)
    all.emplace_back(element, *file_, path_ + '.' + std::to_string(++number), line_of(element));
  return all;
}

double Entry::number() const {
  constexpr double most = 1e30;  // as in scenarios
  double value = 0.0;
  const std::string text = node_.IsScalar() ? node_.Scalar() : "";
  if (!node_.IsScalar() || !solid::read_number(text, value) || std::abs(value) > most)
    refuse((node_.IsScalar() ? "is " + solid::show_text(text) : std::string("is no number")) +
           ", expected a number of at most 1e30");
  return value;
}

double Entry::positive() const {
  const double value = number();
  if (!(value > 0.0)) refuse("is " + describe(value) + ", expected more than 0");
  return value;
}

std::vector<double> Entry::numbers() const {
  std::vector<double> values;
  for (const Entry& element : elements()) values.push_back(element.number());
  return values;
}

std::string Entry::text() const { return node_.IsScalar() ? printable(node_.Scalar()) : ""; }

double Course::at(double place) const {
  const auto above = std::upper_bound(grid.begin() + 1, grid.end() - 1, place);
  const auto k = static_cast<std::size_t>(above - grid.begin());
  const double t = (place - grid[k - 1]) / (grid[k] - grid[k - 1]);
  if (t == 0.0) return values[k - 1];
  if (t == 1.0) return values[k];
  return (1.0 - t) * values[k - 1] + t * values[k];
}

std::vector<double> read_grid(const Entry& table) {
  const Entry entry = table.at("grid");
  std::vector<double> grid = entry.numbers();
  constexpr double least_gap = 1e-9;
  if (grid.size() < 2 || grid.front() != 0.0 || grid.back() != 1.0)
    entry.refuse("expected two or more numbers, the first 0, the last 1");
  for (std::size_t i = 1; i < grid.size(); ++i)
    if (!(grid[i] > grid[i - 1] + least_gap))
      entry.refuse("element " + std::to_string(i + 1) + " is " + describe(grid[i]) +
                   ", expected more than the one before, " + describe(grid[i - 1]));
  return grid;
}

void check_count(const Entry& entry, std::size_t found, std::size_t count) {
  if (found != count)
    entry.refuse("has " + std::to_string(found) + " elements, expected " + std::to_string(count) +
                 ", one for each of grid");
}

Course read_course(const Entry& table) {
  Course course{read_grid(table), {}};
  const Entry values = table.at("values");
  course.values = values.numbers();
  check_count(values, course.values.size(), course.grid.size());
  return course;
}

std::vector<double> unite_grids(std::initializer_list<const std::vector<double>*> grids) {
  std::vector<double> all;
  for (const std::vector<double>* grid : grids) all.insert(all.end(), grid->begin(), grid->end());
  std::sort(all.begin(), all.end());
  const auto close = [](double a, double b) { return b - a <= 1e-9; };
  all.erase(std::unique(all.begin(), all.end(), close), all.end());
  all.back() = 1.0;
  return all;
}

}  // namespace spoke::foreign
