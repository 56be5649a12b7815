// What do two threads gain on rotors, by executor? Whole time steps of real models through
// Simulation::run_until, without an observer, as a user's run makes them: generalized_alpha, its
// iterations, and windows of steps where the executor uses them. Here costs of nodes, memory and
// the choices that "auto" makes from its own timings meet.
//
// Each executor has one simulation of the model. The planned duration is beyond reach, so that
// "auto" finds planning worth while and steps never run out. All are brought to the same step
// before they take turns, each turn about 20 ms of steps: the spin-up is then over in the small
// models, and the number of iterations is about the same in all. Each turn comes after a pause and
// some steps more, which wake threads and bring the model's data. The OpenMP kinds go in a second
// pass with serial again as their reference: OpenMP's threads go on spinning after a turn, some for
// longer than the pause, and would take the processor from the next alternative. Finally all make
// the same number of steps and must have the same state, bit by bit.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bench/compare/interleaved.h"
#include "bench/openmp_kinds.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/simulation.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

constexpr int kThreads = 2;
constexpr double kBatchSeconds = 20e-3;
constexpr double kMostWarmUp = 2.0;       // s, for "auto" to settle
constexpr double kPlannedDuration = 1e6;  // s

/// A scenario and the settings of its solution.
struct Model {
  std::string name;
  Scenario scenario;
  Formulation formulation = Formulation::structured;
  double promised_speedup = 0.0;  ///< speedup promised by auto; 0: only that it is no slower
};

Model rotor_model(const RotorSize& size, Formulation formulation = Formulation::structured,
                  double promised_speedup = 0.0) {
  return {size.name() + " " + std::string(name_of(formulation)), paper_rotor(size), formulation,
          promised_speedup};
}

/// Five blades, of 24 to 64 elements.
Model unequal_model() {
  constexpr std::array kBodies{4, 6, 8, 12, 16};
  constexpr std::array kElements{8, 4, 8, 4, 4};
  Model model = rotor_model({static_cast<int>(kBodies.size()), 4, 4});
  model.name = "5 unequal blades structured";
  for (std::size_t i = 0; i < kBodies.size(); ++i) {
    model.scenario.rotor.blades[i].bodies = kBodies[i];
    model.scenario.rotor.blades[i].elements = kElements[i];
  }
  return model;
}

/// The hub's rotation is an unknown that couples the blades; it reaches some 2 rad/s.
Model torque_model() {
  Model model = rotor_model({3, 4, 4});
  model.name = "(3,4,4) structured, torque";
  model.scenario.rotor.hub.drive =
      TorqueDrive{Curve({0.0, 2.0, 10.0, 12.0}, {0.0, 20.0, 20.0, 0.0}), 0.0};
  return model;
}

Model shipped_model(const std::string& name) {
  return {name, read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / (name + ".toml"))};
}

std::vector<Model> make_models(bool quick) {
  constexpr auto structured = Formulation::structured, subsystem = Formulation::subsystem;
  std::vector<Model> models{rotor_model({3, 4, 4}, structured, 1.7),
                            rotor_model({3, 4, 4}, subsystem, 1.8)};
  if (quick) return models;
  models.push_back(rotor_model({2, 4, 4}, structured, 1.8));
  models.push_back(rotor_model({3, 16, 4}));
  models.push_back(rotor_model({3, 16, 4}, subsystem));
  // Nodes of 24 and 96 blades take 0.1 to 0.2 us structured, over 1 us with dense blocks.
  models.push_back(rotor_model({24, 8, 8}, structured, 1.55));
  models.push_back(rotor_model({24, 8, 8}, subsystem, 1.85));
  models.push_back(rotor_model({96, 8, 8}, structured, 1.7));
  models.push_back(rotor_model({96, 8, 8}, subsystem, 1.93));
  models.push_back(unequal_model());
  models.push_back(torque_model());
  models.push_back(shipped_model("free_hub_satellite"));
  models.push_back(shipped_model("simo_vu_quoc_beam"));  // one subsystem: nothing to gain
  return models;
}

Effort effort_of(const QuestionOptions& options) {
  return options.quick ? Effort{5, 0.0, 1.0} : Effort{25, 0.0, 2.0};
}

