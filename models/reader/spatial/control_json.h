#pragma once

// Writes [control].

#include "models/control.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Returns the table of a pitch controller, with the values in force.
Json control_to_json(const PitchControl& control);
/// Returns the table of a library or of a controller of the program, likewise.
Json control_to_json(const OuterControl& control);

}  // namespace spoke::spatial
