#include "models/scenario.h"

#include "models/scenario_rotor.h"
#include "models/toml_document.h"
#include "models/toml_section.h"

namespace spoke {
namespace {

constexpr double kMostSteps = 1e10;
constexpr int kMostIterations = 1000;

Integration read_integration(const TomlSection& root) {
  const TomlSection section =
      root.section("integration", {"method", "step", "duration", "spectral_radius", "tolerance",
                                   "iterations", "max_iterations"});
  Integration integration;
  integration.method = section.choice(
      "method", {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}, integration.method);
  integration.duration = section.number("duration", Quantity::positive("s"));
  integration.step = section.number("step", Quantity::positive("s"), integration.step);
  integration.spectral_radius =
      section.number("spectral_radius", Quantity::between(0.0, 1.0), integration.spectral_radius);
  integration.tolerance =
      section.number("tolerance", Quantity::positive("m, rad"), integration.tolerance);
  integration.iterations =
      section.integer("iterations", 0, kMostIterations, integration.iterations);
  integration.max_iterations =
      section.integer("max_iterations", 1, kMostIterations, integration.max_iterations);
  if (integration.step > integration.duration) {
    section.fail(section.has("step") ? "step" : "duration",
                 "the step is " + describe(integration.step) +
                     " s, expected at most the duration, " + describe(integration.duration) + " s");
  }
  const double steps = integration.duration / integration.step;
  if (steps > kMostSteps) {
    section.fail(section.has("step") ? "step" : "duration",
                 "makes " + describe(steps) + " steps, expected at most " + describe(kMostSteps));
  }
  return integration;
}

Limits read_limits(const TomlSection& root) {
  const TomlSection section =
      root.section("limits", {"deflection", "energy_growth", "on_energy_growth"});
  Limits limits;
  limits.deflection = section.number("deflection", Quantity::not_negative(""), limits.deflection);
  limits.energy_growth =
      section.number("energy_growth", Quantity::not_negative(""), limits.energy_growth);
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
  scenario.output.interval =
      root.section("output", {"interval"})
          .number("interval", Quantity::not_negative("s"), scenario.output.interval);
  return scenario;
}

Scenario read_scenario(const std::filesystem::path& file, const Overrides& overrides) {
  return parse_scenario(read_text(file), file.string(), overrides);
}

}  // namespace spoke
