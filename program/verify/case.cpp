// Names and units of cases, and their commands.

#include "program/verify/case.h"

#include <spdlog/fmt/fmt.h>

#include <numbers>

namespace spoke::verify {
namespace {

struct Unit {
  std::string_view name;
  double factor;  ///< from SI
};

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr Unit kUnits[] = {
    {"", 1.0},
    {"rad", 1.0},
    {"rad/s", 1.0},
    {"1/s", 1.0},
    {"m", 1.0},
    {"s", 1.0},
    {"N", 1.0},
    {"N m", 1.0},
    {"W", 1.0},
    {"m/s", 1.0},
    {"J", 1.0},
    {"kg m^2/s", 1.0},
    {"Hz", 1.0 / kTurn},
    {"rpm", 60.0 / kTurn},
    {"deg", 360.0 / kTurn},
    {"mm", 1e3},
    {"kN", 1e-3},
    {"kN m", 1e-3},
    {"kW", 1e-3},
    {"MW", 1e-6},
};

/// Returns an option with the first of its values; the command line takes one, or a range.
std::string describe_list(const char* option, const std::vector<double>& values,
                          double factor = 1.0) {
  return values.empty() ? "" : fmt::format("{}{}", option, values.front() * factor);
}

std::string describe_options(const Analysis& analysis) {
  std::string text;
  if (analysis.kind == AnalysisKind::critical)
    text += fmt::format(" --of {} --from {} --to {} --points {}", analysis.critical.of,
                        analysis.critical.from, analysis.critical.to, analysis.critical.points);
  const PerformanceOptions& performance = analysis.performance;
  text += describe_list(" --wind ", performance.wind);
  text += describe_list(" --tip-speed-ratio ", performance.tip_speed_ratio);
  text += describe_list(" --pitch ", performance.pitch, factor_of_unit("deg"));
  if (performance.is_rigid) text += " --rigid";
  if (analysis.state.speed) text += fmt::format(" --speed {}", *analysis.state.speed);
  if (analysis.frame) {
    constexpr const char* kFrames[] = {"turning", "fixed", "floquet"};
    text += fmt::format(" --frame {}", kFrames[static_cast<std::size_t>(*analysis.frame)]);
  }
  if (analysis.count) text += fmt::format(" --count {}", *analysis.count);
  return text;
}

}  // namespace

std::string_view name_of(AnalysisKind kind) {
  switch (kind) {
    case AnalysisKind::steady:
      return "static";
    case AnalysisKind::modes:
      return "modes";
    case AnalysisKind::critical:
      return "critical";
    case AnalysisKind::performance:
      return "performance";
    case AnalysisKind::linearize:
      return "linearize";
    case AnalysisKind::run:
      break;
  }
  return "run";
}

double factor_of_unit(std::string_view unit) {
  for (const Unit& one : kUnits)
    if (one.name == unit) return one.factor;
  return 0.0;
}

std::string command_of(const Case& one, const std::string& folder) {
  std::string text =
      fmt::format("spoke {} {}{}.toml", name_of(one.analysis.kind), folder, one.scenario);
  text += describe_options(one.analysis);
  for (const std::string& assignment : one.overrides)
    text += fmt::format(" --set '{}'", assignment);
  return text;
}

}  // namespace spoke::verify
