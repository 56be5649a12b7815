// What does a step of every shipped model take, and what does auto gain there? Steps through
// Simulation::run_until, without an observer, in the formulation "structured" and with the
// integrator, step and duration of the scenario: serial, and by auto on two threads, which may
// choose a window, or to stay serial. Both take turns, each model by itself.
//
// The steps are those behind the first tenth of the scenario, or fewer where steps are slow; a
// simulation goes back there before each of its turns. Both must end in the same state, bit by bit.
// Evaluations of the accelerations say how many passes a step needs; "real time" is the simulated
// time by the time that it takes.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/compare/interleaved.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/repeated_steps.h"
#include "engine/simulation.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kBatchSeconds = 10e-3;  // s, of the steps of a turn
constexpr double kMostBefore = 0.5;      // s, of the steps before them
constexpr double kLeastSpeed = 0.97;

/// Returns the scenarios of models/ by name; for a smoke run, three.
std::vector<fs::path> find_models(bool quick) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(SPOKE_MODELS_DIR))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (!quick) return files;
  std::erase_if(files, [](const fs::path& file) {
    return file.stem() != "four_bar" && file.stem() != "heavy_top" &&
           file.stem() != "wu_haug_rotor";
  });
  return files;
}

/// The steps of a model that are timed.
struct Stretch {
  std::int64_t before = 0;  ///< number of steps before them
  int steps = 1;
};

Stretch choose_stretch(const Scenario& scenario) {
  constexpr std::int64_t kFirst = 4;
  Simulation simulation(scenario, {.executor = ExecutorKind::serial, .threads = 1});
  const std::int64_t planned = simulation.planned_steps();
  const auto run_to = [&](std::int64_t step) {
    const auto begin = std::chrono::steady_clock::now();
    simulation.run_until(static_cast<double>(step) * simulation.step_size());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  run_to(std::min(kFirst, planned));  // brings what they need into caches
  const std::int64_t timed = std::min(2 * kFirst, planned) - simulation.steps();
  const double step =
      timed > 0 ? run_to(simulation.steps() + timed) / static_cast<double>(timed) : kBatchSeconds;
  const std::int64_t before =
      std::min(planned / 10, static_cast<std::int64_t>(std::ceil(kMostBefore / step)));
  const double most = static_cast<double>(std::max<std::int64_t>(1, planned - before));
  return {before, static_cast<int>(std::clamp(kBatchSeconds / step, 1.0, std::min(most, 1000.0)))};
}

using StepsPointer = std::shared_ptr<RepeatedSteps>;

/// The same steps of a model, serial and by auto.
struct Ways {
  StepsPointer serial, by_auto;
};

Ways make_ways(const std::string& name, const Scenario& scenario) {
  show_progress(name + ": building");
  const Stretch stretch = choose_stretch(scenario);
  const double begin = static_cast<double>(stretch.before) * scenario.integration.step;
  const auto make = [&](ExecutorKind kind, int threads) {
    return std::make_shared<RepeatedSteps>(
        scenario, SimulationOptions{.executor = kind, .threads = threads}, begin, stretch.steps);
  };
  Ways ways{make(ExecutorKind::serial, 1), make(ExecutorKind::automatic, 2)};
  if (ways.serial->hash() != ways.by_auto->hash())
    throw std::runtime_error(name + ": auto ends in another state than serial steps");
  return ways;
}

/// Returns the speedup over the reference: median and quartiles.
std::string speedup_text(Timing timing) {
  const double low = 1.0 / timing.ratio_high, high = 1.0 / timing.ratio_low;
  timing.ratio = 1.0 / timing.ratio;
  timing.ratio_low = low;
  timing.ratio_high = high;
  return ratio_with_spread(timing);
}

}  // namespace

void measure_models(const QuestionOptions& options, Report& report) {
  const Effort effort = options.quick ? Effort{3, 0.0, 1.0} : Effort{25, 0.0, 3.0};
  Table table{
      "Steps of the shipped models, serial, and what auto gains on 2 threads; in turns",
      {"model", "evaluations", "a step", "an evaluation", "real time, times", "auto", "rounds"},
      {}};
  double least = std::numeric_limits<double>::infinity();
  for (const fs::path& file : find_models(options.quick)) {
    const std::string name = file.stem();
    const Scenario scenario = read_scenario(file);
    const Ways ways = make_ways(name, scenario);
    const std::vector<Timing> timings =
        measure({RepeatedSteps::alternative("serial", ways.serial, 0),
                 RepeatedSteps::alternative("auto", ways.by_auto, 0)},
                effort);
    const double evaluations = ways.serial->evaluations_per_step();
    const double step = timings.front().least;
    table.rows.push_back({name, figure(evaluations), graph::duration_text(step),
                          graph::duration_text(step / evaluations),
                          figure(scenario.integration.step / step), speedup_text(timings.back()),
                          std::to_string(timings.back().rounds)});
    for (const Timing& timing : timings) report.add_timing(name, timing);
    report.add_result({{"model", name},
                       {"evaluations_per_step", evaluations},
                       {"auto_chose", ways.by_auto->executor()}});
    least = std::min(least, 1.0 / timings.back().ratio);
  }
  report.add_table(table);
  report.add_target(at_least("auto / serial, the slowest of the models", least, kLeastSpeed));
}

}  // namespace spoke::bench
