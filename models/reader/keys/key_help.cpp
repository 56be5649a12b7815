// Finds keys by the ends of their paths, and tells them without Markdown.

#include "models/reader/keys/key_help.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "models/reader/keys/key_cells.h"
#include "models/reader/keys/tables.h"
#include "models/support/nearest_name.h"

namespace spoke::keys {
namespace {

using Names = std::vector<std::string_view>;

/// Splits a path at dots, without indices.
Names split(std::string_view path) {
  Names names;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('.'), path.size());
    const std::string_view name = path.substr(0, end);
    const bool is_index =
        std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!is_index) names.push_back(name);
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return names;
}

/// Takes brackets and blanks off: "[[blade.joint]]".
std::string_view strip(std::string_view name) {
  const std::size_t begin = name.find_first_not_of("[ ");
  if (begin == std::string_view::npos) return {};
  return name.substr(begin, name.find_last_not_of("] ") + 1 - begin);
}

/// Whether the names of a table that stands within others end as those that are asked for; tables
/// of several places have a part of their paths.
bool end_alike(const Names& asked, const Names& table) {
  const std::size_t common = std::min(asked.size(), table.size());
  return std::equal(asked.end() - static_cast<std::ptrdiff_t>(common), asked.end(),
                    table.end() - static_cast<std::ptrdiff_t>(common));
}

/// Returns a text in Markdown without its marks.
std::string plain(std::string_view markdown) {
  std::string text = without_links(markdown);
  std::erase(text, '`');
  return text;
}

/// Returns the name of a part, "[hub] in space", or that of its table in brackets.
std::string table_name(const Table& table, const Part& part) {
  if (part.name.starts_with('[')) return std::string(part.name);
  const std::string of = table.id.empty() ? "the file" : '[' + std::string(table.id) + ']';
  return part.name.empty() ? of : of + ", " + std::string(part.name);
}

void add_fact(const char* name, const std::string& value, std::string& text) {
  if (!value.empty()) text += std::string("  ") + name + plain(value) + '\n';
}

std::string words(const Row& row) {
  std::string list;
  for (const std::string_view word : words_of(row))
    list += (list.empty() ? "\"" : ", \"") + std::string(word) + '"';
  return list;
}

std::string tell(const Table& table, const Part& part, const Row& row) {
  std::string text = std::string(row.key) + " of " + table_name(table, part) + '\n';
  text += "  " + plain(row.doc) + '\n';
  add_fact("unit     ", unit_of(row), text);
  add_fact("default  ", default_text_of(row), text);
  add_fact("range    ", range_text_of(row), text);
  add_fact("words    ", words(row), text);
  return text;
}

/// Returns the keys of a table, a line each.
std::string tell(const Table& table, const Part& part) {
  std::string text = table_name(table, part) + '\n';
  std::size_t width = 0;
  for (const Row& row : part.rows) width = std::max(width, row.key.size());
  for (const Row& row : part.rows) {
    const std::string unit = unit_of(row);
    text += "  " + std::string(row.key) + std::string(width + 2 - row.key.size(), ' ') +
            plain(row.doc) + (unit.empty() ? "" : " [" + unit + ']') + '\n';
  }
  return text;
}

/// What is told, and for which kinds of the table it is so.
struct Told {
  std::string text, heading, kinds;
};

/// Adds what is told, or the kinds of what was told already.
void add(Told more, std::vector<Told>& all) {
  const auto same = std::find_if(all.begin(), all.end(),
                                 [&](const Told& told) { return told.text == more.text; });
  if (same == all.end())
    all.push_back(std::move(more));
  else if (!more.kinds.empty() && same->kinds != more.kinds)
    same->kinds += ", " + more.kinds;
}

}  // namespace

std::string explain(std::string_view name) {
  Names asked = split(strip(name));
  if (asked.empty()) return {};
  std::vector<Told> told;
  for (const Table& table : tables())
    for (const Part& part : table.parts)
      if (!table.id.empty() && split(table.id).back() == asked.back() &&
          end_alike(asked, split(table.id)))
        add({tell(table, part), {}, {}}, told);
  const std::string_view key = asked.back();
  asked.pop_back();
  for (const Table& table : tables())
    for (const Part& part : table.parts)
      for (const Row& row : part.rows) {
        if (row.key != key) continue;
        if (table.id.empty() ? asked.empty() : end_alike(asked, split(table.id)))
          add({tell(table, part, row), std::string(part.more), std::string(row.more)}, told);
      }
  std::string all;
  for (const Told& one : told) {
    all += (all.empty() ? "" : "\n") + one.text;
    const std::string blanks(one.heading.size() < 9 ? 9 - one.heading.size() : 2, ' ');
    add_fact((one.heading + blanks).c_str(), one.kinds, all);
  }
  return all;
}

std::string find_alike(std::string_view name) {
  const Names asked = split(strip(name));
  if (asked.empty()) return {};
  std::vector<std::string_view> names;
  for (const Table& table : tables()) {
    if (!table.id.empty()) names.push_back(split(table.id).back());
    for (const Part& part : table.parts)
      for (const Row& row : part.rows) names.push_back(row.key);
  }
  const auto nearest = nearest_name(asked.back(), names);
  return nearest ? std::string(*nearest) : std::string();
}

}  // namespace spoke::keys
