// Writes the files of a study's statistics, and the table of its runs.

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "engine/support/csv_cell.h"
#include "program/study/cells.h"
#include "program/study/files.h"

namespace spoke::study {
namespace {

/// Returns heads of columns of damage-equivalent ranges: ",range_m4,range_m10".
std::string range_heads(const StatisticsPlan& plan) {
  std::string heads;
  for (const double exponent : plan.exponents) heads += fmt::format(",range_m{}", exponent);
  return heads;
}

std::string cells_of(const std::vector<double>& numbers) {
  std::string cells;
  for (const double number : numbers) cells += ',' + number_cell(number);
  return cells;
}

std::string sensor_cells(const StatisticsPlan& plan, std::size_t sensor) {
  return csv_cell(plan.sensors[sensor]) + ',' + csv_cell(plan.units[sensor]);
}

/// Returns a text as a cell of a table that a study reads: in quotes only where it needs them.
std::string table_cell(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + '"';
}

}  // namespace

void write_table(const Study& study, const Sampling& sampling, const Sink& sink) {
  std::vector<std::size_t> columns;
  std::string line;
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    const Parameter& parameter = study.parameters[i];
    if (parameter.key.empty() && parameter.kind != ParameterKind::column) continue;
    columns.push_back(i);
    const std::string& head = parameter.key.empty() ? parameter.name : parameter.key;
    line += (line.empty() ? "" : ",") + table_cell(head);
  }
  sink(line + '\n');
  for (std::int64_t run = 0; run < study.design.runs; ++run) {
    const std::vector<double> values = sampling.values(run);
    line.clear();
    for (std::size_t k = 0; k < columns.size(); ++k)
      line += (k == 0 ? "" : ",") +
              table_cell(plain_text(study.parameters[columns[k]], values[columns[k]]));
    sink(line + '\n');
  }
}

void write_statistics_csv(const Study& study, const ForEachRun& for_each, const Sink& sink) {
  const StatisticsPlan& plan = *study.statistics;
  sink("run,sensor,unit,mean,deviation,min,min_time,max,max_time" + range_heads(plan) + '\n');
  for_each([&](const RunResult& result) {
    for (std::size_t i = 0; i < result.statistics.size(); ++i) {
      const SensorStatistics& s = result.statistics[i];
      sink(fmt::format("{},{}", result.run + 1, sensor_cells(plan, i)) +
           cells_of({s.mean, s.deviation, s.min, s.min_time, s.max, s.max_time}) +
           cells_of(s.ranges) + '\n');
    }
  });
}

void write_extremes_csv(const Study& study, const LoadAnalysis& loads, const Sink& sink) {
  const StatisticsPlan& plan = *study.statistics;
  std::string head = "sensor,unit,extreme,run,load_case,t,value,partial_factor,design_value";
  for (const std::string& sensor : plan.sensors) head += ',' + csv_cell("at." + sensor);
  sink(head + '\n');
  for (const Extreme& extreme : loads.extremes) {
    if (extreme.run < 0) continue;
    sink(fmt::format("{},{},{},{}", sensor_cells(plan, extreme.sensor),
                     extreme.is_max ? "max" : "min", extreme.run + 1, csv_cell(extreme.load_case)) +
         cells_of({extreme.time, extreme.value, extreme.factor, extreme.design_value()}) +
         cells_of(extreme.simultaneous) + '\n');
  }
}

void write_lifetime_csv(const Study& study, const LoadAnalysis& loads, const Sink& sink) {
  const StatisticsPlan& plan = *study.statistics;
  sink("sensor,unit,hours,missing_hours,cycles" + range_heads(plan) + '\n');
  for (std::size_t i = 0; i < plan.sensors.size(); ++i)
    sink(sensor_cells(plan, i) + cells_of({loads.hours, loads.missing_hours, plan.cycles}) +
         cells_of(loads.lifetime[i]) + '\n');
}

void write_by_speed_csv(const Study& study, const LoadAnalysis& loads, const Sink& sink) {
  const StatisticsPlan& plan = *study.statistics;
  sink("load_case,speed,runs,sensor,unit,mean,deviation,min,max,mean_min,mean_max" +
       range_heads(plan) + '\n');
  for (const SpeedGroup& group : loads.groups)
    for (std::size_t i = 0; i < group.sensors.size(); ++i) {
      const SensorSummary& s = group.sensors[i];
      sink(fmt::format("{},{},{},{}", csv_cell(group.load_case), number_cell(group.speed),
                       group.runs, sensor_cells(plan, i)) +
           cells_of({s.mean, s.deviation, s.min, s.max, s.mean_min, s.mean_max}) +
           cells_of(s.ranges) + '\n');
    }
}

}  // namespace spoke::study
