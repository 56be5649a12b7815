#pragma once

// Rows of four-bar linkages.

#include "models/scenario.h"

namespace spoke::bench {

/// Returns a row of four-bar linkages, each of which shares a bar with the next: those of
/// models/four_bar.toml, in one subsystem, without sensors.
Scenario row_of_four_bars(int count);

}  // namespace spoke::bench
