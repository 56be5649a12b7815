// How many passes does a step of generalized_alpha need, by model and step, and at the steps that
// accuracy allows? A pass is one evaluation of the accelerations and the correction of the
// coordinates, so the number of passes sets the cost of a step. The error is that of the whole
// history of a displacement: the largest distance from a run at a much smaller step, by the largest
// displacement in that run. From the errors follow, by interpolation, the steps at which a run is
// accurate to 1 % and to 0.1 %; these runs are made and timed. All serial, through
// spoke::Simulation; times are of the processor.
//
// Beside the passes stand those of the engine before its iteration knew of the spin, and how many
// times longer the runs of equal accuracy took then. Times of two programs on different days are
// compared by a yardstick that the iteration does not touch: rk4 on the paper's rotor.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "bench/paper_rotor.h"
#include "bench/passes_models.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/simulation.h"
#include "graph/machine/duration_text.h"
#include "models/error.h"

namespace spoke::bench {
namespace {

constexpr double kPercent = 1e-2;
constexpr double kPermille = 1e-3;
constexpr double kReferenceError = 0.1 * kPermille;  // error that a converged answer may have
constexpr double kYardstickStep = 1e-6;              // s, stable
constexpr int kYardstickSteps = 5000;

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1};

/// Returns the processor time that this process has used [s]: a busy neighbour disturbs it less
/// than the time of day.
double processor_time() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

Simulation simulate(const PassesModel& model, double step) {
  Scenario scenario = model.scenario();
  scenario.integration.method = IntegrationMethod::generalized_alpha;
  scenario.integration.step = step;
  scenario.integration.duration = model.duration;
  scenario.limits.step_error = 0.0;  // off, since errors are wanted here
  return Simulation(scenario, kSerial);
}

double passes_a_step(const Simulation& simulation) {
  return static_cast<double>(simulation.evaluations()) / static_cast<double>(simulation.steps());
}

/// The sensors of a run, at times that all runs of a model have in common.
struct Course {
  std::vector<std::vector<double>> values;  ///< values of the model's sensors, from t = 0 on
  std::vector<std::int64_t> evaluations;    ///< until then
  std::int64_t stride = 1;                  ///< steps from one time to the next
  double time = 0.0;                        ///< time that the run took [s]
  bool diverged = false;
};

void record_now(const Simulation& simulation, const std::vector<std::size_t>& columns,
                Course& course) {
  const auto all = simulation.sensor_values();
  std::vector<double>& values = course.values.emplace_back();
  for (const std::size_t column : columns) values.push_back(all[column]);
  course.evaluations.push_back(simulation.evaluations());
}

/// Runs to the end, looking at the sensors at each multiple of the model's largest step.
Course record(const PassesModel& model, double step) {
  show_progress(model.name + ", step " + graph::duration_text(step));
  Simulation simulation = simulate(model, step);
  std::vector<std::size_t> columns;
  for (const std::string& sensor : model.sensors)
    columns.push_back(simulation.sensor_index(sensor));
  Course course;
  course.stride = std::llround(model.steps.back() / simulation.step_size());
  const double begin = processor_time();
  record_now(simulation, columns, course);
  try {
    while (!simulation.done()) {
      for (std::int64_t k = 0; k < course.stride; ++k) simulation.step();
      record_now(simulation, columns, course);
    }
  } catch (const DivergenceError&) {
    course.diverged = true;
  }
  course.time = processor_time() - begin;
  return course;
}

/// Returns the index of the first time of a span.
std::size_t first_of(const PassesSpan& span, const PassesModel& model) {
  return static_cast<std::size_t>(std::llround(span.from / model.steps.back()));
}

double passes_in(const Course& course, std::size_t first) {
  const std::size_t last = course.evaluations.size() - 1;
  if (last <= first) return std::numeric_limits<double>::quiet_NaN();  // since it diverged before
  return static_cast<double>(course.evaluations[last] - course.evaluations[first]) /
         static_cast<double>(course.stride * static_cast<std::int64_t>(last - first));
}

/// Returns the largest distance between two courses from an index on, by the second one's largest
/// value.
double error_of(const Course& course, const Course& reference, std::size_t first) {
  if (course.diverged) return std::numeric_limits<double>::infinity();
  double distance = 0.0, largest = 0.0;
  for (std::size_t k = first; k < reference.values.size(); ++k) {
    double square = 0.0, size = 0.0;
    for (std::size_t c = 0; c < reference.values[k].size(); ++c) {
      const double value = reference.values[k][c];
      square += std::pow(course.values.at(k)[c] - value, 2);
      size += value * value;
    }
    distance = std::max(distance, std::sqrt(square));
    largest = std::max(largest, std::sqrt(size));
  }
  return distance / largest;
}

std::string percent(double value) { return fmt::format("{:.2g} %", 100.0 * value); }

/// One step of a model, in one span.
struct Cell {
  double passes = 0.0;
  double error = 0.0;
};

/// A model with its results.
struct Finding {
  PassesModel model;
  std::vector<Cell> whole;                         ///< cells of its first span, by step
  double percent_step = 0.0, permille_step = 0.0;  ///< steps of runs that are so accurate [s]
};

void add_row(const PassesModel& model, const PassesSpan& span, std::size_t k, const Cell& cell,
             const Course& course, Table& table, Report& report) {
  const bool has_before = k < span.before.size();
  const double evaluation = course.time / static_cast<double>(course.evaluations.back());
  table.rows.push_back(
      {span.name, graph::duration_text(model.steps[k]), figure(cell.passes),
       has_before ? figure(span.before[k]) : "", course.diverged ? "diverged" : percent(cell.error),
       graph::duration_text(evaluation), span.from > 0.0 ? "" : graph::duration_text(course.time)});
  Json result{{"model", span.name},    {"step_s", model.steps[k]},
              {"passes", cell.passes}, {"diverged", course.diverged},
              {"error", cell.error},   {"evaluation_s", evaluation},
              {"seconds", course.time}};
  if (has_before) result.set("passes_before", span.before[k]);
  report.add_result(std::move(result));
}

/// Returns the largest step below which all errors are as small as asked, by interpolation of the
/// logarithms; the largest of all if they are everywhere.
double find_step(const PassesModel& model, const std::vector<Cell>& cells, double error) {
  const auto worse = std::find_if(cells.begin(), cells.end(),
                                  [=](const Cell& cell) { return !(cell.error <= error); });
  if (worse == cells.end()) return model.steps.back();
  const auto k = static_cast<std::size_t>(worse - cells.begin());
  if (k == 0) return model.steps[0] * std::sqrt(error / worse->error);  // the order is two
  const double low = cells[k - 1].error;
  const double share = std::log(error / low) / std::log(worse->error / low);
  return model.steps[k - 1] * std::pow(model.steps[k] / model.steps[k - 1], share);
}

/// Estimates by Richardson's method the error of the reference run itself, from the two smallest
/// steps' errors and the order that they show.
double error_of_reference(const Finding& finding) {
  const PassesModel& model = finding.model;
  const double least = finding.whole[0].error;
  const double order = std::clamp(std::log2(finding.whole[1].error / least), 1.0, 2.0);
  const double share = std::pow(model.reference_step / model.steps[0], order);
  return least * share / (1.0 - share);
}

void require_convergence(const Finding& finding, Report& report) {
  const double error = error_of_reference(finding);
  report.add_result({{"model", finding.model.name},
                     {"reference_step_s", finding.model.reference_step},
                     {"reference_error", error}});
  if (!(error < kReferenceError))
    throw std::runtime_error(finding.model.name + ": the converged answer is not, but off by " +
                             percent(error));
}

/// Runs a model at all its steps.
Finding examine(PassesModel model, Table& table, Report& report) {
  const Course reference = record(model, model.reference_step);
  std::vector<Course> courses;
  for (const double step : model.steps) courses.push_back(record(model, step));
  Finding finding{std::move(model), {}, 0.0, 0.0};
  for (const PassesSpan& span : finding.model.spans) {
    const std::size_t first = first_of(span, finding.model);
    std::vector<Cell> cells;
    for (std::size_t k = 0; k < courses.size(); ++k) {
      cells.push_back({passes_in(courses[k], first), error_of(courses[k], reference, first)});
      add_row(finding.model, span, k, cells[k], courses[k], table, report);
    }
    if (finding.whole.empty()) finding.whole = std::move(cells);
  }
  finding.percent_step = find_step(finding.model, finding.whole, kPercent);
  finding.permille_step = find_step(finding.model, finding.whole, kPermille);
  return finding;
}

/// Steps that cost the same throughout, whatever the iteration of generalized_alpha does.
class Yardstick {
 public:
  Yardstick() : simulation_(make_scenario(), kSerial) {}

