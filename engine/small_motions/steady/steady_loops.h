#pragma once

// The closed loops of a subsystem at the state in the table: openings, forces and loads.

#include "engine/small_motions/steady/steady_model.h"
#include "engine/step/step_context.h"

namespace spoke::steady {

/// Closes the loops of a system as a run does at its start, and lets joints start there: frames and
/// lengths of closures are those at the start from now on. Returns the use of their rows, by
/// subsystem. Throws InputError like a run.
template <class World>
std::vector<std::vector<LoopRowUse>> start_loops_of(System<World>& system,
                                                    const LoopLimits& limits);

/// Returns the rows of a subsystem's loops.
template <class World>
std::vector<ClosureRow> list_rows(const Subsystem<World>& subsystem,
                                  const SubsystemData<World>& data);

/// Sets in `response` the openings of the loops of subsystem `i` and the forces of their rows;
/// unless the state holds springs, in `rows` the stiffness that bearings with matrices have at its
/// speeds. Shares of loops have what is set in the table: see share_loops(). Precondition: the
/// states of all loops in the table are those of the state.
template <class World>
void put_loops(const System<World>& system, std::size_t i, const SubsystemState& state,
               std::vector<ClosureRow>& rows, StepData<World>& data, SubsystemResponse& response);

/// Returns what the loops exert on their places by the forces of their rows. Precondition: the
/// states of loops are set.
template <class World>
std::vector<LoopLoad> calc_loop_loads(const System<World>& system, std::size_t i,
                                      const Eigen::VectorXd& multipliers,
                                      const StepData<World>& data);

}  // namespace spoke::steady
