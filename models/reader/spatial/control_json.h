#pragma once

// Writes [control.pitch].

#include "models/control.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Returns the table of a pitch controller, with the values in force.
Json control_to_json(const PitchControl& control);

}  // namespace spoke::spatial
