#pragma once

// Scenarios written as TOML in another way than by people: every value of a table inline.

#include <nlohmann/json.hpp>
#include <string>

namespace spoke::test {

inline std::string to_toml(const nlohmann::ordered_json& json) {
  if (!json.is_structured()) return json.dump();
  std::string text;
  for (const auto& [key, value] : json.items())
    text += (text.empty() ? "" : ", ") + (json.is_object() ? key + " = " : "") + to_toml(value);
  return json.is_object() ? '{' + text + '}' : '[' + text + ']';
}

/// Returns a scenario's JSON as a TOML document, a line for each of its outermost keys.
inline std::string document_of(const std::string& json) {
  std::string text;
  const auto parsed = nlohmann::ordered_json::parse(json);
  for (const auto& [key, value] : parsed.items()) text += key + " = " + to_toml(value) + '\n';
  return text;
}

}  // namespace spoke::test
