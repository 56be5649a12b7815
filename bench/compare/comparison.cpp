// From samples to times, speedups, bounds and the best configuration.

#include "bench/compare/comparison.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

#include "bench/compare/statistics.h"

namespace spoke::compare {
namespace {

bool is_serial(const Measurement& measurement) {
  return measurement.configuration.executor == ExecutorKind::serial;
}

bool hashes_agree(const Measurement& measurement, const Measurement& serial) {
  const auto& ours = measurement.hashes;
  return !ours.empty() && ours.size() <= serial.hashes.size() &&
         std::equal(ours.begin(), ours.end(), serial.hashes.begin());
}

Figures calc_figures(const Result& result, const Model& model, int processors,
                     const Capacity& capacity) {
  const std::vector<double>& times = result.measurement.step_times;
  const int threads = std::min(result.measurement.configuration.threads.total(), processors);
  const Quartiles speedup = quartiles_of(result.speedups);
  Figures figures{.mean = mean(times),
                  .deviation = standard_deviation(times),
                  .median = median(times),
                  .speedup = speedup.median,
                  .speedup_low = speedup.low,
                  .speedup_high = speedup.high};
  figures.bound = std::max(model.serial_step / threads, model.span_step);
  figures.ratio_to_bound = figures.median / figures.bound;
  if (capacity.is_known())
    figures.bound_at_capacity = capacity.bound(model.serial_step, model.span_step, threads);
  return figures;
}

Result evaluate(Measurement measurement, const Measurement& serial, const Model& model,
                const Comparison& comparison) {
  const int processors = comparison.machine.cores;
  Result result{.measurement = std::move(measurement)};
  result.hash_equal = hashes_agree(result.measurement, serial);
  result.oversubscribed = result.measurement.configuration.threads.total() > processors;
  result.speedups = ratios(serial.step_times, result.measurement.step_times);
  if (!result.speedups.empty())
    result.figures = calc_figures(result, model, processors, comparison.capacity);
  return result;
}

/// Returns the fastest other result with serial's bits, or null if there is none.
const Result* fastest_rival(const Comparison& comparison, Formulation formulation) {
  const Result* best = nullptr;
  for (const Result& result : comparison.results) {
    if (!belongs_to(result, formulation) || is_serial(result.measurement)) continue;
    if (!result.figures || !result.hash_equal) continue;
    if (best == nullptr || result.figures->speedup > best->figures->speedup) best = &result;
  }
  return best;
}

}  // namespace

const Model& model_of(const Comparison& comparison, Formulation formulation) {
  for (const Model& model : comparison.models)
    if (model.formulation == formulation) return model;
  throw std::logic_error("a formulation that was not compared");
}

void evaluate(Comparison& comparison, std::vector<Measurement> measurements) {
  assert(!comparison.models.empty() && !measurements.empty());
  for (Model& model : comparison.models) {
    const auto of_model = [&](const Measurement& measurement) {
      return measurement.configuration.formulation == model.formulation;
    };
    const auto found =
        std::find_if(measurements.begin(), measurements.end(),
                     [&](const Measurement& m) { return of_model(m) && is_serial(m); });
    if (found == measurements.end()) throw std::logic_error("no serial configuration");
    const Measurement serial = *found;
    if (!serial.step_times.empty()) model.serial_step = median(serial.step_times);
    if (model.pass.work > 0.0)
      model.span_step = model.serial_step * model.pass.span / model.pass.work;
    for (Measurement& measurement : measurements)
      if (of_model(measurement))
        comparison.results.push_back(evaluate(std::move(measurement), serial, model, comparison));
  }
}

bool is_serial(const Result& result) { return is_serial(result.measurement); }

bool belongs_to(const Result& result, Formulation formulation) {
  return result.measurement.configuration.formulation == formulation;
}

bool Verdict::is_winner(const Result& result) const {
  if (kind == Kind::rival_wins) return &result == rival;
  return kind == Kind::serial_wins && is_serial(result) &&
         belongs_to(result, rival->measurement.configuration.formulation);
}

Verdict judge(const Comparison& comparison, Formulation formulation) {
  using Kind = Verdict::Kind;
  constexpr double kTrifle = 0.03;
  constexpr double kPossible = 0.93;  // times the bound; a lower time is an error of measurement
  if (!(model_of(comparison, formulation).serial_step > 0.0)) return {};
  const Result* rival = fastest_rival(comparison, formulation);
  if (rival == nullptr) return {Kind::no_rival, nullptr};
  const Figures& figures = *rival->figures;
  if (figures.ratio_to_bound < kPossible) return {Kind::disturbed, rival};
  if (figures.speedup_low > 1.0 + kTrifle) return {Kind::rival_wins, rival};
  if (figures.speedup_high < 1.0 - kTrifle) return {Kind::serial_wins, rival};
  return {Kind::undecided, rival};
}

}  // namespace spoke::compare
