#pragma once

// Statistics of a run for summary.json: mean, deviation and extremes of what a turbine is judged
// by, and damage-equivalent ranges of root moments, over the output rows.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/support/rainflow.h"
#include "spoke/export.h"

namespace spoke {

/// Mean, deviation and extremes of values that come one after the other (Welford 1962).
class SPOKE_EXPORT SeriesStatistics {
 public:
  void add(double value);

  std::int64_t count() const { return count_; }
  // Not numbers or infinite without a value.
  double mean() const;
  /// Returns the root of the mean square of the distance from the mean.
  double deviation() const;
  double min() const { return min_; }
  double max() const { return max_; }

 private:
  std::int64_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  ///< sum of the squared distances from the mean
  double min_ = std::numeric_limits<double>::infinity();
  double max_ = -std::numeric_limits<double>::infinity();
};

/// Statistics of one sensor. Values that are not finite do not count.
struct SensorSeries {
  std::size_t sensor = 0;  ///< its place in Simulation::sensor_names()
  SeriesStatistics values{};
  /// Of root moments alone. Those of blades in space, whose sensors are in the hub's frame, are of
  /// the moment about the axes of the blade's own root: x along the blade, y flapwise, z edgewise.
  std::optional<EquivalentRange> ranges{};
  double exponent = 0.0;  ///< of Woehler's curve, of the ranges
  /// The axis of these in the hub's frame, along which the moment's three sensors from `first` on
  /// are taken; none: the sensor as it is.
  std::optional<std::array<double, 3>> axis{};
  std::size_t first = 0;

  /// Returns the value of a row whose ranges count.
  double ranged_value(std::span<const double> row) const;
};

/// Collects statistics of a run's rows: of the sensors "air.power", "air.thrust", "hub.speed" and
/// "control.pitch.angle", as far as there are such, and of all root moments.
class SPOKE_EXPORT RunStatistics {
 public:
  /// Frequency of the cycles of damage-equivalent ranges [Hz].
  static constexpr double kFrequency = 1.0;

  /// Prepares statistics of the rows at and after `from` [s]. Without `from` all rows of a model in
  /// air count, and no others. Throws InputError unless from >= 0.
  explicit RunStatistics(const Simulation& simulation, std::optional<double> from = std::nullopt);

  /// Adds a row: all sensors at time t [s]. Rows must come in order of time.
  void add_row(double t, std::span<const double> values);

  /// Returns the series by place of their sensors; none: no statistics are collected.
  const std::vector<SensorSeries>& series() const { return series_; }
  double from() const { return from_; }         ///< [s]
  std::int64_t rows() const { return rows_; }   ///< that count
  double first_time() const { return first_; }  ///< of a row that counts [s]
  double last_time() const { return last_; }    ///< of a row that counts [s]
  /// Returns the range that root moments have as often as kFrequency says over the time between
  /// first and last row, to the same damage; not a number if there is no such time.
  double equivalent_range(const SensorSeries& series) const;

 private:
  double from_ = 0.0;
  std::int64_t rows_ = 0;
  double first_ = 0.0, last_ = 0.0;
  std::vector<SensorSeries> series_;
};

}  // namespace spoke
