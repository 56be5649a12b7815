#pragma once

// What a simulation leaves behind: sensors.csv, a row of sensors per output time, and summary.json,
// what was simulated, how, and the extremes of every sensor. docs/results.md documents every field.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/sensor_file.h"
#include "engine/simulation.h"
#include "spoke/export.h"

namespace spoke {

/// Extremes of one sensor over all steps, t = 0 included, and its value at the last.
struct SensorRange {
  double min = std::numeric_limits<double>::infinity();   ///< smallest value
  double t_min = 0.0;                                     ///< when it was first reached [s]
  double max = -std::numeric_limits<double>::infinity();  ///< largest value
  double t_max = 0.0;                                     ///< when it was first reached [s]
  double final = 0.0;                                     ///< value at the last step
};

/// Gathers the extremes of all sensors. Values that are not numbers count only as final ones.
class SPOKE_EXPORT SensorStatistics {
 public:
  /// Of so many sensors, without a value yet.
  explicit SensorStatistics(std::size_t sensors) : ranges_(sensors) {}
  /// Goes on with what was gathered up to last_time [s].
  SensorStatistics(std::vector<SensorRange> ranges, double last_time)
      : ranges_(std::move(ranges)), last_time_(last_time) {}

  /// values: one for each sensor, at time t [s]. Does not allocate. Throws InputError if there are
  /// more or fewer.
  void add(double t, std::span<const double> values);
  /// By sensor.
  const std::vector<SensorRange>& ranges() const { return ranges_; }
  /// Of the values last added [s].
  double last_time() const { return last_time_; }
  /// The values last added.
  std::vector<double> final_values() const;

 private:
  std::vector<SensorRange> ranges_;
  double last_time_ = 0.0;
};

/// Tells which steps are output: the first one at or after each multiple of an interval.
class SPOKE_EXPORT OutputTimes {
 public:
  /// interval [s]; 0: every step is output. Goes on where next_multiple() was `next`. Throws
  /// InputError unless interval >= 0.
  explicit OutputTimes(double interval, double next = 0.0);

  /// Whether the step that ends at t [s] is output. Call once per step, in order of time. Allows
  /// for the round-off of times: a step 1e-9 of its time too early is on time.
  bool is_due(double t);
  /// The number of the multiple that is due next.
  double next_multiple() const { return next_; }

 private:
  double interval_;
  double next_;
};

/// How a run ended.
struct RunOutcome {
  double wall_time = 0.0;      ///< of the integration loop [s]
  std::string divergence;      ///< the diagnosis; empty: the run did not diverge
  std::string interruption{};  ///< by which signal, when; empty: it was not interrupted
};

/// The text of summary.json.
SPOKE_EXPORT std::string make_summary(const Simulation& simulation,
                                      const SensorStatistics& statistics,
                                      const RunOutcome& outcome);

/// Writes a whole file or nothing. Throws InputError if it cannot be written. The disk is not
/// waited for, see replace_file().
SPOKE_EXPORT void write_file(const std::string& file, const std::string& text);

}  // namespace spoke
