// Reads values of each type, and words what is wrong with them.

#include "models/reader/toml_section.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "models/reader/nearest_name.h"

namespace spoke {
namespace {

const toml::table& empty_table() {
  static const toml::table empty;
  return empty;
}

}  // namespace

std::string join_names(const TomlSection::Keys& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += '"' + std::string(names[i]) + '"';
  }
  return list;
}

TomlSection::TomlSection(const TomlDocument& document, const Keys& known)
    : TomlSection(document, document.root(), "", {1, 1}, known) {}

TomlSection::TomlSection(const TomlDocument& document, const toml::table& table, std::string path,
                         const toml::source_position& position, const Keys& known)
    : document_(&document), table_(&table), path_(std::move(path)), position_(position) {
  check_keys(known);
}

void TomlSection::check_keys(const Keys& known) const {
  // The table is sorted by name; the first slip in the file is what the user wants to hear of.
  const toml::key* first = nullptr;
  for (const auto& [key, node] : *table_) {
    const bool is_known = std::find(known.begin(), known.end(), key.str()) != known.end();
    if (is_known) continue;
    const auto line = [](const toml::key& k) { return k.source().begin.line; };
    if (first == nullptr || line(key) < line(*first)) first = &key;
  }
  if (first == nullptr) return;
  const auto nearest = nearest_name(first->str(), known);
  const std::string expected =
      nearest ? "did you mean \"" + std::string(*nearest) + "\"?" : "expected " + join_names(known);
  document_->fail(path_of(first->str()), first->source().begin, "unknown key, " + expected);
}

bool TomlSection::is_array(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_array();
}

bool TomlSection::is_text(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_string();
}

bool TomlSection::is_table(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_table();
}

TomlSection TomlSection::section(std::string_view key, const Keys& known) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) return {*document_, empty_table(), path_of(key), position_, known};
  if (!node->is_table()) fail_expected(key, "a table [" + path_of(key) + ']');
  return {*document_, *node->as_table(), path_of(key), node->source().begin, known};
}

std::vector<TomlSection> TomlSection::sections(std::string_view key, const Keys& known) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) return {};
  const std::string expected = "tables headed [[" + path_of(key) + "]]";
  if (!node->is_array_of_tables()) fail_expected(key, expected);
  std::vector<TomlSection> all;
  for (const toml::node& element : *node->as_array()) {
    const std::string path = path_of(key) + '.' + std::to_string(all.size() + 1);
    all.push_back({*document_, *element.as_table(), path, element.source().begin, known});
  }
  return all;
}

double TomlSection::number(std::string_view key, const Quantity& quantity) const {
  return checked_number(required(key, quantity.expectation()), path_of(key), quantity);
}

double TomlSection::number(std::string_view key, const Quantity& quantity, double fallback) const {
  return has(key) ? number(key, quantity) : fallback;
}

double TomlSection::checked_number(const toml::node& node, const std::string& path,
                                   const Quantity& quantity) const {
  const auto complain = [&](const std::string& expected) {
    document_->fail(path, node.source().begin, "is " + describe(node) + ", expected " + expected);
  };
  if (!node.is_number()) complain(quantity.expectation());
  const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get())
                                         : node.as_floating_point()->get();
  const std::string expected = quantity.expectation_instead_of(value);
  if (!expected.empty()) complain(expected);
  return value;
}

int TomlSection::integer(std::string_view key, const Count& count) const {
  const auto* value = required(key, count.expectation()).as_integer();
  if (value == nullptr || !count.holds(value->get())) fail_expected(key, count.expectation());
  return static_cast<int>(value->get());
}

int TomlSection::integer(std::string_view key, const Count& count, int fallback) const {
  return has(key) ? integer(key, count) : fallback;
}

bool TomlSection::flag(std::string_view key, bool fallback) const {
  if (!has(key)) return fallback;
  const auto* value = table_->get(key)->as_boolean();
  if (value == nullptr) fail_expected(key, "true or false");
  return value->get();
}

std::string TomlSection::text(std::string_view key, const std::string& fallback) const {
  if (!has(key)) return fallback;
  const auto* value = table_->get(key)->as_string();
  if (value == nullptr) fail_expected(key, "text in quotes");
  return value->get();
}

