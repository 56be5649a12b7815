// How long does the 20 s spin-up of the paper's model take, at 0.1 % accuracy of its own converged
// answer? Spoke's way is generalized_alpha with the structured formulation, at the largest of some
// steps that is accurate enough; the paper's way is rk4 with the subsystem formulation, at its
// largest stable step, where it is far more accurate than asked. All runs are serial, through
// spoke::Simulation.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

#include "bench/compare/interleaved.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/simulation.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

constexpr double kDuration = 20.0;       // s
constexpr double kAccuracy = 1e-3;       // as a fraction of the largest deflection
constexpr double kReferenceStep = 5e-4;  // s, step of the converged answer
constexpr double kSampling = 0.005;      // s, a whole multiple of reference steps and of rk4's
constexpr double kShortSpan = 0.05;      // s, over which slow alternatives are timed
constexpr std::string_view kSensor = "blade1.tip.y";

// All divide the duration and are whole numbers of reference steps.
constexpr std::array kCandidates{0.1, 0.08, 0.05, 0.04, 0.025, 0.02, 0.01, 0.005};  // s

Simulation make_simulation(IntegrationMethod method, double step, Formulation formulation) {
  Scenario scenario = paper_rotor({});
  scenario.integration.method = method;
  scenario.integration.step = step;
  scenario.integration.duration = kDuration;
  return Simulation(scenario, {formulation, ExecutorKind::serial, 1});
}

void run_to_end(Simulation& simulation) {
  while (!simulation.done()) simulation.step();
}

/// A deflection over time, from t = 0 on.
struct TipCurve {
  double interval = 0.0;  ///< [s]
  std::vector<double> values;

  double largest() const {
    double most = 0.0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
  }
};

/// Runs to the end, sampling every `stride` steps.
TipCurve record(Simulation& simulation, int stride, const std::string& what) {
  const auto& names = simulation.sensor_names();
  const auto column =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), kSensor) - names.begin());
  TipCurve curve{simulation.step_size() * stride, {simulation.sensor_values()[column]}};
  while (!simulation.done()) {
    for (int k = 0; k < stride; ++k) simulation.step();
    curve.values.push_back(simulation.sensor_values()[column]);
    if (curve.values.size() % 500 == 0)
      show_progress(what + ": t = " + figure(simulation.time()) + " s");
  }
  return curve;
}

/// Returns the largest difference over the times that both have, relative to the reference's
/// largest value.
double difference(const TipCurve& curve, const TipCurve& reference) {
  const double finer = std::min(curve.interval, reference.interval);
  const double coarser = std::max(curve.interval, reference.interval);
  const auto stride = static_cast<std::size_t>(std::lround(coarser / finer));
  const auto& dense = curve.interval <= reference.interval ? curve.values : reference.values;
  const auto& sparse = curve.interval <= reference.interval ? reference.values : curve.values;
  double most = 0.0;
  for (std::size_t k = 0; k < sparse.size(); ++k)
    most = std::max(most, std::abs(sparse[k] - dense.at(k * stride)));
  return most / reference.largest();
}

std::string percent(double value) {
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "%.2g %%", 100.0 * value);
  return text.data();
}

/// rk4's largest stable step, shortened to divide the sampling interval.
struct ExplicitStep {
  int per_sampling = 0;
  double size() const { return kSampling / per_sampling; }
};

ExplicitStep find_explicit_step() {
  const Simulation simulation =
      make_simulation(IntegrationMethod::rk4, kSampling, Formulation::structured);
  const double bound = simulation.linear_properties().rk4_largest_step;
  return {static_cast<int>(std::ceil(kSampling / bound))};
}

