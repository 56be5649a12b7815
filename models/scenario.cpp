#include "models/scenario.h"

#include <filesystem>

#include "models/field_reader.h"
#include "models/scenario_rotor.h"
#include "models/text_file.h"
#include "models/toml_document.h"

namespace spoke {
namespace {

Integration read_integration(const TomlSection& root) {
  const TomlSection section =
      root.section("integration", {"method", "step", "duration", "spectral_radius", "tolerance",
                                   "iterations", "max_iterations"});
  Integration integration;
  integration.method = section.choice(
      "method", {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}, integration.method);
  visit_fields(integration, FieldReader{section});
  const std::string fault = find_step_fault(integration);
  if (!fault.empty()) section.fail(section.has("step") ? "step" : "duration", fault);
  return integration;
}

Limits read_limits(const TomlSection& root) {
  const TomlSection section =
      root.section("limits", {"deflection", "energy_growth", "on_energy_growth"});
  Limits limits;
  visit_fields(limits, FieldReader{section});
  limits.on_energy_growth = section.choice(
      "on_energy_growth", {EnergyGrowth::warn, EnergyGrowth::stop}, limits.on_energy_growth);
  return limits;
}

}  // namespace

std::string_view name_of(IntegrationMethod method) {
  return method == IntegrationMethod::rk4 ? "rk4" : "generalized_alpha";
}

std::string_view name_of(EnergyGrowth growth) {
  return growth == EnergyGrowth::stop ? "stop" : "warn";
}

std::string_view name_of(HubSupport support) {
  return support == HubSupport::free ? "free" : "axle";
}

std::string_view name_of(ReferenceFrame frame) {
  return frame == ReferenceFrame::chord ? "chord" : "clamped";
}

std::string_view name_of(LoadFrame frame) {
  switch (frame) {
    case LoadFrame::inertial:
      return "inertial";
    case LoadFrame::section:
      return "section";
    case LoadFrame::hub:
      break;
  }
  return "hub";
}

Scenario parse_scenario(const std::string& text, const std::string& name,
                        const Overrides& overrides) {
  TomlDocument document(text, name);
  for (const std::string& assignment : overrides) document.set(assignment);
  const TomlSection root(document, {"title", "hub", "blade", "blades", "gravity", "damping", "load",
                                    "integration", "limits", "output"});
  Scenario scenario;
  scenario.name = std::filesystem::path(name).stem().string();
  scenario.title = root.text("title", scenario.name);
  scenario.rotor = read_rotor(root);
  scenario.integration = read_integration(root);
  scenario.limits = read_limits(root);
  visit_fields(scenario.output, FieldReader{root.section("output", {"interval"})});
  return scenario;
}

Scenario read_scenario(const std::string& file, const Overrides& overrides) {
  return parse_scenario(read_text(file), file, overrides);
}

}  // namespace spoke
