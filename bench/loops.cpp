// What do closed loops cost? Whole steps through Simulation::run_until, without an observer, by the
// serial executor unless said otherwise:
//
//   Andrews' squeezer and two four-bar linkages, as shipped: time of a run and of a step. Beside
//   each the same bodies and joints without loops: what the loops take of an evaluation of the
//   accelerations, for the open tree moves otherwise and iterates otherwise.
//
//   1 to 32 suspensions of models/vehicle.toml on one chassis, whose loops are closed inside of
//   their subsystems: the cost of one of them.
//
//   24 suspensions by "auto" on two threads against serial: on a free chassis, where all make every
//   iteration together, and on one that is held, where they need not.
//
// A simulation goes back to where it began before each of its turns.

#include <spdlog/fmt/fmt.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/compare/interleaved.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/repeated_steps.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

constexpr double kMostFourBarStep = 10e-6;  // s
constexpr double kMostAndrewsRun = 0.1;     // s, of 3000 steps
constexpr double kLeastShareOfLinear = 0.8, kMostShareOfLinear = 1.2;
constexpr std::array kSuspensions{1, 2, 4, 8, 16, 32};
constexpr int kManySuspensions = 24;
constexpr int kSteps = 500;

Scenario shipped(const std::string& name) {
  return read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / (name + ".toml"));
}

/// Returns the same tree of bodies without its loops.
Scenario opened(Scenario scenario) {
  for (spatial::Subsystem& subsystem : scenario.space->subsystems) subsystem.loops.clear();
  scenario.space->anchors.clear();
  scenario.sensors.clear();
  return scenario;
}

/// Returns a chassis with suspensions that are alike but for their names.
Scenario with_suspensions(int count, bool is_free) {
  Scenario scenario = shipped("vehicle");
  scenario.sensors.clear();
  spatial::Model& model = *scenario.space;
  model.loads.clear();
  const spatial::Subsystem suspension = model.subsystems.front();
  model.subsystems.assign(static_cast<std::size_t>(count), suspension);
  for (int i = 0; i < count; ++i)
    model.subsystems[static_cast<std::size_t>(i)].name = "suspension_" + std::to_string(i);
  if (!is_free) {
    model.hub.support = HubSupport::axle;
    model.hub.velocity.setZero();
    model.hub.drive = FixedDrive{};
  }
  scenario.integration.duration = 1e3;
  return scenario;
}

using LoopSteps = std::shared_ptr<RepeatedSteps>;

LoopSteps make_steps(const std::string& name, const Scenario& scenario, int steps,
                     ExecutorKind kind = ExecutorKind::serial, int threads = 1) {
  show_progress(name + ": building");
  return std::make_shared<RepeatedSteps>(
      scenario, SimulationOptions{Formulation::structured, kind, threads}, 0.0, steps);
}

/// Makes an alternative whose time is that of a step, by `per` of them.
Alternative make_alternative(std::string name, const LoopSteps& steps, int reference,
                             double per = 1.0) {
  Alternative made = RepeatedSteps::alternative(std::move(name), steps, reference);
  made.scale /= per;
  return made;
}

void measure_mechanisms(const Effort& effort, Report& report) {
  struct Mechanism {
    const char* name;
    int steps;
  };
  Table table{"Mechanisms, closed and with their loops left open, serial; each in turns",
              {"model", "evaluations", "a step", "an evaluation", "closed / open", "rounds"},
              {}};
  for (const auto& [name, steps] :
       {Mechanism{"four_bar", 2000}, Mechanism{"andrews_squeezer", 3000},
        Mechanism{"bricard", 2000}, Mechanism{"vehicle", 500}}) {
    const Scenario scenario = shipped(name);
    const LoopSteps open = make_steps(name, opened(scenario), steps),
                    closed = make_steps(name, scenario, steps);
    const std::vector<Timing> timings =
        measure({make_alternative("open", open, 0, open->evaluations_per_step()),
                 make_alternative("closed", closed, 0, closed->evaluations_per_step())},
                effort);
    for (std::size_t k = 0; k < timings.size(); ++k) {
      const double evaluations = (k == 0 ? open : closed)->evaluations_per_step();
      table.rows.push_back({std::string(name) + ", " + timings[k].name, figure(evaluations),
                            graph::duration_text(timings[k].least * evaluations),
                            graph::duration_text(timings[k].least),
                            k == 0 ? "" : ratio_with_spread(timings[k]),
                            std::to_string(timings[k].rounds)});
      report.add_timing(name, timings[k]);
    }
    const double step = timings[1].least * closed->evaluations_per_step();
    if (name == std::string("four_bar"))
      report.add_target(
          at_most("two four-bar linkages, a step, us", 1e6 * step, 1e6 * kMostFourBarStep));
    if (name == std::string("andrews_squeezer"))
      report.add_target(
          at_most("Andrews' squeezer, 3000 steps, s", 3000.0 * step, kMostAndrewsRun));
  }
  report.add_table(table);
}

