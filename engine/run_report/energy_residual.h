#pragma once

// How far the balance of energy was off in a run, as told on the terminal and on its page.

#include <string>

#include "engine/results.h"
#include "engine/simulation.h"

namespace spoke::run_report {

/// The energy residual of largest size.
struct EnergyResidual {
  double value = 0.0;       ///< [J]; negative: energy was lost
  double time = 0.0;        ///< at which it was reached first [s]
  double share = 0.0;       ///< of the largest kinetic energy, positive; 0 if there is none
  bool is_notable = false;  ///< above a thousandth
  std::string explanation;  ///< why, where that is known; may be empty
};

/// Of all steps so far.
EnergyResidual find_energy_residual(const Simulation& simulation,
                                    const SensorStatistics& statistics);

}  // namespace spoke::run_report
