#pragma once

// The drive of a hub as JSON.

#include <nlohmann/json.hpp>

#include "models/drive.h"

namespace spoke {

/// The table [hub.drive] of a scenario file.
nlohmann::ordered_json drive_to_json(const Drive& drive);

}  // namespace spoke
