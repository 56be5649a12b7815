#pragma once

// Statistics of the sensors of one run, over all of its steps.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/support/rainflow.h"
#include "program/study/study.h"

namespace spoke::study {

/// The statistics of one sensor in one run, in its unit.
struct SensorStatistics {
  double mean = 0.0;       ///< over time, by the trapezoidal rule
  double deviation = 0.0;  ///< root of the mean square of the distance from the mean, likewise
  double min = 0.0, max = 0.0;
  double min_time = 0.0, max_time = 0.0;  ///< [s]
  /// Ranges that, once a second, do the damage of all ranges: by exponent.
  std::vector<double> ranges;
  /// Values of all sensors of the statistics at these times.
  std::vector<double> at_min, at_max;
};

/// Collects the statistics of sensors from the values of steps, which come in order of time.
class SensorCollector {
 public:
  /// `sensors`: places of the sensors among the values of a step. Refers to `plan`.
  SensorCollector(const StatisticsPlan& plan, std::vector<std::size_t> sensors);

  /// Adds a step at time t [s]. Steps before the plan's begin do not count.
  void add(double t, std::span<const double> values);
  /// Returns the statistics by sensor; none if no step counts.
  std::vector<SensorStatistics> result() const;

 private:
  /// A sensor's sums. Values are taken from the first one on, so that squares do not cancel.
  struct Series {
    double first = 0.0, last = 0.0;
    double integral = 0.0, squares = 0.0;  ///< of the distances from the first value
    SensorStatistics statistics;
    std::vector<EquivalentRange> ranges;
  };

  void add_value(double t, double value, Series& series);

  const StatisticsPlan* plan_;
  std::vector<std::size_t> sensors_;
  std::vector<Series> series_;
  std::vector<double> row_;  ///< values of the sensors at a step
  bool has_steps_ = false;
  double begin_ = 0.0, last_ = 0.0;  ///< times of the first and the last step that count [s]
};

}  // namespace spoke::study
