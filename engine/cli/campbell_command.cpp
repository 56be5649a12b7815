// Prints a Campbell diagram as tables, and writes campbell.csv, campbell.json and campbell.html.

#include "engine/cli/campbell_command.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>

#include "engine/cli/progress_line.h"
#include "engine/cli/report.h"
#include "engine/cli/results_folder.h"
#include "engine/output_file.h"
#include "engine/steady_report/campbell_files.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

CampbellResult solve(const Arguments& arguments, const CampbellOptions& options,
                     const Scenario& scenario) {
  try {
    return solve_campbell(scenario, options);
  } catch (const InputError& error) {
    show_progress("");
    throw InputError(arguments.scenario + ": " + error.what());
  }
}

void write(const CampbellResult& result, const CampbellOptions& options, const std::string& title,
           const fs::path& folder) {
  replace_file((folder / "campbell.csv").string(), steady_report::make_csv(result));
  replace_file((folder / "campbell.json").string(), steady_report::make_json(result));
  replace_file((folder / "campbell.html").string(),
               steady_report::make_html(result, options.harmonics, title));
}

}  // namespace

int find_campbell(const Arguments& arguments) {
  const Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  const fs::path folder = arguments.out.empty() ? fs::path("results") / scenario.name / "campbell"
                                                : fs::path(arguments.out);
  require_folder(folder);
  CampbellOptions options{.speeds = arguments.steady.speeds, .count = arguments.steady.count};
  options.progress = [&options](std::size_t done) {
    show_progress(fmt::format("{} of {} speeds", done, options.speeds.size()));
  };
  const CampbellResult result = solve(arguments, options, scenario);
  show_progress("");
  const ResultsFolder taken(folder);
  write(result, options, scenario.title.empty() ? scenario.name : scenario.title, folder);
  print_title(scenario.title);
  print_table(steady_report::make_branch_table(result));
  print_table(steady_report::make_crossing_table(result));
  print_line("written", (folder / "campbell.html").string() + ", campbell.csv, campbell.json");
  return 0;
}

}  // namespace spoke::cli
