// Reads nested arrays: a matrix, or one for each speed.

#include "models/reader/bearing_reader.h"

#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "models/reader/keys/quantities.h"

namespace spoke {
namespace {

using Matrices = std::vector<Eigen::Matrix2d>;

constexpr Quantity kBearingStiffness = Quantity::any("N/m");
constexpr Quantity kBearingDamping = Quantity::any("N s/m");

/// Whether an array has two rows of two values each, which are no arrays.
bool is_two_by_two(const TomlArray* matrix) {
  if (matrix == nullptr || matrix->size() != 2) return false;
  for (const TomlValue& row : *matrix) {
    if (row.as_array() == nullptr || row.as_array()->size() != 2) return false;
    for (const TomlValue& element : *row.as_array())
      if (element.as_array() != nullptr) return false;
  }
  return true;
}

/// Reads a matrix, or one for each speed.
Matrices read_key(const TomlSection& section, std::string_view key, const Quantity& quantity) {
  const std::string shape = "[[xx, xy], [yx, yy]]" + in_parentheses(quantity.unit);
  const bool has_speed = section.has("speed");
  if (!section.is_nested(key)) section.fail_expected(key, "an array of matrices " + shape);
  const TomlArray& values = section.values(key);
  if (!has_speed && !is_two_by_two(&values)) section.fail_expected(key, "a matrix " + shape);
  for (std::size_t i = 0; has_speed && i < values.size(); ++i)
    if (!is_two_by_two(values[i].as_array()))
      section.fail_at(std::string(key) + '.' + std::to_string(i + 1),
                      "is " + describe(values[i]) + ", expected a matrix " + shape);
  Matrices matrices;
  std::vector<double> numbers;
  for (const std::vector<double>& row : section.rows(key, quantity, has_speed ? 4 : 2))
    numbers.insert(numbers.end(), row.begin(), row.end());
  for (std::size_t i = 0; i + 3 < numbers.size(); i += 4) {
    matrices.emplace_back();
    matrices.back() << numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3];
  }
  return matrices;
}

Json to_json(const Eigen::Matrix2d& matrix) {
  return Json::array({std::vector<double>{matrix(0, 0), matrix(0, 1)},
                      std::vector<double>{matrix(1, 0), matrix(1, 1)}});
}

/// Finds speeds that are no table's.
void find_speed_faults(const std::vector<double>& speed, const spatial::FirstFault& first) {
  if (speed.empty()) return;
  for (std::size_t i = 0; i < speed.size(); ++i)
    first("speed." + std::to_string(i + 1), speed[i], kSpeed);
  if (speed.size() == 1) first.add({"speed", "has 1 number, expected 2 or more"});
  for (std::size_t i = 1; i < speed.size(); ++i)
    if (!(speed[i] > speed[i - 1]))
      first.add({"speed." + std::to_string(i + 1),
                 "is " + describe(speed[i]) + ", expected more than the value before it, " +
                     describe(speed[i - 1])});
}

void find_key_faults(const std::string& key, const Matrices& matrices, const Quantity& quantity,
                     std::size_t speeds, const spatial::FirstFault& first) {
  if (matrices.empty()) return;
  const std::size_t expected = speeds == 0 ? 1 : speeds;
  if (matrices.size() != expected)
    first.add({key, "has " + std::to_string(matrices.size()) + " matrices, expected " +
                        (speeds == 0 ? "one, or speed with a value for each"
                                     : std::to_string(speeds) + ", one for each speed")});
  for (std::size_t i = 0; i < matrices.size(); ++i)
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 2; ++c)
        first(key + (speeds == 0 ? "" : '.' + std::to_string(i + 1)) + '.' + std::to_string(r + 1) +
                  '.' + std::to_string(c + 1),
              matrices[i](r, c), quantity);
}

}  // namespace

std::optional<BearingMatrices> read_matrices(const TomlSection& section) {
  BearingMatrices matrices;
  const bool has_speed = section.has("speed");
  if (!has_speed && !section.is_nested("stiffness") && !section.is_nested("damping")) return {};
  if (has_speed) matrices.speed = section.numbers("speed", kSpeed);
  for (const auto& [key, read, quantity] :
       {std::tuple("stiffness", &matrices.stiffness, kBearingStiffness),
        std::tuple("damping", &matrices.damping, kBearingDamping)})
    if (has_speed ? section.has(key) : section.is_nested(key))
      *read = read_key(section, key, quantity);
  return matrices;
}

spatial::Fault find_matrix_fault(const Loop& loop) {
  if (!loop.matrices) return {};
  const BearingMatrices& matrices = *loop.matrices;
  const spatial::FirstFault first;
  const char* given = matrices.stiffness.empty() ? "damping" : "stiffness";
  if (loop.kind != LoopKind::bearing) first.add({given, std::string(kMatrixOfOther)});
  const std::string mixed = "is given as numbers beside matrices, expected a matrix";
  if (!loop.stiffness.empty()) first.add({"stiffness", mixed});
  if (!loop.damping.empty()) first.add({"damping", mixed});
  find_speed_faults(matrices.speed, first);
  if (matrices.stiffness.empty() && matrices.damping.empty())
    first.add(matrices.speed.empty()
                  ? spatial::Fault{"stiffness", "has no matrix, nor has damping; expected one"}
                  : spatial::Fault{"speed",
                                   "is given without matrices, expected stiffness, damping or "
                                   "both"});
  find_key_faults("stiffness", matrices.stiffness, kBearingStiffness, matrices.speed.size(), first);
  find_key_faults("damping", matrices.damping, kBearingDamping, matrices.speed.size(), first);
  return first.found();
}

void add_matrices(const BearingMatrices& matrices, Json& loop) {
  if (!matrices.speed.empty()) loop.set("speed", matrices.speed);
  for (const auto& [key, given] :
       {std::pair("stiffness", &matrices.stiffness), std::pair("damping", &matrices.damping)}) {
    if (given->empty()) continue;
    if (matrices.speed.empty()) {
      loop.set(key, to_json(given->front()));
      continue;
    }
    Json all = Json::array();
    for (const Eigen::Matrix2d& matrix : *given) all.push_back(to_json(matrix));
    loop.set(key, all);
  }
}

}  // namespace spoke
