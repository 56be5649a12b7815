#pragma once

// Measures a response of a sensor's values, step by step.

#include <limits>
#include <optional>
#include <vector>

#include "engine/results.h"
#include "program/study/study.h"

namespace spoke::study {

/// Values at times.
struct History {
  std::vector<double> times;   ///< [s]
  std::vector<double> values;  ///< values in the sensor's unit
};

/// A response of a sensor in one run. Values come in order of time.
class Measurement {
 public:
  /// output_interval: interval of a history that gives none itself [s].
  Measurement(const Response& response, double output_interval);

  /// Adds the sensor's value at time t [s].
  void add(double t, double value);
  /// Returns the response; not a number where there is none: no step in the window, no crossing.
  double result() const;
  /// Returns the history, for a response that is one.
  History take_history() { return std::move(history_); }

 private:
  void add_extreme(double value);
  void add_to_integral(double t, double value);
  void note_crossing(double t, double value);
  double mean() const;
  double period() const;

  const Response* response_;
  double result_ = std::numeric_limits<double>::quiet_NaN();
  /// Begin of the window, and integral by the trapezoidal rule.
  double begin_ = 0.0, integral_ = 0.0;
  double last_time_ = 0.0, last_value_ = 0.0;
  bool has_values_ = false;
  std::optional<OutputTimes> due_;
  History history_;  ///< values of a history, or of a period
};

}  // namespace spoke::study
