// Reads values of each type, and words what is wrong with them.

#include "models/reader/toml_section.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "models/support/nearest_name.h"

namespace spoke {
namespace {

const TomlTable& empty_table() {
  static const TomlTable empty;
  return empty;
}

/// Returns the element at an index from 1; null if there is none.
const TomlValue* element_at(const TomlArray& array, const std::string& index) {
  const std::size_t i = std::strtoul(index.c_str(), nullptr, 10);
  return i == 0 || i > array.size() ? nullptr : &array[i - 1];
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

TomlSection::TomlSection(const TomlDocument& document, const TomlTable& table, std::string path,
                         const TomlPosition& position, const Keys& known)
    : document_(&document), table_(&table), path_(std::move(path)), position_(position) {
  check_keys(known);
}

void TomlSection::check_keys(const Keys& known) const {
  // The table is sorted by name; the first slip in the file is what the user wants to hear of.
  const TomlMember* first = nullptr;
  for (const TomlMember& member : *table_) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    if (first == nullptr || member.position.line < first->position.line) first = &member;
  }
  if (first == nullptr) return;
  const auto nearest = nearest_name(first->key, known);
  const std::string expected =
      nearest ? "did you mean \"" + std::string(*nearest) + "\"?" : "expected " + join_names(known);
  document_->fail(path_of(first->key), first->position, "unknown key, " + expected);
}

bool TomlSection::is_array(std::string_view key) const {
  const TomlValue* value = table_->find(key);
  return value != nullptr && value->as_array() != nullptr;
}

bool TomlSection::is_nested(std::string_view key) const {
  if (!is_array(key)) return false;
  const TomlArray& array = *table_->find(key)->as_array();
  return !array.empty() && array.front().as_array() != nullptr;
}

bool TomlSection::is_text(std::string_view key) const {
  const TomlValue* value = table_->find(key);
  return value != nullptr && value->as_text() != nullptr;
}

bool TomlSection::is_table(std::string_view key) const {
  const TomlValue* value = table_->find(key);
  return value != nullptr && value->as_table() != nullptr;
}

TomlSection TomlSection::section(std::string_view key, const Keys& known) const {
  const TomlValue* value = table_->find(key);
  if (value == nullptr) return {*document_, empty_table(), path_of(key), position_, known};
  if (value->as_table() == nullptr) fail_expected(key, "a table [" + path_of(key) + ']');
  return {*document_, *value->as_table(), path_of(key), value->position, known};
}

std::vector<TomlSection> TomlSection::sections(std::string_view key, const Keys& known) const {
  const TomlValue* value = table_->find(key);
  if (value == nullptr) return {};
  const std::string expected = "tables headed [[" + path_of(key) + "]]";
  if (!value->is_array_of_tables()) fail_expected(key, expected);
  std::vector<TomlSection> all;
  for (const TomlValue& element : *value->as_array()) {
    const std::string path = path_of(key) + '.' + std::to_string(all.size() + 1);
    all.push_back({*document_, *element.as_table(), path, element.position, known});
  }
  return all;
}

double TomlSection::number(std::string_view key, const Quantity& quantity) const {
  return checked_number(required(key, quantity.expectation()), path_of(key), quantity);
}

double TomlSection::number(std::string_view key, const Quantity& quantity, double fallback) const {
  return has(key) ? number(key, quantity) : fallback;
}

double TomlSection::checked_number(const TomlValue& value, const std::string& path,
                                   const Quantity& quantity) const {
  const auto complain = [&](const std::string& expected) {
    document_->fail(path, value.position, "is " + describe(value) + ", expected " + expected);
  };
  const std::int64_t* integer = value.as_integer();
  const double* floating = value.as_floating_point();
  if (integer == nullptr && floating == nullptr) complain(quantity.expectation());
  const double number = integer != nullptr ? static_cast<double>(*integer) : *floating;
  const std::string expected = quantity.expectation_instead_of(number);
  if (!expected.empty()) complain(expected);
  return number;
}

int TomlSection::integer(std::string_view key, const Count& count) const {
  const auto* value = required(key, count.expectation()).as_integer();
  if (value == nullptr || !count.holds(*value)) fail_expected(key, count.expectation());
  return static_cast<int>(*value);
}

int TomlSection::integer(std::string_view key, const Count& count, int fallback) const {
  return has(key) ? integer(key, count) : fallback;
}

bool TomlSection::flag(std::string_view key, bool fallback) const {
  if (!has(key)) return fallback;
  const auto* value = table_->find(key)->as_flag();
  if (value == nullptr) fail_expected(key, "true or false");
  return *value;
}

std::string TomlSection::text(std::string_view key, const std::string& fallback) const {
  if (!has(key)) return fallback;
  const auto* value = table_->find(key)->as_text();
  if (value == nullptr) fail_expected(key, "text in quotes");
  return *value;
}

std::vector<double> TomlSection::numbers(std::string_view key, const Quantity& quantity,
                                         std::size_t count) const {
  const std::string expected = "an array of " +
                               (count == 0 ? "numbers" : std::to_string(count) + " numbers") +
                               in_parentheses(quantity.unit);
  const TomlArray* array = required(key, expected).as_array();
  if (array == nullptr || array->empty() || (count != 0 && array->size() != count)) {
    fail_expected(key, expected);
  }
  std::vector<double> values;
  values.reserve(array->size());
  for (const TomlValue& element : *array) {
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
  const TomlArray* array = required(key, "an array of arrays of " + numbers).as_array();
  if (array == nullptr || array->empty()) fail_expected(key, "an array of arrays of " + numbers);
  std::vector<std::vector<double>> all;
  for (const TomlValue& element : *array) {
    const std::string path = path_of(key) + '.' + std::to_string(all.size() + 1);
    std::vector<double> row;
    if (element.as_array() != nullptr) flatten(*element.as_array(), path, quantity, row);
    if (element.as_array() == nullptr || (row.size() != count && row.size() != other_count) ||
        row.empty())
      document_->fail(path, element.position,
                      "is " + describe(element) + ", expected an array of " + numbers);
    all.push_back(std::move(row));
  }
  return all;
}

void TomlSection::flatten(const TomlArray& array, const std::string& path, const Quantity& quantity,
                          std::vector<double>& numbers) const {
  std::size_t index = 0;
  for (const TomlValue& element : array) {
    const std::string at = path + '.' + std::to_string(++index);
    if (element.as_array() != nullptr) {
      flatten(*element.as_array(), at, quantity, numbers);
    } else {
      numbers.push_back(checked_number(element, at, quantity));
    }
  }
}

const TomlArray& TomlSection::values(std::string_view key) const {
  const std::string expected = "an array of values";
  const TomlArray* array = required(key, expected).as_array();
  if (array == nullptr || array->empty()) fail_expected(key, expected);
  return *array;
}

std::vector<double> TomlSection::increasing_numbers(std::string_view key,
                                                    const Quantity& quantity) const {
  std::vector<double> values = numbers(key, quantity);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[i - 1]) continue;
    const TomlValue& element = (*table_->find(key)->as_array())[i];
    document_->fail(path_of(key) + '.' + std::to_string(i + 1), element.position,
                    "is " + describe(element) + ", expected more than the value before it, " +
                        describe(values[i - 1]));
  }
  return values;
}

std::size_t TomlSection::choice(std::string_view key, const Keys& names) const {
  const std::string expected = join_names(names);
  const auto* value = required(key, expected).as_text();
  if (value == nullptr) fail_expected(key, expected);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (*value == names[i]) return i;
  }
  fail_expected(key, expected);
}

