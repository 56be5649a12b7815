// Prints a critical speed or load, and writes critical.csv, critical.json and critical.html.

#include "program/cli/commands.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/steady_task.h"
#include "program/steady_report/critical_files.h"
#include "program/steady_report/modes_page.h"

namespace spoke::cli {
namespace {

CriticalResult solve(CriticalOptions options, const SteadyTask& task) {
  const CountProgress progress(static_cast<std::size_t>(options.points), "values");
  options.progress = [&progress](std::size_t done) { progress.show(done); };
  return task.solve([&](const Scenario& scenario) { return solve_critical(scenario, options); });
}

void print(const CriticalResult& result, const CriticalOptions& options, const SteadyTask& task) {
  print_title(task.scenario().title);
  print_line("critical", steady_report::describe_critical(result, options));
  print_table(steady_report::make_branch_table(result, options));
  print_line("written", task.path("critical.html") + ", critical.csv, critical.json");
}

}  // namespace

int find_critical(const Arguments& arguments) {
  const SteadyTask task(arguments, "critical", {"critical.csv", "critical.json", "critical.html"});
  const SteadyArguments& asked = arguments.steady;
  const CriticalOptions options{.of = asked.of,
                                .from = asked.from,
                                .to = asked.to,
                                .state = asked.state,
                                .points = asked.points,
                                .count = asked.count,
                                .frame = asked.frame};
  const CriticalResult result = solve(options, task);
  task.write({{"critical.csv", steady_report::make_csv(result, options)},
              {"critical.json", steady_report::make_json(result, options)},
              {"critical.html",
               steady_report::make_html(result, options, task.scenario(), task.title())}});
  print(result, options, task);
  if (result.critical) SteadyTask::warn(result.states[result.critical->state].equilibrium);
  return 0;
}

}  // namespace spoke::cli
