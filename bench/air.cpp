// What does air cost? Whole steps through Simulation::run_until, without an observer, serial, of
// the rotor of models/nrel_5mw_in_wind.toml, its axle at rest: in steady wind, and the same rotor
// in a vacuum with loads of the size of the air's on it. Both in turns. A step's cost by evaluation
// says what a node "air" costs beside the nodes of the structure, which is what is asked for: that
// air costs at most as much; the evaluations say what the iteration takes more.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/compare/interleaved.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/simulation.h"
#include "graph/machine/duration_text.h"
#include "models/system/spatial_system.h"

namespace spoke::bench {
namespace {

constexpr double kBegin = 2.0;  // s
constexpr int kSteps = 100;
constexpr double kMostCost = 2.0, kLeastSpeed = 60.0;

/// Returns the turbine in steady wind.
Scenario read_turbine() {
  Scenario scenario =
      read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / "nrel_5mw_in_wind.toml");
  scenario.sensors.clear();
  Wind steady;
  steady.velocity = scenario.space->air->wind.velocity;
  scenario.space->air->wind = steady;
  return scenario;
}

/// Returns the rotor of a turbine alone, in air or in a vacuum.
Scenario make_rotor(Scenario scenario, bool is_in_air) {
  scenario.space = spoke::without_support(*scenario.space);
  if (is_in_air) return scenario;
  scenario.space->air.reset();
  spatial::DistributedLoad load;
  load.frame = spatial::LoadFrame::body;
  load.from = 10.0;
  load.force_per_length = {0.0, 713.0, 4531.0};
  scenario.space->distributed_loads = {load};
  return scenario;
}

/// A simulation that makes the same steps over and over.
class AirSteps {
 public:
  explicit AirSteps(const Scenario& scenario)
      : simulation_(scenario, {Formulation::structured, ExecutorKind::serial, 1}) {
    simulation_.run_until(kBegin);
    start_ = simulation_.save();
    run();
    evaluations_ = static_cast<double>(simulation_.evaluations() - start_.evaluations) / kSteps;
  }

  void go_back() { simulation_.restore(start_); }
  void run() {
    simulation_.run_until(static_cast<double>(start_.steps + kSteps) * simulation_.step_size());
  }
  double evaluations_per_step() const { return evaluations_; }
  double step_size() const { return simulation_.step_size(); }

 private:
  Simulation simulation_;
  SavedState start_;
  double evaluations_ = 0.0;
};

}  // namespace

void measure_air(const QuestionOptions& options, Report& report) {
  const Scenario turbine = read_turbine();
  struct Way {
    const char* name;
    Scenario scenario;
  };
  const Way ways[] = {{"rotor in a vacuum", make_rotor(turbine, false)},
                      {"rotor in air", make_rotor(turbine, true)},
                      {"turbine in air", turbine}};
  std::vector<std::shared_ptr<AirSteps>> steps;
  std::vector<Alternative> alternatives;
  for (const Way& way : ways) {
    show_progress(std::string(way.name) + ": building");
    steps.push_back(std::make_shared<AirSteps>(way.scenario));
    alternatives.push_back({way.name, [own = steps.back()] { own->run(); },
                            [own = steps.back()] { own->go_back(); }, 1.0 / kSteps, 0});
  }
  const std::vector<Timing> timings =
      measure(alternatives, options.quick ? Effort{3, 0.0, 1.0} : Effort{31, 0.0, 20.0});
  Table table{"The NREL 5 MW rotor and turbine in air, whole steps, serial; in turns",
              {"model", "evaluations", "a step", "an evaluation", "/ vacuum", "real time, times"},
              {}};
  std::vector<double> costs;
  for (std::size_t k = 0; k < timings.size(); ++k) {
    costs.push_back(timings[k].least / steps[k]->evaluations_per_step());
    table.rows.push_back({timings[k].name, figure(steps[k]->evaluations_per_step()),
                          graph::duration_text(timings[k].least), graph::duration_text(costs[k]),
                          k == 0 ? "" : figure(costs[k] / costs[0]),
                          figure(steps[k]->step_size() / timings[k].least)});
    report.add_timing("nrel_5mw_in_wind", timings[k]);
  }
  report.add_table(table);
  report.add_target(
      at_most("rotor in air / in a vacuum, an evaluation, times", costs[1] / costs[0], kMostCost));
  report.add_target(at_least("turbine in air, simulated seconds a second",
                             steps[2]->step_size() / timings[2].least, kLeastSpeed));
}

}  // namespace spoke::bench
