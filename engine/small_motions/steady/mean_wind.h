#pragma once

// The wind that a model in steady rotation knows: the same at every time, and unless it counts in
// full, at every place.

#include "engine/small_motions/steady/steady_model.h"
#include "models/scenario.h"

namespace spoke::steady {

/// Whether a scenario has air, and a wind that is not the same at every place and time.
bool has_changing_wind(const Scenario& scenario);

/// Which places have the wind of their own.
enum class WindPlaces {
  hub,  ///< none: all have that of the undeformed hub of a rotor
  all,
};

/// Returns the scenario in the mean of its wind, see WindField::mean(); of a course over time in
/// its value at `instant`. `rotor`: whose hub has the wind. Precondition: has_changing_wind().
Scenario in_mean_wind(const Scenario& scenario, Instant instant, WindPlaces places, int rotor = 0);

}  // namespace spoke::steady
