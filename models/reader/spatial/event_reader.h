#pragma once

// Reads, checks and writes [[event]].

#include <vector>

#include "models/reader/spatial/fault.h"
#include "models/reader/toml_section.h"
#include "models/spatial_model.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Reads the events of a model that is otherwise read.
std::vector<Event> read_events(const TomlSection& root, const Model& model);

/// Finds a fault of the events of a model that is otherwise fine; its path begins with "event".
Fault find_events_fault(const Model& model);

/// Returns the table of an event, with the values in force.
Json event_to_json(const Event& event);

}  // namespace spoke::spatial