std::vector<double> TomlSection::numbers(std::string_view key, const Quantity& quantity,
                                         std::size_t count) const {
  const std::string expected = "an array of " +
                               (count == 0 ? "numbers" : std::to_string(count) + " numbers") +
                               in_parentheses(quantity.unit);
  const toml::array* array = required(key, expected).as_array();
  if (array == nullptr || array->empty() || (count != 0 && array->size() != count)) {
    fail_expected(key, expected);
  }
  std::vector<double> values;
  values.reserve(array->size());
  for (const toml::node& element : *array) {
    const std::string path = path_of(key) + '.' + std::to_string(values.size() + 1);
    values.push_back(checked_number(element, path, quantity));
  }
  return values;
}

std::vector<std::vector<double>> TomlSection::rows(std::string_view key, const Quantity& quantity,
                                                   std::size_t count,
                                                   std::size_t other_count) const {
  const std::string numbers = std::to_string(count) +
                              (other_count == 0 ? "" : " or " + std::to_string(other_count)) +
                              " numbers" + in_parentheses(quantity.unit);
  const toml::array* array = required(key, "an array of arrays of " + numbers).as_array();
  if (array == nullptr || array->empty()) fail_expected(key, "an array of arrays of " + numbers);
  std::vector<std::vector<double>> all;
  for (const toml::node& element : *array) {
    const std::string path = path_of(key) + '.' + std::to_string(all.size() + 1);
    std::vector<double> row;
    if (element.is_array()) flatten(*element.as_array(), path, quantity, row);
    if (!element.is_array() || (row.size() != count && row.size() != other_count) || row.empty())
      document_->fail(path, element.source().begin,
                      "is " + describe(element) + ", expected an array of " + numbers);
    all.push_back(std::move(row));
  }
  return all;
}

void TomlSection::flatten(const toml::array& array, const std::string& path,
                          const Quantity& quantity, std::vector<double>& numbers) const {
  std::size_t index = 0;
  for (const toml::node& element : array) {
    const std::string at = path + '.' + std::to_string(++index);
    if (element.is_array()) {
      flatten(*element.as_array(), at, quantity, numbers);
    } else {
      numbers.push_back(checked_number(element, at, quantity));
    }
  }
}

const toml::array& TomlSection::values(std::string_view key) const {
  const std::string expected = "an array of values";
  const toml::array* array = required(key, expected).as_array();
  if (array == nullptr || array->empty()) fail_expected(key, expected);
  return *array;
}

std::vector<double> TomlSection::increasing_numbers(std::string_view key,
                                                    const Quantity& quantity) const {
  std::vector<double> values = numbers(key, quantity);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[i - 1]) continue;
    const toml::node& element = *table_->get(key)->as_array()->get(i);
    document_->fail(path_of(key) + '.' + std::to_string(i + 1), element.source().begin,
                    "is " + describe(element) + ", expected more than the value before it, " +
                        describe(values[i - 1]));
  }
  return values;
}

std::size_t TomlSection::choice(std::string_view key, const Keys& names) const {
  const std::string expected = join_names(names);
  const auto* value = required(key, expected).as_string();
  if (value == nullptr) fail_expected(key, expected);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (value->get() == names[i]) return i;
  }
  fail_expected(key, expected);
}

std::string TomlSection::place(std::string_view key) const {
  const std::string path = key.empty() ? path_ : path_of(key);
  return document_->place(path, position(key)) + ": " + path;
}

const toml::source_position& TomlSection::position(std::string_view key) const {
  const toml::node* node = key.empty() ? nullptr : table_->get(key);
  return node == nullptr ? position_ : node->source().begin;
}

void TomlSection::fail(std::string_view key, const std::string& what) const {
  document_->fail(key.empty() ? path_ : path_of(key), position(key), what);
}

void TomlSection::fail_at(std::string_view path, const std::string& what) const {
  if (path.empty()) fail("", what);
  const toml::node* deepest = nullptr;
  const toml::node* node = table_;
  for (std::size_t begin = 0; node != nullptr && begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string name(path.substr(begin, end - begin));
    if (const toml::table* table = node->as_table()) {
      node = table->get(name);
    } else if (const toml::array* array = node->as_array()) {
      node = array->get(static_cast<std::size_t>(std::strtoul(name.c_str(), nullptr, 10)) - 1);
    } else {
      node = nullptr;
    }
    if (node != nullptr) deepest = node;
    begin = end + 1;
  }
  document_->fail(path_of(path), deepest == nullptr ? position_ : deepest->source().begin, what);
}

void TomlSection::fail_expected(std::string_view key, const std::string& expected) const {
  fail(key, "is " + describe(*table_->get(key)) + ", expected " + expected);
}

const toml::node& TomlSection::required(std::string_view key, const std::string& expected) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) fail(key, "is missing, expected " + expected);
  return *node;
}

std::string TomlSection::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + '.' + std::string(key);
}

}  // namespace spoke
