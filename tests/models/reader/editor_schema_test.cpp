// The JSON schema for editors: it takes the shipped scenarios, and refuses what it can.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "models/reader/keys/tables.h"
#include "models/reader/toml_document.h"
#include "models/text_file.h"

using namespace spoke;
using nlohmann::json;

namespace {

/// A validator of JSON Schema, draft 7, as far as the schema goes; it knows no other keywords.
class Validator {
 public:
  explicit Validator(json schema) : root_(std::move(schema)) {}

  /// Returns what is wrong with a value; empty: nothing.
  std::string find_fault(const json& value) const { return find_fault(value, root_, "scenario"); }

  /// Checks that a part of the schema has known keywords alone, and references that lead somewhere.
  void check(const json& schema) const {
    for (const auto& [keyword, value] : schema.items()) {
      if (keyword == "properties" || keyword == "definitions")
        for (const auto& [name, part] : value.items()) check(part);
      else if (keyword == "items" || (keyword == "additionalProperties" && value.is_object()))
        check(value);
      else if (keyword == "anyOf" || keyword == "allOf")
        for (const json& part : value) check(part);
      else if (keyword == "$ref")
        CHECK(root_.contains(pointer(value)));
      else
        CHECK(std::find(std::begin(kOthers), std::end(kOthers), keyword) != std::end(kOthers));
    }
  }
  void check() const { check(root_); }

 private:
  static constexpr const char* kOthers[] = {"$schema",     "title",
                                            "description", "type",
                                            "enum",        "required",
                                            "minItems",    "maxItems",
                                            "minimum",     "exclusiveMinimum",
                                            "maximum",     "exclusiveMaximum",
                                            "default",     "additionalProperties"};

  static json::json_pointer pointer(const json& reference) {
    return json::json_pointer(reference.get<std::string>().substr(1));
  }

  static bool has_type(const json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    return type == "number" && value.is_number();
  }

  static bool is_in_range(const json& value, const json& schema) {
    const double number = value.get<double>();
    return number >= schema.value("minimum", -INFINITY) &&
           number > schema.value("exclusiveMinimum", -INFINITY) &&
           number <= schema.value("maximum", INFINITY) &&
           number < schema.value("exclusiveMaximum", INFINITY);
  }

  std::string find_object_fault(const json& value, const json& schema,
                                const std::string& path) const {
    for (const json& key : schema.value("required", json::array()))
      if (!value.contains(key.get<std::string>())) return path + " lacks " + key.dump();
    for (const auto& [key, member] : value.items()) {
      const std::string place = path + '.' + key;
      if (schema.contains("properties") && schema["properties"].contains(key)) {
        if (std::string fault = find_fault(member, schema["properties"][key], place);
            !fault.empty())
          return fault;
      } else if (!schema["additionalProperties"].is_object()) {
        return place + " is unknown";
      } else if (std::string fault = find_fault(member, schema["additionalProperties"], place);
                 !fault.empty()) {
        return fault;
      }
    }
    return {};
  }

  std::string find_array_fault(const json& value, const json& schema,
                               const std::string& path) const {
    if (value.size() < schema.value("minItems", std::size_t{0}) ||
        value.size() > schema.value("maxItems", value.size()))
      return path + " has a wrong size";
    for (const json& element : value)
      if (std::string fault = find_fault(element, schema["items"], path + "[]"); !fault.empty())
        return fault;
    return {};
  }

  std::string find_fault(const json& value, const json& schema, const std::string& path) const {
    if (schema.contains("$ref")) return find_fault(value, root_[pointer(schema["$ref"])], path);
    if (schema.contains("allOf")) return find_fault(value, schema["allOf"][0], path);
    if (schema.contains("anyOf")) {
      std::string first;
      for (const json& form : schema["anyOf"]) {
        std::string fault = find_fault(value, form, path);
        if (fault.empty()) return {};
        if (first.empty()) first = fault;
      }
      return first;
    }
    if (!has_type(value, schema["type"])) return path + " is no " + schema["type"].dump();
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
      return path + " is no known word";
    if (value.is_number() && !is_in_range(value, schema)) return path + " is out of range";
    if (value.is_object()) return find_object_fault(value, schema, path);
    if (value.is_array() && schema.contains("items")) return find_array_fault(value, schema, path);
    return {};
  }

  json root_;
};

json to_json(const TomlTable& table);

json to_json(const TomlValue& value) {
  if (const std::string* text = value.as_text()) return *text;
  if (const std::int64_t* integer = value.as_integer()) return *integer;
  if (const double* number = value.as_floating_point()) return *number;
  if (const bool* flag = value.as_flag()) return *flag;
  if (const TomlTable* table = value.as_table()) return to_json(*table);
  json array = json::array();
  for (const TomlValue& element : *value.as_array()) array.push_back(to_json(element));
  return array;
}

json to_json(const TomlTable& table) {
  json object = json::object();
  for (const TomlMember& member : table) object[member.key] = to_json(member.value);
  return object;
}

json read_file(const std::string& file) {
  const TomlDocument document(read_text(file), file);
  return to_json(document.root());
}

const Validator& validator() {
  static const Validator kMade(json::parse(keys::editor_schema().dump()));
  return kMade;
}

/// Returns the fault of the scenario of the README with a part replaced.
std::string fault_with(const char* pointer, const json& value) {
  json scenario = read_file(SPOKE_MODELS_DIR "/nrel_5mw_in_wind.toml");
  scenario[json::json_pointer(pointer)] = value;
  return validator().find_fault(scenario);
}

}  // namespace

TEST_CASE("the editor's schema is a schema") { validator().check(); }

TEST_CASE("shipped scenarios satisfy the editor's schema") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SPOKE_MODELS_DIR)) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path().string());
    CHECK(validator().find_fault(read_file(entry.path().string())) == "");
    ++count;
  }
  CHECK(count > 20);
}

TEST_CASE("the editor's schema marks what is wrong") {
  CHECK(fault_with("/air/density", 1.2) == "");
  CHECK(fault_with("/air/density", 0.0) == "scenario.air.density is out of range");
  CHECK(fault_with("/air/density", "1") == "scenario.air.density is no \"number\"");
  CHECK(fault_with("/air/densty", 1.0) == "scenario.air.densty is unknown");
  CHECK(fault_with("/aerodynamics/stall", "slow") ==
        "scenario.aerodynamics.stall is no known word");
  CHECK(fault_with("/aerodynamics/inflow_factor", 2.5) ==
        "scenario.aerodynamics.inflow_factor is out of range");
  CHECK(fault_with("/gravity/acceleration", {0, 1, 2, 3}) ==
        "scenario.gravity.acceleration has a wrong size");
  CHECK(fault_with("/integration", {{"step", 0.1}}) == "scenario.integration lacks \"duration\"");
  CHECK(fault_with("/control/pitch/sign", 2) == "scenario.control.pitch.sign is out of range");
  CHECK(fault_with("/blade/count", 0) == "scenario.blade.count is out of range");
}
