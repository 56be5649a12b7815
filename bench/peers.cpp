// How long do problems take that other programs have been timed on? docs/peers.md has their
// figures. Serial, through spoke::Simulation, sensors of the last step of each sample only:
//
//   a uniform blade of 61.5 m under sudden gravity, bench/uniform_blade.toml, at rest and in spin:
//   by bodies and step, the time of the run and its error, the largest difference of the tip's
//   place out of the plane of rotation from bench/uniform_blade.csv as a fraction of the largest
//   one. A target is the least time within an error;
//
//   four-bar linkages in a row, models/four_bar.toml: the time of a step, and the error of a corner
//   after 10 s. The bars stay parallel, so that an equation in one angle is the reference.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/four_bars.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/repeated_steps.h"
#include "engine/simulation.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

constexpr double kSampling = 0.1;  // s, rows of the reference
constexpr std::array kBodies{2, 3, 4, 8, 16};
constexpr std::array kSteps{0.1, 0.05, 0.025, 0.0125, 0.005, 0.0025};  // s, parts of kSampling
constexpr std::array kErrors{1e-2, 2e-3, 7e-4};
constexpr std::array kRows{2, 10, 40};

SimulationOptions serial() { return {Formulation::structured, ExecutorKind::serial, 1}; }

std::size_t find_sensor(const Simulation& simulation, std::string_view name) {
  const auto& names = simulation.sensor_names();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw std::runtime_error(fmt::format("no sensor is named {}", name));
  return static_cast<std::size_t>(at - names.begin());
}

/// A motion of the blade, and the converged places of its tip.
struct Motion {
  const char* name;
  std::size_t column;  ///< of the reference
  double speed;        ///< [rad/s]
};
constexpr std::array kMotions{Motion{"at rest", 1, 0.0}, Motion{"in spin", 2, 1.267109}};

/// Returns a column of bench/uniform_blade.csv, whose first line has names.
std::vector<double> read_reference(std::size_t column) {
  std::ifstream file(std::filesystem::path(SPOKE_BENCH_DIR) / "uniform_blade.csv");
  std::vector<double> values;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < column; ++k) begin = line.find(',', begin) + 1;
    values.push_back(std::stod(line.substr(begin)));
  }
  if (values.empty()) throw std::runtime_error("bench/uniform_blade.csv: has no rows");
  return values;
}

Scenario make_blade(const Motion& motion, int bodies, double step) {
  std::vector<std::string> settings{fmt::format("blade.bodies={}", bodies),
                                    fmt::format("integration.step={}", step)};
  if (motion.speed != 0.0) {
    settings.emplace_back("hub.drive.kind=constant");
    settings.push_back(fmt::format("hub.drive.speed={}", motion.speed));
  }
  return read_scenario(std::filesystem::path(SPOKE_BENCH_DIR) / "uniform_blade.toml", settings);
}

/// A run of the blade, and what came of it.
struct Run {
  int bodies = 0;
  double step = 0.0;   ///< [s]
  double error = 0.0;  ///< as a fraction of the largest place
};

/// Runs to the end, and returns the error.
double run(const std::vector<double>& reference, Simulation& simulation) {
  const std::size_t tip = find_sensor(simulation, "blade1.tip.z");
  double most = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    simulation.run_until(kSampling * static_cast<double>(k));
    most = std::max(most, std::abs(simulation.sensor_values()[tip] - reference[k]));
    largest = std::max(largest, std::abs(reference[k]));
  }
  return most / largest;
}

/// Makes an alternative whose time is that of a whole run, without its start.
Alternative time_run(const Motion& motion, const Run& what) {
  const auto slot = std::make_shared<std::optional<Simulation>>();
  const auto scenario =
      std::make_shared<const Scenario>(make_blade(motion, what.bodies, what.step));
  return {fmt::format("{} bodies, {}", what.bodies, graph::duration_text(what.step)),
          [slot, scenario] { (*slot)->run_until(scenario->integration.duration); },
          [slot, scenario] { slot->emplace(*scenario, serial()); }, 1.0, 0};
}

