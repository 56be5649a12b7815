#pragma once

// What report.html needs of a run, collected while it goes on.

#include <span>
#include <string>
#include <vector>

#include "engine/run_report/animation.h"
#include "engine/run_report/curves.h"

namespace spoke::run_report {

/// What is recorded for the page while a simulation runs.
class Recorder {
 public:
  explicit Recorder(const Simulation& simulation);

  /// A row of sensors, at time t [s].
  void add_row(double t, std::span<const double> sensors);
  /// A picture of the simulation's state.
  void add_picture(const Simulation& simulation) { animation_.add(simulation); }

  const std::vector<Plot>& plots() const { return plots_; }
  const Curves& curves() const { return curves_; }
  const Animation& animation() const { return animation_; }

 private:
  std::vector<Plot> plots_;
  std::vector<double> values_;  ///< of all channels
  Curves curves_;               ///< of all channels, plot by plot
  Animation animation_;
};

/// The data of the page's script, as JSON.
std::string make_data(const Recorder& recorder);

}  // namespace spoke::run_report
