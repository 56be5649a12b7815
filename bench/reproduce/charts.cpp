// Fills the charts with the computed and measured values and with the paper's.

#include "bench/reproduce/charts.h"

#include <spdlog/fmt/fmt.h>

#include <limits>

#include "bench/reproduce/tables.h"
#include "graph/machine/duration_text.h"

namespace spoke::reproduce {
namespace {

using report::LineSeries;

template <class ValueOf>
report::LineChart drive_chart(const Reproduction& all, report::Axis y, ValueOf value_of) {
  LineSeries series{.name = y.title, .markers = false};
  for (const DrivePoint& point : all.drive)
    series.points.push_back({point.t, value_of(point.motion)});
  report::LineChart chart{.title = "Hub " + y.title, .x = {.title = "time", .unit = "s"}};
  chart.y = std::move(y);
  chart.series = {std::move(series)};
  return chart;
}

LineSeries line_of(const Deflection& deflection, bool dashed) {
  LineSeries series{.name = deflection.name, .markers = false, .dashed = dashed};
  for (const auto& [t, y] : deflection.points) series.points.push_back({t, y});
  return series;
}

/// Returns the exact solution as single points: values that cannot be shown part the line between
/// them.
LineSeries exact_points() {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  LineSeries series{.name = "exact (independent)"};
  for (const auto& [t, y] : exact::points()) {
    series.points.push_back({t, y});
    series.points.push_back({t, kGap});
  }
  series.points.push_back({exact::kLagTime, exact::kLag, "the peak"});
  return series;
}

std::optional<report::Bar> bar_of(const Reproduction& all, Work work,
                                  const compare::Configuration& which) {
  const auto spread = all.timings.find(work, which);
  if (!spread) return {};
  return report::Bar{.value = 1e3 * spread->median,
                     .low = 1e3 * spread->low,
                     .high = 1e3 * spread->high,
                     .text = graph::duration_text(spread->median)};
}

}  // namespace

report::LineChart speed_chart(const Reproduction& all) {
  return drive_chart(all, {.title = "speed", .unit = "rad/s"},
                     [](const DriveMotion& motion) { return motion.speed; });
}

report::LineChart angle_chart(const Reproduction& all) {
  return drive_chart(all, {.title = "angle", .unit = "rad"},
                     [](const DriveMotion& motion) { return motion.angle; });
}

report::LineChart acceleration_chart(const Reproduction& all) {
  return drive_chart(all, {.title = "acceleration", .unit = "rad/s^2"},
                     [](const DriveMotion& motion) { return motion.acceleration; });
}

report::LineChart deflection_chart(const Reproduction& all) {
  report::LineChart chart{.title = "Deflection of the tip",
                          .x = {.title = "time", .unit = "s"},
                          .y = {.title = "tip.y", .unit = "m"}};
  chart.series = {line_of(all.paper, false), line_of(all.stiffened, false),
                  line_of(all.finest, true), exact_points()};
  return chart;
}

report::LineChart subsystem_chart(const Reproduction& all) {
  report::LineChart chart{.title = "Subsystem threads",
                          .x = {.title = "threads", .low = 1.0, .ticks = {1.0, 2.0, 3.0}},
                          .y = {.title = "time per step", .unit = "ms"}};
  report::Range medians;  // a slow one flattens the others unless the axis is logarithmic
  LineSeries ideal{.name = "serial / threads", .markers = false, .dashed = true};
  const auto alone = all.timings.find(Work::steps, serial(Formulation::subsystem));
  for (const int number : {1, 2}) {
    LineSeries series{.name = fmt::format("scheme {}", number)};
    for (const int threads : {1, 2, 3})
      if (const auto spread = all.timings.find(Work::steps, scheme(number, threads))) {
        medians.add(1e3 * spread->median);
        series.points.push_back({static_cast<double>(threads), 1e3 * spread->median});
        series.band.push_back(
            {static_cast<double>(threads), 1e3 * spread->low, 1e3 * spread->high});
      }
    chart.series.push_back(std::move(series));
  }
  for (const int threads : {1, 2, 3})
    if (alone)
      ideal.points.push_back({static_cast<double>(threads), 1e3 * alone->median / threads});
  chart.series.push_back(std::move(ideal));
  chart.y.kind = report::scale_for(medians);
  if (chart.y.kind == report::ScaleKind::linear) chart.y.low = 0.0;
  return chart;
}

report::BarChart layered_chart(const Reproduction& all, Work work) {
  report::BarChart chart{
      .title = work == Work::steps ? "Layered, whole step" : "Layered, inverse part of a step",
      .value = {.title = "time", .unit = "ms", .kind = report::ScaleKind::log}};
  chart.series = {{.name = "scheme 1"}, {.name = "scheme 2"}};
  for (const int inner : {1, 2, 3, 4}) {
    chart.groups.push_back(fmt::format("3x{}", inner));
    for (const int number : {1, 2})
      chart.series[static_cast<std::size_t>(number - 1)].bars.push_back(
          bar_of(all, work, scheme(number, {3, inner})));
  }
  if (const auto alone = all.timings.find(work, serial(Formulation::subsystem)))
    chart.lines = {{"serial", 1e3 * alone->median}};
  return chart;
}

report::BarChart method_chart(const Reproduction& all) {
  report::BarChart chart{
      .title = "Time per step",
      .value = {.title = "time per step", .unit = "ms", .kind = report::ScaleKind::log}};
  chart.series = {{.name = "here"}, {.name = "paper"}};
  for (const MethodTime& time : method_times(all)) {
    chart.groups.push_back(time.name);
    std::optional<report::Bar> here, printed;
    if (time.seconds)
      here = report::Bar{.value = 1e3 * *time.seconds,
                         .text = graph::duration_text(*time.seconds),
                         .tooltip = time.how};
    if (time.paper_ms)
      printed =
          report::Bar{.value = *time.paper_ms, .text = fmt::format("{:.2f} ms", *time.paper_ms)};
    chart.series[0].bars.push_back(std::move(here));
    chart.series[1].bars.push_back(std::move(printed));
  }
  return chart;
}

}  // namespace spoke::reproduce