void measure_blade(const Motion& motion, const QuestionOptions& options, Report& report) {
  const std::vector<double> reference = read_reference(motion.column);
  std::vector<Run> runs;
  std::vector<Alternative> alternatives;
  for (const int bodies : kBodies)
    for (const double step : kSteps) {
      if (options.quick && (bodies > 3 || step < 0.02)) continue;
      show_progress(fmt::format("blade {}: {} bodies", motion.name, bodies));
      Simulation simulation(make_blade(motion, bodies, step), serial());
      runs.push_back({bodies, step, run(reference, simulation)});
      alternatives.push_back(time_run(motion, runs.back()));
    }
  const Effort effort = options.quick ? Effort{2, 1e-3, 0.2} : Effort{11, 1e-3, 2.0};
  const std::vector<Timing> timings = measure(alternatives, effort);
  Table table{fmt::format("Uniform blade under sudden gravity, {}: 5 s, serial", motion.name),
              {"bodies", "step", "error", "time", "rounds"},
              {}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    table.rows.push_back({std::to_string(runs[k].bodies), graph::duration_text(runs[k].step),
                          fmt::format("{:.2g} %", 100.0 * runs[k].error),
                          graph::duration_text(timings[k].least),
                          std::to_string(timings[k].rounds)});
    report.add_timing(fmt::format("uniform blade {}", motion.name), timings[k]);
    report.add_result({{"model", fmt::format("uniform blade {}", motion.name)},
                       {"bodies", runs[k].bodies},
                       {"step_s", runs[k].step},
                       {"error", runs[k].error}});
  }
  report.add_table(table);
  for (const double error : kErrors) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (runs[k].error <= error) least = std::min(least, timings[k].least);
    report.add_remark(fmt::format("  within {:.2g} %     {}", 100.0 * error,
                                  std::isfinite(least) ? graph::duration_text(least) : "none"));
  }
}

/// Returns the corner of the first bar of a row [m], by the equation of their angle from the
/// horizontal: (N + 1)/3 + N of inertia, (N + 1)/2 + N of weight times g cos(theta).
std::array<double, 2> swing(int linkages, double duration) {
  constexpr double kGravity = 9.81;
  constexpr int kParts = 200000;
  const double n = linkages;
  const double factor = kGravity * (0.5 * (n + 1.0) + n) / ((n + 1.0) / 3.0 + n);
  const auto rate = [factor](double angle) { return -factor * std::cos(angle); };
  double angle = 0.5 * std::numbers::pi, speed = -1.0;
  const double h = duration / kParts;
  for (int k = 0; k < kParts; ++k) {  // the method of Runge and Kutta of order 4, by Nystroem
    const double k1 = rate(angle), k2 = rate(angle + 0.5 * h * speed + 0.125 * h * h * k1);
    const double k3 = rate(angle + h * speed + 0.5 * h * h * k2);
    angle += h * speed + h * h / 6.0 * (k1 + 2.0 * k2);
    speed += h / 6.0 * (k1 + 4.0 * k2 + k3);
  }
  return {std::cos(angle), std::sin(angle)};
}

void measure_rows(const QuestionOptions& options, Report& report) {
  constexpr int kTimedSteps = 50;
  const auto sensors =
      read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / "four_bar.toml").sensors;
  std::vector<Alternative> alternatives;
  std::vector<double> errors;
  for (const int count : kRows) {
    if (options.quick && count == kRows.back()) continue;
    show_progress(fmt::format("{} four-bars", count));
    Scenario scenario = row_of_four_bars(count);
    alternatives.push_back(RepeatedSteps::alternative(
        std::to_string(count),
        std::make_shared<RepeatedSteps>(scenario, serial(), 0.0, kTimedSteps), 0));
    scenario.sensors = sensors;
    Simulation simulation(scenario, serial());
    simulation.run_until(scenario.integration.duration);
    const auto [x, y] = swing(count, scenario.integration.duration);
    const auto& values = simulation.sensor_values();
    errors.push_back(std::hypot(values[find_sensor(simulation, "linkage.B0.x")] - x,
                                1.0 + values[find_sensor(simulation, "linkage.B0.y")] - y));
  }
  const Effort effort = options.quick ? Effort{3, 1e-3, 0.5} : Effort{31, 1e-3, 4.0};
  const std::vector<Timing> timings = measure(alternatives, effort);
  Table table{"Four-bar linkages in a row, one subsystem, steps of 5 ms, serial; in turns",
              {"linkages", "a step", "of it each", "error after 10 s [m]", "rounds"},
              {}};
  for (std::size_t k = 0; k < timings.size(); ++k) {
    table.rows.push_back({timings[k].name, graph::duration_text(timings[k].least),
                          graph::duration_text(timings[k].least / kRows[k]),
                          fmt::format("{:.2g}", errors[k]), std::to_string(timings[k].rounds)});
    report.add_timing("four-bars", timings[k]);
    report.add_result({{"model", "four-bars"}, {"linkages", kRows[k]}, {"error_m", errors[k]}});
  }
  report.add_table(table);
}

}  // namespace

void measure_peers(const QuestionOptions& options, Report& report) {
  for (const Motion& motion : kMotions) measure_blade(motion, options, report);
  measure_rows(options, report);
}

}  // namespace spoke::bench
