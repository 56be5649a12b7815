// Tables and charts of loads.

#include "program/study_report/load_part.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "program/report/chart.h"
#include "program/report/markup.h"

namespace spoke::study_report {
namespace {

using report::Align;
using study::Extreme;
using study::LoadAnalysis;
using study::SensorSummary;
using study::SpeedGroup;
using study::StatisticsPlan;

constexpr std::size_t kMostDrawn = 24;         // sensors with a chart
constexpr std::size_t kMostSimultaneous = 12;  // sensors whose values at extremes are shown

std::string value_text(double value, const StatisticsPlan& plan, std::size_t sensor) {
  return report::quantity(value, plan.units[sensor], 4);
}

void add_range_columns(const StatisticsPlan& plan, report::Table& table) {
  for (const double exponent : plan.exponents)
    table.columns.push_back({fmt::format("range, m = {}", exponent), Align::number});
}

report::Table make_extreme_table(const StatisticsPlan& plan, const LoadAnalysis& loads) {
  report::Table table{.caption = "Extremes, with partial factors",
                      .columns = {{"sensor"},
                                  {""},
                                  {"run", Align::number},
                                  {"load case"},
                                  {"at", Align::number},
                                  {"value", Align::number},
                                  {"factor", Align::number},
                                  {"design value", Align::number}}};
  const bool shows_others = plan.sensors.size() <= kMostSimultaneous;
  if (shows_others)
    for (const std::string& sensor : plan.sensors)
      table.columns.push_back({"with " + sensor, Align::number});
  for (const Extreme& extreme : loads.extremes) {
    if (extreme.run < 0) continue;
    report::Row row{
        {plan.sensors[extreme.sensor], extreme.is_max ? "greatest" : "least",
         std::to_string(extreme.run + 1), extreme.load_case, report::quantity(extreme.time, "s", 5),
         value_text(extreme.value, plan, extreme.sensor), report::figure(extreme.factor, 4),
         value_text(extreme.design_value(), plan, extreme.sensor)}};
    for (std::size_t i = 0; shows_others && i < extreme.simultaneous.size(); ++i)
      row.cells.push_back(value_text(extreme.simultaneous[i], plan, i));
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table make_lifetime_table(const StatisticsPlan& plan, const LoadAnalysis& loads) {
  report::Table table{
      .caption = fmt::format("Damage-equivalent ranges of {} cycles, over {} hours",
                             report::figure(plan.cycles, 4), report::figure(loads.hours, 6)),
      .columns = {{"sensor"}}};
  add_range_columns(plan, table);
  for (std::size_t i = 0; i < plan.sensors.size(); ++i) {
    report::Row row{{plan.sensors[i]}};
    for (const double range : loads.lifetime[i]) row.cells.push_back(value_text(range, plan, i));
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table make_speed_table(const StatisticsPlan& plan, const LoadAnalysis& loads) {
  report::Table table{.caption = "Statistics by wind speed; ranges are once a second",
                      .columns = {{"load case"},
                                  {"wind", Align::number},
                                  {"runs", Align::number},
                                  {"sensor"},
                                  {"mean", Align::number},
                                  {"deviation", Align::number},
                                  {"least", Align::number},
                                  {"greatest", Align::number}}};
  add_range_columns(plan, table);
  for (const SpeedGroup& group : loads.groups)
    for (std::size_t i = 0; i < std::min(group.sensors.size(), kMostDrawn); ++i) {
      const SensorSummary& s = group.sensors[i];
      report::Row row{{group.load_case,
                       std::isnan(group.speed) ? "" : report::quantity(group.speed, "m/s", 4),
                       std::to_string(group.runs), plan.sensors[i], value_text(s.mean, plan, i),
                       value_text(s.deviation, plan, i), value_text(s.min, plan, i),
                       value_text(s.max, plan, i)}};
      for (const double range : s.ranges) row.cells.push_back(value_text(range, plan, i));
      table.rows.push_back(std::move(row));
    }
  return table;
}

/// Returns the load case that charts show: the first one of several speeds.
std::string find_drawn_case(const LoadAnalysis& loads) {
  for (const SpeedGroup& group : loads.groups)
    if (std::count_if(loads.groups.begin(), loads.groups.end(), [&](const SpeedGroup& other) {
          return other.load_case == group.load_case && !std::isnan(other.speed);
        }) > 1)
      return group.load_case;
  return loads.groups.front().load_case;
}

report::LineChart make_speed_chart(const StatisticsPlan& plan, const LoadAnalysis& loads,
                                   const std::string& load_case, std::size_t sensor) {
  report::LineChart chart{.title = plan.sensors[sensor],
                          .x = {.title = "wind", .unit = "m/s"},
                          .y = {.title = plan.sensors[sensor], .unit = plan.units[sensor]}};
  std::vector<const SpeedGroup*> groups;
  for (const SpeedGroup& group : loads.groups)
    if (group.load_case == load_case && !std::isnan(group.speed)) groups.push_back(&group);
  std::sort(groups.begin(), groups.end(),
            [](const SpeedGroup* a, const SpeedGroup* b) { return a->speed < b->speed; });
  const auto add = [&](const char* name, double SensorSummary::*value) {
    report::LineSeries line{.name = name};
    for (const SpeedGroup* group : groups)
      line.points.push_back({group->speed, group->sensors[sensor].*value, ""});
    chart.series.push_back(std::move(line));
  };
  add("greatest", &SensorSummary::max);
  add("mean", &SensorSummary::mean);
  add("least", &SensorSummary::min);
  return chart;
}

}  // namespace

void add_loads(const study::Study& study, const LoadAnalysis& loads, report::Page& page) {
  const StatisticsPlan& plan = *study.statistics;
  page.add_heading("Loads");
  page.add_table(make_extreme_table(plan, loads));
  if (loads.has_hours) {
    if (loads.missing_hours > 0.0)
      page.add_note(fmt::format("{} hours are of runs without result, and do no damage here.",
                                report::figure(loads.missing_hours, 4)),
                    report::Tone::warning);
    page.add_table(make_lifetime_table(plan, loads));
  }
  if (loads.groups.empty()) return;
  page.add_table(make_speed_table(plan, loads));
  if (plan.sensors.size() > kMostDrawn)
    page.add_paragraph(fmt::format("Of {} sensors the first {} are shown; all are in by_speed.csv.",
                                   plan.sensors.size(), kMostDrawn));
  const std::string load_case = find_drawn_case(loads);
  page.add_markup("<div class=\"side\">\n");
  for (std::size_t i = 0; i < std::min(plan.sensors.size(), kMostDrawn); ++i)
    page.add_figure(report::render(make_speed_chart(plan, loads, load_case, i)), load_case);
  page.add_markup("</div>\n");
}

}  // namespace spoke::study_report
