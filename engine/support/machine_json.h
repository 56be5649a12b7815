#pragma once

// The machine in the JSON files that Spoke writes.

#include "engine/support/machine.h"
#include "models/support/json.h"

namespace spoke {

/// Returns "cpu", "cores", "memory_bytes", "os", "compiler".
Json describe_machine(const Machine& machine);
/// Returns "threads", "before", "after"; null if it was not measured.
Json describe(const Capacity& capacity);
/// Returns a load average; null if it is not known.
Json load_or_null(double load);

}  // namespace spoke
