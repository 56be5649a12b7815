#include "engine/cli/measure_child_command.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <sstream>

#include "engine/cli/report.h"
#include "engine/cli/threads_option.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

constexpr std::size_t kFixedWords = 9;  // before the overrides

template <class Value>
Value value_of(std::string_view name, const std::vector<Value>& values) {
  const auto found =
      std::find_if(values.begin(), values.end(), [&](Value v) { return name_of(v) == name; });
  if (found == values.end()) throw InputError("unknown: " + std::string(name));
  return *found;
}

Simulation make_simulation(const std::vector<std::string>& words) {
  if (words.size() < kFixedWords) throw InputError("is started by the command compare only");
  Scenario scenario = read_scenario(
      words[1], {words.begin() + static_cast<std::ptrdiff_t>(kFixedWords), words.end()});
  const auto kinds = graph::executor_kinds();
  const SimulationOptions options{
      .formulation = value_of<Formulation>(
          words[2], {Formulation::structured, Formulation::subsystem, Formulation::augmented}),
      .executor = value_of<ExecutorKind>(words[3], {kinds.begin(), kinds.end()}),
      .threads = parse_threads(words[4]),
      .window = std::stoi(words[8])};
  scenario.integration.method = value_of<IntegrationMethod>(
      words[5], {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4});
  scenario.integration.step = std::stod(words[6]);
  scenario.integration.duration = std::stod(words[7]);
  return Simulation(scenario, options);
}

void answer(const std::string& line) {
  fmt::print("{}\n", one_line(line));
  std::fflush(stdout);
}

void run_batch(Simulation& simulation, std::int64_t steps) {
  using Clock = std::chrono::steady_clock;
  const std::int64_t before = simulation.steps();
  const double end = simulation.time() + static_cast<double>(steps) * simulation.step_size();
  const auto begin = Clock::now();
  simulation.run_until(end);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  if (simulation.steps() - before != steps) throw InputError("the steps ran out");
  answer(fmt::format("done {} {}", seconds, simulation.state_hash()));
}

void serve(Simulation& simulation) {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word;
    std::int64_t steps = 0;
    if (!(words >> word >> steps) || word != "run" || steps < 1)
      throw InputError("expected run STEPS, got " + line);
    run_batch(simulation, steps);
  }
}

}  // namespace

compare::Command make_child_command(const ChildTask& task,
                                    const compare::Configuration& configuration) {
  compare::Command command{
      "/proc/self/exe",
      {std::string(kMeasureChild), task.scenario, std::string(name_of(configuration.formulation)),
       std::string(name_of(configuration.executor)), graph::name_of(configuration.threads),
       std::string(name_of(task.integration.method)), fmt::format("{}", task.integration.step),
       fmt::format("{}", task.integration.duration), fmt::format("{}", task.window)},
      compare::environment_of(configuration)};
  command.arguments.insert(command.arguments.end(), task.overrides.begin(), task.overrides.end());
  return command;
}

int measure_child(const std::vector<std::string>& words) {
  try {
    Simulation simulation = make_simulation(words);
    answer("ready");
    serve(simulation);
    return 0;
  } catch (const DivergenceError& error) {
    answer(std::string("diverged ") + error.what());
    return 3;
  } catch (const std::exception& error) {
    answer(std::string("failed ") + error.what());
    return 2;
  }
}

}  // namespace spoke::cli
