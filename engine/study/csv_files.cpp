// runs.csv and histories.csv.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/study/files.h"
#include "engine/support/plain_zero.h"

namespace spoke::study {
namespace {

/// A cell, in quotes if it has to be.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + '"';
}

std::string number_cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", plain_zero(value)) : "";
}

std::string row_of(const Study& study, const std::vector<double>& values, const RunResult& result) {
  std::string row = fmt::format("{},{}", result.run + 1, name_of(result.status));
  for (std::size_t i = 0; i < values.size(); ++i)
    row += ',' + cell(plain_text(study.parameters[i], values[i]));
  for (std::size_t k = 0; k < study.responses.size(); ++k)
    if (study.responses[k].kind != ResponseKind::history)
      row += ',' + number_cell(result.responses[k]);
  return row + ',' + cell(result.diagnosis) + '\n';
}

/// The rows of one run, by time.
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
  for (const Parameter& parameter : study.parameters) head += ',' + parameter.name;
  for (const Response& response : study.responses)
    if (response.kind != ResponseKind::history) head += ',' + response.name;
  sink(head + ",diagnosis\n");
  for_each(
      [&](const RunResult& result) { sink(row_of(study, sampling.values(result.run), result)); });
}

void write_histories_csv(const Study& study, const ForEachRun& for_each, const Sink& sink) {
  std::string head = "run,t";
  for (const Response& response : study.responses)
    if (response.kind == ResponseKind::history) head += ',' + response.name;
  sink(head + '\n');
  for_each([&](const RunResult& result) { sink(rows_of(result)); });
}

}  // namespace spoke::study
