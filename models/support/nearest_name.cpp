// Edit distance by dynamic programming.

#include "models/support/nearest_name.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace spoke {

int edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table d(i, j) = distance of the first i letters of a from the first j of b.
  std::vector<int> before_last(b.size() + 1);
  std::vector<int> last(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

std::optional<std::string_view> nearest_name(std::string_view typed,
                                             std::span<const std::string_view> names) {
  std::optional<std::string_view> nearest;
  int best = std::numeric_limits<int>::max();
  for (const std::string_view name : names) {
    const int distance = edit_distance(typed, name);
    // More than half of the letters wrong is another word, not a slip.
    const bool slip = 2 * distance <= static_cast<int>(std::max(typed.size(), name.size()));
    if (slip && distance < best) {
      best = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::string describe_unknown(const std::string& name, std::span<const std::string_view> names) {
  const auto nearest = nearest_name(name, names);
  std::string text = "is \"" + name + "\", ";
  if (nearest) return text + "did you mean \"" + std::string(*nearest) + "\"?";
  if (names.size() > 12) return text + "expected one of " + std::to_string(names.size()) + " names";
  text += "expected ";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0                  ? "\""
             : i + 1 == names.size() ? " or \""
                                     : ", \"") +
            std::string(names[i]) + '"';
  return text;
}

}  // namespace spoke
