#pragma once

// The largest error of a run's energy balance, as told on the terminal and on the page.

#include <string>

#include "engine/results.h"
#include "engine/simulation.h"

namespace spoke::run_report {

/// The energy residual of largest magnitude.
struct EnergyResidual {
  double value = 0.0;  ///< residual [J]; negative: energy was lost
  double time = 0.0;   ///< time at which it was reached first [s]
  /// Its magnitude as a fraction of the largest kinetic energy; 0 if there is none.
  double share = 0.0;
  bool is_notable = false;  ///< whether the share is above a thousandth, and no round-off
  std::string explanation;  ///< cause, where it is known; may be empty
};

/// Finds the residual over all steps so far.
EnergyResidual find_energy_residual(const Simulation& simulation,
                                    const SensorStatistics& statistics);

}  // namespace spoke::run_report
