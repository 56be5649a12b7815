// What does a whole step cost, by model and integrator? Measured against the evaluations of the
// accelerations that it contains:
//
//   ratio = time of a step / (evaluations in the step x time of a bare evaluation)
//
// A step is one that `spoke run` makes with the serial executor: predicted and corrected, checked,
// recorded, with the sensors of every step handed to the collectors of their extremes and of the
// tips' largest deflections. Rows are counted but not written: `spoke run` leaves writing out of
// the time that it reports. rk4 makes four evaluations in a step, generalized_alpha as many as it
// iterates. A bare evaluation is what `formulations` measures: one pass of the step graph in the
// structured formulation that only evaluates, and no observer is called.
//
// The rotor is the paper's with geometric stiffening, as models/wu_haug_rotor.toml has it. Timed
// are the whole 20 s of generalized_alpha, for the evaluations in a step change on the way, and the
// first steps of rk4.

#include <array>
#include <memory>
#include <stdexcept>

#include "bench/compare/interleaved.h"
#include "bench/evaluated_model.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/results.h"
#include "engine/simulation.h"
#include "graph/machine/duration_text.h"
#include "program/run_report/tip_deflections.h"

namespace spoke::bench {
namespace {

constexpr std::array kSizes{RotorSize{3, 4, 4}, RotorSize{3, 16, 4}, RotorSize{24, 8, 8}};
constexpr double kMostRatio = 1.4;

/// The steps of an integrator, and how they are measured.
struct Steps {
  IntegrationMethod method;
  double size;  ///< [s]; for rk4 stable at every size of the rotor
  int count;    ///< number of steps from rest
};
constexpr std::array kSteps{Steps{IntegrationMethod::generalized_alpha, 0.005, 4000},
                            Steps{IntegrationMethod::rk4, 1e-5, 1000}};

Scenario make_scenario(const RotorSize& size, const Steps& steps) {
  Scenario scenario = paper_rotor(size, true);
  scenario.integration.method = steps.method;
  scenario.integration.step = steps.size;
  return scenario;
}

SimulationOptions serially() {
  SimulationOptions options;
  options.executor = ExecutorKind::serial;
  return options;
}

/// A simulation that makes the same steps over and over, as `spoke run` makes them.
class RepeatedSteps {
 public:
  RepeatedSteps(const RotorSize& size, const Steps& steps)
      : simulation_(make_scenario(size, steps), serially()),
        count_(steps.count),
        statistics_(simulation_.sensor_names().size()),
        tips_(simulation_),
        due_(simulation_.scenario().output.interval) {
    start_ = simulation_.save();
    require_agreement();
  }

  void go_back() { simulation_.restore(start_); }

  void run() {
    const double end = static_cast<double>(start_.steps + count_) * simulation_.step_size();
    simulation_.run_until(end, [this](double t, std::span<const double> sensors) {
      statistics_.add(t, sensors);
      tips_.add(t, sensors);
      rows_ += due_.is_due(t) ? 1 : 0;
    });
  }

  int count() const { return count_; }
  double evaluations_per_step() const { return static_cast<double>(evaluations_) / count_; }

 private:
  /// Demands that the timed steps lead to the state of steps that are made one by one.
  void require_agreement() {
    for (int k = 0; k < count_; ++k) simulation_.step();
    const std::uint64_t expected = simulation_.state_hash();
    evaluations_ = simulation_.evaluations() - start_.evaluations;
    go_back();
    run();
    if (simulation_.state_hash() != expected ||
        simulation_.evaluations() != start_.evaluations + evaluations_)
      throw std::runtime_error("steps that are observed end in another state than single ones");
  }

  Simulation simulation_;
  int count_;
  SensorStatistics statistics_;
  run_report::TipDeflections tips_;
  OutputTimes due_;
  std::int64_t rows_ = 0;
  SavedState start_;
  std::int64_t evaluations_ = 0;
};

/// Makes an alternative whose reported time is that per evaluation.
Alternative make_alternative(const std::shared_ptr<RepeatedSteps>& steps, const Steps& how) {
  return {std::string(name_of(how.method)), [steps] { steps->run(); },
          [steps] { steps->go_back(); }, 1.0 / (steps->count() * steps->evaluations_per_step()), 0};
}

void measure_size(const RotorSize& size, const Effort& effort, Table& table, Report& report) {
  show_progress(size.name() + ": building");
  const ModelPointer<Plane> model =
      make_models(make_system(paper_rotor(size, true).rotor), {Formulation::structured}).front();
  std::vector<Alternative> alternatives{{"evaluation", [model] { model->evaluate(); }, {}, 1.0, 0}};
  std::vector<double> evaluations{1.0};
  for (const Steps& how : kSteps) {
    const auto steps = std::make_shared<RepeatedSteps>(size, how);
    evaluations.push_back(steps->evaluations_per_step());
    alternatives.push_back(make_alternative(steps, how));
  }
  const std::vector<Timing> timings = measure(alternatives, effort);
  for (std::size_t k = 0; k < timings.size(); ++k) {
    const Timing& timing = timings[k];
    report.add_timing(size.name(), timing);
    if (k == 0) continue;
    table.rows.push_back({k == 1 ? size.name() : "", timing.name,
                          graph::duration_text(timing.least * evaluations[k]),
                          figure(evaluations[k]), graph::duration_text(timings.front().least),
                          ratio_with_spread(timing), std::to_string(timing.rounds)});
    report.add_target(
        at_most("a step / its evaluations, " + size.name() + ", " + timing.name + ", times",
                timing.ratio, kMostRatio));
  }
}

}  // namespace

void measure_whole_steps(const QuestionOptions& options, Report& report) {
  Table table{"A step with the sensors of every step, serial; each size in turns",
              {"(N,M,E)", "integrator", "step", "evaluations", "an evaluation",
               "step / evaluations", "rounds"},
              {}};
  const Effort effort = options.quick ? Effort{3, 1e-3, 1.0} : Effort{51, 5e-3, 8.0};
  for (const RotorSize& size : kSizes) measure_size(size, effort, table, report);
  report.add_table(table);
}

}  // namespace spoke::bench
