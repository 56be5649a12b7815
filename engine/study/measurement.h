#pragma once

// What a response makes of a sensor's values, step by step.

#include <limits>
#include <optional>
#include <vector>

#include "engine/results.h"
#include "engine/study/study.h"

namespace spoke::study {

/// Values at times.
struct History {
  std::vector<double> times;   ///< [s]
  std::vector<double> values;  ///< in the sensor's unit
};

/// One response of one run, of a sensor. Values come in order of time.
class Measurement {
 public:
  /// output_interval: of a history that does not say its own [s].
  Measurement(const Response& response, double output_interval);

  /// The sensor's value at time t [s].
  void add(double t, double value);
  /// The response; not a number where there is none: no step in the window, no crossing.
  double result() const;
  /// Of a response that is a history.
  History take_history() { return std::move(history_); }

 private:
  void add_extreme(double value);
  void add_to_integral(double t, double value);
  void note_crossing(double t, double value);
  double mean() const;
  double period() const;

  const Response* response_;
  double result_ = std::numeric_limits<double>::quiet_NaN();
  double begin_ = 0.0, integral_ = 0.0;  ///< of the window, by the trapezoidal rule
  double last_time_ = 0.0, last_value_ = 0.0;
  bool has_values_ = false;
  std::optional<OutputTimes> due_;
  History history_;  ///< of history, and of period
};

}  // namespace spoke::study
