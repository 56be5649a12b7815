// Writes means, deviations, extremes and damage-equivalent ranges of a run's rows.

#include "program/run_report/row_statistics.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

/// Returns "exponent 10", or that there are several.
std::string describe_exponents(const std::vector<SensorSeries>& series) {
  std::set<double> exponents;
  for (const SensorSeries& one : series)
    if (one.ranges) exponents.insert(one.exponent);
  return exponents.size() == 1 ? fmt::format("exponent {:g}", *exponents.begin())
                               : "the exponent in the last column";
}

std::string describe(const RunStatistics& rows) {
  std::string text = "Over " + describe_rows(rows) + ".";
  const auto& series = rows.series();
  if (std::any_of(series.begin(), series.end(), [](const auto& s) { return s.ranges.has_value(); }))
    text += fmt::format(
        " The damage-equivalent range is that of a sine of {:g} Hz which does the same damage in "
        "that time, by rainflow counting and {}. Ranges of moments of blades are about "
        "the axes of their own roots.",
        RunStatistics::kFrequency, describe_exponents(series));
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
                       {"damage-equivalent range", Align::number},
                       {"exponent", Align::number}},
                      {}};
  for (const SensorSeries& series : rows.series()) {
    if (series.values.count() == 0) continue;
    const double range = rows.equivalent_range(series);
    table.rows.push_back(
        {{simulation.sensor_names()[series.sensor], simulation.sensor_units()[series.sensor],
          number(series.values.mean()), number(series.values.deviation()),
          number(series.values.min()), number(series.values.max()),
          std::isfinite(range) ? number(range) : std::string(),
          series.ranges ? number(series.exponent) : std::string()}});
  }
  return table;
}

}  // namespace spoke::run_report
