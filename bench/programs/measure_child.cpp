// The child process: it reads its task, runs batches of steps and answers with their times.

#include "bench/programs/measure_child.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>

#include "bench/reproduce/inverse_part.h"
#include "models/error.h"
#include "models/paper_rotor.h"
#include "program/cli/program.h"
#include "program/cli/report.h"
#include "program/cli/standard_streams.h"
#include "program/cli/threads_option.h"

namespace spoke::cli {
namespace {

constexpr std::string_view kMeasureChild = "measure-child";
constexpr std::size_t kFixedWords = 9;  // words before the overrides

using Clock = std::chrono::steady_clock;
using reproduce::Work;

template <class Value>
Value value_of(std::string_view name, const std::vector<Value>& values) {
  const auto found =
      std::find_if(values.begin(), values.end(), [&](Value v) { return name_of(v) == name; });
  if (found == values.end()) throw InputError("unknown: " + std::string(name));
  return *found;
}

// A scenario may come from a pipe, or change meanwhile: it is read once, and handed to all children
// on their standard input, behind a line with its length.
std::string make_input(const ChildTask& task) {
  return task.scenario.empty() ? "" : fmt::format("{}\n{}", task.text.size(), task.text);
}

std::string read_input() {
  std::size_t length = 0;
  if (!(std::cin >> length) || std::cin.get() != '\n')
    throw InputError("expected the length of a scenario");
  std::string text(length, '\0');
  if (!std::cin.read(text.data(), static_cast<std::streamsize>(length)))
    throw InputError("the scenario ends early");
  return text;
}

Scenario make_scenario(const std::vector<std::string>& words) {
  const Overrides overrides(words.begin() + static_cast<std::ptrdiff_t>(kFixedWords), words.end());
  Scenario scenario =
      words[1].empty() ? paper_rotor(overrides) : parse_scenario(read_input(), words[1], overrides);
  scenario.integration.method = value_of<IntegrationMethod>(
      words[5], {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4});
  scenario.integration.step = std::stod(words[6]);
  scenario.integration.duration = std::stod(words[7]);
  return scenario;
}

SimulationOptions make_options(const std::vector<std::string>& words) {
  const auto kinds = graph::executor_kinds();
  return {.formulation = formulation_of(words[2]),
          .executor = value_of<ExecutorKind>(words[3], {kinds.begin(), kinds.end()}),
          .threads = parse_threads(words[4])};
}

void answer(const std::string& line) {
  cli::print(one_line(line) + '\n');
  flush_output();
}

struct Timed {
  double seconds = 0.0;
  std::uint64_t hash = 0;
};
/// Runs that many steps.
using Batch = std::function<Timed(std::int64_t steps)>;

template <class Run>
double time_of(Run run) {
  const auto begin = Clock::now();
  run();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Timed run_steps(Simulation& simulation, std::int64_t steps) {
  const std::int64_t before = simulation.steps();
  const double end = simulation.time() + static_cast<double>(steps) * simulation.step_size();
  const double seconds = time_of([&] { simulation.run_until(end); });
  if (simulation.steps() - before != steps) throw InputError("the steps ran out");
  return {seconds, simulation.state_hash()};
}

Batch make_batch(const std::vector<std::string>& words) {
  if (words.size() < kFixedWords)
    throw InputError("is started by the commands compare and reproduce only");
  const Scenario scenario = make_scenario(words);
  const SimulationOptions options = make_options(words);
  switch (value_of<Work>(words[8], {Work::steps, Work::inverse, Work::run})) {
    case Work::inverse:
      return
          [part = std::make_shared<reproduce::InversePart>(scenario, options)](std::int64_t steps) {
            return Timed{time_of([&] { part->run(steps); }), 0};
          };
    case Work::run:
      return [=](std::int64_t steps) {
        Simulation simulation(scenario, options);
        return run_steps(simulation, steps);
      };
    case Work::steps:
      break;
  }
  return [simulation = std::make_shared<Simulation>(scenario, options)](std::int64_t steps) {
    return run_steps(*simulation, steps);
  };
}

void serve(const Batch& batch) {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word;
    std::int64_t steps = 0;
    if (!(words >> word >> steps) || word != "run" || steps < 1)
      throw InputError("expected run STEPS, got " + line);
    const Timed timed = batch(steps);
    answer(fmt::format("done {} {}", timed.seconds, timed.hash));
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
       fmt::format("{}", task.integration.duration), std::string(name_of(task.work))},
      compare::environment_of(configuration),
      make_input(task)};
  command.arguments.insert(command.arguments.end(), task.overrides.begin(), task.overrides.end());
  return command;
}

bool is_child(int argc, char** argv) { return argc > 1 && argv[1] == kMeasureChild; }

int measure_child(int argc, char** argv) {
  prepare_process();
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const Batch batch = make_batch(words);
    answer("ready");
    serve(batch);
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
