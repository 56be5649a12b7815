#pragma once

// The start of closed loops (docs/formulation.md, section 12): frames and lengths that are those at
// the start; joints moved until the loops are closed; redundant rows; freedoms.

#include <vector>

#include "engine/step/step_context.h"
#include "models/scenario.h"

namespace spoke {

/// Returns what counts at the start by a scenario.
LoopLimits make_loop_limits(const Integration& integration);

/// Sets the frames and lengths of closures that are those at the start, closes the loops, first
/// their openings, then their rates, and finds rows that are redundant, which take no part in the
/// run. The bodies must stand at their initial coordinates. Fills context.loop_start.
///
/// Throws InputError that names loop and row if a loop cannot be closed, if nothing in a subsystem
/// with loops can move, or if prescribed motion fights a loop.
template <class World>
void start_loops(SystemContext<World>& context);

/// Closes the loops again from a state near by, as an equilibrium that was found to a tolerance.
template <class World>
void close_loops(SystemContext<World>& context);

}  // namespace spoke