double seconds_of(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// One simulation, run by one executor.
class Runner {
 public:
  Runner(const Model& model, ExecutorKind kind, graph::Threads threads)
      : name_(name_of(kind)), simulation_(endless(model), options_for(model, kind, threads)) {
    if (threads.inner > 1 || kind == ExecutorKind::openmp_scheme1 ||
        kind == ExecutorKind::openmp_scheme2)
      name_ += fmt::format(" {}x{}", threads.outer, threads.inner);
  }

  const std::string& name() const { return name_; }
  const Simulation& simulation() const { return simulation_; }

  void advance(std::int64_t steps) {
    simulation_.run_until(simulation_.time() +
                          static_cast<double>(steps) * simulation_.step_size());
  }
  /// Advances in batches, so that calls of the executor are like the timed ones.
  void advance_to(std::int64_t step, std::int64_t batch) {
    show_progress(name_ + ": to step " + std::to_string(step));
    while (simulation_.steps() < step) advance(std::min(batch, step - simulation_.steps()));
  }
  /// "auto" times and tries plans during its first steps.
  bool settled() const {
    const std::string text = simulation_.executor_description();
    return text.find("still tuning") == std::string::npos &&
           text.find("not timed yet") == std::string::npos;
  }
  /// Goes on until the executor has settled, and no longer than kMostWarmUp.
  void settle(std::int64_t batch) {
    show_progress(name_ + ": settling");
    double seconds = 0.0;
    do {
      seconds += seconds_of([&] { advance(batch); });
    } while (seconds < kMostWarmUp && !settled());
    advance(batch);
  }

 private:
  static Scenario endless(const Model& model) {
    Scenario scenario = model.scenario;
    scenario.integration.method = IntegrationMethod::generalized_alpha;
    scenario.integration.duration = kPlannedDuration;
    return scenario;
  }
  static SimulationOptions options_for(const Model& model, ExecutorKind kind,
                                       graph::Threads threads) {
    return {model.formulation, kind, threads, kind == ExecutorKind::flow_graph ? 1 : 0};
  }

  std::string name_;
  Simulation simulation_;
};

using RunnerPointer = std::shared_ptr<Runner>;

RunnerPointer make_runner(const Model& model, ExecutorKind kind, graph::Threads threads) {
  show_progress(model.name + ": building " + std::string(name_of(kind)));
  return std::make_shared<Runner>(model, kind, threads);
}

/// Returns how many steps take kBatchSeconds, by their present cost.
std::int64_t steps_per_batch(Runner& runner) {
  std::int64_t steps = 1;
  double seconds = seconds_of([&] { runner.advance(steps); });
  while (seconds < 0.5 * kBatchSeconds) {
    steps *= 2;
    seconds = seconds_of([&] { runner.advance(steps); });
  }
  const double exact = kBatchSeconds / seconds * static_cast<double>(steps);
  return std::max<std::int64_t>(2, std::llround(exact));
}

Alternative make_alternative(const RunnerPointer& runner, std::int64_t batch) {
  return {runner->name(),
          [runner, batch] { runner->advance(batch); },
          {},
          1.0 / static_cast<double>(batch),
          0};
}

/// Makes an alternative with a pause before its turn, and some steps that wake its threads.
Alternative after_pause(const RunnerPointer& runner, std::int64_t batch) {
  Alternative alternative = make_alternative(runner, batch);
  alternative.prepare = [runner, steps = (batch + 2) / 3] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    runner->advance(steps);
  };
  return alternative;
}

void require_same_state(const Model& model, const std::vector<RunnerPointer>& runners,
                        std::int64_t batch) {
  std::int64_t last = 0;
  for (const RunnerPointer& runner : runners) last = std::max(last, runner->simulation().steps());
  for (const RunnerPointer& runner : runners) runner->advance_to(last, batch);
  const Simulation& reference = runners.front()->simulation();
  for (const RunnerPointer& runner : runners) {
    const Simulation& simulation = runner->simulation();
    if (simulation.steps() != reference.steps() ||
        simulation.state_hash() != reference.state_hash())
      throw std::runtime_error(fmt::format("{}: {} and {} differ in their state after {} steps",
                                           model.name, runner->name(), runners.front()->name(),
                                           last));
  }
}

