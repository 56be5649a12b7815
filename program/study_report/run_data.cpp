// Writes columns of numbers for as many runs as a page can draw.

#include "program/study_report/run_data.h"

#include <cmath>

#include "models/support/json.h"

namespace spoke::study_report {
namespace {

using study::Parameter;
using study::Response;
using study::ResponseKind;
using study::Study;

constexpr std::int64_t kMostRuns = 5000;
constexpr std::int64_t kMostNumbers = 60'000;  // numbers of all columns

Json column(const Parameter& parameter, Json values) {
  Json json = {{"name", parameter.name}, {"values", std::move(values)}};
  if (!parameter.is_choice()) return json;
  Json choices = Json::array();
  for (const study::Level& level : parameter.levels)
    choices.push_back(plain_text(parameter, level.number));
  json.set("choices", choices);
  return json;
}

/// Returns the parts of a --set option: the key, and the values of a choice as TOML writes them.
Json key_of(const Parameter& parameter) {
  if (parameter.key.empty()) return nullptr;
  Json json = {{"key", parameter.key}};
  if (!parameter.is_choice()) return json;
  Json texts = Json::array();
  for (const study::Level& level : parameter.levels) texts.push_back(level.text);
  json.set("toml", texts);
  return json;
}

Json responses_of(const Study& study, const std::vector<Json>& columns) {
  Json responses = Json::array();
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (study.responses[k].kind != ResponseKind::history)
      responses.push_back({{"name", study.responses[k].name},
                           {"unit", study.responses[k].unit},
                           {"values", columns[k]}});
  return responses;
}

}  // namespace

std::int64_t drawn_stride(const Study& study) {
  const std::int64_t columns = std::ssize(study.parameters) + std::ssize(study.responses);
  const std::int64_t most = std::max<std::int64_t>(std::min(kMostRuns, kMostNumbers / columns), 1);
  return (study.design.runs + most - 1) / most;
}

std::string make_run_data(const Study& study, const study::Sampling& sampling,
                          const study::ForEachRun& for_each) {
  const std::int64_t stride = drawn_stride(study);
  Json runs = Json::array();
  std::vector<Json> values(study.parameters.size(), Json::array());
  std::vector<Json> results(study.responses.size(), Json::array());
  for_each([&](const study::RunResult& result) {
    if (result.run % stride != 0) return;
    runs.push_back(result.run + 1);
    const std::vector<double> of_run = sampling.values(result.run);
    for (std::size_t i = 0; i < values.size(); ++i) values[i].push_back(of_run[i]);
    for (std::size_t k = 0; k < results.size(); ++k) results[k].push_back(result.responses[k]);
  });
  Json parameters = Json::array(), keys = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    parameters.push_back(column(study.parameters[i], std::move(values[i])));
    keys.push_back(key_of(study.parameters[i]));
  }
  const Json data = {{"scenario", study.scenario_file},
                     {"runs", runs},
                     {"keys", keys},
                     {"parameters", parameters},
                     {"responses", responses_of(study, results)}};
  return data.dump();
}

}  // namespace spoke::study_report
