// Prints the model, its natural frequencies and the limit of rk4.

#include <spdlog/fmt/fmt.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>

#include "engine/results.h"
#include "engine/small_motions/vibration/frequency_limits.h"
#include "models/count_text.h"
#include "models/error.h"
#include "models/reader/keys/simulation_keys.h"
#include "models/start.h"
#include "program/cli/build_simulation.h"
#include "program/cli/commands.h"
#include "program/cli/file_guard.h"
#include "program/cli/print_air.h"
#include "program/cli/print_loops.h"
#include "program/cli/print_space.h"
#include "program/cli/report.h"
#include "program/cli/standard_streams.h"
#include "program/run_report/model_page.h"

namespace spoke::cli {
namespace {

std::string describe_frequency(double frequency) {
  return fmt::format("{:.6g} rad/s ({:.6g} Hz)", frequency, frequency / (2.0 * std::numbers::pi));
}

/// Frequencies of the model and the limits that they set for rk4.
struct Limits {
  LinearProperties properties;
  double speed = 0.0;   ///< hub speed at which rk4's limit holds [rad/s]
  std::string unknown;  ///< reason why they are not known; empty if they are
};

Limits find_limits(const Simulation& simulation) try {
  if (!simulation.scenario().space) return {simulation.linear_properties(), 0.0, {}};
  const auto found = vibration::find_frequency_limits(simulation.scenario());
  return {{found.lowest, found.highest, found.rk4.step}, found.rk4.speed, {}};
} catch (const InputError& error) {
  return {{0.0, 0.0, std::numeric_limits<double>::infinity()}, 0.0, error.what()};
}

void print_limits(const Limits& limits) {
  const LinearProperties& properties = limits.properties;
  if (!limits.unknown.empty())
    return print_line("rk4", "largest step not known: " + limits.unknown);
  if (properties.highest_frequency > 0.0) {
    print_line("at rest",
               "lowest natural frequency " + describe_frequency(properties.lowest_frequency));
    print_line("", "highest natural frequency " + describe_frequency(properties.highest_frequency));
  } else {
    print_line("at rest", "nothing vibrates");
  }
  if (!std::isfinite(properties.rk4_largest_step)) return;
  const std::string where =
      limits.speed == 0.0 ? "" : fmt::format(" (at {:.6g} rad/s)", limits.speed);
  print_line("rk4",
             fmt::format("stable up to a step of {:.4g} s{}", properties.rk4_largest_step, where));
}

/// Prints memory, frequencies, and steps.
void print_properties(const Simulation& simulation, const Limits& limits) {
  print_line("memory", fmt::format("about {:.3g} MB",
                                   1e-6 * static_cast<double>(simulation.size().memory_bytes)));
  print_limits(limits);
  const Integration& integration = simulation.scenario().integration;
  constexpr std::array<std::string_view, 3> kSaid{"method", "step", "duration"};
  print_line("integration",
             fmt::format("{}, {} of {:.6g} s{}", name_of(integration.method),
                         counted(simulation.planned_steps(), "step"), simulation.step_size(),
                         keys::describe_others(keys::kIntegrationRows, &integration, kSaid)));
}

/// Prints the limits that are not the default.
void print_watched(const spoke::Limits& limits) {
  const std::string text = keys::describe_others(keys::kLimitsRows, &limits);
  if (!text.empty()) print_line("limits", text.substr(2));
}

void warn_of_rk4(const Arguments& arguments, const Simulation& simulation, double largest_step) {
  if (simulation.scenario().integration.method != IntegrationMethod::rk4) return;
  if (simulation.step_size() <= largest_step) return;
  print_error(fmt::format(
      "warning: {}: integration.step: {:.6g} s is not stable with rk4, expected at most {:.4g} s",
      one_line(arguments.scenario), simulation.step_size(), largest_step));
}

void print_start(const Scenario& scenario) {
  if (scenario.initial.state == InitialState::undeformed) return;
  print_line("starts", fmt::format("at its equilibrium at {:.6g} rad/s, all ramps over",
                                   start_speed(scenario)));
}

/// Prints the exponents that the scenario gives.
void print_statistics(const Statistics& statistics) {
  std::string text;
  for (const auto& [name, exponent] : statistics.exponents)
    text += fmt::format("{}{:.6g} of {}", text.empty() ? "exponents " : ", ", exponent, name);
  if (!text.empty()) print_line("statistics", text);
}

/// Writes the page of the model, if one is asked for.
void draw(const Arguments& arguments, const Simulation& simulation) {
  if (arguments.html.empty()) return;
  write_file(arguments.html, run_report::make_model_page(simulation));
  print_line("drawn", arguments.html);
}

}  // namespace

int check(const Arguments& arguments) {
  SimulationOptions options = arguments.options;
  options.executor = ExecutorKind::serial;
  const Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  if (!arguments.html.empty()) require_place(arguments.html, kPage);
  warn_of_oddities(arguments.scenario, scenario);
  const Simulation simulation = build_simulation(arguments.scenario, scenario, options);
  if (scenario.space) {
    print_title(scenario.title);
    print_space(*scenario.space);
    if (scenario.space->air) print_air(*scenario.space);
  } else {
    print_model(simulation);
  }
  print_loops(simulation);
  const Limits limits = find_limits(simulation);
  print_properties(simulation, limits);
  print_start(scenario);
  print_watched(scenario.limits);
  print_statistics(scenario.statistics);
  draw(arguments, simulation);
  warn_of_rk4(arguments, simulation, limits.properties.rk4_largest_step);
  return 0;
}

}  // namespace spoke::cli
