// Makes a scenario out of values, simulates it or solves for its modes, and finds the responses.

#include "program/study/single_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "engine/simulation/simulation_core.h"
#include "models/error.h"
#include "models/support/nearest_name.h"
#include "models/support/quantity.h"

namespace spoke::study {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kNamedModes = 10;  // number of modes among which one is looked for by its name
// The numbers of runs that check_study() tries before it takes none to be possible: runs read, and
// runs built, which takes longer.
constexpr std::int64_t kMostTried = 1000, kMostBuilt = 50;

SimulationOptions on_one_thread() {
  SimulationOptions options;
  options.executor = ExecutorKind::serial;
  options.threads = {1, 1};
  return options;
}

Scenario make_scenario(const Study& study, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]) && !is_left_out(study.parameters[i], values[i]))
      throw InputError("--set " + study.parameters[i].key + "=: is " +
                       toml_text(study.parameters[i], values[i]) + ", expected a finite number");
  return parse_scenario(study.scenario_text, study.scenario_file, make_overrides(study, values));
}

/// Whether a response needs the sensors at each step; otherwise steps are made without them.
bool needs_steps(const Study& study) {
  return study.statistics ||
         std::any_of(study.responses.begin(), study.responses.end(), [](const Response& r) {
           return r.kind != ResponseKind::frequency && r.kind != ResponseKind::final;
         });
}

/// Returns the places of the sensors of a study's statistics. Throws InputError if one is missing.
std::vector<std::size_t> places_of(const StatisticsPlan& plan, const Simulation& simulation) {
  std::vector<std::size_t> places;
  for (const std::string& sensor : plan.sensors) places.push_back(simulation.sensor_index(sensor));
  return places;
}

/// The measurements of a study's responses of sensors.
struct Measurements {
  Measurements(const Study& study, const Simulation& simulation) {
    for (std::size_t k = 0; k < study.responses.size(); ++k) {
      const Response& response = study.responses[k];
      if (response.kind == ResponseKind::frequency) continue;
      places.push_back(k);
      sensors.push_back(simulation.sensor_index(response.sensor));
      measured.emplace_back(response, simulation.scenario().output.interval);
    }
    if (study.statistics)
      collector.emplace(*study.statistics, places_of(*study.statistics, simulation));
  }

  void add(double t, std::span<const double> values) {
    for (std::size_t i = 0; i < measured.size(); ++i) measured[i].add(t, values[sensors[i]]);
    if (collector) collector->add(t, values);
  }

  std::vector<std::size_t> places, sensors;  ///< places among responses, and of sensors
  std::vector<Measurement> measured;
  std::optional<SensorCollector> collector;  ///< of the study's statistics
};

void describe_warnings(const Simulation& simulation, RunResult& result) {
  for (const Warning& warning : simulation.warnings()) {
    result.status = RunStatus::doubtful;
    result.diagnosis += (result.diagnosis.empty() ? "" : "; ") + warning.text;
  }
}

void simulate(const Study& study, Simulation& simulation, RunResult& result) {
  Measurements measurements(study, simulation);
  measurements.add(simulation.time(), simulation.sensor_values());
  if (needs_steps(study)) {
    simulation.run_until(
        std::numeric_limits<double>::infinity(),
        [&](double t, std::span<const double> values) { measurements.add(t, values); });
  } else {
    simulation.run_until(std::numeric_limits<double>::infinity());
    measurements.add(simulation.time(), simulation.sensor_values());
  }
  for (std::size_t i = 0; i < measurements.measured.size(); ++i) {
    const std::size_t k = measurements.places[i];
    result.responses[k] = measurements.measured[i].result();
    if (study.responses[k].kind == ResponseKind::history)
      result.histories.push_back(measurements.measured[i].take_history());
  }
  if (measurements.collector) result.statistics = measurements.collector->result();
  describe_warnings(simulation, result);
}

/// Finds a mode by its number or name; null if there is none.
const Mode* find_mode(const Response& response, const ModesResult& modes) {
  int number = 0;
  for (const Mode& mode : modes.modes) {
    if (!response.mode_of.empty() && mode.of != response.mode_of) continue;
    ++number;
    if (response.mode_name.empty() ? number == response.mode : mode.name == response.mode_name)
      return &mode;
  }
  return nullptr;
}

/// Lists the names of the existing modes: "flap 1", "lag 1" or "torsion 1".
std::string list_modes(const Response& response, const ModesResult& modes) {
  std::vector<std::string_view> names;
  for (const Mode& mode : modes.modes)
    names.push_back(response.mode_name.empty() ? mode.of : mode.name);
  const auto nearest = nearest_name(response.mode_name, names);
  if (nearest && !response.mode_name.empty())
    return "did you mean \"" + std::string(*nearest) + "\"?";
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::string list;
  for (const std::string_view name : names)
    list += (list.empty() ? "\"" : ", \"") + std::string(name) + '"';
  return "expected one of " + list;
}

