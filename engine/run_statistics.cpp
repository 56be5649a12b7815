// Chooses the sensors of which a run has statistics, and collects these.

#include "engine/run_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "models/error.h"

namespace spoke {
namespace {

bool is_root_moment(std::string_view name) {
  constexpr std::array<std::string_view, 4> kEnds{".root.moment", ".root.moment.x",
                                                  ".root.moment.y", ".root.moment.z"};
  return std::any_of(kEnds.begin(), kEnds.end(),
                     [&](std::string_view end) { return name.ends_with(end); });
}

bool has_statistics(std::string_view name) {
  constexpr std::array<std::string_view, 4> kNames{"air.power", "air.thrust", "hub.speed",
                                                   "control.pitch.angle"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end() || is_root_moment(name);
}

bool is_in_air(const Scenario& scenario) { return scenario.space && scenario.space->air; }

}  // namespace

void SeriesStatistics::add(double value) {
  ++count_;
  const double before = value - mean_;
  mean_ += before / static_cast<double>(count_);
  squares_ += before * (value - mean_);
  min_ = std::min(min_, value);
  max_ = std::max(max_, value);
}

double SeriesStatistics::mean() const {
  return count_ > 0 ? mean_ : std::numeric_limits<double>::quiet_NaN();
}

double SeriesStatistics::deviation() const {
  return std::sqrt(squares_ / static_cast<double>(count_));
}

RunStatistics::RunStatistics(const Simulation& simulation, std::optional<double> from)
    : from_(from.value_or(0.0)) {
  if (!(from_ >= 0.0)) throw InputError("RunStatistics: expected a time of 0 or more (s)");
  if (!from && !is_in_air(simulation.scenario())) return;
  const std::vector<std::string>& names = simulation.sensor_names();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!has_statistics(names[k])) continue;
    series_.push_back({k});
    if (is_root_moment(names[k])) series_.back().ranges.emplace(kExponent);
  }
}

void RunStatistics::add_row(double t, std::span<const double> values) {
  if (t * (1.0 + 1e-9) < from_) return;  // round-off of times, as of OutputTimes
  if (rows_++ == 0) first_ = t;
  last_ = t;
  for (SensorSeries& series : series_) {
    const double value = values[series.sensor];
    if (!std::isfinite(value)) continue;
    series.values.add(value);
    if (series.ranges) series.ranges->add(value);
  }
}

double RunStatistics::equivalent_range(const SensorSeries& series) const {
  const double cycles = kFrequency * (last_ - first_);
  if (!(cycles > 0.0) || !series.ranges) return std::numeric_limits<double>::quiet_NaN();
  return series.ranges->calc(cycles);
}

}  // namespace spoke
