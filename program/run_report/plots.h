#pragma once

// Which sensors report.html plots over time, and which of them share a plot.

#include <cstddef>
#include <string>
#include <vector>

#include "engine/simulation.h"

namespace spoke::run_report {

/// A curve over time that a page shows: a sensor, or its component in another direction.
struct Channel {
  std::string name;   ///< name in the plot's legend
  std::size_t first;  ///< index of a sensor
  double first_factor = 1.0;
  std::size_t second = 0;  ///< index of another sensor, which is added
  double second_factor = 0.0;
};

/// Curves that share a plot.
struct Plot {
  std::string title;
  std::string unit;
  std::vector<Channel> channels;
};

/// Makes the plots of a simulation's sensors: deflections of the tips, motion and torque of the
/// hub, air and control of pitch, energies, loads of the roots, and the scenario's own sensors.
std::vector<Plot> make_plots(const Simulation& simulation);

}  // namespace spoke::run_report