  double time() {  // least of several times [s]
    double least = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < 5; ++turn) {
      const double begin = processor_time();
      for (int k = 0; k < kYardstickSteps; ++k) simulation_.step();
      least = std::min(least, processor_time() - begin);
    }
    return least;
  }

 private:
  static Scenario make_scenario() {
    Scenario scenario = paper_rotor({});
    scenario.integration.method = IntegrationMethod::rk4;
    scenario.integration.step = kYardstickStep;
    scenario.integration.duration = 20.0;
    return scenario;
  }

  Simulation simulation_;
};

/// A run that is as accurate as asked.
struct Solution {
  double step = 0.0;    ///< [s]
  double passes = 0.0;  ///< a step
  double time = 0.0;    ///< [s]
  double ratio = 0.0;   ///< its time relative to the yardstick's
};

/// Runs at a step, as often as the time allows, in turns with the yardstick; the least counts.
Solution solve(const PassesModel& model, double step, double seconds, Yardstick& yardstick) {
  show_progress(model.name + ", whole run at " + graph::duration_text(step));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Solution solution{0.0, 0.0, kInfinity, 0.0};
  double unit = kInfinity, spent = 0.0;
  do {
    unit = std::min(unit, yardstick.time());
    Simulation simulation = simulate(model, step);
    const double begin = processor_time();
    simulation.run_until(kInfinity);
    const double time = processor_time() - begin;
    solution.step = simulation.step_size();
    solution.passes = passes_a_step(simulation);
    solution.time = std::min(solution.time, time);
    spent += time + unit;
  } while (spent < seconds);
  solution.ratio = solution.time / unit;
  return solution;
}

