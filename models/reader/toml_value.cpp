// Tables, and values in messages.

#include "models/reader/toml_value.h"

#include <algorithm>
#include <utility>

#include "models/support/quantity.h"

namespace spoke {
namespace {

template <class Members>
auto place_of(std::string_view key, Members& members) {
  return std::lower_bound(
      members.begin(), members.end(), key,
      [](const TomlMember& member, std::string_view k) { return member.key.compare(k) < 0; });
}

}  // namespace

const TomlValue* TomlTable::find(std::string_view key) const {
  const auto member = place_of(key, members_);
  return member == members_.end() || member->key != key ? nullptr : &member->value;
}

TomlValue* TomlTable::find(std::string_view key) {
  return const_cast<TomlValue*>(std::as_const(*this).find(key));
}

void TomlTable::set(std::string_view key, TomlValue value, const TomlPosition& position) {
  const auto member = place_of(key, members_);
  if (member == members_.end() || member->key != key) {
    members_.insert(member, TomlMember{std::string(key), position, std::move(value)});
  } else {
    member->value = std::move(value);
  }
}

std::vector<TomlMember>::const_iterator TomlTable::begin() const { return members_.begin(); }
std::vector<TomlMember>::const_iterator TomlTable::end() const { return members_.end(); }

bool TomlValue::is_array_of_tables() const {
  const TomlArray* array = as_array();
  return array != nullptr && !array->empty() &&
         std::all_of(array->begin(), array->end(),
                     [](const TomlValue& element) { return element.as_table() != nullptr; });
}

std::string describe(const TomlValue& value) {
  constexpr std::size_t longest = 60;
  if (const auto* text = value.as_text()) return '"' + one_line(*text, longest) + '"';
  if (const auto* integer = value.as_integer()) return std::to_string(*integer);
  if (const auto* number = value.as_floating_point()) {
    // 4.0 where a whole number is expected must not read 4.
    const std::string text = describe(*number);
    return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
  }
  if (const auto* flag = value.as_flag()) return *flag ? "true" : "false";
  if (const auto* array = value.as_array()) {
    if (array->empty()) return "an empty array";
    return (value.is_array_of_tables() ? "an array of tables (" : "an array (") +
           std::to_string(array->size()) + ')';
  }
  return value.as_table() != nullptr ? "a table" : "a date or time";
}

std::string one_line(std::string_view text, std::size_t longest) {
  std::string line(text.substr(0, longest));
  if (text.size() > longest) {
    // The text is never cut inside a UTF-8 sequence.
    while (!line.empty() && (static_cast<unsigned char>(text[line.size()]) & 0xC0U) == 0x80U) {
      line.pop_back();
    }
    line += "...";
  }
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return line;
}

}  // namespace spoke
