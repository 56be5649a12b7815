// Reads scenario files: read_scenario() and parse_scenario() of models/scenario.h.

#include <filesystem>

#include "models/reader/keys/scenario_keys.h"
#include "models/reader/loop_faults.h"
#include "models/reader/row_reader.h"
#include "models/reader/scenario_fields.h"
#include "models/reader/scenario_rotor.h"
#include "models/reader/scenario_sensors.h"
#include "models/reader/spatial/model_reader.h"
#include "models/reader/spatial/sensor_reader.h"
#include "models/reader/spatial/wind_reader.h"
#include "models/reader/statistics_reader.h"
#include "models/reader/toml_document.h"
#include "models/scenario.h"
#include "models/start.h"
#include "models/text_file.h"

namespace spoke {
namespace {

/// Reads [integration], after the model.
Integration read_integration(const TomlSection& root, const Scenario& scenario) {
  const TomlSection section = root.section("integration", keys::keys_of(keys::kIntegrationRows));
  Integration integration;
  keys::read(section, keys::kIntegrationRows, &integration);
  if (section.has("iterate_to") || section.has("tolerance"))
    integration.iterate_to = section.choice(
        "iterate_to", {IterationGoal::error, IterationGoal::tolerance}, IterationGoal::tolerance);
  const std::string fault = find_step_fault(integration);
  if (!fault.empty()) section.fail(section.has("step") ? "step" : "duration", fault);
  const std::string radius_fault = find_radius_fault(integration, scenario);
  if (!radius_fault.empty()) section.fail("spectral_radius", radius_fault);
  return integration;
}

Limits read_limits(const TomlSection& root) {
  const TomlSection section = root.section("limits", keys::keys_of(keys::kLimitsRows));
  Limits limits;
  keys::read(section, keys::kLimitsRows, &limits);
  return limits;
}

/// Reads [initial], after all that the start depends on.
Initial read_initial(const TomlSection& root, const Scenario& read) {
  const TomlSection section = root.section("initial", keys::keys_of(keys::kInitialRows));
  Scenario scenario = read;
  Initial& initial = scenario.initial;
  keys::read(section, keys::kInitialRows, &initial);
  const StartFault fault = find_start_fault(scenario);
  if (!fault.key.empty()) section.fail(fault.key, fault.text);
  return initial;
}

/// Returns the elements of an array of tables, if a table has one of this name.
std::vector<const TomlTable*> find_tables(const TomlTable& table, std::string_view key) {
  std::vector<const TomlTable*> tables;
  const TomlValue* value = table.find(key);
  if (value && value->as_array())
    for (const TomlValue& element : *value->as_array())
      if (element.as_table()) tables.push_back(element.as_table());
  return tables;
}

/// Returns the key of the first body that is a solid, whatever else the scenario says; empty if
/// there is none.
std::string find_solid(const TomlTable& root) {
  std::size_t number = 0;
  for (const TomlTable* subsystem : find_tables(root, "subsystem")) {
    ++number;
    std::size_t body = 0;
    for (const TomlTable* table : find_tables(*subsystem, "body")) {
      ++body;
      const TomlValue* kind = table->find("kind");
      if (kind && kind->as_text() && *kind->as_text() == "solid")
        return "subsystem." + std::to_string(number) + ".body." + std::to_string(body) + ".kind";
    }
  }
  return {};
}

bool has_suspension(const TomlTable& root) {
  const TomlValue* hub = root.find("hub");
  return hub && hub->as_table() && hub->as_table()->find("suspension");
}

/// Reads the model, in the plane or in space. Files that it names are relative to `folder`.
void read_world(const TomlDocument& document, const TomlSection& root, const std::string& folder,
                Scenario& scenario) {
  const bool is_spatial =
      root.has("world") && keys::read_word(root, keys::kScenarioRows, "world") == 1;
  const auto refuse = [&](std::string_view key, const char* expected) {
    if (root.has(key))
      root.fail(key, "belongs to another world, expected world = " + std::string(expected));
  };
  if (is_spatial) {
    refuse("drag", "\"plane\"");
    scenario.space = spatial::read_model(root, folder);
  } else {
    if (const std::string path = find_solid(document.root()); !path.empty())
      root.fail_at(path, "is \"solid\", and solids belong to world = \"space\"");
    refuse("subsystem", "\"space\"");
    for (const char* key :
         {"support", "rotor", "control", "event", "air", "wind", "aerodynamics", "airfoil"})
      refuse(key, "\"space\"");
    if (has_suspension(document.root()))
      root.fail_at("hub.suspension", "belongs to another world, expected world = \"space\"");
    scenario.rotor = read_rotor(root);
  }
}

/// Returns the file's name without folder and ending; it names a folder, so that "." and ".." are
/// none.
std::string name_of_file(const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem().string();
  return stem.find_first_not_of('.') == std::string::npos ? "scenario" : stem;
}

}  // namespace

Scenario parse_scenario(const std::string& text, const std::string& name,
                        const Overrides& overrides) {
  TomlDocument document(text, name);
  for (const std::string& assignment : overrides) document.set(assignment);
  const TomlSection root(document, keys::keys_of(keys::kScenarioRows));
  Scenario scenario;
  scenario.name = name_of_file(name);
  scenario.title = root.text("title", scenario.name);
  read_world(document, root, std::filesystem::path(name).parent_path().string(), scenario);
  scenario.initial = read_initial(root, scenario);
  scenario.integration = read_integration(root, scenario);
  if (const spatial::Fault fault = spatial::find_end_fault(scenario))
    root.fail_at(fault.path, fault.text);
  scenario.limits = read_limits(root);
  keys::read(root.section("output", keys::keys_of(keys::kOutputRows)), keys::kOutputRows,
             &scenario.output);
  scenario.statistics = read_statistics(root, scenario);
  scenario.sensors = scenario.space ? spatial::read_sensors(root, *scenario.space)
                                    : read_sensors(root, scenario.rotor.blades);
  return scenario;
}

Scenario read_scenario(const std::string& file, const Overrides& overrides) {
  return parse_scenario(read_text(file), file, overrides);
}

}  // namespace spoke
