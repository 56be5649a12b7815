#pragma once

// Sharing of the subsystems of a model over processes.

#include "engine/step/step_context.h"

namespace spoke {

/// Shares the subsystems of an allocated context out over the processes of `exchange`, which must
/// outlive it. Precondition: no more processes than subsystems, formulation not augmented, and no
/// loads of the user's.
template <class World>
void share_out(Exchange& exchange, SystemContext<World>& context);

}  // namespace spoke
