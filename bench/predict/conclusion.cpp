// The sentences of the conclusion, a function for each.

#include "bench/predict/conclusion.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "graph/machine/duration_text.h"
#include "models/count_text.h"

namespace spoke::predict {
namespace {

constexpr double kEqual = 1.03;  // ratio of times up to which two executors are equally good
constexpr double kPays = 1.05;   // gain below which more threads do not pay

const Series* find_series(const Prediction& prediction, ExecutorKind kind) {
  const auto found = std::find_if(prediction.series.begin(), prediction.series.end(),
                                  [kind](const Series& series) { return series.executor == kind; });
  return found == prediction.series.end() ? nullptr : &*found;
}

/// Returns the point of the fewest threads beyond which more threads gain less than a twentieth.
const Point& last_that_pays(const Series& series) {
  double least = series.points.front().step.expected;
  for (const Point& point : series.points) least = std::min(least, point.step.expected);
  return *std::find_if(series.points.begin(), series.points.end(), [least](const Point& point) {
    return point.step.expected <= kPays * least;
  });
}

std::string threads_text(int threads) { return counted(threads, "thread"); }

std::string describe_disturbance(const Prediction& prediction) {
  if (!is_busy(prediction.load_before, prediction.machine.cores)) return "";
  return fmt::format(
      "Other work was running (load average {:.2f} at the start): costs of nodes and runtimes are "
      "too high, measured times too long, and none of what follows is certain until it is repeated "
      "on an idle machine.",
      prediction.load_before);
}

/// Describes the bounds that no executor of this graph can beat.
std::string bound_text(const RunGraph& run, const char* whose) {
  return fmt::format(
      "In {}{}, a step is {} of work, {} of it on the costliest path, and whatever the number of "
      "threads no executor is then more than {:.1f} times as fast as one thread.",
      describe_runs(run), whose, graph::duration_text(run.work), graph::duration_text(run.span),
      run.parallelism());
}

std::string describe_bound(const Prediction& prediction) {
  if (!prediction.auto_run) return bound_text(prediction.run, "");
  return bound_text(prediction.run, ", which all but auto make") + ' ' +
         bound_text(*prediction.auto_run, ", which auto makes");
}

std::string describe_limit(const Prediction& prediction) {
  const Series* const series = find_series(prediction, ExecutorKind::automatic);
  if (series == nullptr) return "";
  const Point& last = last_that_pays(*series);
  const Point& most = series->points.back();
  if (prediction.speedup(last) < kPays)
    return fmt::format(
        "More threads do not pay: auto runs serially, or gains less than a "
        "twentieth, on up to {}.",
        threads_text(most.threads));
  const std::string gain = fmt::format(
      "auto, in {}, {:.2f} times serial's speed on {} ({:.2f} to {:.2f})",
      describe_runs(prediction.auto_run.value_or(prediction.run)), prediction.speedup(last),
      threads_text(last.threads), prediction.serial.step.expected / last.step.pessimistic,
      prediction.serial.step.expected / last.step.optimistic);
  if (&last == &most)
    return fmt::format("More threads pay up to the {} looked at: {}.", most.threads, gain);
  return fmt::format("More threads stop paying at {}: {}; {} give {:.2f}.", last.threads, gain,
                     most.threads, prediction.speedup(most));
}

/// Says on which numbers of threads the levels are better, and on which the graph.
std::string describe_levels(const Prediction& prediction) {
  const Series* const levels = find_series(prediction, ExecutorKind::openmp_levels);
  const Series* const graph = find_series(prediction, ExecutorKind::automatic);
  if (levels == nullptr || graph == nullptr) return "";
  std::vector<int> as_good;
  const Point* worst = nullptr;
  double gain = kEqual;  // largest gain of the graph
  for (std::size_t k = 0; k < levels->points.size(); ++k) {
    const Point& point = levels->points[k];
    if (point.threads == 1) continue;
    const double ratio = point.step.expected / graph->points[k].step.expected;
    if (ratio <= kEqual) as_good.push_back(point.threads);
    if (ratio <= gain) continue;
    gain = ratio;
    worst = &point;
  }
  const std::string most = worst == nullptr
                               ? ""
                               : fmt::format("auto is up to {:.2f} times as fast (on {})", gain,
                                             threads_text(worst->threads));
  if (as_good.empty()) return worst == nullptr ? "" : "Against openmp_levels, " + most + ".";
  return fmt::format(
      "Level by level (openmp_levels) is as good as the graph or better on {} threads{}.",
      fmt::join(as_good, ", "), worst == nullptr ? "" : "; elsewhere " + most);
}

/// Says how many processes pay.
std::string describe_ranks(const Prediction& prediction) {
  std::vector<RankPoint> several;
  for (const RankPoint& point : prediction.ranks)
    if (point.ranks > 1) several.push_back(point);
  if (several.empty()) return "";
  const auto slower = [](const RankPoint& a, const RankPoint& b) { return a.step() < b.step(); };
  const double least = std::min_element(several.begin(), several.end(), slower)->step();
  const RankPoint& last =
      *std::find_if(several.begin(), several.end(),
                    [least](const RankPoint& point) { return point.step() <= kPays * least; });
  const double gain = prediction.speedup(last);
  if (gain < kPays)
    return fmt::format("Several processes do not pay: {} give {:.2f} times serial's speed.",
                       last.ranks, gain);
  return fmt::format(
      "Processes of one thread each pay up to {} of those looked at: {:.2f} times serial's speed, "
      "{:.0f} % of the time on the network.",
      last.ranks, gain, 100.0 * last.telling / last.step());
}

/// Describes the error of a prediction: in per cent, or as a factor if it is far too low.
std::string describe_error(double error) {
  if (error > -0.75) return fmt::format("{:+.1f} % off", 100.0 * error);
  return fmt::format("too low by a factor of {:.3g}", 1.0 / (1.0 + error));
}

std::string describe_errors(const Prediction& prediction) {
  double largest = 0.0;
  int points = 0;
  const auto add = [&](const Point& point) {
    if (!point.error()) return;
    ++points;
    if (std::abs(*point.error()) > std::abs(largest)) largest = *point.error();
  };
  add(prediction.serial);
  for (const Series& series : prediction.series)
    for (const Point& point : series.points) add(point);
  if (points == 0) return "Nothing was measured to check the predictions.";
  return fmt::format(
      "Of {} checked on this machine the worst is {}; those for "
      "more threads than it has processors ({}) are extrapolations, to processors equal to this "
      "one that do not compete for caches and memory.",
      counted(points, "prediction"), describe_error(largest), prediction.machine.cores);
}

/// Names the executors of the build that are not predicted.
std::string describe_left_out() {
  std::vector<std::string_view> names;
  for (const ExecutorKind kind : left_out_executors()) names.push_back(graph::name_of(kind));
  if (names.empty()) return "";
  return fmt::format(
      "Not predicted: {}, since what it costs to start and end nested teams, and to make tasks of "
      "OpenMP, is not calibrated; of OpenMP there is openmp_levels.",
      fmt::join(names, ", "));
}

}  // namespace

std::vector<std::string> make_conclusions(const Prediction& prediction) {
  std::vector<std::string> parts{describe_disturbance(prediction),
                                 describe_bound(prediction),
                                 describe_limit(prediction),
                                 describe_levels(prediction),
                                 describe_ranks(prediction),
                                 describe_errors(prediction),
                                 describe_left_out()};
  std::erase(parts, "");
  return parts;
}

std::string make_conclusion(const Prediction& prediction) {
  return fmt::format("{}", fmt::join(make_conclusions(prediction), " "));
}

}  // namespace spoke::predict
