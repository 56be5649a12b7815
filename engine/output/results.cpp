// Collects extremes of the sensors, chooses times of output rows, and fills the fields of
// summary.json.

#include "engine/results.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "engine/output_file.h"
#include "engine/run_statistics.h"
#include "engine/support/machine_json.h"
#include "engine/support/source_commit.h"
#include "models/error.h"
#include "models/reader/scenario_json.h"
#include "models/support/instructions.h"

namespace spoke {
namespace {

std::string hexadecimal(std::uint64_t number) {
  std::array<char, 19> text;
  std::snprintf(text.data(), text.size(), "0x%016llx", static_cast<unsigned long long>(number));
  return text.data();
}

Json describe_model(const ModelSize& size) {
  return {{"subsystems", size.subsystems},
          {"bodies", size.bodies},
          {"coordinates", size.coordinates},
          {"joints", size.joints},
          {"loops", size.loops},
          {"couplings", size.couplings},
          {"freedoms", size.freedoms},
          {"graph_nodes", size.graph_nodes},
          {"graph_edges", size.graph_edges},
          {"memory_bytes", size.memory_bytes}};
}

Json describe_sensors(const Simulation& simulation, const SensorStatistics& statistics) {
  Json sensors = Json::object();
  for (std::size_t i = 0; i < statistics.ranges().size(); ++i) {
    const SensorRange& range = statistics.ranges()[i];
    sensors.set(simulation.sensor_names()[i], {{"unit", simulation.sensor_units()[i]},
                                               {"min", range.min},
                                               {"t_min", range.t_min},
                                               {"max", range.max},
                                               {"t_max", range.t_max},
                                               {"final", range.final}});
  }
  return sensors;
}

Json describe_series(const Simulation& simulation, const RunStatistics& rows,
                     const SensorSeries& series) {
  Json json = {{"unit", simulation.sensor_units()[series.sensor]},
               {"mean", series.values.mean()},
               {"standard_deviation", series.values.deviation()},
               {"min", series.values.min()},
               {"max", series.values.max()}};
  if (series.ranges) {
    json.set("damage_equivalent_range", rows.equivalent_range(series));
    json.set("wohler_exponent", series.exponent);
  }
  return json;
}

Json describe_rows(const Simulation& simulation, const RunStatistics& rows) {
  Json sensors = Json::object();
  for (const SensorSeries& series : rows.series())
    sensors.set(simulation.sensor_names()[series.sensor],
                describe_series(simulation, rows, series));
  return {{"of", "output rows"},
          {"from_s", rows.from()},
          {"rows", rows.rows()},
          {"first_row_s", rows.first_time()},
          {"last_row_s", rows.last_time()},
          {"wohler_exponent", find_wohler_exponent(simulation.scenario(), "blade")},
          {"equivalent_frequency_hz", RunStatistics::kFrequency},
          {"sensors", sensors}};
}

Json describe_loops_at_start(const LoopsAtStart& loops) {
  Json subsystems = Json::array(), moved = Json::array(), speeds = Json::array();
  for (const SubsystemFreedoms& own : loops.subsystems)
    subsystems.push_back({{"name", own.name},
                          {"joint_coordinates", own.joints},
                          {"deformation_coordinates", own.deformations},
                          {"rows", own.rows},
                          {"independent_rows", own.independent},
                          {"mobility", own.mobility}});
  for (const MovedJoint& joint : loops.moved)
    moved.push_back({{"joint", joint.joint}, {"by", joint.by}, {"unit", joint.unit}});
  for (const ChangedSpeed& speed : loops.speeds)
    speeds.push_back(
        {{"joint", speed.joint}, {"from", speed.from}, {"to", speed.to}, {"unit", speed.unit}});
  return {{"subsystems", subsystems},
          {"redundant_rows", loops.redundant},
          {"moved", moved},
          {"changed_speeds", speeds}};
}

/// Describes the error of a step; nothing for rk4.
Json describe_accuracy(const Simulation& simulation) {
  const StepAccuracy accuracy = simulation.step_accuracy();
  if (accuracy.place.empty()) return nullptr;
  return {{"largest", accuracy.error},
          {"t", accuracy.time},
          {"place", accuracy.place},
          {"step_for_limit_s", accuracy.step}};
}

Json describe_events(const std::vector<EventInRun>& events) {
  Json json = Json::array();
  for (const EventInRun& event : events)
    json.push_back({{"name", event.name}, {"t", event.time ? Json(*event.time) : Json(nullptr)}});
  return json;
}

const char* status_of(const RunOutcome& outcome) {
  if (!outcome.divergence.empty()) return "diverged";
  return outcome.interruption.empty() ? "completed" : "interrupted";
}

/// Returns the number of processes that simulate the model together.
int count_processes(const SimulationOptions& options) {
  return options.exchange ? options.exchange->count() : 1;
}

}  // namespace

void SensorStatistics::add(double t, std::span<const double> values) {
  if (values.size() != ranges_.size())
    throw InputError("SensorStatistics::add(): " + std::to_string(values.size()) +
                     " values, expected " + std::to_string(ranges_.size()));
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    SensorRange& range = ranges_[i];
    const double value = values[i];
    if (value < range.min) {
      range.min = value;
      range.t_min = t;
    }
    if (value > range.max) {
      range.max = value;
      range.t_max = t;
    }
    range.final = value;
  }
  last_time_ = t;
}

