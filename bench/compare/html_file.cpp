// The page compare.html: conclusion, charts, tables and method.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>

#include "bench/compare/conclusion.h"
#include "bench/compare/files.h"
#include "bench/compare/page.h"
#include "bench/compare/table.h"
#include "graph/machine/duration_text.h"
#include "models/count_text.h"
#include "program/report/chart.h"
#include "program/report/markup.h"

namespace spoke::compare {
namespace {

report::BarChart speedup_chart(const Comparison& comparison, const Model& model) {
  report::BarChart chart{
      .title = fmt::format("Speedup over serial, {}", name_of(model.formulation)),
      .value = {.title = "serial time / time in the same round"}};
  report::BarSeries speedups{"median of rounds, whiskers: quartiles"};
  report::BarMarks bounds{"bound T1 / max(T1/P, Tinf)"};
  for (const Result& result : comparison.results) {
    if (!belongs_to(result, model.formulation) || !result.figures) continue;
    const Figures& figures = *result.figures;
    chart.groups.push_back(name_of(result.measurement.configuration));
    speedups.bars.push_back(
        report::Bar{figures.speedup, figures.speedup_low, figures.speedup_high,
                    report::ratio_text(figures.speedup),
                    fmt::format("{} a step, {}", graph::duration_text(figures.median),
                                counted(std::ssize(result.measurement.step_times), "round")),
                    result.oversubscribed});
    bounds.values.push_back(model.serial_step / figures.bound);
  }
  chart.series = {std::move(speedups)};
  chart.marks = {std::move(bounds)};
  chart.lines = {{"serial", 1.0}};
  return chart;
}

/// Returns the chart of times per step: a group for each configuration, and in it a bar for each
/// formulation.
report::BarChart time_chart(const Comparison& comparison) {
  report::BarChart chart{
      .title = "Time per step",
      .value = {.title = "median time per step", .unit = "us", .kind = report::ScaleKind::log}};
  std::map<std::string, std::size_t> places;
  for (const Result& result : comparison.results) {
    const std::string name = name_of(result.measurement.configuration);
    if (places.try_emplace(name, chart.groups.size()).second) chart.groups.push_back(name);
  }
  for (const Model& model : comparison.models) {
    report::BarSeries series{std::string(name_of(model.formulation))};
    series.bars.resize(chart.groups.size());
    for (const Result& result : comparison.results)
      if (belongs_to(result, model.formulation) && result.figures)
        series.bars[places.at(name_of(result.measurement.configuration))] =
            report::Bar{.value = 1e6 * result.figures->median,
                        .text = fmt::format("{:.3g}", 1e6 * result.figures->median)};
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// Returns the chart of speedups by number of threads, a line for each executor that was measured
/// on several numbers.
report::LineChart scaling_chart(const Comparison& comparison, const Model& model) {
  report::LineChart chart{.title = fmt::format("Scaling, {}", name_of(model.formulation)),
                          .x = {.title = "threads", .low = 1.0},
                          .y = {.title = "speedup", .low = 0.0},
                          .lines = {{"serial", 1.0}}};
  for (const Result& result : comparison.results) {
    const Configuration& configuration = result.measurement.configuration;
    const bool plain = configuration.executor != ExecutorKind::serial &&
                       configuration.threads.inner == 1 && !configuration.bind &&
                       configuration.wait == Wait::runtime_default && !configuration.spin.count;
    if (!belongs_to(result, model.formulation) || !result.figures || !plain) continue;
    const std::string name(name_of(configuration.executor));
    auto series = std::find_if(chart.series.begin(), chart.series.end(),
                               [&](const report::LineSeries& s) { return s.name == name; });
    if (series == chart.series.end()) series = chart.series.insert(series, {.name = name});
    const double threads = configuration.threads.outer;
    series->points.push_back({threads, result.figures->speedup});
    series->band.push_back({threads, result.figures->speedup_low, result.figures->speedup_high});
    auto& ticks = chart.x.ticks;
    if (std::find(ticks.begin(), ticks.end(), threads) == ticks.end()) ticks.push_back(threads);
  }
  for (report::LineSeries& series : chart.series) {
    std::sort(series.points.begin(), series.points.end(),
              [](const auto& a, const auto& b) { return a.x < b.x; });
    std::sort(series.band.begin(), series.band.end(),
              [](const auto& a, const auto& b) { return a.x < b.x; });
  }
  return chart;
}

/// Returns the caption below a formulation's bars; it explains pale bars if there are any.
std::string caption_of_speedups(const Comparison& comparison, const Model& model) {
  const bool has_pale =
      std::any_of(comparison.results.begin(), comparison.results.end(), [&](const Result& result) {
        return belongs_to(result, model.formulation) && result.figures && result.oversubscribed;
      });
  return has_pale ? "Pale bars have more threads than processors." : "";
}

std::vector<report::Fact> facts_of(const Comparison& comparison) {
  return {{"capacity", comparison.capacity.is_known() ? comparison.capacity.text() : "-"},
          {"integrator",
           fmt::format("{}, step {:.6g} s", name_of(comparison.scenario.integration.method),
                       comparison.step_size)}};
}

std::string method_of(const Comparison& comparison) {
  return fmt::format(
      "Every configuration simulates the same steps from t = 0 in a process of its own. After {} "
      "untimed batches of steps, fewer of what is slow, come up to {}; in each, every "
      "process runs one batch while all others are halted. Speedups are ratios of times within a "
      "round. T1 is the median serial time of a step, Tinf the share of it that lies on the "
      "costliest path through the step graph; no execution on P processors takes less than "
      "max(T1/P, Tinf), if nodes cost the same on each; at capacity, P is what the threads did of "
      "one thread's work when all ran the same loop, before or after the rounds. Bits are equal if "
      "the state is the same as "
      "serial's after every batch, to the last bit.",
      kWarmUpBatches, counted(comparison.rounds, "round"));
}

}  // namespace

std::string make_html(const Comparison& comparison) {
  report::Page page =
      make_page(comparison.scenario, fmt::format("{} to run a step, compared in {}",
                                                 counted(std::ssize(comparison.results), "way"),
                                                 counted(comparison.rounds, "round")));
  page.add_notes(make_conclusions(comparison));
  add_facts(page, facts_of(comparison), comparison.machine, comparison.loads);
  for (const Model& model : comparison.models) {
    page.add_heading(fmt::format("Formulation {}", name_of(model.formulation)));
    page.add_figure(render(speedup_chart(comparison, model)),
                    caption_of_speedups(comparison, model));
    const report::LineChart scaling = scaling_chart(comparison, model);
    if (scaling.x.ticks.size() > 2) page.add_figure(render(scaling));
    page.add_table(make_table(comparison, model));
  }
  if (comparison.models.size() > 1) {
    const report::BarChart times = time_chart(comparison);
    page.add_heading("All formulations");
    page.add_figure(render(times), report::caption_of(times.value));
  }
  add_method(page, "How this was measured", method_of(comparison));
  return page.html();
}

}  // namespace spoke::compare
