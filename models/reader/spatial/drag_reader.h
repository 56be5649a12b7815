#pragma once

// Reads, checks and writes the drag of bodies.

#include "models/reader/spatial/fault.h"
#include "models/reader/toml_section.h"
#include "models/spatial_model.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Reads the table "drag" of a body whose shape is known.
BodyDrag read_drag(const TomlSection& body, const Body& of);

/// Finds a fault of the drag of a body; its path begins with a key of the drag.
Fault find_drag_fault(const Body& body);

Json drag_to_json(const BodyDrag& drag);

}  // namespace spoke::spatial
