#pragma once

// A run as Python asks for it: steps with the interpreter lock released, rows in memory.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/run_report/recorder.h"
#include "engine/results.h"
#include "engine/simulation.h"

namespace spoke::python {

/// The sensors of a run at its output times.
class Recording {
 public:
  /// Steps to time `until` [s] and keeps a row every `every` [s], the present state and the last
  /// step included; 0: every step. Throws like Simulation::run_until(), and what Python raises
  /// where a signal asks for it, at the end of a step. The interpreter lock must be held.
  static std::unique_ptr<Recording> run(std::shared_ptr<Simulation> simulation, double until,
                                        double every);

  std::size_t rows() const { return numbers_.size() / width(); }
  /// Of a row: time, then the sensors.
  std::size_t width() const { return simulation_->sensor_names().size() + 1; }
  /// By row. Stays where it is.
  const std::vector<double>& numbers() const { return numbers_; }
  const Simulation& simulation() const { return *simulation_; }
  double wall_time() const { return outcome_.wall_time; }  ///< of the steps [s]

  /// summary.json of the run. Throws StateError if the simulation has gone on since.
  std::string make_summary() const;
  /// report.html of the run. Throws likewise.
  std::string make_page() const;

 private:
  explicit Recording(std::shared_ptr<Simulation> simulation);
  void add(double t, std::span<const double> sensors, OutputTimes& due);
  void add_row(double t, std::span<const double> sensors);
  void integrate(double until, OutputTimes& due);
  void require_its_state() const;

  std::shared_ptr<Simulation> simulation_;
  std::vector<double> numbers_;
  SensorStatistics statistics_;
  run_report::Recorder recorder_;
  RunOutcome outcome_;
  double last_row_ = -1.0;  ///< its time [s]
  std::int64_t last_step_ = 0;
};

}  // namespace spoke::python
