// Prints modes, and writes modes.json, modes.csv and modes.html.

#include <spdlog/fmt/fmt.h>

#include "program/cli/commands.h"
#include "program/cli/report.h"
#include "program/cli/steady_task.h"
#include "program/steady_report/mode_files.h"
#include "program/steady_report/modes_page.h"

namespace spoke::cli {
namespace {

void print(const ModesResult& result, const SteadyTask& task) {
  print_title(task.scenario().title);
  print_line("speed", steady_report::describe_speeds(result.equilibrium));
  print_line("blades", result.are_blades_coupled ? "couple through the hub" : "do not couple");
  print_table(steady_report::make_mode_table(result));
  for (const std::string& note : result.notes) print_line("note", note);
  if (const std::string growth = steady_report::describe_growth(result); !growth.empty())
    print_line("unstable", growth);
  print_line("written", task.path("modes.html") + ", modes.csv, modes.json");
}

}  // namespace

int find_modes(const Arguments& arguments) {
  const SteadyTask task(arguments, "modes", {"modes.json", "modes.csv", "modes.html"});
  const ModesResult result = task.solve([&](const Scenario& scenario) {
    return solve_modes(scenario,
                       {arguments.steady.state, arguments.steady.count, arguments.steady.frame});
  });
  task.write({{"modes.json", steady_report::make_json(result)},
              {"modes.csv", steady_report::make_csv(result)},
              {"modes.html", steady_report::make_html(result, task.scenario(), task.title())}});
  print(result, task);
  SteadyTask::warn(result.equilibrium);
  return 0;
}

}  // namespace spoke::cli
