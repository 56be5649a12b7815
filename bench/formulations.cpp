// What does one evaluation of the accelerations cost, by formulation and size? One pass of the step
// graph that only evaluates (explicit, no integration), run by the serial executor, on the paper's
// model in the state that it reaches at 5 s of its spin-up, each coordinate then disturbed by up to
// a tenth. Undisturbed, elastic forces cancel except for a ten-millionth, and the accelerations,
// which remain, would agree to as many digits fewer.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "bench/compare/interleaved.h"
#include "bench/evaluated_model.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "graph/machine/duration_text.h"
#include "models/support/instructions.h"
#include "models/system/spatial_system.h"

namespace spoke::bench {
namespace {

constexpr RotorSize kSmall{3, 4, 4};
constexpr RotorSize kWide{24, 8, 8};
constexpr RotorSize kFine{3, 4, 64};
constexpr std::array kSizes{kSmall, RotorSize{3, 4, 16}, RotorSize{3, 16, 4}, kFine, kWide};

/// Returns a tolerance relative to the largest acceleration. The condition number of a clamped body
/// grows with E^3, and every formulation loses those digits alike.
double tolerance_for(int elements) { return 1e-11 * std::max(1.0, std::pow(elements / 4.0, 3)); }

/// Evaluates all models and demands that they agree with the last one. Returns the largest
/// difference.
template <class World>
double require_agreement(const std::string& name, double tolerance,
                         const std::vector<ModelPointer<World>>& models) {
  for (const ModelPointer<World>& model : models) model->evaluate();
  const Eigen::VectorXd reference = models.back()->accelerations();
  double largest = 0.0;
  for (const ModelPointer<World>& model : models) {
    const double difference =
        (model->accelerations() - reference).template lpNorm<Eigen::Infinity>() /
        reference.template lpNorm<Eigen::Infinity>();
    if (!(difference < tolerance))
      throw std::runtime_error("formulations disagree at " + name + ": accelerations by " +
                               std::to_string(difference * 1e12) + "e-12 of the largest");
    largest = std::max(largest, difference);
  }
  return largest;
}

template <class World>
Alternative make_alternative(std::string name, const ModelPointer<World>& model) {
  return {std::move(name), [model] { model->evaluate(); }, {}, 1.0, 0};
}

std::string scientific(double value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.0e", value);
  return text.data();
}

/// Returns the formulations to compare at a size; a quick run leaves out those that take seconds.
std::vector<Formulation> formulations_for(const RotorSize& size, bool quick) {
  std::vector<Formulation> all(formulations().begin(), formulations().end());
  const bool slow = size.total_elements() > 300;
  if (quick && slow) all.pop_back();
  return all;
}

void add_small_targets(const std::string& name, const std::vector<Timing>& timings,
                       double over_subsystem, double over_augmented, Report& report) {
  report.add_target(at_least("structured is faster than subsystem, " + name + ", times",
                             timings[1].ratio, over_subsystem));
  report.add_target(at_least("structured is faster than augmented, " + name + ", times",
                             timings[2].ratio, over_augmented));
}

/// Times the formulations of one system in turns, as rows of the table.
template <class World>
std::vector<Timing> compare(const std::string& name, const System<World>& system, double tolerance,
                            const std::vector<Formulation>& formulations, const Effort& effort,
                            Table& table, Report& report) {
  show_progress(name + ": building");
  const auto models = make_models(system, formulations);
  const std::string agreement = scientific(require_agreement(name, tolerance, models));
  std::vector<Alternative> alternatives;
  for (std::size_t k = 0; k < models.size(); ++k)
    alternatives.push_back(make_alternative(std::string(name_of(formulations[k])), models[k]));
  const std::vector<Timing> timings = measure(alternatives, effort);
  for (const Timing& timing : timings) {
    const bool first = &timing == &timings.front();
    table.rows.push_back({first ? name : "", timing.name, graph::duration_text(timing.least),
                          first ? "1" : ratio_with_spread(timing), std::to_string(timing.rounds),
                          first ? agreement : ""});
    report.add_timing(name, timing);
  }
  return timings;
}

void compare_formulations(const QuestionOptions& options, Report& report) {
  Table table{"One evaluation, by formulation; the formulations in turns at each size",
              {"(N,M,E)", "formulation", "time", "/ structured", "rounds", "agree to"},
              {}};
  const Effort effort = options.quick ? Effort{5, 1e-3, 1.0} : Effort{};
  for (const RotorSize& size : kSizes) {
    const std::vector<Timing> timings =
        compare(size.name(), make_system(paper_rotor(size).rotor), tolerance_for(size.elements),
                formulations_for(size, options.quick), effort, table, report);
    // In augmented, only the bodies' terms have kernels for wider vectors.
    const double over_augmented = kernels_in_use() == Kernels::baseline ? 100.0 : 250.0;
    if (&size == &kSizes.front())
      add_small_targets(size.name(), timings, 10.0, over_augmented, report);
  }
  const std::string name = "in space " + kSmall.name();
  const Scenario scenario = sized_rotor("spatial_wu_haug.toml", kSmall, false);
  add_small_targets(name,
                    compare(name, make_system(*scenario.space), 1e-9,
                            formulations_for(kSmall, options.quick), effort, table, report),
                    8.0, 60.0, report);
  report.add_table(table);
}

/// Measures the structured formulation: for each size without and with stiffening, in turns. Ratios
/// without stiffening are to the smallest size; with it, to the same size without.
std::vector<Timing> measure_structured(const QuestionOptions& options) {
  std::vector<Alternative> alternatives;
  for (const RotorSize& size : kSizes)
    for (const bool stiffening : {false, true}) {
      const auto model =
          make_models(make_system(paper_rotor(size, stiffening).rotor), {Formulation::structured})
              .front();
      alternatives.push_back(
          make_alternative(stiffening ? "structured, stiffening" : "structured", model));
      if (stiffening) alternatives.back().reference = static_cast<int>(alternatives.size()) - 2;
    }
  return measure(alternatives, options.quick ? Effort{5, 1e-3, 1.0} : Effort{101, 1e-3, 12.0});
}

double cost_per_element(const RotorSize& size, const Timing& timing) {
  return timing.ratio * kSmall.total_elements() / size.total_elements();
}

void add_structured_targets(const std::vector<Timing>& timings, Report& report) {
  double most_stiffening = 0.0;
  for (std::size_t k = 0; k < kSizes.size(); ++k) {
    most_stiffening = std::max(most_stiffening, timings[2 * k + 1].ratio);
    const std::string name = kSizes[k].name();
    if (name != kFine.name() && name != kWide.name()) continue;
    report.add_target(
        at_most("structured, cost per element, " + name + " / " + kSmall.name() + ", times",
                cost_per_element(kSizes[k], timings[2 * k]), 1.5));
  }
  report.add_target(
      at_most("structured, stiffening on / off, worst size, times", most_stiffening, 1.2));
}

/// Splits the cost into that of a body and that of an element, by the sizes that differ in E only.
void add_cost_split(const std::vector<Timing>& timings, Report& report) {
  double small = 0.0, fine = 0.0;
  for (std::size_t k = 0; k < kSizes.size(); ++k) {
    if (kSizes[k].name() == kSmall.name()) small = timings[2 * k].least;
    if (kSizes[k].name() == kFine.name()) fine = timings[2 * k].least;
  }
  const double element = (fine - small) / (kFine.total_elements() - kSmall.total_elements());
  const double body = (small - element * kSmall.total_elements()) / (kSmall.blades * kSmall.bodies);
  report.add_remark(
      "  From " + kSmall.name() + " to " + kFine.name() + ": about " + figure(body * 1e9) +
      " ns a body and " + figure(element * 1e9) +
      " ns an element,\n  so that an element of a coarse body is dearer than one of a fine body.");
}

void scale_structured(const QuestionOptions& options, Report& report) {
  const std::vector<Timing> timings = measure_structured(options);
  Table table{"structured alone; all sizes in turns",
              {"(N,M,E)", "elements", "time", "per element", "/ " + kSmall.name(), "stiffening on",
               "/ off"},
              {}};
  for (std::size_t k = 0; k < kSizes.size(); ++k) {
    const RotorSize& size = kSizes[k];
    const Timing& off = timings[2 * k];
    const Timing& on = timings[2 * k + 1];
    const int elements = size.total_elements();
    table.rows.push_back({size.name(), std::to_string(elements), graph::duration_text(off.least),
                          figure(off.least / elements * 1e9) + " ns",
                          figure(cost_per_element(size, off)), graph::duration_text(on.least),
                          ratio_with_spread(on)});
    report.add_timing(size.name() + ", structured alone", off);
    report.add_timing(size.name() + ", structured alone", on);
  }
  report.add_table(table);
  add_cost_split(timings, report);
  add_structured_targets(timings, report);
}

}  // namespace

void measure_formulations(const QuestionOptions& options, Report& report) {
  compare_formulations(options, report);
  scale_structured(options, report);
}

}  // namespace spoke::bench
