// Writes the matrices A.mtx, B.mtx, C.mtx and D.mtx, and linear.json.

#include <spdlog/fmt/fmt.h>

#include "program/cli/commands.h"
#include "program/cli/report.h"
#include "program/cli/steady_task.h"
#include "program/steady_report/linear_files.h"
#include "program/steady_report/mode_files.h"

namespace spoke::cli {
namespace {

void print(const LinearSystem& system, const SteadyTask& task) {
  print_title(task.scenario().title);
  print_line("speed", steady_report::describe_speeds(system.equilibrium));
  print_line("frame", system.frame == ModeFrame::fixed ? "fixed: multi-blade coordinates"
                                                       : "turning with the hub");
  print_line("states", std::to_string(system.states.size()));
  print_line("inputs", std::to_string(system.inputs.size()));
  print_line("outputs", std::to_string(system.outputs.size()));
  for (const std::string& name : system.left_out)
    print_line("left out", name + ": it is no constant function of the state");
  for (const std::string& name : system.left_out_inputs)
    print_line("left out", name + ": it turns with the hub, and is not alike on all blades");
  print_line("written", task.path("linear.json") + ", A.mtx, B.mtx, C.mtx, D.mtx");
}

}  // namespace

int linearize(const Arguments& arguments) {
  const SteadyTask task(arguments, "linear", {"A.mtx", "B.mtx", "C.mtx", "D.mtx", "linear.json"});
  const LinearSystem system = task.solve([&](const Scenario& scenario) {
    return solve_linear_system(scenario, arguments.steady.state, arguments.steady.frame);
  });
  task.write({{"A.mtx", steady_report::make_matrix_market(system.A)},
              {"B.mtx", steady_report::make_matrix_market(system.B)},
              {"C.mtx", steady_report::make_matrix_market(system.C)},
              {"D.mtx", steady_report::make_matrix_market(system.D)},
              {"linear.json", steady_report::make_json(system)}});
  print(system, task);
  SteadyTask::warn(system.equilibrium);
  return 0;
}

}  // namespace spoke::cli
