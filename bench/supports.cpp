// What does a support cost, and what do two threads gain where one carries the rotor? Whole steps
// through Simulation::run_until, without an observer, of models/nrel_5mw_turbine.toml: tower,
// nacelle, and a rotor whose blades are the work. Beside it the rotor alone, the same but for the
// support, its axle at rest. Both serial and by "auto" on two threads, the turbine also by
// "flow_graph", which always takes both; all in turns.
//
// The steps are those from 2 s on, when blades and tower move; a simulation goes back there before
// each of its turns. The ratio of evaluations says what of the ratio of steps is one of iterations.

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/repeated_steps.h"
#include "graph/machine/duration_text.h"
#include "models/system/spatial_system.h"

namespace spoke::bench {
namespace {

constexpr double kBegin = 2.0;  // s
constexpr int kSteps = 200;
constexpr double kMostCost = 1.35, kLeastSpeedup = 1.7;

Scenario read_turbine() {
  Scenario scenario =
      read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / "nrel_5mw_turbine.toml");
  scenario.sensors.clear();
  return scenario;
}

/// Returns a rotor without what carries it.
Scenario without_support(Scenario scenario) {
  scenario.space = spoke::without_support(*scenario.space);
  return scenario;
}

using SupportSteps = std::shared_ptr<RepeatedSteps>;

SupportSteps make_steps(const std::string& name, const Scenario& scenario, ExecutorKind kind,
                        int threads) {
  show_progress(name + ": building");
  return std::make_shared<RepeatedSteps>(
      scenario, SimulationOptions{Formulation::structured, kind, threads}, kBegin, kSteps);
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

void measure_supports(const QuestionOptions& options, Report& report) {
  const Scenario turbine = read_turbine(), rotor = without_support(turbine);
  struct Way {
    const char* name;
    const Scenario& scenario;
    ExecutorKind kind;
    int threads, reference;
  };
  const Way ways[] = {{"rotor alone, serial", rotor, ExecutorKind::serial, 1, 0},
                      {"turbine, serial", turbine, ExecutorKind::serial, 1, 0},
                      {"rotor alone, auto", rotor, ExecutorKind::automatic, 2, 0},
                      {"turbine, auto", turbine, ExecutorKind::automatic, 2, 1},
                      {"turbine, flow_graph", turbine, ExecutorKind::flow_graph, 2, 1}};
  std::vector<SupportSteps> steps;
  std::vector<Alternative> alternatives;
  for (const Way& way : ways) {
    steps.push_back(make_steps(way.name, way.scenario, way.kind, way.threads));
    const auto reference = static_cast<std::size_t>(way.reference);
    if (way.threads > 1 && steps.back()->hash() != steps[reference]->hash())
      throw std::runtime_error(std::string(way.name) + " ends in another state than serial steps");
    alternatives.push_back(RepeatedSteps::alternative(way.name, steps.back(), way.reference));
  }
  const std::vector<Timing> timings =
      measure(alternatives, options.quick ? Effort{3, 0.0, 1.0} : Effort{31, 0.0, 20.0});
  Table table{"The NREL 5 MW turbine and its rotor alone, whole steps, on 1 or 2 threads; in turns",
              {"model", "evaluations", "a step", "/ rotor alone", "speedup", "rounds"},
              {}};
  for (std::size_t k = 0; k < timings.size(); ++k) {
    const Timing& timing = timings[k];
    const bool is_shared = ways[k].threads > 1;
    table.rows.push_back({timing.name, figure(steps[k]->evaluations_per_step()),
                          graph::duration_text(timing.least),
                          k == 1 ? ratio_with_spread(timing) : "",
                          is_shared ? speedup_text(timing) : "", std::to_string(timing.rounds)});
    report.add_timing("nrel_5mw_turbine", timing);
  }
  report.add_table(table);
  report.add_remark("  auto chose for the turbine: " + steps[3]->executor());
  report.add_target(
      at_most("turbine / its rotor alone, a step, times", timings[1].ratio, kMostCost));
  report.add_target(
      at_least("turbine, auto on 2 threads / serial", 1.0 / timings[3].ratio, kLeastSpeedup));
}

}  // namespace spoke::bench