std::string TomlSection::place(std::string_view key) const {
  const std::string path = key.empty() ? path_ : path_of(key);
  return document_->place(path, position(key)) + ": " + path;
}

const TomlPosition& TomlSection::position(std::string_view key) const {
  const TomlValue* value = key.empty() ? nullptr : table_->find(key);
  return value == nullptr ? position_ : value->position;
}

void TomlSection::fail(std::string_view key, const std::string& what) const {
  document_->fail(key.empty() ? path_ : path_of(key), position(key), what);
}

void TomlSection::fail_at(std::string_view path, const std::string& what) const {
  if (path.empty()) fail("", what);
  const TomlValue* deepest = nullptr;
  const TomlTable* table = table_;
  const TomlArray* array = nullptr;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string name(path.substr(begin, end - begin));
    const TomlValue* value = table != nullptr   ? table->find(name)
                             : array != nullptr ? element_at(*array, name)
                                                : nullptr;
    if (value == nullptr) break;
    deepest = value;
    table = value->as_table();
    array = value->as_array();
    begin = end + 1;
  }
  document_->fail(path_of(path), deepest == nullptr ? position_ : deepest->position, what);
}

void TomlSection::fail_expected(std::string_view key, const std::string& expected) const {
  fail(key, "is " + describe(*table_->find(key)) + ", expected " + expected);
}

const TomlValue& TomlSection::required(std::string_view key, const std::string& expected) const {
  const TomlValue* value = table_->find(key);
  if (value == nullptr) fail(key, "is missing, expected " + expected);
  return *value;
}

std::string TomlSection::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + '.' + std::string(key);
}

}  // namespace spoke
