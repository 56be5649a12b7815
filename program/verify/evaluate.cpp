// Chooses the analysis of a case, and reads figures of steady states, modes and critical values.

#include "program/verify/evaluate.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "models/error.h"
#include "models/support/nearest_name.h"
#include "program/verify/answer.h"
#include "program/verify/measure_run.h"
#include "program/verify/steady_figures.h"

namespace spoke::verify {
namespace {

[[noreturn]] void refuse_quantity(const Figure& figure, std::span<const std::string_view> known) {
  throw InputError("figure \"" + figure.name + "\": quantity " +
                   describe_unknown(figure.quantity, known));
}

const Mode& find_mode(const std::vector<Mode>& modes, const Figure& figure) {
  int left = figure.number;
  for (const Mode& mode : modes) {
    const bool fits = figure.of.empty() || mode.name == figure.of || mode.kind == figure.of;
    if (fits && --left == 0) return mode;
  }
  std::string names;
  for (const Mode& mode : modes) names += (names.empty() ? "" : ", ") + mode.name;
  throw InputError("figure \"" + figure.name + "\": mode \"" + figure.of + "\" number " +
                   std::to_string(figure.number) + " is not among " + names);
}

double mode_figure(const std::vector<Mode>& modes, const Figure& figure) {
  const Mode& mode = find_mode(modes, figure);
  if (figure.quantity == "frequency") return mode.frequency;
  if (figure.quantity == "growth") return mode.eigenvalue.real();
  if (figure.quantity == "magnitude") return std::abs(mode.eigenvalue);
  if (figure.quantity == "square") return (mode.eigenvalue * mode.eigenvalue).real();
  if (figure.quantity == "damping ratio") return mode.damping_ratio;
  refuse_quantity(figure, {{"frequency", "growth", "magnitude", "square", "damping ratio"}});
}

double critical_figure(const CriticalResult& result, const Figure& figure) {
  if (!result.critical) throw InputError("there is no critical value in the range");
  const CriticalPoint& point = *result.critical;
  if (!figure.of.empty() && name_of(point.kind) != figure.of)
    throw InputError("what ends the equilibrium is a " + std::string(name_of(point.kind)) +
                     ", expected a " + figure.of);
  if (figure.quantity == "value") return point.value;
  if (figure.quantity == "frequency") return point.frequency;
  refuse_quantity(figure, {{"value", "frequency"}});
}

double performance_figure(const PerformanceResult& result, const Figure& figure) {
  const auto number = static_cast<std::size_t>(figure.number);
  if (number > result.points.size())
    throw InputError("figure \"" + figure.name + "\": there are only " +
                     std::to_string(result.points.size()) + " points");
  const PerformancePoint& point = result.points[number - 1];
  if (!point.gap.empty()) throw InputError(point.gap);
  if (figure.quantity == "power") return point.power;
  if (figure.quantity == "thrust") return point.thrust;
  if (figure.quantity == "torque") return point.torque;
  if (figure.quantity == "power coefficient") return point.power_coefficient;
  if (figure.quantity == "thrust coefficient") return point.thrust_coefficient;
  if (figure.quantity == "speed") return point.speed;
  if (figure.quantity == "pitch") return point.pitch;
  refuse_quantity(figure, {{"power", "thrust", "torque", "power coefficient", "thrust coefficient",
                            "speed", "pitch"}});
}

/// Reads all figures of a result by `read`.
template <class Result, class Read>
std::vector<double> read_all(const Result& result, const Case& one, const Read& read) {
  std::vector<double> values;
  for (const Figure& figure : one.figures) values.push_back(read(result, figure));
  return values;
}

CriticalResult find_critical(const Analysis& analysis, const Scenario& scenario) {
  CriticalOptions options = analysis.critical;
  options.state = analysis.state;
  options.count = analysis.count;
  options.frame = analysis.frame;
  return solve_critical(scenario, options);
}

std::vector<double> evaluate_in_si(const Case& one, const Scenario& scenario) {
  const Analysis& analysis = one.analysis;
  switch (analysis.kind) {
    case AnalysisKind::steady:
      return read_all(solve_equilibrium(scenario, analysis.state), one, read_steady);
    case AnalysisKind::modes:
      return read_all(solve_modes(scenario, {analysis.state, analysis.count, analysis.frame}).modes,
                      one, mode_figure);
    case AnalysisKind::critical:
      return read_all(find_critical(analysis, scenario), one, critical_figure);
    case AnalysisKind::performance:
      return read_all(solve_performance(scenario, analysis.performance), one, performance_figure);
    case AnalysisKind::linearize:
      return read_all(solve_linear_system(scenario, analysis.state), one, read_answer);
    case AnalysisKind::run:
      break;
  }
  return measure_run(one, scenario);
}

}  // namespace

std::vector<double> evaluate(const Case& one, const Scenario& scenario) {
  std::vector<double> values = evaluate_in_si(one, scenario);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] *= one.figures[k].times * factor_of_unit(one.figures[k].unit);
  return values;
}

}  // namespace spoke::verify