/// The timings of one model: serial first, then auto, flow_graph and the kinds of OpenMP.
struct Measured {
  std::vector<Timing> timings;
  std::string chosen;  ///< plan chosen by auto
  std::int64_t steps = 0;

  /// Returns the speedup over serial; 0 without that kind.
  double speedup(ExecutorKind kind) const {
    for (const Timing& timing : timings)
      if (timing.name.starts_with(name_of(kind))) return 1.0 / timing.ratio;
    return 0.0;
  }
  double best() const {
    double most = 0.0;
    for (const Timing& timing : timings) most = std::max(most, 1.0 / timing.ratio);
    return most;
  }
};

Measured measure_model(const Model& model, const QuestionOptions& options) {
  const RunnerPointer serial = make_runner(model, ExecutorKind::serial, 1);
  const RunnerPointer automatic = make_runner(model, ExecutorKind::automatic, kThreads);
  const RunnerPointer flow_graph = make_runner(model, ExecutorKind::flow_graph, kThreads);
  std::vector<RunnerPointer> runners{serial, automatic, flow_graph};

  std::int64_t batch = steps_per_batch(*serial);
  automatic->settle(batch);
  const std::int64_t begin =
      std::max(automatic->simulation().steps(), serial->simulation().steps());
  for (const RunnerPointer& runner : runners) runner->advance_to(begin, batch);
  batch = steps_per_batch(*serial);

  std::vector<Alternative> alternatives;
  for (const RunnerPointer& runner : runners) {
    runner->advance_to(serial->simulation().steps(), batch);
    alternatives.push_back(after_pause(runner, batch));
  }
  Measured measured{measure(alternatives, effort_of(options)), {}, 0};
  measured.chosen = automatic->simulation().executor_description();

  alternatives = {after_pause(serial, batch)};
  for (const ExecutorKind kind : openmp_kinds()) {
    runners.push_back(make_runner(model, kind, {kThreads, 1}));
    runners.back()->advance_to(serial->simulation().steps(), batch);
    alternatives.push_back(after_pause(runners.back(), batch));
  }
  if (alternatives.size() > 1) {
    const std::vector<Timing> paused = measure(alternatives, effort_of(options));
    measured.timings.insert(measured.timings.end(), paused.begin() + 1, paused.end());
  }
  require_same_state(model, runners, batch);
  measured.steps = serial->simulation().steps();
  return measured;
}

/// Returns the speedup over the reference: median and quartiles.
std::string speedup_with_spread(Timing timing) {
  timing.ratio = 1.0 / timing.ratio;
  timing.ratio_low = 1.0 / timing.ratio_low;
  timing.ratio_high = 1.0 / timing.ratio_high;
  std::swap(timing.ratio_low, timing.ratio_high);
  return ratio_with_spread(timing);
}

/// Adds the targets promised for single models.
void add_targets(const Model& model, const Measured& measured, Report& report) {
  const double speedup = measured.speedup(ExecutorKind::automatic);
  report.add_target(at_least("auto is never slower than serial, " + model.name, speedup, 0.97));
  if (model.promised_speedup > 0.0)
    report.add_target(at_least("auto / serial, " + model.name, speedup, model.promised_speedup));
  if (model.name != "(3,4,4) subsystem") return;
  // The work of three blades shared by two threads bounds a window, not the path through a step.
  report.add_target(at_most("auto: time / (serial / 2), " + model.name, kThreads / speedup, 1.1));
  const double levels = measured.speedup(ExecutorKind::openmp_levels);
  const double outer = measured.speedup(ExecutorKind::openmp_scheme1);
  if (levels > 0.0)
    report.add_target(at_least("auto / openmp_levels, " + model.name, speedup / levels, 0.95));
  if (outer > 0.0)
    report.add_target(
        at_least("auto / openmp_scheme1 2x1, outer only, " + model.name, speedup / outer, 1.2));
}