std::vector<double> SensorStatistics::final_values() const {
  std::vector<double> values;
  values.reserve(ranges_.size());
  for (const SensorRange& range : ranges_) values.push_back(range.final);
  return values;
}

OutputTimes::OutputTimes(double interval, double next) : interval_(interval), next_(next) {
  if (!(interval >= 0.0)) throw InputError("OutputTimes: expected an interval of 0 or more");
}

bool OutputTimes::is_due(double t) {
  if (interval_ == 0.0) return true;
  const double multiples = t * (1.0 + 1e-9) / interval_;
  if (multiples < next_) return false;
  next_ = std::floor(multiples) + 1.0;
  return true;
}

namespace {

Json summarise(const Simulation& simulation, const SensorStatistics& statistics,
               const RunOutcome& outcome) {
  const Scenario& scenario = simulation.scenario();
  Json summary = {{"version", SPOKE_VERSION}};
  if (!source_commit().empty()) summary.set("commit", source_commit());
  summary.set("status", status_of(outcome));
  const std::string message = outcome.divergence + outcome.interruption;
  if (!message.empty()) summary.set("message", message);
  std::vector<std::string> warnings;
  for (const Warning& warning : simulation.warnings()) warnings.push_back(warning.text);
  summary.set("warnings", warnings);
  summary.update({{"scenario", scenario_to_json(scenario)},
                  {"model", describe_model(simulation.size())},
                  {"machine", describe_machine(this_machine())},
                  {"formulation", name_of(simulation.options().formulation)},
                  {"integrator", name_of(scenario.integration.method)},
                  {"executor", simulation.executor_name()},
                  {"executor_choice", simulation.executor_description()},
                  {"threads", simulation.threads().total()},
                  {"processes", count_processes(simulation.options())},
                  {"step_size_s", simulation.step_size()},
                  {"steps", simulation.steps()},
                  {"evaluations", simulation.evaluations()},
                  {"step_error", describe_accuracy(simulation)},
                  {"wall_time_s", outcome.wall_time},
                  {"instructions", instructions_in_use()},
                  {"state_hash", hexadecimal(simulation.state_hash())},
                  {"sensors", describe_sensors(simulation, statistics)}});
  if (const LoopsAtStart loops = simulation.loops_at_start(); !loops.subsystems.empty())
    summary.set("loops", describe_loops_at_start(loops));
  if (const std::vector<EventInRun> events = simulation.events(); !events.empty())
    summary.set("events", describe_events(events));
  return summary;
}

}  // namespace

std::string make_summary(const Simulation& simulation, const SensorStatistics& statistics,
                         const RunOutcome& outcome) {
  return summarise(simulation, statistics, outcome).dump_lines();
}

std::string make_summary(const Simulation& simulation, const SensorStatistics& statistics,
                         const RunOutcome& outcome, const RunStatistics& rows) {
  Json summary = summarise(simulation, statistics, outcome);
  if (!rows.series().empty()) summary.set("statistics", describe_rows(simulation, rows));
  return summary.dump_lines();
}

void write_file(const std::string& file, const std::string& text) {
  replace_file(file, text, Outlives::process);
}

}  // namespace spoke
