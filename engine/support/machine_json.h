#pragma once

// The machine in the JSON files that Spoke writes.

#include <nlohmann/json_fwd.hpp>

#include "engine/support/machine.h"

namespace spoke {

/// "cpu", "cores", "memory_bytes", "os", "compiler".
nlohmann::ordered_json describe_machine(const Machine& machine);
/// A load average; null if it is not known.
nlohmann::ordered_json load_or_null(double load);

}  // namespace spoke
