#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/run_report/film.h"
#include "engine/run_report/history.h"

namespace spoke::run_report {

/// What is recorded for the page while a simulation runs.
class Recorder {
 public:
  explicit Recorder(const Simulation& simulation);

  /// A row of sensors, at time t [s].
  void add_row(double t, std::span<const double> sensors);
  /// A picture of the simulation's state.
  void add_picture(const Simulation& simulation) { film_.add(simulation); }

  const std::vector<Plot>& plots() const { return plots_; }
  const History& history() const { return history_; }
  const Film& film() const { return film_; }

 private:
  std::vector<Plot> plots_;
  std::vector<double> values_;  ///< of all channels
  History history_;             ///< of all channels, plot by plot
  Film film_;
};

/// The data of the page's script, as JSON.
std::string make_data(const Recorder& recorder, double hub_radius);

}  // namespace spoke::run_report
