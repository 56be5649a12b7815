// Prints an equilibrium, and writes static.json, section_forces.csv and static.html.

#include "program/cli/commands.h"
#include "program/cli/report.h"
#include "program/cli/steady_task.h"
#include "program/steady_report/static_air.h"
#include "program/steady_report/static_files.h"

namespace spoke::cli {
namespace {

void print(const EquilibriumResult& result, const SteadyTask& task) {
  print_title(task.scenario().title);
  for (const auto& [label, text] : steady_report::make_facts(result)) print_line(label, text);
  if (!result.rotors.empty()) print_table(steady_report::make_rotor_table(result));
  print_table(steady_report::make_tip_table(result));
  const report::Table joints = steady_report::make_joint_table(result);
  if (!joints.rows.empty()) print_table(joints);
  const report::Table loops = steady_report::make_loop_table(result);
  if (!loops.rows.empty()) print_table(loops);
  print_line("written", task.path("static.html") + ", static.json, section_forces.csv" +
                            (steady_report::has_air(result) ? ", section_air.csv" : ""));
}

}  // namespace

int find_static(const Arguments& arguments) {
  const SteadyTask task(arguments, "static",
                        {"static.json", "section_forces.csv", "static.html", "section_air.csv"});
  const EquilibriumResult result = task.solve([&](const Scenario& scenario) {
    return solve_equilibrium(scenario, arguments.steady.state);
  });
  std::vector<SteadyTask::File> files = {
      {"static.json", steady_report::make_json(result)},
      {"section_forces.csv", steady_report::make_section_csv(result)},
      {"static.html", steady_report::make_html(result, task.scenario(), task.title())}};
  if (steady_report::has_air(result))
    files.push_back({"section_air.csv", steady_report::make_air_csv(result)});
  task.write(files);
  print(result, task);
  SteadyTask::warn(result);
  return 0;
}

}  // namespace spoke::cli
