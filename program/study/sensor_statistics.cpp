// Integrates values and squares, and counts ranges.

#include "program/study/sensor_statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spoke::study {

SensorCollector::SensorCollector(const StatisticsPlan& plan, std::vector<std::size_t> sensors)
    : plan_(&plan),
      sensors_(std::move(sensors)),
      series_(sensors_.size()),
      row_(sensors_.size(), 0.0) {
  for (Series& series : series_)
    for (const double exponent : plan.exponents) series.ranges.emplace_back(exponent);
}

void SensorCollector::add(double t, std::span<const double> values) {
  if (t < plan_->from) return;
  for (std::size_t i = 0; i < sensors_.size(); ++i) row_[i] = values[sensors_[i]];
  if (!has_steps_) begin_ = t;
  for (std::size_t i = 0; i < series_.size(); ++i) add_value(t, row_[i], series_[i]);
  has_steps_ = true;
  last_ = t;
}

void SensorCollector::add_value(double t, double value, Series& series) {
  SensorStatistics& statistics = series.statistics;
  if (!has_steps_) {
    series.first = value;
  } else {
    const double a = series.last - series.first, b = value - series.first;
    series.integral += 0.5 * (t - last_) * (a + b);
    series.squares += 0.5 * (t - last_) * (a * a + b * b);
  }
  series.last = value;
  if (!has_steps_ || value < statistics.min) {
    statistics.min = value;
    statistics.min_time = t;
    statistics.at_min = row_;
  }
  if (!has_steps_ || value > statistics.max) {
    statistics.max = value;
    statistics.max_time = t;
    statistics.at_max = row_;
  }
  if (std::isfinite(value))
    for (EquivalentRange& range : series.ranges) range.add(value);
}

std::vector<SensorStatistics> SensorCollector::result() const {
  std::vector<SensorStatistics> all;
  if (!has_steps_) return all;
  const double seconds = last_ - begin_;
  for (const Series& series : series_) {
    SensorStatistics statistics = series.statistics;
    const double mean = seconds > 0.0 ? series.integral / seconds : 0.0;
    const double square = seconds > 0.0 ? series.squares / seconds : 0.0;
    statistics.mean = series.first + mean;
    statistics.deviation = std::sqrt(std::max(square - mean * mean, 0.0));
    for (const EquivalentRange& range : series.ranges)
      statistics.ranges.push_back(seconds > 0.0 ? range.calc(seconds) : 0.0);
    all.push_back(std::move(statistics));
  }
  return all;
}

}  // namespace spoke::study