/// Solves for the modes about a speed: as many as responses ask for by number, and if some ask by
/// name, up to kNamedModes where there are so many.
ModesResult solve_modes_of(const Study& study, const Scenario& scenario,
                           const std::optional<double>& speed) {
  int least = 1, most = 1;
  for (const Response& response : study.responses) {
    if (response.kind != ResponseKind::frequency || response.speed != speed) continue;
    least = std::max(least, response.mode);
    most = std::max({most, least, response.mode_name.empty() ? 1 : kNamedModes});
  }
  for (; most > least; --most) try {
      return solve_modes(scenario, {{speed}, most});
    } catch (const InputError&) {
      // There are fewer modes than that; or the last attempt will say what is wrong.
    }
  return solve_modes(scenario, {{speed}, most});
}

/// Solves for the modes once for each speed.
void find_frequencies(const Study& study, const Scenario& scenario, RunResult& result) {
  std::map<std::optional<double>, ModesResult> solved;
  for (std::size_t k = 0; k < study.responses.size(); ++k) {
    const Response& response = study.responses[k];
    if (response.kind != ResponseKind::frequency) continue;
    auto found = solved.find(response.speed);
    if (found == solved.end())
      found = solved.emplace(response.speed, solve_modes_of(study, scenario, response.speed)).first;
    const Mode* mode = find_mode(response, found->second);
    if (mode == nullptr)
      throw InputError(response.place + ": there is no such mode, " +
                       list_modes(response, found->second));
    result.responses[k] = mode->frequency / (2.0 * std::numbers::pi);
  }
}

/// Whether two runs differ only in values of the drive, see SimulationCore::begin_again().
bool has_same_model(const Study& study, const std::vector<double>& a,
                    const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::string& key = study.parameters[i].key;
    const bool is_of_drive = key.starts_with("hub.drive.") && key != "hub.drive.kind";
    if (!key.empty() && !is_of_drive && a[i] != b[i]) return false;
  }
  return true;
}

/// Converts an error about an override of a run to one about the parameter that made it.
InputError locate(const Study& study, std::int64_t run, const std::string& message) {
  for (const Parameter& parameter : study.parameters) {
    const std::string begin = "--set " + parameter.key + '=';
    if (parameter.key.empty() || !message.starts_with(begin)) continue;
    const std::size_t end = message.find(": ", begin.size());
    return InputError(parameter.place + ": in run " + std::to_string(run + 1) + ": " +
                      message.substr(end + 2));
  }
  for (const std::string& file : {study.file, study.scenario_file})
    if (message.starts_with(file + ':')) return InputError(message);
  return InputError(study.scenario_file + ": " + message);
}

/// Whether a name is one that statistics ask for: it, or its beginning with "*" behind.
bool is_asked(const std::string& name, const std::string& asked) {
  return asked.ends_with('*') ? name.starts_with(asked.substr(0, asked.size() - 1)) : name == asked;
}

/// Fills in the sensors that a study's statistics ask for, in the order of the simulation's.
void choose_sensors(const Simulation& simulation, StatisticsPlan& plan) {
  const std::vector<std::string>& known = simulation.sensor_names();
  plan.sensors.clear();
  plan.units.clear();
  for (const std::string& asked : plan.asked)
    if (std::none_of(known.begin(), known.end(),
                     [&](const std::string& name) { return is_asked(name, asked); }))
      throw InputError(plan.place + ": \"" + asked + "\" is no sensor, expected one such as \"" +
                       known.front() + "\", or the beginning of some with \"*\" behind");
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!plan.asked.empty() &&
        std::none_of(plan.asked.begin(), plan.asked.end(),
                     [&](const std::string& asked) { return is_asked(known[i], asked); }))
      continue;
    plan.sensors.push_back(known[i]);
    plan.units.push_back(simulation.sensor_units()[i]);
  }
  const double end = simulation.scenario().integration.duration;
  if (plan.from >= end)
    throw InputError(plan.place + ": statistics begin at " + describe(plan.from) +
                     " s, expected a time before the end, " + describe(end) + " s");
}

