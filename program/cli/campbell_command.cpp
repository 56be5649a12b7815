// Prints a Campbell diagram as tables, and writes campbell.csv, campbell.json and campbell.html.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/small_motions/steady/steady_warnings.h"
#include "program/cli/commands.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/standard_streams.h"
#include "program/cli/steady_task.h"
#include "program/steady_report/campbell_files.h"
#include "program/steady_report/modes_page.h"

namespace spoke::cli {
namespace {

CampbellResult solve(CampbellOptions options, const SteadyTask& task) {
  const CountProgress progress(options.speeds.size(), "speeds");
  options.progress = [&progress](std::size_t done) { progress.show(done); };
  return task.solve([&](const Scenario& scenario) { return solve_campbell(scenario, options); });
}

/// Returns the notes of all speeds, each once.
std::vector<std::string> list_notes(const CampbellResult& result) {
  std::vector<std::string> notes;
  for (const ModesResult& state : result.states)
    for (const std::string& note : state.notes)
      if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  return notes;
}

void print(const CampbellResult& result, const SteadyTask& task) {
  print_title(task.scenario().title);
  print_table(steady_report::make_branch_table(result));
  print_table(steady_report::make_crossing_table(result));
  if (!result.gaps.empty()) print_table(steady_report::make_gap_table(result));
  for (const std::string& note : list_notes(result)) print_line("note", note);
  for (const std::string& line : steady_report::describe_losses(result)) print_line("lost", line);
  print_line("written", task.path("campbell.html") + ", campbell.csv, campbell.json");
}

/// Prints the warning of the speed at which bodies bend most.
void warn(const CampbellResult& result) {
  const EquilibriumResult* most = nullptr;
  double largest = 0.0;
  for (const ModesResult& state : result.states) {
    const double ratio = steady::find_largest_bending(state.equilibrium).ratio;
    if (state.equilibrium.warnings.empty() || ratio <= largest) continue;
    largest = ratio;
    most = &state.equilibrium;
  }
  if (most == nullptr) return;
  print_error(fmt::format("warning: at {:.6g} rad/s {}", most->speed, most->warnings[0].text));
}

}  // namespace

int find_campbell(const Arguments& arguments) {
  const SteadyTask task(arguments, "campbell", {"campbell.csv", "campbell.json", "campbell.html"});
  const CampbellOptions options{.speeds = arguments.steady.speeds,
                                .count = arguments.steady.count,
                                .most = 10,
                                .frame = arguments.steady.frame};
  const CampbellResult result = solve(options, task);
  task.write({{"campbell.csv", steady_report::make_csv(result)},
              {"campbell.json", steady_report::make_json(result)},
              {"campbell.html", steady_report::make_html(result, options.harmonics, task.scenario(),
                                                         task.title())}});
  print(result, task);
  warn(result);
  return 0;
}

}  // namespace spoke::cli
