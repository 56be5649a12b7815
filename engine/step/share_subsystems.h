#pragma once

// Sharing of the subsystems of a model over processes.

#include <vector>

#include "engine/step/step_context.h"

namespace spoke {

/// Estimates the costs of the subsystems: their coordinates, and the frames of their bodies.
template <class World>
std::vector<double> weights_of(const StepData<World>& data);
/// Shares the subsystems of an allocated context out over the processes of `exchange`, which must
/// outlive it. Precondition: no more processes than subsystems, formulation not augmented, and no
/// loads of the user's.
template <class World>
void share_out(Exchange& exchange, SystemContext<World>& context);

}  // namespace spoke
