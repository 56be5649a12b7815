// Prints modes, and writes modes.json and modes.csv.

#include "engine/cli/modes_command.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>

#include "engine/cli/report.h"
#include "engine/cli/results_folder.h"
#include "engine/output_file.h"
#include "engine/steady_report/mode_files.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

ModesResult solve(const Arguments& arguments, const Scenario& scenario) {
  try {
    return solve_modes(scenario, {{arguments.steady.speed}, arguments.steady.count});
  } catch (const InputError& error) {
    throw InputError(arguments.scenario + ": " + error.what());
  }
}

void print(const ModesResult& result, const Scenario& scenario, const fs::path& folder) {
  print_title(scenario.title);
  print_line("speed", fmt::format("{:.6g} rad/s", result.equilibrium.speed));
  print_line("blades", result.are_blades_coupled ? "couple through the hub" : "do not couple");
  print_table(steady_report::make_mode_table(result));
  if (const std::string growth = steady_report::describe_growth(result); !growth.empty())
    print_line("unstable", growth);
  print_line("written", (folder / "modes.csv").string() + ", modes.json");
}

}  // namespace

int find_modes(const Arguments& arguments) {
  const Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  const fs::path folder = arguments.out.empty() ? fs::path("results") / scenario.name / "modes"
                                                : fs::path(arguments.out);
  require_folder(folder);
  const ModesResult result = solve(arguments, scenario);
  const ResultsFolder taken(folder);
  replace_file((folder / "modes.json").string(), steady_report::make_json(result));
  replace_file((folder / "modes.csv").string(), steady_report::make_csv(result));
  print(result, scenario, folder);
  return 0;
}

}  // namespace spoke::cli
