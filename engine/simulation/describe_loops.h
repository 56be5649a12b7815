#pragma once

// Names what the start of closed loops has found.

#include <vector>

#include "engine/loops_at_start.h"
#include "engine/small_motions/steady/subsystem_names.h"
#include "engine/step/step_context.h"

namespace spoke {

/// Describes context.loop_start. `names`: those of the subsystems.
template <class World>
LoopsAtStart describe_loops(const SystemContext<World>& context,
                            const std::vector<SubsystemNames>& names);

}  // namespace spoke