void measure_suspensions(const Effort& effort, Report& report) {
  std::vector<Alternative> alternatives;
  for (const int count : kSuspensions) {
    const std::string name = std::to_string(count);
    alternatives.push_back(make_alternative(
        name, make_steps(name + " suspensions", with_suspensions(count, true), kSteps), 0));
  }
  const std::vector<Timing> timings = measure(alternatives, effort);
  Table table{"Suspensions on a free chassis, serial; all in turns",
              {"suspensions", "a step", "of it each", "/ 1", "rounds"},
              {}};
  for (std::size_t k = 0; k < timings.size(); ++k) {
    const double count = kSuspensions[k];
    table.rows.push_back({timings[k].name, graph::duration_text(timings[k].least),
                          graph::duration_text(timings[k].least / count),
                          ratio_with_spread(timings[k]), std::to_string(timings[k].rounds)});
    report.add_timing("suspensions", timings[k]);
  }
  report.add_table(table);
  // What each more of them costs.
  const auto slope = [&](std::size_t from, std::size_t to) {
    return (timings[to].least - timings[from].least) / (kSuspensions[to] - kSuspensions[from]);
  };
  const std::size_t last = timings.size() - 1;
  Target linear = at_most("a further suspension, from 8 to 32 / from 1 to 8, times",
                          slope(3, last) / slope(0, 3), kMostShareOfLinear);
  linear.least = kLeastShareOfLinear;
  report.add_target(linear);
}

void measure_threads(const Effort& effort, Report& report) {
  Table table{fmt::format("{} suspensions, by executor; each chassis in turns", kManySuspensions),
              {"chassis", "executor", "a step", "/ serial", "rounds"},
              {}};
  for (const bool is_free : {false, true}) {
    const std::string name = is_free ? "free" : "held";
    const Scenario scenario = with_suspensions(kManySuspensions, is_free);
    const LoopSteps serial = make_steps(name, scenario, kSteps),
                    automatic =
                        make_steps(name + ", auto", scenario, kSteps, ExecutorKind::automatic, 2);
    if (serial->hash() != automatic->hash())
      throw std::runtime_error("suspensions: serial and auto differ in their state");
    const std::vector<Timing> timings = measure(
        {make_alternative("serial", serial, 0), make_alternative("auto", automatic, 0)}, effort);
    for (std::size_t k = 0; k < timings.size(); ++k) {
      table.rows.push_back({k == 0 ? name : "", timings[k].name,
                            graph::duration_text(timings[k].least), ratio_with_spread(timings[k]),
                            std::to_string(timings[k].rounds)});
      report.add_timing(name + " chassis", timings[k]);
    }
    report.add_target(at_least("24 suspensions, " + name + " chassis, 2 threads, speedup",
                               1.0 / timings[1].ratio, is_free ? 1.4 : 1.7));
  }
  report.add_table(table);
}

}  // namespace

void measure_loops(const QuestionOptions& options, Report& report) {
  const Effort effort = options.quick ? Effort{3, 1e-3, 1.0} : Effort{31, 1e-3, 6.0};
  measure_mechanisms(effort, report);
  measure_suspensions(effort, report);
  if (!options.quick) measure_threads(effort, report);
}

}  // namespace spoke::bench
