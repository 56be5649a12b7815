// Writes a scenario as the identity of its model, and compares two.

#include "engine/simulation/model_identity.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace spoke {
namespace {

using Json = nlohmann::json;

/// "/blades/0/length" as scenario files and --set name it: "blades.1.length".
std::string key_of(const std::string& pointer) {
  std::istringstream stream(pointer.substr(1));
  std::string key;
  for (std::string part; std::getline(stream, part, '/');) {
    const bool is_index =
        !part.empty() && part.size() < 9 &&
        std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (is_index) part = std::to_string(std::stoi(part) + 1);
    key += (key.empty() ? "" : ".") + part;
  }
  return key;
}

/// A value in a message; long ones are cut.
std::string text_of(const std::optional<Json>& value) {
  if (!value) return "absent";
  constexpr std::size_t most = 60;
  std::string text = value->dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > most) text = text.substr(0, most) + "...";
  return text;
}

std::optional<Json> value_at(const Json& json, const Json::json_pointer& place) {
  if (!json.contains(place)) return {};
  return json.at(place);
}

}  // namespace

std::string make_identity(const Scenario& scenario, Formulation formulation, double step_size) {
  Json json = Json::parse(scenario.to_json());
  json.erase("title");
  json.erase("initial");  // and what it has done to drive and ramps stays
  json.erase("limits");
  json.erase("output");
  json.erase("sensor");
  json["integration"].erase("duration");
  json["integration"]["step"] = step_size;
  json["formulation"] = name_of(formulation);
  return json.dump();
}

std::string find_difference(const std::string& saved, const std::string& here) {
  if (saved == here) return {};
  // A text of another origin may be nested without end.
  const auto is_shallow = [](int depth, Json::parse_event_t, Json&) { return depth < 32; };
  const Json before = Json::parse(saved, is_shallow, false);
  const Json now = Json::parse(here, nullptr, false);
  if (!before.is_object()) return "the saved state does not say of which model it is";
  const Json changes = Json::diff(before, now);
  if (changes.empty()) return {};
  const auto pointer = changes[0]["path"].get<std::string>();
  // An element added to a list has the place "-" behind its end.
  if (pointer.empty() || pointer.ends_with("/-")) {
    const std::string list = pointer.empty() ? pointer : pointer.substr(0, pointer.size() - 2);
    return key_of(list.empty() ? "/scenario" : list) + " has not as many entries as here";
  }
  const Json::json_pointer place(pointer);
  return key_of(pointer) + " is " + text_of(value_at(before, place)) + " in the saved state and " +
         text_of(value_at(now, place)) + " here";
}

}  // namespace spoke
