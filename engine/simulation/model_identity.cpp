// Writes a scenario as the identity of its model, and compares two.

#include "engine/simulation/model_identity.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <sstream>
#include <variant>

#include "models/air/wind_kept.h"
#include "models/reader/scenario_json.h"
#include "models/solid/kept_geometry.h"

namespace spoke {
namespace {

/// Returns the key "blades.1.length", as scenario files and --set name it, for the pointer
/// "/blades/0/length".
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

/// Returns a value for a message; long ones are cut.
std::string text_of(const std::string& value) {
  if (value.empty()) return "absent";
  constexpr std::size_t most = 60;
  return value.size() > most ? value.substr(0, most) + "..." : value;
}

/// Returns what stands for files of these contents.
std::string name_contents(std::uint64_t hash) {
  std::ostringstream contents;
  contents << "contents " << std::hex << hash;
  return contents.str();
}

/// Puts the contents of a solid's files in the place of their names.
void identify_solid(const spatial::SolidBody& body, const std::string& path, Json& json) {
  const std::string contents = name_contents(solid::find_geometry(body)->content);
  if (!body.matrices) {
    json.set_at(path + "/mesh", contents);
    return;
  }
  for (const char* key : {"/mass", "/stiffness", "/nodes"}) json.set_at(path + key, contents);
  if (!body.matrices->own.front().empty()) json.set_at(path + "/geometric_stiffness", contents);
}

void identify_solids(const spatial::Model& model, Json& json) {
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    for (std::size_t j = 0; j < model.subsystems[i].bodies.size(); ++j)
      if (const auto* body = std::get_if<spatial::SolidBody>(&model.subsystems[i].bodies[j].shape))
        identify_solid(*body, "/subsystem/" + std::to_string(i) + "/body/" + std::to_string(j),
                       json);
}

void identify_wind(const spatial::Model& model, Json& json) {
  if (!model.air || model.air->wind.file.empty()) return;
  json.set_at("/wind/file", name_contents(air::find_wind(model.air->wind)->content()));
}

}  // namespace

std::string make_identity(const Scenario& scenario, Formulation formulation, double step_size) {
  // The way in which it starts is left out: its effect on drive and ramps is in the model.
  Json json = model_to_json(scenario);
  if (scenario.space) {
    identify_solids(*scenario.space, json);
    identify_wind(*scenario.space, json);
  }
  Json integration = integration_to_json(scenario);
  integration.erase("duration");
  integration.set("step", step_size);
  json.set("integration", std::move(integration));
  json.set("formulation", name_of(formulation));
  return json.dump_sorted();
}

std::string find_difference(const std::string& saved, const std::string& here) {
  if (saved == here) return {};
  const Json before = Json::parse(saved);
  if (!before.is_object()) return "the saved state does not say of which model it is";
  const std::optional<JsonChange> change = JsonChange::find_first(before, Json::parse(here));
  if (!change) return {};
  const std::string& place = change->place;
  // An element added to a list has the place "-" behind its end.
  if (place.empty() || place.ends_with("/-")) {
    const std::string list = place.empty() ? place : place.substr(0, place.size() - 2);
    return key_of(list.empty() ? "/scenario" : list) + " has not as many entries as here";
  }
  return key_of(place) + " is " + text_of(change->before) + " in the saved state and " +
         text_of(change->after) + " here";
}

}  // namespace spoke
