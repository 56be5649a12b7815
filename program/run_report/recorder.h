#pragma once

// Collects the data of report.html while a run goes on.

#include <span>
#include <string>
#include <vector>

#include "program/run_report/animation.h"
#include "program/run_report/curves.h"
#include "program/run_report/plots.h"

namespace spoke::run_report {

/// The data recorded for the page while a simulation runs.
class Recorder {
 public:
  explicit Recorder(const Simulation& simulation);

  /// Adds a row of sensors, at time t [s].
  void add_row(double t, std::span<const double> sensors);
  /// Adds a picture of the simulation's state.
  void add_picture(const Simulation& simulation) { animation_.add(simulation); }

  const std::vector<Plot>& plots() const { return plots_; }
  const Curves& curves() const { return curves_; }
  const Animation& animation() const { return animation_; }

 private:
  std::vector<Plot> plots_;
  std::vector<double> values_;  ///< values of all channels
  Curves curves_;               ///< curves of all channels, plot by plot
  Animation animation_;
};

/// Returns the data of the page's script, as JSON.
std::string make_data(const Recorder& recorder, const std::vector<EventInRun>& events);

}  // namespace spoke::run_report