void check_sensors(const Simulation& simulation, Study& study) {
  if (study.statistics) choose_sensors(simulation, *study.statistics);
  const std::vector<std::string>& known = simulation.sensor_names();
  for (Response& response : study.responses) {
    if (response.kind == ResponseKind::frequency) continue;
    const auto found = std::find(known.begin(), known.end(), response.sensor);
    if (found == known.end()) {
      const std::vector<std::string_view> names(known.begin(), known.end());
      const auto nearest = nearest_name(response.sensor, names);
      throw InputError(response.place + ": \"" + response.sensor + "\" is no sensor, " +
                       (nearest ? "did you mean \"" + std::string(*nearest) + "\"?"
                                : "expected one such as \"" + known.front() + '"'));
    }
    const bool is_time =
        response.kind == ResponseKind::first_crossing || response.kind == ResponseKind::period;
    response.unit =
        is_time ? "s" : simulation.sensor_units()[static_cast<std::size_t>(found - known.begin())];
    const double end = simulation.scenario().integration.duration;
    const double begin = std::max(response.from, response.time);
    if (begin > end)
      throw InputError(response.place + ": looks at " + describe(begin) +
                       " s, expected a time within the duration, " + describe(end) + " s");
  }
}

/// Checks that a run can be made, with the sensors and modes that are asked for.
void check_run(const Scenario& scenario, Study& study) {
  RunResult result;
  result.responses.assign(study.responses.size(), kNone);
  if (study.simulates()) check_sensors(Simulation(scenario, on_one_thread()), study);
  if (std::any_of(study.responses.begin(), study.responses.end(),
                  [](const Response& r) { return r.kind == ResponseKind::frequency; }))
    find_frequencies(study, scenario, result);
}

/// Returns the run that is tried as number `k`, each once: run 0 first, then runs spread over all,
/// in strides of a golden section, which no parameter's period divides.
std::int64_t run_to_try(std::int64_t k, std::int64_t runs) {
  auto stride = static_cast<std::int64_t>(0.6180339887498949 * static_cast<double>(runs)) + 1;
  while (std::gcd(stride, runs) != 1) ++stride;
  return k * stride % runs;
}

}  // namespace

std::string_view name_of(RunStatus status) {
  constexpr std::array<std::string_view, 4> names = {"done", "doubtful", "diverged", "refused"};
  return names[static_cast<std::size_t>(status)];
}

void check_study(Study& study) {
  parse_scenario(study.scenario_text, study.scenario_file);
  const Sampling sampling(study);
  std::optional<InputError> first;  // the error of run 1
  bool diverges = false;
  std::int64_t built = 0;
  const std::int64_t tries = std::min(study.design.runs, kMostTried);
  for (std::int64_t k = 0; k < tries && built < kMostBuilt; ++k) {
    const std::int64_t run = run_to_try(k, study.design.runs);
    try {
      const Scenario scenario = make_scenario(study, sampling.values(run));
      ++built;
      check_run(scenario, study);
      return;
    } catch (const InputError& error) {
      if (!first) first = locate(study, run, error.what());
    } catch (const DivergenceError&) {
      diverges = true;  // a row of its own
    }
  }
  if (!diverges) throw *first;
}

/// A simulation, and the state where it began.
struct RunMaker::Built {
  Built(const Scenario& scenario, const std::vector<double>& of_values)
      : simulation(scenario, on_one_thread()),
        start(core_of(simulation).take_values(0)),
        values(of_values) {}

  Simulation simulation;
  std::vector<double> start;
  std::vector<double> values;  ///< values of the parameters
};

RunMaker::RunMaker(const Study& study, const Sampling& sampling)
    : study_(study), sampling_(sampling) {}

RunMaker::~RunMaker() = default;

Simulation& RunMaker::simulation_of(const Scenario& scenario, const std::vector<double>& values) {
  if (built_ && may_begin_again(scenario) && has_same_model(study_, built_->values, values)) {
    core_of(built_->simulation).begin_again(scenario, built_->start);
  } else {
    built_.reset();
    built_ = std::make_unique<Built>(scenario, values);
  }
  return built_->simulation;
}

void RunMaker::run_scenario(const Scenario& scenario, const std::vector<double>& values,
                            RunResult& result) {
  if (study_.simulates()) simulate(study_, simulation_of(scenario, values), result);
  if (std::any_of(study_.responses.begin(), study_.responses.end(),
                  [](const Response& r) { return r.kind == ResponseKind::frequency; }))
    find_frequencies(study_, scenario, result);
}

RunResult RunMaker::make(std::int64_t run) {
  RunResult result;
  result.run = run;
  result.responses.assign(study_.responses.size(), kNone);
  try {
    const std::vector<double> values = sampling_.values(run);
    run_scenario(make_scenario(study_, values), values, result);
    return result;
  } catch (const DivergenceError& error) {
    result.status = RunStatus::diverged;
    result.diagnosis = error.what();
  } catch (const InputError& error) {
    result.status = RunStatus::refused;
    result.diagnosis = error.what();
  }
  result.responses.assign(study_.responses.size(), kNone);
  result.histories.clear();
  result.statistics.clear();
  return result;
}

}  // namespace spoke::study
