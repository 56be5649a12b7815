// Prints the model, its natural frequencies and the limit of rk4.

#include "engine/cli/check_command.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <numbers>
#include <system_error>

#include "engine/cli/build_simulation.h"
#include "engine/cli/print_space.h"
#include "engine/cli/report.h"
#include "engine/cli/results_folder.h"
#include "engine/cli/standard_streams.h"
#include "engine/results.h"
#include "engine/run_report/model_page.h"
#include "models/count_text.h"
#include "models/error.h"
#include "models/start.h"

namespace spoke::cli {
namespace {

std::string describe_frequency(double frequency) {
  return fmt::format("{:.6g} rad/s ({:.6g} Hz)", frequency, frequency / (2.0 * std::numbers::pi));
}

/// Memory, frequencies at rest, and steps.
void print_properties(const Simulation& simulation, const LinearProperties& properties) {
  print_line("memory", fmt::format("about {:.3g} MB",
                                   1e-6 * static_cast<double>(simulation.size().memory_bytes)));
  if (properties.highest_frequency > 0.0) {
    print_line("at rest",
               "lowest natural frequency " + describe_frequency(properties.lowest_frequency));
    print_line("", "highest natural frequency " + describe_frequency(properties.highest_frequency));
    print_line("rk4", fmt::format("stable up to a step of {:.4g} s", properties.rk4_largest_step));
  } else {
    print_line("at rest", "nothing vibrates");
  }
  print_line("integration",
             fmt::format("{}, {} of {:.6g} s", name_of(simulation.scenario().integration.method),
                         counted(simulation.planned_steps(), "step"), simulation.step_size()));
}

void print_start(const Scenario& scenario) {
  if (scenario.initial.state == InitialState::undeformed) return;
  print_line("starts", fmt::format("at its equilibrium at {:.6g} rad/s, all ramps over",
                                   start_speed(scenario)));
}

/// Refuses to draw in the place of a folder, or of the scenario.
void require_place(const Arguments& arguments) {
  if (arguments.html.empty()) return;
  require_no_folder(arguments.html);
  std::error_code none;
  if (std::filesystem::equivalent(arguments.html, arguments.scenario, none))
    throw InputError("spoke check: --html: " + arguments.html + " is the scenario itself");
}

/// The model as a page, if that is asked for.
void draw(const Arguments& arguments, const Scenario& scenario) {
  if (arguments.html.empty()) return;
  write_file(arguments.html, run_report::make_model_page(scenario));
  print_line("drawn", arguments.html);
}

}  // namespace

int check(const Arguments& arguments) {
  SimulationOptions options = arguments.options;
  options.executor = ExecutorKind::serial;
  const Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  require_place(arguments);
  warn_of_degrees(arguments.scenario, scenario);
  if (scenario.space) {
    print_title(scenario.title);
    print_space(*scenario.space);
  }
  const Simulation simulation = build_simulation(arguments.scenario, scenario, options);
  if (!scenario.space) print_model(simulation);
  const LinearProperties properties = simulation.linear_properties();
  print_properties(simulation, properties);
  print_start(scenario);
  draw(arguments, scenario);
  if (simulation.scenario().integration.method == IntegrationMethod::rk4 &&
      simulation.step_size() > properties.rk4_largest_step) {
    print_error(fmt::format(
        "warning: {}: integration.step: {:.6g} s is not stable with rk4, expected at most {:.4g} s",
        one_line(arguments.scenario), simulation.step_size(), properties.rk4_largest_step));
  }
  return 0;
}

}  // namespace spoke::cli
