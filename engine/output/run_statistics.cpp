// Chooses the sensors of which a run has statistics, and collects these.

#include "engine/run_statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "models/error.h"

namespace spoke {
namespace {

/// Returns the subsystem of which a sensor is the root moment: "blade1"; empty: of none.
std::string find_owner(const std::string& name) {
  constexpr std::array<std::string_view, 4> kEnds{".root.moment", ".root.moment.x",
                                                  ".root.moment.y", ".root.moment.z"};
  for (const std::string_view end : kEnds)
    if (name.ends_with(end)) return name.substr(0, name.size() - end.size());
  return {};
}

bool has_statistics(const std::string& name) {
  constexpr std::array<std::string_view, 4> kNames{"air.power", "air.thrust", "hub.speed",
                                                   "control.pitch.angle"};
  // Those of further rotors have its name before: "tail.air.power".
  const auto is_shown = [&name](std::string_view shown) {
    return name.ends_with(shown) &&
           (name.size() == shown.size() || name[name.size() - shown.size() - 1] == '.');
  };
  return std::any_of(kNames.begin(), kNames.end(), is_shown) || !find_owner(name).empty();
}

/// Returns the axes of the root of a blade or another subsystem, as columns in the hub's frame; the
/// unit matrix where it has none of its own.
Eigen::Matrix3d find_root_axes(const Scenario& scenario, const std::string& owner) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  const spatial::Model& model = *scenario.space;
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    if (owner == "blade" + std::to_string(i + 1))
      return (AngleAxisd(model.blades[i].azimuth, Vector3d::UnitZ()) *
              AngleAxisd(-model.blades[i].precone, Vector3d::UnitY()))
          .toRotationMatrix();
  for (const spatial::Subsystem& subsystem : model.subsystems)
    if (owner == subsystem.name)
      return AngleAxisd(subsystem.azimuth, Vector3d::UnitZ()).toRotationMatrix();
  return Eigen::Matrix3d::Identity();
}

/// Makes the series of a root moment.
SensorSeries make_moment_series(const Scenario& scenario, const std::string& name,
                                const std::string& owner, std::size_t sensor) {
  SensorSeries series{sensor};
  series.exponent = find_wohler_exponent(scenario, owner);
  series.ranges.emplace(series.exponent);
  if (!scenario.space) return series;
  const Eigen::Matrix3d axes = find_root_axes(scenario, owner);
  if (axes.isIdentity(0.0)) return series;  // no other bits than the sensor's
  const auto direction = static_cast<std::size_t>(name.back() - 'x');
  const Eigen::Vector3d axis = axes.col(static_cast<Eigen::Index>(direction));
  series.axis = {axis.x(), axis.y(), axis.z()};
  series.first = sensor - direction;
  return series;
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

double SensorSeries::ranged_value(std::span<const double> row) const {
  if (!axis) return row[sensor];
  return (*axis)[0] * row[first] + (*axis)[1] * row[first + 1] + (*axis)[2] * row[first + 2];
}

RunStatistics::RunStatistics(const Simulation& simulation, std::optional<double> from)
    : from_(from.value_or(0.0)) {
  if (!(from_ >= 0.0)) throw InputError("RunStatistics: expected a time of 0 or more (s)");
  if (!from && !is_in_air(simulation.scenario())) return;
  const std::vector<std::string>& names = simulation.sensor_names();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!has_statistics(names[k])) continue;
    const std::string owner = find_owner(names[k]);
    series_.push_back(owner.empty()
                          ? SensorSeries{k}
                          : make_moment_series(simulation.scenario(), names[k], owner, k));
  }
}

void RunStatistics::add_row(double t, std::span<const double> values) {
  if (t * (1.0 + 1e-9) < from_) return;  // round-off of times, as of OutputTimes
  if (rows_++ == 0) first_ = t;
  last_ = t;
  for (SensorSeries& series : series_) {
    if (const double value = values[series.sensor]; std::isfinite(value)) series.values.add(value);
    if (!series.ranges) continue;
    if (const double value = series.ranged_value(values); std::isfinite(value))
      series.ranges->add(value);
  }
}

double RunStatistics::equivalent_range(const SensorSeries& series) const {
  const double cycles = kFrequency * (last_ - first_);
  if (!(cycles > 0.0) || !series.ranges) return std::numeric_limits<double>::quiet_NaN();
  return series.ranges->calc(cycles);
}

}  // namespace spoke
