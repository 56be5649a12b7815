// Writes study.json, and the commands in it.

#include <cmath>

#include "models/support/json.h"
#include "program/study/files.h"

namespace spoke::study {
namespace {

/// Quotes a word for a shell's command line.
std::string shell_word(const std::string& text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=+-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

Json json_of(const Parameter& parameter) {
  Json json = {{"name", parameter.name},
               {"key", parameter.key.empty() ? Json(nullptr) : Json(parameter.key)},
               {"kind", name_of(parameter.kind)}};
  if (!parameter.levels.empty()) {
    Json values = Json::array();
    for (const Level& level : parameter.levels)
      values.push_back(level.text.empty() ? Json(level.number)
                                          : Json(plain_text(parameter, level.number)));
    json.set("values", values);
  } else if (parameter.kind == ParameterKind::normal) {
    json.set("mean", parameter.low);
    json.set("deviation", parameter.high);
  } else if (parameter.kind == ParameterKind::uniform ||
             parameter.kind == ParameterKind::log_uniform) {
    json.set("low", parameter.low);
    json.set("high", parameter.high);
  }
  return json;
}

Json json_of(const Design& design) {
  Json json = {{"kind", name_of(design.kind)}, {"runs", design.runs}};
  if (design.kind == DesignKind::saltelli) json.set("points", design.points);
  if (!design.table.empty()) json.set("file", design.table);
  if (design.kind != DesignKind::grid && design.kind != DesignKind::table)
    json.set("seed", design.seed);
  if (design.kind == DesignKind::sobol || design.kind == DesignKind::saltelli)
    json.set("scramble", design.is_scrambled);
  return json;
}

Json json_of(const MainEffect& effect, const Study& study) {
  const Parameter& parameter = study.parameters[effect.parameter];
  Json levels = Json::array();
  for (const EffectLevel& level : effect.levels) {
    if (level.count == 0) continue;
    Json json = parameter.is_choice() ? Json{{"value", plain_text(parameter, level.low)}}
                                      : Json{{"low", level.low}, {"high", level.high}};
    json.update({{"runs", level.count}, {"mean", level.mean}});
    levels.push_back(json);
  }
  return {{"parameter", parameter.name}, {"share", effect.share}, {"levels", levels}};
}

Json json_of(const Response& response, const ResponseAnalysis& found, const Study& study,
             const Sampling& sampling) {
  Json json = {{"name", response.name}, {"kind", name_of(response.kind)}, {"unit", response.unit}};
  if (!response.sensor.empty()) json.set("sensor", response.sensor);
  if (response.kind == ResponseKind::history) return json;
  const Summary& summary = found.summary;
  json.set("count", summary.count);
  if (summary.count == 0) return json;
  const auto extreme = [&](double value, std::int64_t run) {
    return Json{
        {"value", value}, {"run", run + 1}, {"replay", replay_command(study, sampling, run)}};
  };
  json.update({{"mean", summary.mean}, {"deviation", summary.deviation}});
  json.set("min", extreme(summary.min, summary.run_of_min));
  json.set("max", extreme(summary.max, summary.run_of_max));
  Json effects = Json::array(), indices = Json::array();
  for (const MainEffect& effect : found.effects) effects.push_back(json_of(effect, study));
  for (const SobolIndex& index : found.indices)
    indices.push_back({{"parameter", study.parameters[index.parameter].name},
                       {"first", index.first},
                       {"total", index.total}});
  json.set("main_effects", effects);
  if (study.design.kind == DesignKind::saltelli)
    json.set("sobol_indices", {{"points", found.index_points}, {"parameters", indices}});
  return json;
}

}  // namespace

std::string replay_command(const Study& study, const Sampling& sampling, std::int64_t run) {
  std::string command = "spoke run " + shell_word(study.scenario_file);
  for (const std::string& assignment : make_overrides(study, sampling.values(run)))
    command += " --set " + shell_word(assignment);
  return command;
}

std::string make_json(const Study& study, const Sampling& sampling, const Analysis& analysis) {
  Json parameters = Json::array(), responses = Json::array(), failed = Json::array();
  for (const Parameter& parameter : study.parameters) parameters.push_back(json_of(parameter));
  for (std::size_t k = 0; k < study.responses.size(); ++k)
    responses.push_back(json_of(study.responses[k], analysis.responses[k], study, sampling));
  for (const FailedRun& run : analysis.failed)
    failed.push_back({{"run", run.run + 1},
                      {"status", name_of(run.status)},
                      {"diagnosis", run.diagnosis},
                      {"replay", replay_command(study, sampling, run.run)}});
  const RunCounts& counts = analysis.counts;
  const Json json = {{"version", SPOKE_VERSION},
                     {"title", study.title},
                     {"study", study.file},
                     {"scenario", study.scenario_file},
                     {"design", json_of(study.design)},
                     {"runs",
                      {{"done", counts.done},
                       {"doubtful", counts.doubtful},
                       {"diverged", counts.diverged},
                       {"refused", counts.refused}}},
                     {"parameters", parameters},
                     {"responses", responses},
                     {"failed", failed}};
  return json.dump_lines();
}

}  // namespace spoke::study
