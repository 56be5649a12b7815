// The page predict.html: conclusion, charts, table and facts.

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "bench/compare/page.h"
#include "bench/predict/conclusion.h"
#include "bench/predict/files.h"
#include "bench/predict/table.h"
#include "program/report/chart.h"

namespace spoke::predict {
namespace {

report::LineSeries predicted_line(const Prediction& prediction, const Series& series) {
  report::LineSeries line{.name = std::string(graph::name_of(series.executor)), .markers = false};
  const double serial = prediction.serial.step.expected;
  for (const Point& point : series.points) {
    const double threads = point.threads;
    line.points.push_back({threads, prediction.speedup(point)});
    line.band.push_back({threads, serial / point.step.pessimistic, serial / point.step.optimistic});
  }
  return line;
}

/// Returns the measured points in the colour of the predicted line, the s-th of the chart.
report::LineSeries measured_points(const Series& series, std::size_t s) {
  report::LineSeries points{.name = fmt::format("{}, measured", graph::name_of(series.executor)),
                            .joined = false,
                            .color_of = s};
  for (const Point& point : series.points)
    if (point.measured)
      points.points.push_back({1.0 * point.threads, point.measured->speedup.median,
                               fmt::format("{:+.1f} % off", 100.0 * *point.error())});
  return points;
}

/// Returns a line that no executor crosses, with a point at each number of threads.
template <class Speedup>
report::LineSeries bound_line(const char* name, const Prediction& prediction, Speedup speedup) {
  report::LineSeries line{.name = name, .markers = false, .dashed = true};
  for (const Point& point : prediction.series.front().points)
    line.points.push_back({1.0 * point.threads, speedup(1.0 * point.threads)});
  return line;
}

std::vector<double> thread_counts(const Prediction& prediction) {
  std::vector<double> counts;
  for (const Point& point : prediction.series.front().points) counts.push_back(point.threads);
  return counts;
}

/// Returns an axis for speedups from a quarter on; lines of lower ones end at the axis.
report::Axis speedup_axis(const std::vector<double>& counts) {
  report::Axis axis{.title = "speedup",
                    .kind = report::ScaleKind::log,
                    .low = 0.25,
                    .high = std::max(2.0, counts.back()),
                    .ticks = {0.25, 0.5, 1.0}};
  for (double tick = 2.0; tick <= *axis.high; tick *= 2.0) axis.ticks.push_back(tick);
  return axis;
}

report::LineChart speedup_chart(const Prediction& prediction) {
  const std::vector<double> counts = thread_counts(prediction);
  report::LineChart chart{
      .title = "Speedup over serial, by threads",
      .x = {.title = "threads", .kind = report::ScaleKind::log, .ticks = counts},
      .y = speedup_axis(counts)};
  if (counts.size() > 1) {
    chart.x.low = counts.front();
    chart.x.high = counts.back();
  }
  for (const Series& series : prediction.series)
    chart.series.push_back(predicted_line(prediction, series));
  chart.series.push_back(
      bound_line("as many as threads", prediction, [](double threads) { return threads; }));
  const auto add_bound = [&](const char* name, const RunGraph& run) {
    chart.series.push_back(bound_line(
        name, prediction, [&run](double threads) { return std::min(threads, run.parallelism()); }));
  };
  add_bound("T1 / max(T1/P, Tinf)", prediction.run);
  if (prediction.auto_run) add_bound("the same, auto's window", *prediction.auto_run);
  for (std::size_t s = 0; s < prediction.series.size(); ++s) {
    report::LineSeries measured = measured_points(prediction.series[s], s);
    if (!measured.points.empty()) chart.series.push_back(std::move(measured));
  }
  return chart;
}

/// Returns the chart of measured beside predicted times, for each point that was measured.
report::BarChart check_chart(const Prediction& prediction) {
  report::BarChart chart{.title = "Predicted and measured time per step",
                         .value = {.title = "time per step", .unit = "us"}};
  report::BarSeries predicted{"predicted, whiskers: band"},
      measured{"measured, whiskers: quartiles"};
  const auto add = [&](ExecutorKind executor, const Point& point) {
    if (!point.measured) return;
    const auto bar = [](double value, double low, double high) {
      return report::Bar{.value = 1e6 * value, .low = 1e6 * low, .high = 1e6 * high};
    };
    const Quartiles& step = point.measured->step;
    chart.groups.push_back(fmt::format("{} {}", graph::name_of(executor), point.threads));
    predicted.bars.emplace_back(
        bar(point.step.expected, point.step.optimistic, point.step.pessimistic));
    measured.bars.emplace_back(bar(step.median, step.low, step.high));
  };
  add(ExecutorKind::serial, prediction.serial);
  for (const Series& series : prediction.series)
    for (const Point& point : series.points) add(series.executor, point);
  report::Range values;
  for (const auto* bars : {&predicted.bars, &measured.bars})
    for (const auto& bar : *bars)  // a single slow quartile flattens the others, too
      for (const std::optional<double>& value : {std::optional(bar->value), bar->low, bar->high})
        if (value) values.add(*value);
  chart.value.kind = report::scale_for(values);
  chart.series = {std::move(predicted), std::move(measured)};
  return chart;
}

constexpr const char* kMethod =
    "The nodes of the step graph were timed one by one on one thread while it made real steps, "
    "the same ones as the measured processes and in the same rounds: of the graph of one pass, and "
    "of that of the window of steps which auto chooses in a run, or of one window for all if that "
    "was asked for; a process that is much slower than serial makes fewer steps in a round. A "
    "simulator then runs the graph on any number of processors equal to this one: flow_graph and "
    "auto by the schedule that auto ranks its plans with, in which each node, each cluster and "
    "each "
    "handover to another processor has its measured cost; openmp_levels level by level, the "
    "costliest thread of each and a barrier, which is taken to grow as the logarithm of the "
    "threads. The band is that of any greedy schedule, from max(T1/P, Tinf) to "
    "(T1 - Tinf)/P + Tinf or what the runtime's costs make of it. That data move between "
    "processors, and that these share cache capacity, memory and power, is not modelled.";

}  // namespace

std::string make_html(const Prediction& prediction) {
  report::Page page =
      compare::make_page(prediction.scenario,
                         fmt::format("What more threads would give, predicted from one thread{}",
                                     prediction.rounds > 0 ? " and checked on this machine" : ""));
  page.add_notes(make_conclusions(prediction));
  page.add_figure(
      render(speedup_chart(prediction)),
      "Both axes are logarithmic. Bands: bounds of any greedy schedule. Dashed: bounds of "
      "any schedule. Points: measured here.");
  if (prediction.rounds > 0) {
    const report::BarChart check = check_chart(prediction);
    page.add_figure(render(check), report::caption_of(check.value));
  }
  compare::add_facts(page, make_facts(prediction), prediction.machine,
                     {prediction.load_before, prediction.load_after});
  page.add_table(make_table(prediction));
  if (!prediction.ranks.empty()) page.add_table(make_rank_table(prediction));
  compare::add_method(page, "How this was predicted", kMethod);
  return page.html();
}

}  // namespace spoke::predict
