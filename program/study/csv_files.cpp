// Writes runs.csv and histories.csv.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/support/csv_cell.h"
#include "engine/support/plain_zero.h"
#include "program/study/cells.h"
#include "program/study/files.h"

namespace spoke::study {

std::string number_cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", plain_zero(value)) : "";
}

namespace {

/// Returns a number with all digits and its sign, or a text as a cell.
std::string value_cell(const Parameter& parameter, double value) {
  const std::string text = plain_text(parameter, value);
  return parameter.is_choice() ? csv_cell(text) : text;
}

std::string row_of(const Study& study, const std::vector<double>& values, const RunResult& result) {
  std::string row = fmt::format("{},{}", result.run + 1, name_of(result.status));
  for (std::size_t i = 0; i < values.size(); ++i)
    row += ',' + value_cell(study.parameters[i], values[i]);
  for (std::size_t k = 0; k < study.responses.size(); ++k)
    if (study.responses[k].kind != ResponseKind::history)
      row += ',' + number_cell(result.responses[k]);
  return row + ',' + csv_cell(result.diagnosis) + '\n';
}

/// Returns the rows of one run, by time.
std::string rows_of(const RunResult& result) {
  std::map<double, std::vector<double>> rows;
  for (std::size_t h = 0; h < result.histories.size(); ++h) {
    const History& history = result.histories[h];
    for (std::size_t i = 0; i < history.times.size(); ++i) {
      auto& row = rows[history.times[i]];
      row.resize(result.histories.size(), std::numeric_limits<double>::quiet_NaN());
      row[h] = history.values[i];
    }
  }
  std::string text;
  for (const auto& [t, row] : rows) {
    text += fmt::format("{},{}", result.run + 1, t);
    for (const double value : row) text += ',' + number_cell(value);
    text += '\n';
  }
  return text;
}

}  // namespace

void write_runs_csv(const Study& study, const Sampling& sampling, const ForEachRun& for_each,
                    const Sink& sink) {
  std::string head = "run,status";
  for (const Parameter& parameter : study.parameters) head += ',' + csv_cell(parameter.name);
  for (const Response& response : study.responses)
    if (response.kind != ResponseKind::history) head += ',' + csv_cell(response.name);
  sink(head + ",diagnosis\n");
  for_each(
      [&](const RunResult& result) { sink(row_of(study, sampling.values(result.run), result)); });
}

void write_histories_csv(const Study& study, const ForEachRun& for_each, const Sink& sink) {
  std::string head = "run,t";
  for (const Response& response : study.responses)
    if (response.kind == ResponseKind::history) head += ',' + csv_cell(response.name);
  sink(head + '\n');
  for_each([&](const RunResult& result) { sink(rows_of(result)); });
}

}  // namespace spoke::study
