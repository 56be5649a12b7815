// Parses text and overrides, applies the overrides, and finds where a key stands.

#include "models/reader/toml_document.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "models/count_text.h"
#include "models/error.h"
#include "models/reader/toml_depth.h"
#include "models/support/quantity.h"

namespace spoke {
namespace {

constexpr std::size_t kLongestQuote = 60;
constexpr std::size_t kDeepestPath = 8;
constexpr std::size_t kMostNames = 32;  // most names of a key's path in the file

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Returns the names of a key path; empty if it is not one, or deeper than any key.
std::vector<std::string> split_path(std::string_view path) {
  constexpr std::string_view letters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string_view name = path.substr(begin, end - begin);
    if (name.empty() || name.find_first_not_of(letters) != std::string_view::npos) return {};
    names.emplace_back(name);
    begin = end + 1;
  }
  if (names.size() > kDeepestPath) return {};
  return names;
}

std::string join_path(const std::vector<std::string>& names, std::size_t count) {
  std::string path;
  for (std::size_t i = 0; i < count; ++i) path += (i == 0 ? "" : ".") + names[i];
  return path;
}

bool is_index(std::string_view name) {
  return name.size() <= 9 && std::all_of(name.begin(), name.end(),
                                         [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string quote_as_toml(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + '"';
}

TomlPosition position_of(const toml::source_position& position) {
  return {static_cast<int>(position.line), static_cast<int>(position.column)};
}

TomlValue take_over(const toml::node& node) {
  TomlValue taken{{}, position_of(node.source().begin)};
  node.visit([&taken](const auto& value) {
    if constexpr (toml::is_table<decltype(value)>) {
      TomlTable& table = taken.data.emplace<TomlTable>();
      for (const auto& [key, member] : value)
        table.set(key.str(), take_over(member), position_of(key.source().begin));
    } else if constexpr (toml::is_array<decltype(value)>) {
      TomlArray& array = taken.data.emplace<TomlArray>();
      array.reserve(value.size());
      for (const toml::node& element : value) array.push_back(take_over(element));
    } else if constexpr (!toml::is_chronological<decltype(value)>) {
      taken.data = value.get();
    }
  });
  return taken;
}

/// Returns the value that the text of an assignment stands for.
TomlValue parse_value(std::string_view text, const std::string& where) {
  const std::string assignment = "value = " + std::string(text);
  try {
    if (!find_deep_key(assignment, kMostNames)) {
      const toml::table parsed = toml::parse(assignment);
      if (parsed.size() == 1) return take_over(*parsed.get("value"));
    }
  } catch (const toml::parse_error&) {
    // A bare word: reference_frame=chord.
  }
  try {
    return take_over(*toml::parse("value = " + quote_as_toml(text)).get("value"));
  } catch (const toml::parse_error& error) {
    throw InputError(where + ": the value is not TOML: " + one_line(error.description()));
  }
}

TomlValue* find(TomlValue& parent, const std::string& name) {
  if (TomlTable* table = parent.as_table()) return table->find(name);
  TomlArray* array = parent.as_array();
  if (array == nullptr || !is_index(name)) return nullptr;
  const std::size_t index = std::stoul(name);
  return index == 0 || index > array->size() ? nullptr : &(*array)[index - 1];
}

/// Puts `value` under `name` of a table, or at an index of an array, at most one behind its end.
/// Returns what is wrong if it does not fit there.
std::string put(TomlValue& parent, const std::string& name, TomlValue value) {
  if (TomlTable* table = parent.as_table()) {
    table->set(name, std::move(value));
    return {};
  }
  TomlArray* array = parent.as_array();
  if (array == nullptr) return "is " + describe(parent) + ", which holds no keys";
  const std::size_t index = is_index(name) ? std::stoul(name) : 0;
  if (index == 0 || index > array->size() + 1) {
    return "is an array of " + counted(std::ssize(*array), "value") + ", expected " +
           (array->empty() ? "the index 1"
                           : "an index from " + range_text(1, std::ssize(*array) + 1)) +
           " instead of \"" + one_line(name, kLongestQuote) + '"';
  }
  if (index > array->size()) {
    array->push_back(std::move(value));
  } else {
    (*array)[index - 1] = std::move(value);
  }
  return {};
}

/// Returns the line and column, from 1, of a byte of the text.
TomlPosition position_of(std::size_t byte, std::string_view text) {
  const std::string_view before = text.substr(0, byte);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const auto column = byte - (before.rfind('\n') + 1);  // npos + 1 is 0
  return {static_cast<int>(lines + 1), static_cast<int>(column + 1)};
}

}  // namespace

TomlDocument::TomlDocument(const std::string& text, std::string name) : name_(std::move(name)) {
  if (const auto zero = text.find('\0'); zero != std::string::npos) {
    throw InputError(name_ + ": has a zero byte at " + std::to_string(zero) +
                         ", expected a text file (TOML in UTF-8)",
                     {.file = name_});
  }
  if (const auto deep = find_deep_key(text, kMostNames)) {
    fail("", position_of(*deep, text),
         "has a key of more than " + std::to_string(kMostNames) +
             " names, expected at most that many, joined by dots");
  }
  try {
    root_ = take_over(toml::parse(text, name_));
  } catch (const toml::parse_error& error) {
    fail("", position_of(error.source().begin), "not TOML: " + one_line(error.description()));
  }
}

void TomlDocument::set(const std::string& assignment) {
  const std::string where = "--set " + one_line(assignment, kLongestQuote);
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw InputError(where + ": has no '=', expected key=value, for example blade.bodies=8");
  }
  const std::string_view path = trim(std::string_view(assignment).substr(0, equals));
  const std::string_view text = trim(std::string_view(assignment).substr(equals + 1));
  const Names names = split_path(path);
  if (names.empty()) {
    throw InputError(where + ": the key is \"" + one_line(path, kLongestQuote) +
                     "\", expected names joined by dots, for example blade.bodies=8");
  }
  if (text.empty()) throw InputError(where + ": has no value behind '=', expected key=value");
  TomlValue value = parse_value(text, where);
  TomlValue* parent = &root_;
  for (std::size_t depth = 0; depth + 1 < names.size(); ++depth) {
    parent = &find_or_make(*parent, names, depth, where);
  }
  const std::string wrong = put(*parent, names.back(), std::move(value));
  if (!wrong.empty()) {
    throw InputError(where + ": " + join_path(names, names.size() - 1) + ": " + wrong);
  }
  remember(join_path(names, names.size()), where);
}

/// Returns the node names[depth] of `parent`; if there is none, adds a table, or an array where an
/// index follows.
TomlValue& TomlDocument::find_or_make(TomlValue& parent, const Names& names, std::size_t depth,
                                      const std::string& where) {
  const std::string& name = names[depth];
  if (find(parent, name) == nullptr) {
    const bool array = is_index(names[depth + 1]);
    TomlValue made;
    if (array) {
      made.data = TomlArray{};
    } else {
      made.data = TomlTable{};
    }
    const std::string wrong = put(parent, name, std::move(made));
    if (!wrong.empty()) throw InputError(where + ": " + join_path(names, depth) + ": " + wrong);
    remember(join_path(names, depth + 1), where);
  }
  return *find(parent, name);
}

void TomlDocument::remember(const std::string& path, const std::string& where) {
  std::erase_if(overrides_, [&](const auto& entry) { return entry.first.starts_with(path + '.'); });
  overrides_[path] = where;
}

std::string TomlDocument::find_override(const std::string& path) const {
  for (std::string prefix = path; !prefix.empty();) {
    if (const auto found = overrides_.find(prefix); found != overrides_.end()) {
      return found->second;
    }
    const auto dot = prefix.rfind('.');
    prefix.resize(dot == std::string::npos ? 0 : dot);
  }
  return {};
}

std::string TomlDocument::place(const std::string& path, const TomlPosition& position) const {
  if (std::string where = find_override(path); !where.empty()) return where;
  if (!position.is_known()) return name_;
  return name_ + ':' + std::to_string(position.line) + ':' + std::to_string(position.column);
}

void TomlDocument::fail(const std::string& path, const TomlPosition& position,
                        const std::string& what) const {
  InputPlace place{.key = path};
  if (find_override(path).empty()) {
    place.file = name_;
    place.line = position.line;  // 0: not known
    place.column = position.column;
  }
  const std::string message = path + (path.empty() ? "" : ": ") + what;
  throw InputError(this->place(path, position) + ": " + one_line(message), std::move(place));
}

}  // namespace spoke
