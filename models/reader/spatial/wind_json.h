#pragma once

// Writes [wind].

#include "models/support/json.h"
#include "models/wind.h"

namespace spoke::spatial {

/// Returns the table [wind] with all values in force, which read_wind() reads as the same wind. A
/// file's name leads to it from every folder.
Json wind_to_json(const Wind& wind);

}  // namespace spoke::spatial