/// Makes the converged answer. Another integrator, of another order, must find the same; running to
/// the end at rk4's largest stable step, it also shows that this step is stable.
TipCurve converge(ExplicitStep step, Report& report) {
  Simulation reference = make_simulation(IntegrationMethod::generalized_alpha, kReferenceStep,
                                         Formulation::structured);
  TipCurve curve = record(reference, 1, "converged answer");
  Simulation check = make_simulation(IntegrationMethod::rk4, step.size(), Formulation::structured);
  const double error = difference(record(check, step.per_sampling, "cross-check"), curve);
  report.add_remark("\n  converged answer   generalized_alpha at " +
                    graph::duration_text(kReferenceStep) + ": largest lag of the tip " +
                    std::to_string(curve.largest()) + " m");
  report.add_remark("  cross-check        rk4 at " + graph::duration_text(step.size()) +
                    ", its largest stable step: differs by " + percent(error));
  report.add_result({{"model", "converged answer"},
                     {"largest_deflection_m", curve.largest()},
                     {"rk4_step_s", step.size()},
                     {"rk4_difference", error}});
  if (!(error < 0.01 * kAccuracy))
    throw std::runtime_error("the converged answer is not: rk4 differs by " + percent(error));
  return curve;
}

/// A step that is accurate enough.
struct Solution {
  double step = 0.0;  ///< [s]
  double final_value = 0.0;
  std::uint64_t state_hash = 0;
};

/// Tries the candidates, largest first; the report shows all.
Solution find_largest_step(const TipCurve& reference, Report& report) {
  Table table{"Error of generalized_alpha over the 20 s, relative to the largest lag",
              {"step", "steps", "evaluations", "per step", "error", ""},
              {}};
  std::optional<Solution> found;
  for (const double step : kCandidates) {
    Simulation simulation =
        make_simulation(IntegrationMethod::generalized_alpha, step, Formulation::structured);
    const TipCurve curve = record(simulation, 1, "step " + graph::duration_text(step));
    const double error = difference(curve, reference);
    const bool taken = !found && error <= kAccuracy;
    if (taken) found = Solution{step, curve.values.back(), simulation.state_hash()};
    const auto steps = static_cast<double>(simulation.steps());
    const auto evaluations = static_cast<double>(simulation.evaluations());
    table.rows.push_back({graph::duration_text(step), std::to_string(simulation.steps()),
                          std::to_string(simulation.evaluations()), figure(evaluations / steps),
                          percent(error), taken ? "<- taken" : ""});
    report.add_result({{"model", "candidate"},
                       {"step_s", step},
                       {"evaluations", simulation.evaluations()},
                       {"error", error},
                       {"taken", taken}});
  }
  report.add_table(table);
  if (!found) throw std::runtime_error("no candidate step is accurate to 0.1 %");
  return *found;
}

using SimulationSlot = std::shared_ptr<std::optional<Simulation>>;

/// Runs the whole 20 s at the step that was found, from a simulation set up before the clock
/// starts.
Alternative whole_run(std::string name, double step, Formulation formulation,
                      const SimulationSlot& slot) {
  Alternative alternative;
  alternative.name = std::move(name);
  alternative.prepare = [=] {
    slot->emplace(make_simulation(IntegrationMethod::generalized_alpha, step, formulation));
  };
  alternative.run = [=] { run_to_end(**slot); };
  return alternative;
}

/// Continues rk4 for a short span each time; the time scaled to 20 s is reported.
Alternative short_runs(std::string name, ExplicitStep step, double span, Formulation formulation,
                       const SimulationSlot& slot) {
  const auto steps = static_cast<int>(std::lround(span / step.size()));
  slot->emplace(make_simulation(IntegrationMethod::rk4, step.size(), formulation));
  Alternative alternative;
  alternative.name = std::move(name);
  alternative.prepare = [] {};  // one span a turn
  alternative.run = [=] {
    for (int k = 0; k < steps; ++k) (*slot)->step();
  };
  alternative.scale = kDuration / span;
  return alternative;
}

/// The simulations that the alternatives leave behind.
struct Slots {
  SimulationSlot ours = std::make_shared<std::optional<Simulation>>();
  SimulationSlot with_sensors = std::make_shared<std::optional<Simulation>>();
  SimulationSlot implicit_subsystem = std::make_shared<std::optional<Simulation>>();
  SimulationSlot explicit_structured = std::make_shared<std::optional<Simulation>>();
  SimulationSlot paper = std::make_shared<std::optional<Simulation>>();
  SimulationSlot conventional = std::make_shared<std::optional<Simulation>>();
  SimulationSlot set_up = std::make_shared<std::optional<Simulation>>();
};

