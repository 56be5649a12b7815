// Prints the performance of a rotor in wind, and writes performance.csv, .json and .html.

#include <filesystem>
#include <string>
#include <vector>

#include "program/cli/commands.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/steady_task.h"
#include "program/steady_report/performance_files.h"

namespace spoke::cli {
namespace {

/// Tables of a map, as the controller ROSCO reads them.
constexpr const char* kTables = "Cp_Ct_Cq.txt";

PerformanceResult solve(PerformanceOptions options, const SteadyTask& task) {
  const std::size_t pitches = std::max<std::size_t>(1, options.pitch.size());
  const std::size_t count = options.tip_speed_ratio.empty()
                                ? options.wind.size()
                                : options.tip_speed_ratio.size() * pitches;
  const CountProgress progress(count, "points");
  options.progress = [&progress](std::size_t done) { progress.show(done); };
  return task.solve([&](const Scenario& scenario) { return solve_performance(scenario, options); });
}

/// Returns the sign of joint angles towards feather, as the control of pitch has it; 1 without one.
int feather_sign(const Scenario& scenario) {
  const spatial::Model& model = *scenario.space;
  const double sign = model.pitch_control   ? model.pitch_control->sign
                      : model.outer_control ? model.outer_control->sign
                                            : 1.0;
  return sign < 0.0 ? -1 : 1;
}

}  // namespace

int find_performance(const Arguments& arguments) {
  const SteadyTask task(arguments, "performance",
                        {"performance.csv", "performance.json", "performance.html", kTables});
  const PerformanceArguments& asked = arguments.performance;
  const PerformanceResult result = solve({.wind = asked.wind,
                                          .tip_speed_ratio = asked.tip_speed_ratio,
                                          .pitch = asked.pitch,
                                          .joint = asked.joint,
                                          .is_rigid = asked.is_rigid,
                                          .rotor = asked.rotor},
                                         task);
  const std::string tables =
      steady_report::make_coefficient_tables(result, feather_sign(task.scenario()));
  std::vector<SteadyTask::File> files = {
      {"performance.csv", steady_report::make_csv(result)},
      {"performance.json", steady_report::make_json(result, task.scenario())},
      {"performance.html", steady_report::make_html(result, task.title())}};
  std::error_code none;
  if (tables.empty())
    std::filesystem::remove(task.path(kTables), none);  // belongs to an earlier map
  else
    files.push_back({kTables, tables});
  task.write(files);
  print_title(task.scenario().title);
  print_table(steady_report::make_performance_table(result));
  print_line("written", task.path("performance.html") + ", performance.csv, performance.json" +
                            (tables.empty() ? "" : std::string(", ") + kTables));
  return 0;
}

}  // namespace spoke::cli
