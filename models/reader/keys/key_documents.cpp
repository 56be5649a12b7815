// Tables of keys in Markdown.

#include <algorithm>
#include <array>
#include <cmath>

#include "models/reader/keys/key_cells.h"
#include "models/reader/keys/tables.h"

namespace spoke::keys {
namespace {

/// Returns a number as documents write it: "1e-9" without a zero before the 9.
std::string number_text(double number) {
  std::string text = describe(number);
  if (const std::size_t at = text.find("e-0"); at != std::string::npos) text.erase(at + 2, 1);
  return text;
}

std::string describe_range(const Quantity& range) {
  const bool has_least = std::isfinite(range.least), has_greatest = std::isfinite(range.greatest);
  if (has_least && has_greatest && range.least_included && range.greatest_included)
    return number_text(range.least) + " to " + number_text(range.greatest);
  std::string text;
  if (has_least)
    text = range.least_included ? number_text(range.least) + " or more"
                                : "greater than " + number_text(range.least);
  if (has_greatest)
    text += std::string(has_least ? ", " : "") +
            (range.greatest_included ? "at most " : "less than ") + number_text(range.greatest);
  return text;
}

std::string quoted(std::string_view word) { return "`\"" + std::string(word) + "\"`"; }

/// Returns the rows of a table of documents, and the heading of its last column.
Part find_part(std::string_view name, std::vector<const Row*>& rows) {
  Part found;
  for (const Table& table : tables())
    for (const Part& part : table.parts) {
      if (part.name != name) continue;
      found = part;
      for (const Row& row : part.rows)
        if (std::find(rows.begin(), rows.end(), &row) == rows.end()) rows.push_back(&row);
    }
  return found;
}

/// Returns the heading of the column of keys: "key of `[hub]`" if the part is named by its table.
std::string key_heading(std::string_view name) {
  if (!name.starts_with('[')) return "key";
  return "key of `" + std::string(name.substr(0, name.rfind(']') + 1)) + '`';
}

using Cells = std::array<std::string, 6>;

std::string line_of(const Cells& cells, const std::array<bool, 6>& is_shown) {
  std::string line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (is_shown[i]) line += (cells[i].empty() ? "" : ' ' + cells[i]) + " |";
  return line + '\n';
}

/// Adds the last cell to a line that is equal otherwise, if there is one.
bool add_to_equal(const Cells& cells, std::vector<Cells>& lines) {
  for (Cells& line : lines) {
    if (!std::equal(cells.begin(), cells.end() - 1, line.begin())) continue;
    if (!cells.back().empty() && line.back() != cells.back()) line.back() += ", " + cells.back();
    return true;
  }
  return false;
}

}  // namespace

std::string unit_of(const Row& row) {
  if (!row.unit_text.empty()) return std::string(row.unit_text);
  std::string text;
  for (std::size_t i = 0; i < row.range.unit.size(); ++i) {
    const std::string_view rest = row.range.unit.substr(i);
    if (rest[0] != '^') {
      text += rest[0];
      continue;
    }
    constexpr std::array kPowers{"²", "³", "⁴"};
    text += kPowers[static_cast<std::size_t>(rest[1] - '2')];
    ++i;
  }
  return text;
}

std::string range_text_of(const Row& row) {
  if (!row.range_text.empty()) return std::string(row.range_text);
  if ((row.forms & kWhole) != 0 && row.count.greatest > row.count.least)
    return std::to_string(row.count.least) + " to " + std::to_string(row.count.greatest);
  return describe_range(row.range);
}

std::string default_text_of(const Row& row) {
  if (!row.default_text.empty()) return std::string(row.default_text);
  if (row.presence == Presence::required) return "required";
  if (row.kind == Row::Kind::by_hand) return {};
  const void* const made = row.standard();
  switch (row.kind) {
    case Row::Kind::number:
      return number_text(member_of<double>(row, made));
    case Row::Kind::count:
      return std::to_string(member_of<int>(row, made));
    case Row::Kind::flag:
      return member_of<bool>(row, made) ? "true" : "false";
    case Row::Kind::choice:
      return quoted(row.word(row.chosen(made)));
    case Row::Kind::vector: {
      const double* const v = &member_of<double>(row, made);
      return "`[" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + "]`";
    }
    default:
      return {};
  }
}

std::string without_links(std::string_view markdown) {
  std::string text(markdown);
  for (std::size_t middle = text.find("]("); middle != std::string::npos;
       middle = text.find("](", middle)) {
    const std::size_t begin = text.rfind('[', middle), end = text.find(')', middle);
    text.erase(middle, end + 1 - middle);
    text.erase(begin, 1);
    middle = begin;
  }
  return text;
}

std::vector<std::string_view> document_names() {
  std::vector<std::string_view> names;
  for (const Table& table : tables())
    for (const Part& part : table.parts)
      if (!part.name.empty() && std::find(names.begin(), names.end(), part.name) == names.end())
        names.push_back(part.name);
  return names;
}

std::string to_markdown(std::string_view name) {
  std::vector<const Row*> rows;
  const Part part = find_part(name, rows);
  if (rows.empty()) return {};
  std::vector<Cells> lines;
  std::array<bool, 6> is_shown{};
  for (const Row* row : rows) {
    const Cells cells{'`' + std::string(row->key) + '`',
                      std::string(row->doc),
                      unit_of(*row),
                      default_text_of(*row),
                      range_text_of(*row),
                      std::string(row->more)};
    if (!add_to_equal(cells, lines)) lines.push_back(cells);
    for (std::size_t i = 0; i < is_shown.size(); ++i)
      is_shown[i] = is_shown[i] || !cells[i].empty();
  }
  std::string text = line_of(
      {key_heading(name), "meaning", "unit", "default", "range", std::string(part.more)}, is_shown);
  text += '|';
  for (const bool shown : is_shown) text += shown ? "---|" : "";
  text += '\n';
  for (const Cells& cells : lines) text += line_of(cells, is_shown);
  return text;
}

}  // namespace spoke::keys
