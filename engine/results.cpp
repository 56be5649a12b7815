#include "engine/results.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/machine.h"
#include "models/error.h"

namespace spoke {
namespace {

using Json = nlohmann::ordered_json;

void append_number(std::string& text, double number) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  text.append(buffer.data(), end);
}

[[noreturn]] void fail_to_write(const std::filesystem::path& file) {
  const std::string reason = errno != 0 ? std::strerror(errno) : "unknown reason";
  throw InputError(file.string() + ": cannot be written: " + reason);
}

std::string hexadecimal(std::uint64_t number) {
  std::array<char, 19> text;
  std::snprintf(text.data(), text.size(), "0x%016llx", static_cast<unsigned long long>(number));
  return text.data();
}

Json describe_machine() {
  const Machine machine = this_machine();
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"memory_bytes", machine.memory},
          {"os", machine.os},
          {"compiler", machine.compiler}};
}

Json describe_model(const ModelSize& size) {
  return {{"subsystems", size.subsystems},    {"bodies", size.bodies},
          {"coordinates", size.coordinates},  {"joints", size.joints},
          {"graph_nodes", size.graph_nodes},  {"graph_edges", size.graph_edges},
          {"memory_bytes", size.memory_bytes}};
}

Json describe_sensors(const Simulation& simulation, const SensorStatistics& statistics) {
  Json sensors = Json::object();
  for (std::size_t i = 0; i < statistics.ranges().size(); ++i) {
    const SensorRange& range = statistics.ranges()[i];
    sensors[simulation.sensor_names()[i]] = {{"unit", simulation.sensor_units()[i]},
                                             {"min", range.min},
                                             {"t_min", range.t_min},
                                             {"max", range.max},
                                             {"t_max", range.t_max},
                                             {"final", range.final}};
  }
  return sensors;
}

}  // namespace

void SensorStatistics::add(double t, std::span<const double> values) {
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

bool OutputTimes::is_due(double t) {
  if (interval_ == 0.0) return true;
  const double multiples = t * (1.0 + 1e-9) / interval_;
  if (multiples < next_) return false;
  next_ = std::floor(multiples) + 1.0;
  return true;
}

SensorFile::SensorFile(std::filesystem::path file, const std::vector<std::string>& names)
    : file_(std::move(file)) {
  errno = 0;
  stream_.open(file_, std::ios::binary);
  if (!stream_) fail_to_write(file_);
  line_ = "t";
  for (const std::string& name : names) line_ += ',' + name;
  write_line();
}

void SensorFile::write_row(double t, std::span<const double> values) {
  line_.clear();
  append_number(line_, t);
  for (const double value : values) {
    line_ += ',';
    append_number(line_, value);
  }
  write_line();
}

void SensorFile::write_line() {
  line_ += '\n';
  stream_ << line_;
  if (!stream_) fail_to_write(file_);
}

void SensorFile::close() {
  errno = 0;
  stream_.close();
  if (!stream_) fail_to_write(file_);
}

std::string make_summary(const Simulation& simulation, const SensorStatistics& statistics,
                         const RunOutcome& outcome) {
  const Scenario& scenario = simulation.scenario();
  Json summary = {{"version", SPOKE_VERSION},
                  {"status", outcome.divergence.empty() ? "completed" : "diverged"}};
  if (!outcome.divergence.empty()) summary["message"] = outcome.divergence;
  summary.update({{"scenario", Json::parse(scenario.to_json())},
                  {"model", describe_model(simulation.size())},
                  {"machine", describe_machine()},
                  {"formulation", name_of(simulation.options().formulation)},
                  {"integrator", name_of(scenario.integration.method)},
                  {"executor", name_of(simulation.options().executor)},
                  {"executor_choice", simulation.executor_description()},
                  {"threads", simulation.threads().total()},
                  {"step_size_s", simulation.step_size()},
                  {"steps", simulation.steps()},
                  {"evaluations", simulation.evaluations()},
                  {"wall_time_s", outcome.wall_time},
                  {"state_hash", hexadecimal(simulation.state_hash())},
                  {"sensors", describe_sensors(simulation, statistics)}});
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  // Readers see the old file or the new one, never half of it.
  std::filesystem::path temporary = file;
  temporary += ".tmp";
  errno = 0;
  std::ofstream stream(temporary, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) {
    const int reason = errno;
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    errno = reason;
    fail_to_write(file);
  }
  std::error_code error;
  std::filesystem::rename(temporary, file, error);
  if (error) throw InputError(file.string() + ": cannot be written: " + error.message());
}

}  // namespace spoke
