// Prints an equilibrium, and writes static.json, section_forces.csv and static.html.

#include "engine/cli/static_command.h"

#include <filesystem>

#include "engine/cli/report.h"
#include "engine/cli/results_folder.h"
#include "engine/output_file.h"
#include "engine/steady_report/static_files.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

EquilibriumResult solve(const Arguments& arguments, const Scenario& scenario) {
  try {
    return solve_equilibrium(scenario, {arguments.steady.speed});
  } catch (const InputError& error) {
    throw InputError(arguments.scenario + ": " + error.what());
  }
}

void print(const EquilibriumResult& result, const Scenario& scenario, const fs::path& folder) {
  print_title(scenario.title);
  for (const auto& [label, text] : steady_report::make_facts(result)) print_line(label, text);
  print_table(steady_report::make_tip_table(result));
  const report::Table joints = steady_report::make_joint_table(result);
  if (!joints.rows.empty()) print_table(joints);
  print_line("written", (folder / "static.html").string() + ", static.json, section_forces.csv");
}

}  // namespace

int find_static(const Arguments& arguments) {
  const Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  const fs::path folder = arguments.out.empty() ? fs::path("results") / scenario.name / "static"
                                                : fs::path(arguments.out);
  require_folder(folder);
  const EquilibriumResult result = solve(arguments, scenario);
  const ResultsFolder taken(folder);
  const std::string title = scenario.title.empty() ? scenario.name : scenario.title;
  replace_file((folder / "static.json").string(), steady_report::make_json(result));
  replace_file((folder / "section_forces.csv").string(), steady_report::make_section_csv(result));
  replace_file((folder / "static.html").string(), steady_report::make_html(result, title));
  print(result, scenario, folder);
  return 0;
}

}  // namespace spoke::cli
