// What does `auto` gain, or cost, a user who starts `spoke run`? Pairs of whole processes, auto
// against serial, one right after the other, on runs that take serial 0.1 to 10 s, on the machine
// as it is and beside a process that keeps one processor busy. The worth of another thread in the
// quiet part is measured before and after each row, and targets of speed hold where both were above
// 1.8: otherwise the machine may be busy, or two processors be one core.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/whole_processes.h"
#include "graph/calibrate/capacity.h"
#include "graph/calibrate/quantiles.h"
#include "graph/executor.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

/// A shipped scenario with changes, and the gains that auto promises on it.
struct Model {
  std::string name, scenario;
  std::vector<std::string> settings;
  bool promises_gain = false;
};

std::vector<Model> make_models(bool quick) {
  const Model small{"(3,4,4)", "wu_haug_rotor", {}, true};
  if (quick) return {small};
  return {small,
          {"(24,8,8)", "large_rotor", {}, true},
          {"(2,4,4)", "wu_haug_rotor", {"blade.count=2"}, false},
          {"free hub", "free_hub_satellite", {}, false},
          {"(96,8,8)", "large_rotor", {"blade.count=96"}, false}};
}

/// The serial time of runs, the number of pairs, and the promise.
struct Length {
  double seconds;
  int pairs;
  double promised_gain;
};

std::vector<Length> make_lengths(bool quick) {
  if (quick) return {{0.1, 3, 1.3}};
  return {{0.1, 7, 1.3}, {0.5, 7, 1.6}, {2.0, 7, 1.75}, {10.0, 3, 1.75}};
}

std::string scenario_file(const Model& model) {
  return std::filesystem::path(SPOKE_MODELS_DIR) / (model.scenario + ".toml");
}

std::vector<std::string> arguments_of(const Model& model, double duration,
                                      const std::string& executor) {
  std::vector<std::string> arguments{
      "run", scenario_file(model), "--executor", executor, "--no-report", "--quiet", "--out"};
  arguments.push_back(std::filesystem::temp_directory_path() / "spoke_bench_whole_runs");
  for (const std::string& setting : model.settings)
    arguments.insert(arguments.end(), {"--set", setting});
  arguments.insert(arguments.end(), {"--set", fmt::format("integration.duration={}", duration),
                                     "--set", "output.interval=1"});
  return arguments;
}

/// Returns the duration of a simulation that takes about `seconds` serially [s].
double duration_for(const Model& model, double seconds) {
  double duration = 5.0;
  double taken = 0.0;
  const double start = seconds_of_process({"--version"});
  while (true) {
    taken = seconds_of_process(arguments_of(model, duration, "serial")) - start;
    if (taken > 0.3 || taken > 0.5 * seconds) break;
    duration *= 3.0;
  }
  return duration * seconds / taken;
}

struct Pairs {
  double serial = 0.0;  ///< s, median
  double autos = 0.0;   ///< s, median
  double ratio = 0.0;   ///< median of serial / auto
};

Pairs measure_pairs(const Model& model, double duration, int count) {
  std::vector<double> serial, autos, ratios;
  for (int k = 0; k < count; ++k) {
    serial.push_back(seconds_of_process(arguments_of(model, duration, "serial")));
    autos.push_back(seconds_of_process(arguments_of(model, duration, "auto")));
    ratios.push_back(serial.back() / autos.back());
  }
  return {graph::median(serial), graph::median(autos), graph::median(ratios)};
}

void measure_row(const Model& model, const Length& length, double duration, bool is_quiet,
                 Table& table, Report& report) {
  show_progress(fmt::format("{}, {} s{}", model.name, length.seconds, is_quiet ? "" : ", busy"));
  const int threads = graph::available_threads();
  std::optional<BusyProcess> other;
  if (!is_quiet) other.emplace();
  const double before = graph::measure_capacity(threads, 0.1);
  const Pairs pairs = measure_pairs(model, duration, length.pairs);
  const double capacity = std::min(before, graph::measure_capacity(threads, 0.1));
  const std::string row =
      fmt::format("{}, {} s, {}", model.name, length.seconds, is_quiet ? "quiet" : "busy");
  table.rows.push_back({row, graph::duration_text(pairs.serial), graph::duration_text(pairs.autos),
                        figure(pairs.ratio), figure(capacity)});
  report.add_result({{"row", row},
                     {"serial_s", pairs.serial},
                     {"auto_s", pairs.autos},
                     {"serial_over_auto", pairs.ratio},
                     {"capacity", capacity}});
  report.add_target(
      at_most("auto - serial [s], " + row, pairs.autos - pairs.serial, 0.03 * pairs.serial + 5e-3));
  if (is_quiet && model.promises_gain && capacity > 1.8)
    report.add_target(at_least("serial / auto, " + row, pairs.ratio, length.promised_gain));
}

}  // namespace

void measure_whole_runs(const QuestionOptions& options, Report& report) {
  for (const Model& model : make_models(options.quick)) {
    Table table{"Whole runs of " + model.name + ", medians of pairs",
                {"model, serial time", "serial", "auto", "serial / auto", "capacity"},
                {}};
    for (const Length& length : make_lengths(options.quick)) {
      const double duration = duration_for(model, length.seconds);
      for (const bool is_quiet : {true, false})
        measure_row(model, length, duration, is_quiet, table, report);
    }
    report.add_table(table);
  }
}

}  // namespace spoke::bench
