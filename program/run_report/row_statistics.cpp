// Writes means, deviations, extremes and damage-equivalent ranges of a run's rows.

#include "program/run_report/row_statistics.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "models/count_text.h"
#include "program/report/markup.h"

namespace spoke::run_report {
namespace {

std::string number(double value) { return fmt::format("{:.6g}", value); }

/// Returns "201 rows of sensors.csv from 0 to 20 s".
std::string describe_rows(const RunStatistics& rows) {
  return fmt::format("{} of sensors.csv from {} to {} s", counted(rows.rows(), "row"),
                     number(rows.first_time()), number(rows.last_time()));
}

std::string describe(const RunStatistics& rows) {
  std::string text = "Over " + describe_rows(rows) + ".";
  const auto& series = rows.series();
  if (std::any_of(series.begin(), series.end(), [](const auto& s) { return s.ranges.has_value(); }))
    text += fmt::format(
        " The damage-equivalent range is that of a sine of {:g} Hz which does the same damage in "
        "that "
        "time, by rainflow counting and exponent {:g}.",
        RunStatistics::kFrequency, RunStatistics::kExponent);
  return text;
}

}  // namespace

std::vector<report::Tile> make_mean_tiles(const Simulation& simulation, const RunStatistics& rows) {
  constexpr std::array<std::pair<const char*, const char*>, 2> kMeans{
      {{"air.power", "Mean power of the air"}, {"air.thrust", "Mean thrust of the air"}}};
  std::vector<report::Tile> tiles;
  for (const auto& [name, label] : kMeans)
    for (const SensorSeries& series : rows.series()) {
      if (simulation.sensor_names()[series.sensor] != name || series.values.count() == 0) continue;
      const std::string& unit = simulation.sensor_units()[series.sensor];
      tiles.push_back({label, report::quantity(series.values.mean(), unit, 4),
                       "standard deviation " + report::quantity(series.values.deviation(), unit)});
    }
  return tiles;
}

report::Table make_statistics_table(const Simulation& simulation, const RunStatistics& rows) {
  using report::Align;
  report::Table table{describe(rows),
                      {{"sensor"},
                       {"unit"},
                       {"mean", Align::number},
                       {"standard deviation", Align::number},
                       {"lowest", Align::number},
                       {"highest", Align::number},
                       {"damage-equivalent range", Align::number}},
                      {}};
  for (const SensorSeries& series : rows.series()) {
    if (series.values.count() == 0) continue;
    const double range = rows.equivalent_range(series);
    table.rows.push_back(
        {{simulation.sensor_names()[series.sensor], simulation.sensor_units()[series.sensor],
          number(series.values.mean()), number(series.values.deviation()),
          number(series.values.min()), number(series.values.max()),
          std::isfinite(range) ? number(range) : std::string()}});
  }
  return table;
}

}  // namespace spoke::run_report
