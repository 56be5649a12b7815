// Words and defaults of rows.

#include "models/support/key_row.h"

#include <algorithm>

namespace spoke::keys {
namespace {

/// Returns the value of a row in words; empty for those that have no short one.
std::string describe_value(const Row& row, const void* of) {
  switch (row.kind) {
    case Row::Kind::number:
      return describe(member_of<double>(row, of));
    case Row::Kind::count:
      return std::to_string(member_of<int>(row, of));
    case Row::Kind::option: {
      const auto& value = member_of<std::optional<double>>(row, of);
      return value ? describe(*value) : std::string();
    }
    case Row::Kind::choice:
      return std::string(row.word(row.chosen(of)));
    default:
      return {};
  }
}

}  // namespace

std::vector<std::string_view> words_of(const Row& row) {
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < row.word_count; ++i) words.push_back(row.word(i));
  for (std::string_view rest = row.words; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    words.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return words;
}

std::string describe_others(Rows rows, const void* of, std::span<const std::string_view> said) {
  std::string text;
  for (const Row& row : rows) {
    if (row.kind == Row::Kind::by_hand || !applies(row, of)) continue;
    if (std::find(said.begin(), said.end(), row.key) != said.end()) continue;
    const std::string value = describe_value(row, of);
    if (value.empty() || value == describe_value(row, row.standard())) continue;
    text += ", " + std::string(row.key) + ' ' + value;
  }
  return text;
}

}  // namespace spoke::keys
