#pragma once

// Results of a simulation: sensors.csv, a row of sensors per output time, and summary.json, the
// model, the method, and the extremes of every sensor. docs/results.md documents every field.

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

class RunStatistics;

/// Extremes of one sensor over all steps, t = 0 included, and its value at the last.
struct SensorRange {
  double min = std::numeric_limits<double>::infinity();   ///< smallest value
  double t_min = 0.0;                                     ///< at which it was first reached [s]
  double max = -std::numeric_limits<double>::infinity();  ///< largest value
  double t_max = 0.0;                                     ///< at which it was first reached [s]
  double final = 0.0;                                     ///< value at the last step
};

/// Collects the extremes of all sensors. Values that are not numbers count only as final ones.
class SPOKE_EXPORT SensorStatistics {
 public:
  /// Makes statistics of so many sensors, without a value yet.
  explicit SensorStatistics(std::size_t sensors) : ranges_(sensors) {}
  /// Goes on from statistics that were collected up to last_time [s].
  SensorStatistics(std::vector<SensorRange> ranges, double last_time)
      : ranges_(std::move(ranges)), last_time_(last_time) {}

  /// Adds the values of all sensors at time t [s], one for each. Does not allocate. Throws
  /// InputError if there are more or fewer.
  void add(double t, std::span<const double> values);
  /// Returns the extremes by sensor.
  const std::vector<SensorRange>& ranges() const { return ranges_; }
  /// Returns the time of the values that were added last [s].
  double last_time() const { return last_time_; }
  /// Returns the values that were added last.
  std::vector<double> final_values() const;

 private:
  std::vector<SensorRange> ranges_;
  double last_time_ = 0.0;
};

/// Chooses the steps of output rows: the first one at or after each multiple of an interval.
class SPOKE_EXPORT OutputTimes {
 public:
  /// `interval` [s]; 0: every step is output. `next` is the next_multiple() from which to go on.
  /// Throws InputError unless interval >= 0.
  explicit OutputTimes(double interval, double next = 0.0);

  /// Returns whether the step that ends at t [s] is output. Must be called once per step, in order
  /// of time. Allows for round-off of times: a step that is early by 1e-9 of its time counts as on
  /// time.
  bool is_due(double t);
  /// Returns the number of the next multiple.
  double next_multiple() const { return next_; }

 private:
  double interval_;
  double next_;
};

/// The end of a run.
struct RunOutcome {
  double wall_time = 0.0;      ///< of the integration loop [s]
  std::string divergence;      ///< the diagnosis; empty: the run did not diverge
  std::string interruption{};  ///< signal and time; empty: the run was not interrupted
};

/// Returns the text of summary.json.
SPOKE_EXPORT std::string make_summary(const Simulation& simulation,
                                      const SensorStatistics& statistics,
                                      const RunOutcome& outcome);
/// Returns the text of summary.json with statistics of the rows, if there are any.
SPOKE_EXPORT std::string make_summary(const Simulation& simulation,
                                      const SensorStatistics& statistics, const RunOutcome& outcome,
                                      const RunStatistics& rows);

/// Writes a whole file or nothing. Throws InputError if it cannot be written. Does not wait for the
/// disk, see replace_file().
SPOKE_EXPORT void write_file(const std::string& file, const std::string& text);

}  // namespace spoke