std::vector<Alternative> make_alternatives(double step, ExplicitStep explicit_step,
                                           const Slots& slots) {
  std::vector<Alternative> all;
  all.push_back(
      whole_run("generalized_alpha + structured", step, Formulation::structured, slots.ours));
  all.push_back(short_runs("rk4 + subsystem", explicit_step, kShortSpan, Formulation::subsystem,
                           slots.paper));
  all.push_back(whole_run("  as first, sensors every step", step, Formulation::structured,
                          slots.with_sensors));
  all.back().run = [slot = slots.with_sensors] {
    while (!(*slot)->done()) {
      (*slot)->step();
      (*slot)->sensor_values();
    }
  };
  all.push_back({"  setting the first up",
                 [=] {
                   slots.set_up->emplace(make_simulation(IntegrationMethod::generalized_alpha, step,
                                                         Formulation::structured));
                 },
                 [=] { slots.set_up->reset(); }, 1.0, 0});
  all.push_back(whole_run("generalized_alpha + subsystem", step, Formulation::subsystem,
                          slots.implicit_subsystem));
  all.push_back(short_runs("rk4 + structured", explicit_step, kShortSpan, Formulation::structured,
                           slots.explicit_structured));
  all.push_back(short_runs("rk4 + augmented", explicit_step, kSampling, Formulation::augmented,
                           slots.conventional));
  return all;
}

void demand(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("what was timed is not what was asked: " + what);
}

/// Demands that the timed runs computed the solution that was judged accurate.
void require_agreement(const Solution& solution, const Slots& slots) {
  demand((*slots.ours)->state_hash() == solution.state_hash &&
             (*slots.with_sensors)->state_hash() == solution.state_hash,
         "generalized_alpha + structured ends in another state than before");
  const double by_subsystem = (*slots.implicit_subsystem)->sensor(kSensor);
  demand(std::abs(by_subsystem - solution.final_value) < 1e-6 * std::abs(solution.final_value),
         "generalized_alpha + subsystem ends in another state than with structured");
  demand((*slots.paper)->steps() == (*slots.explicit_structured)->steps(),
         "the formulations did not make the same steps of rk4");
  const double paper = (*slots.paper)->sensor(kSensor);
  const double structured = (*slots.explicit_structured)->sensor(kSensor);
  // Early in the spin-up the deflection is small, and its last digits are lost beside the blade's
  // length.
  demand(std::abs(paper - structured) < 1e-6 * std::abs(structured) + 1e-12,
         "rk4 + subsystem differs from rk4 + structured");
}

void report_timings(const std::vector<Timing>& timings, Report& report) {
  Table table{"Time for the 20 s, all in turns, serial", {"", "time", "/ first", "rounds"}, {}};
  for (const Timing& timing : timings) {
    table.rows.push_back({timing.name, graph::duration_text(timing.least),
                          &timing == &timings.front() ? "1" : ratio_with_spread(timing),
                          std::to_string(timing.rounds)});
    report.add_timing("20 s", timing);
  }
  report.add_table(table);
  report.add_remark("  Each round times rk4 over a short span of the motion (" +
                    graph::duration_text(kShortSpan) + "; augmented " +
                    graph::duration_text(kSampling) +
                    ")\n  and scales that to 20 s: its steps cost the same throughout.");
  report.add_target(at_least("generalized_alpha + structured beats rk4 + subsystem, 20 s, times",
                             timings[1].ratio, 3000.0));
}

}  // namespace

void measure_time_to_solution(const QuestionOptions& options, Report& report) {
  const ExplicitStep explicit_step = find_explicit_step();
  const TipCurve reference = converge(explicit_step, report);
  const Solution solution = find_largest_step(reference, report);
  const Slots slots;
  const Effort effort{options.quick ? 3 : 25, 0.0, 60.0};
  const std::vector<Timing> timings =
      measure(make_alternatives(solution.step, explicit_step, slots), effort);
  require_agreement(solution, slots);
  report_timings(timings, report);
}

}  // namespace spoke::bench