void add_solution_row(const PassesModel& model, double error, const Solution& solution,
                      const SolutionBefore& before, Table& table, Report& report) {
  const bool has_before = before.time > 0.0;
  table.rows.push_back({model.name, percent(error), graph::duration_text(solution.step),
                        figure(solution.passes), graph::duration_text(solution.time),
                        has_before ? graph::duration_text(before.step) : "",
                        has_before ? figure(before.passes) : "",
                        has_before ? figure(before.time / solution.ratio) : ""});
  report.add_result({{"model", model.name},
                     {"solution_error", error},
                     {"step_s", solution.step},
                     {"passes", solution.passes},
                     {"seconds", solution.time},
                     {"yardsticks", solution.ratio},
                     {"yardsticks_before", before.time}});
}

/// Makes and times the runs of a model that are accurate to 1 % and to 0.1 %.
void solve_both(const Finding& finding, double seconds, Yardstick& yardstick, Table& table,
                Report& report) {
  const PassesModel& model = finding.model;
  const Solution rough = solve(model, finding.percent_step, seconds, yardstick);
  add_solution_row(model, kPercent, rough, model.percent, table, report);
  const bool largest = finding.percent_step == model.steps.back();
  report.add_target(at_most(model.name + ", passes a step at " +
                                (largest ? "the largest step" : percent(kPercent) + " error"),
                            rough.passes, model.most_passes));
  const Solution fine = solve(model, finding.permille_step, seconds, yardstick);
  add_solution_row(model, kPermille, fine, model.permille, table, report);
  if (model.least_speedup > 0.0)
    report.add_target(
        at_least(model.name + " at " + percent(kPermille) + " error, faster than before, times",
                 model.permille.time / fine.ratio, model.least_speedup));
}

/// Adds the target promised for all steps from one on.
void add_target_of_all_steps(const Finding& finding, Report& report) {
  const PassesModel& model = finding.model;
  if (!(model.most_passes_from > 0.0)) return;
  double most = 0.0;
  for (std::size_t k = 0; k < model.steps.size(); ++k)
    if (model.steps[k] >= model.most_passes_from) most = std::max(most, finding.whole[k].passes);
  report.add_target(at_most(model.name + ", passes a step, most of " +
                                graph::duration_text(model.most_passes_from) + " to " +
                                graph::duration_text(model.steps.back()),
                            most, model.most_passes));
}

}  // namespace

void measure_passes(const QuestionOptions& options, Report& report) {
  Table table{"Passes a step of generalized_alpha, and the error of the history",
              {"model", "step", "passes", "before", "error", "an evaluation", "time"},
              {}};
  std::vector<Finding> findings;
  for (const PassesModel& model : make_passes_models())
    if (!options.quick || !model.slow) findings.push_back(examine(model, table, report));
  report.add_table(table);
  for (const Finding& finding : findings) require_convergence(finding, report);
  Yardstick yardstick;
  Table solutions{
      "Whole runs as accurate as asked; at the largest step in the table above if all are",
      {"model", "error", "step", "passes", "time", "step before", "passes", "faster, times"},
      {}};
  for (const Finding& finding : findings) {
    add_target_of_all_steps(finding, report);
    solve_both(finding, options.quick ? 0.0 : 3.0, yardstick, solutions, report);
  }
  report.add_table(solutions);
}

}  // namespace spoke::bench
