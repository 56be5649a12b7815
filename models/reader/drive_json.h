#pragma once

// Writes the drive of a hub as JSON.

#include "models/drive.h"
#include "models/support/json.h"

namespace spoke {

/// Returns the table [hub.drive] of a scenario file.
Json drive_to_json(const Drive& drive);

}  // namespace spoke
