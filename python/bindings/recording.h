#pragma once

// A run for Python: steps with the interpreter lock released, rows in memory.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/courses.h"
#include "engine/results.h"
#include "engine/run_statistics.h"
#include "program/run_report/picture_steps.h"
#include "program/run_report/recorder.h"
#include "program/run_report/tip_deflections.h"
#include "python/bindings/used_simulation.h"

namespace spoke::python {

class SignalWatch;

/// The sensors of a run at its output times, and the data of its page.
class Recording {
 public:
  /// Prepares a run from the simulation's present state on, with a row every `every` [s]; 0: every
  /// step. `has_page`: whether make_page() will be called. `statistics_from`: see RunStatistics.
  /// Throws InputError unless both times are 0 or more.
  Recording(std::shared_ptr<UsedSimulation> simulation, double every, bool has_page,
            std::optional<double> statistics_from);

  /// Steps to time `until` [s]; the present state and the last step are rows, too. Throws like
  /// Simulation::run_until(), and at the end of a step what Python raises for a signal; earlier
  /// rows stay recorded. To be called once, with the interpreter lock held.
  void run(double until);

  std::size_t rows() const { return numbers_.size() / width(); }
  /// Returns the width of a row: time, then the sensors.
  std::size_t width() const { return simulation_->sensor_names().size() + 1; }
  /// Returns the numbers by row. They stay where they are once the run is over.
  const std::vector<double>& numbers() const { return numbers_; }
  const Simulation& simulation() const { return *simulation_; }
  double wall_time() const { return outcome_.wall_time; }  ///< wall time of the steps [s]

  bool has_page() const { return recorder_.has_value(); }
  /// Whether the simulation can still be put where the run ended, as summary and page need; not if
  /// it diverged and was restored since.
  bool is_at_hand() const { return last_ || simulation_->steps() == last_step_; }

  /// Returns summary.json of the run. Throws StateError if the run diverged and the simulation was
  /// restored since.
  std::string make_summary();
  /// Returns report.html of the run. Throws StateError without `has_page`, and where make_summary()
  /// does.
  std::string make_page();

 private:
  void add_row(double t, std::span<const double> sensors);
  void add(double t, std::span<const double> sensors);
  template <class Observe>
  void step_to(double until, const bool& is_stopped, const Observe& observe);
  void step_to(double until, SignalWatch& watch);
  void finish();
  void keep_end();
  template <class Make>
  std::string at_last_step(Make&& make);

  std::shared_ptr<UsedSimulation> simulation_;
  OutputTimes due_;
  std::vector<double> numbers_;
  SensorStatistics statistics_;
  RunStatistics row_statistics_;
  run_report::TipDeflections tips_;
  std::optional<run_report::Recorder> recorder_;  ///< data of the page
  RunOutcome outcome_;
  std::optional<SavedState> last_;  ///< state at its end; none after a step that failed,
                                    ///< or of a controller that keeps data of its own
  Courses last_courses_;            ///< in force then
  std::int64_t last_step_ = 0;
};

}  // namespace spoke::python