void compare_executors(const QuestionOptions& options, Report& report) {
  const std::vector<Model> models = make_models(options.quick);
  Table table{"Speedup over serial on 2 threads, whole steps; the executors in turns at each model",
              {"model", "serial, step"},
              {}};
  std::string choices = "  auto chose:";
  int near_best = 0;
  for (const Model& model : models) {
    const Measured measured = measure_model(model, options);
    const Timing& serial = measured.timings.front();
    std::vector<std::string> row{model.name, graph::duration_text(serial.least)};
    for (const Timing& timing : measured.timings) {
      report.add_timing(model.name, timing);
      if (&timing == &serial) continue;
      row.push_back(speedup_with_spread(timing));
      if (table.rows.empty()) table.columns.push_back(timing.name);
    }
    table.rows.push_back(std::move(row));
    choices += fmt::format("\n  {:<28}{}", model.name, measured.chosen);
    report.add_result({{"model", model.name},
                       {"auto_chose", measured.chosen},
                       {"steps_compared", measured.steps}});
    add_targets(model, measured, report);
    if (measured.speedup(ExecutorKind::automatic) >= 0.97 * measured.best()) ++near_best;
  }
  report.add_table(table);
  report.add_remark(choices);
  const auto count = static_cast<int>(models.size());
  report.add_target(
      at_least(fmt::format("models of {} where auto is within 3 % of the best executor", count),
               near_best, count - 1));
}

/// Measures nested teams of more threads than processors.
void measure_nested_teams(const Model& model, const QuestionOptions& options, Report& report) {
  const std::vector<RunnerPointer> runners{
      make_runner(model, ExecutorKind::serial, 1),
      make_runner(model, ExecutorKind::openmp_scheme1, {3, 4})};
  const std::int64_t batch = steps_per_batch(*runners.front());
  std::vector<Alternative> alternatives;
  for (const RunnerPointer& runner : runners) {
    runner->advance_to(runners.front()->simulation().steps(), batch);
    alternatives.push_back(after_pause(runner, batch));
  }
  const std::vector<Timing> timings = measure(alternatives, effort_of(options));
  require_same_state(model, runners, batch);
  report.add_timing(model.name + ", 3x4 threads", timings[1]);
  report.add_target(
      at_least("openmp_scheme1 3x4 / serial, " + model.name, 1.0 / timings[1].ratio, 1.0 / 3.0));
}

/// Measures more threads than processors.
void measure_oversubscription(const Model& model, const QuestionOptions& options, Report& report) {
  constexpr std::array kCounts{kThreads, 6, 12};
  for (const ExecutorKind kind : {ExecutorKind::automatic, ExecutorKind::flow_graph}) {
    std::vector<RunnerPointer> runners;
    for (const int threads : kCounts) runners.push_back(make_runner(model, kind, threads));
    const std::int64_t batch = steps_per_batch(*runners.front());
    std::int64_t begin = 0;
    for (const RunnerPointer& runner : runners) {
      runner->settle(batch);
      begin = std::max(begin, runner->simulation().steps());
    }
    std::vector<Alternative> alternatives;
    for (const RunnerPointer& runner : runners) {
      runner->advance_to(begin, batch);
      alternatives.push_back(make_alternative(runner, batch));
    }
    const std::vector<Timing> timings = measure(alternatives, effort_of(options));
    require_same_state(model, runners, batch);
    for (std::size_t k = 1; k < kCounts.size(); ++k) {
      report.add_timing(fmt::format("{}, {} threads", model.name, kCounts[k]), timings[k]);
      report.add_target(at_least(fmt::format("{}: speed on {} threads / {} threads, {}",
                                             name_of(kind), kCounts[k], kThreads, model.name),
                                 1.0 / timings[k].ratio, 0.9));
    }
  }
}

}  // namespace

void measure_executors(const QuestionOptions& options, Report& report) {
  compare_executors(options, report);
  for (const Model& model : {rotor_model({3, 4, 4}, Formulation::subsystem),
                             rotor_model({24, 8, 8}), rotor_model({96, 8, 8})})
    measure_oversubscription(model, options, report);
  if (!graph::has_executor(ExecutorKind::openmp_scheme1)) return;
  for (const Formulation formulation : {Formulation::structured, Formulation::subsystem})
    measure_nested_teams(rotor_model({3, 4, 4}, formulation), options, report);
}

}  // namespace spoke::bench
